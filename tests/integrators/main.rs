//! The integrators: the adapter to the general ones, and the geometric ones with what each keeps.

mod common;
mod general;
mod long;
mod numbers;
mod order_eight;
mod orders;
mod preservation;
mod refusals;
