//! The integrators: order 8, and the geometric ones with what each keeps.

mod common;
mod long;
mod numbers;
mod order_eight;
mod orders;
mod preservation;
mod refusals;

use super::*;
use common::*;
use lab::follow::Follow;
use lab::general::GeneralMethod;
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::integrators::geometric::{
    FreeSplitting, GroupMidpoint, HeavySplitting, Integrator, MoserVeselov, MuntheKaas, Order,
    Phase, VeselovOrder, Weight,
};
