//! One module a module of the library, one test a claim: named after its paragraph of the tutorial, with the claim above it.

#![expect(
    clippy::excessive_precision,
    reason = "expected values keep all the digits they were computed to"
)]

mod conservation;
mod elliptic;
mod euler_equations;
mod euler_top;
mod falling_strip;
mod frame;
mod gyroscope;
mod impacts;
mod inertia;
mod integrators;
mod kovalevskaya_top;
mod lagrange_top;
mod phenomena;
mod pythagoras;
mod rolling;
mod scenes;
mod sheet;
mod spool;
mod superball;
mod tippe_top;
mod yo_yo;

use approx::assert_relative_eq;
use lab::general::DifferentialEquations;
use nalgebra::{Matrix3, Vector3};
use num_rational::Ratio;
use proptest::prelude::*;
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::inertia::{InertiaMatrix, MassProperties, PrincipalMoments, shapes};
use spinning_bodies::integrators::{Effort, Kept, Leg, Method, order_eight};
use spinning_bodies::rolling::Moment;
use spinning_bodies::scene::{Choice, Geometric, Request, Scene, Solver};
use spinning_bodies::{Error, Result};
use std::f64::consts::{
    FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, FRAC_PI_8, PI, SQRT_2, TAU,
};
use support::double_double::Dd;
use support::inertia::{gauss, integral, unit_gauss};
use support::{
    ONE, R, TWO, Uniform, ZERO, close, cross, derivative, dot, euler, exact, exact_slope, greatest,
    heavy_rates, mean, near, observed, ration, rational, refused, relative, runge_kutta, turned,
    vector, whole, within, wrapped,
};

/// These times, to this accuracy.
fn asking(times: impl Into<Vec<f64>>, accuracy: f64) -> Request {
    let request = Request::at(times).unwrap();
    request.to_accuracy(accuracy).unwrap()
}

/// Order 8 of the library itself.
const OURS: Solver = Solver::Geometric(Geometric::DormandPrince8);

/// The same asked of this solver.
fn using(request: &Request, solver: Solver) -> Request {
    let request = request.clone().with_methods(&DifferentialEquations);
    request.by(Choice::Use(solver))
}

/// The same asked of one of the general methods.
fn by_general(request: Request, method: Method) -> Request {
    using(&request, Solver::General(method))
}

/// A number as it is printed, with so many digits after the point.
fn rounded(value: f64, digits: i32, expected: f64) {
    near!(value, expected, 0.5000001 * 10f64.powi(-digits));
}

/// A run of order 8 from time 0 on.
fn leg<'a, const N: usize, S: ?Sized>(
    system: &'a S,
    (start, scales): (&'a [f64; N], &'a [f64; N]),
    (times, end): (&'a [f64], f64),
) -> Leg<'a, N, S> {
    let (kept, start) = (Kept::Nothing, (0.0, start));
    Leg {
        system,
        kept,
        start,
        scales,
        times,
        end,
    }
}

/// How far two moments of what rolls are apart, in units of a speed.
fn moments_apart(a: &Moment, b: &Moment, size: f64) -> f64 {
    let numbers = |m: &Moment| {
        let [heat, work] = [m.heat, m.work].map(|energy| energy / size);
        [m.position, m.velocity, m.rim_speed, m.turned, heat, work]
    };
    let (a, b) = (numbers(a), numbers(b));
    greatest((0..6).map(|k| (a[k] - b[k]).abs())) / size
}
