//! Scenes: every effect changes the answer, its zero limit does not, the ledger balances, and closed forms agree with integrators.

#[cfg(feature = "scene-files")]
mod bodies;
mod contact;
#[cfg(feature = "scene-files")]
mod files;
mod meteorite;
mod roller;
mod shape;
mod spool;
mod strip;
mod superball;
mod top;
mod yo_yo;
