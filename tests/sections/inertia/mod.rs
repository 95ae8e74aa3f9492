//! Section 2, the inertia matrix: one test a claim. Truths are exact rationals, quadrature written here, point
//! sums, or another route through the library (a mesh against a formula).

mod angular_momentum;
mod boxes_and_laminae;
mod common;
mod energy;
mod mass_and_axis;
mod parallel_axes;
mod principal_axes;
mod routh;
mod same_inertia;
mod symmetry;

use super::*;
use common::*;
use spinning_bodies::inertia::{PlatonicSolid, RigidMotion, mesh_mass_properties};
use support::inertia::{assert_inertia, circle, cubature, particles};
