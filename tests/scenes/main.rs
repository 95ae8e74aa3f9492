//! Scenes: every effect matters, and what is absent does not.

mod strip;
mod top;
mod yo_yo;
