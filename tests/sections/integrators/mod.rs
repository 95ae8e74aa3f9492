//! The integrators: order 8, and the geometric ones with what each keeps.

mod common;
mod long;
mod numbers;
mod order_eight;
mod orders;
mod preservation;
mod refusals;
