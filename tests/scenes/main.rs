//! Scenes: what each effect changes, that its absence costs nothing, that plans, ledgers and refusals are right.

mod shape;
mod top;
