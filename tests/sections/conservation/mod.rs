//! Section 3 of the tutorial: conservation laws, the ledger, and the star that turns.

mod changing_shape;
mod common;
mod energy_and_forces;
mod ledger;
mod particles;
mod points_of_reference;
mod refusals;
mod turning_stars;

use super::*;
use common::*;
use spinning_bodies::conservation::{Law, Ledger, Particle, Particles, uniform_gravity};
use spinning_bodies::phenomena::Waist;
use spinning_bodies::rotating_fluid::{JacobiEllipsoid, MaclaurinSpheroid};
