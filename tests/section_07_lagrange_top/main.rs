//! Section 7 of the tutorial: Lagrange's top. The truths it is held against: the register's numbers to twenty digits, exact
//! rationals for identities, quadratures, and an integrator of its own that knows neither angles nor elliptic functions.

#![expect(
    clippy::excessive_precision,
    reason = "expected values keep all the digits they were computed to"
)]

mod axes;
mod common;
mod integrals;
mod integrator;
mod nutation;
mod pendulum;
mod precession;
mod release;
mod sleeping;
mod special;
#[path = "../support/inertia.rs"]
mod support;
mod traces;
