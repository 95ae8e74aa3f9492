//! Section 7 of the tutorial: Lagrange's top. The truths it is held against: the register's numbers to twenty digits, exact
//! rationals for identities, quadratures. That a state is right at its time, `tests/hard_cases/lagrange_top.rs` says at 32 digits.

mod axes;
mod common;
mod integrals;
mod nutation;
mod pendulum;
mod precession;
mod release;
mod sleeping;
mod special;
mod traces;

use super::*;
use common::*;
use spinning_bodies::lagrange_top::{LagrangeTop, Nutation, State, pendulum_between};
