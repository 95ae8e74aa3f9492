//! Section 4.7 of the tutorial: bodies that stand on a table. The truths they are held against: closed forms, integrals that friction
//! cannot change, the register's numbers, published simulations, and trajectories computed to 25 digits by other equations.

mod celt;
mod chiral;
mod common;
mod egg;
mod hoop;
mod reference;
mod tippe;

use super::*;
use common::*;
use spinning_bodies::scene::contact::{State, TableTop, passage};
use spinning_bodies::scene::effects::{Gravity, NoSlip, Regularised, Viscous};
use spinning_bodies::tippe_top::{ConvexBody, Start, Surface, TippeTop, bodies, quasi_steady};
