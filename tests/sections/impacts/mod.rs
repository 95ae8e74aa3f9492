//! Section 4.2 of the tutorial: a meteorite strikes a planet and sticks.

mod common;
mod energy_and_tilt;
mod exact;
mod first_order;
mod refusals;

use super::*;
use common::*;
use spinning_bodies::impacts::{Meteorite, Planet, grazing_mass_ratio, strike};
