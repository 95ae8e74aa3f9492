//! Properties over bodies and starts that nobody chose, and bad input of every kind.

mod bad_input;
mod euler_top;
mod inertia;
mod kovalevskaya_top;
mod lagrange_top;
#[cfg(feature = "serde")]
mod written;

use nalgebra::Vector3;
use proptest::prelude::*;
use spinning_bodies::frame::Attitude;
use support::derivative;

/// Up to this size, and half of them small.
fn component(most: f64) -> impl Strategy<Value = f64> {
    (prop::bool::ANY, -most..most, -12.0..0.0).prop_map(
        |(small, x, exponent): (bool, f64, f64)| {
            if small { x * exponent.exp2() } else { x }
        },
    )
}

fn turn() -> impl Strategy<Value = Attitude> {
    prop::array::uniform4(0.05..1.0_f64).prop_map(|[w, x, y, z]| {
        Attitude::from_quaternion(w - 0.5, x - 0.4, y, z).expect("y is not zero")
    })
}

fn composed(first: &Attitude, second: &Attitude) -> Attitude {
    let q = first.quaternion() * second.quaternion();
    Attitude::from_quaternion(q.w, q.i, q.j, q.k).expect("a unit quaternion")
}

/// How fast three numbers of a state change, and the body turns, twice q⁻¹q′, at the time n·step.
fn rates(at: impl Fn(f64) -> ([f64; 3], Attitude), n: i32, step: f64) -> [Vector3<f64>; 2] {
    let (_, here) = at(f64::from(n) * step);
    let beside = |t: f64| {
        let ([a, b, c], there) = at(t);
        let q = here.quaternion().inverse() * there.quaternion();
        let [x, y, z] = (2.0 * q.w.signum() * q.imag()).into();
        [a, b, c, x, y, z]
    };
    let [a, b, c, x, y, z] = derivative(beside, n, step);
    [Vector3::new(a, b, c), Vector3::new(x, y, z)]
}
