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

/// The derivative at the middle of nine values at equal distances, to the eighth power of the distance.
fn derivative(values: [Vector3<f64>; 9], step: f64) -> Vector3<f64> {
    let weights = [1.0 / 280.0, -4.0 / 105.0, 1.0 / 5.0, -4.0 / 5.0];
    let mut sum = Vector3::zeros();
    for (k, weight) in weights.into_iter().enumerate() {
        sum += (values[k] - values[8 - k]) * weight;
    }
    sum / step
}
