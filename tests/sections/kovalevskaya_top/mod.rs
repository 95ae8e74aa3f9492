//! Section 8: Kovalevskaya's top, and the lattice that came next.
//!
//! Identities are checked in exact rationals, motions against power series of order 30 that know nothing of her road and
//! against a table of 30 digits.

mod attitude;
mod common;
mod constant;
mod equations;
mod pivots;
mod separation;
mod toda;

use super::*;
use common::*;
use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, Integrability, TopState};
use spinning_bodies::kovalevskaya_top::{KovalevskayaTop, Method};
use support::power_series;
