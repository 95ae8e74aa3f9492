//! Section 6 of the tutorial: Euler's top. The truths it is held against: the register's closed forms and numbers to twenty
//! digits, exact rationals for identities, quadrature, and power series of its own in pairs of doubles (`support/power_series.rs`).

mod attitude;
mod batch;
mod common;
mod integrals;
mod own_axes;
mod picture;
mod poinsot;
mod regimes;
mod solution;
mod stability;
mod symmetric;

use super::*;
use common::*;
use spinning_bodies::elliptic::{Jacobi, Modulus, Parameter, complete_first};
use spinning_bodies::euler_top::{EulerTop, Poinsot, Regime, State, SymmetricTop};
use support::free_top::Flight;
