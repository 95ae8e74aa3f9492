//! Scenes of Section 4: every effect matters, and what is absent does not.

mod strip;
mod yo_yo;
