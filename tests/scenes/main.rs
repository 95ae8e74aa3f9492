//! Scenes: for every effect, what leaving it out does, its zero limit, its ledger, and the closed form against a general method.

mod meteorite;
mod roller;
mod spool;
mod superball;
