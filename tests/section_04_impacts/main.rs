//! Section 4.2 of the tutorial: a meteorite strikes a planet and sticks.

#![expect(
    clippy::excessive_precision,
    reason = "expected values keep all the digits they were computed to"
)]

#[path = "../support/any.rs"]
mod any;
mod common;
mod energy_and_tilt;
mod exact;
mod first_order;
mod refusals;
