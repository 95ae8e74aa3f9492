//! Section 3 of the tutorial: conservation laws, the ledger, and the star that turns.

#![expect(
    clippy::excessive_precision,
    reason = "expected values keep all the digits they were computed to"
)]

mod changing_shape;
mod common;
mod energy_and_forces;
mod particles;
mod points_of_reference;
mod refusals;
mod turning_stars;
