//! Section 5: Euler's equations with torque, about any point, in both kinds of axes; the tops with a further integral;
//! the ideal fluid as a top. The two directions of the transport theorem are tested in `sections/frame.rs`.

mod common;
mod fluid;
mod further_integrals;
mod momentum_sphere;
mod motions;
mod refusals;

use super::*;
use common::*;
use nalgebra::Complex;
use spinning_bodies::euler_equations::{
    AxisMoments, HeavyTop, SpringBody, TopState, equilibria, flow, rate, rate_in_any_axes,
    streamline,
};
use spinning_bodies::ideal_fluid::{SquareRoot, TruncatedFluid};
