//! Scenes: what each effect changes, that its absence costs nothing, that plans, ledgers and refusals are right.

mod meteorite;
mod roller;
mod spool;
mod superball;
mod top;
