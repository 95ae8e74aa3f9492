//! Scenes: every effect matters, and what is absent does not.

mod meteorite;
mod roller;
mod shape;
mod spool;
mod strip;
mod superball;
mod top;
mod yo_yo;
