//! Power series of her tops, and the projection onto the surface of the constants (8.2).

use nalgebra::{Matrix4, Quaternion, SMatrix, SVector};

use super::constants::{Constants, Phase};
use crate::euler_equations::{AxisMoments, Coefficients, Numeral, Series};

/// A state together with its attitude.
pub(super) type FullState = (Phase, Quaternion<f64>);

/// The equations in units where I = (2, 2, 1) and C = (C₁, 0, 0).
pub(super) fn coefficients<N: Numeral>(c: N) -> Coefficients<N> {
    let moments = AxisMoments::allowing_rods([2.0, 2.0, 1.0]);
    Coefficients::new(&moments, [c, N::from(0.0), N::from(0.0)])
}

/// Power series of a state with its attitude, in doubles.
pub(super) fn series(c: f64, (state, attitude): &FullState) -> Series<f64, 10> {
    let [p, q, r, z1, z2, z3] = *state;
    let Quaternion { coords } = attitude;
    let start = [p, q, r, z1, z2, z3, coords.w, coords.x, coords.y, coords.z];
    Series::about(&coefficients(c), start, 24, 1e-17)
}

/// The state with its attitude after `h`.
pub(super) fn full_state(series: &Series<f64, 10>, h: f64) -> FullState {
    let [p, q, r, z1, z2, z3, w, x, y, z] = series.after(h);
    ([p, q, r, z1, z2, z3], Quaternion::new(w, x, y, z))
}

/// The slope below which a condition is followed only in part.
const LEAST_SLOPE: f64 = 3e-3;

// ANCHOR: projection
/// The state moved by the least change onto the surface of constant E, L_vert, |z| and |K|, those of the start.
///
/// This corrects rounding across the surface, never along it: the directions along the surface are those of the phases, that is of time.
/// One step of Newton's method with the least change. Near a double root two of the four surfaces touch, and rounding would be
/// amplified; the change is therefore damped where a condition has a small slope, and is never more than 1/(2·LEAST_SLOPE) of the residual.
pub(super) fn project(constants: &Constants, state: &Phase) -> Phase {
    let Constants { c, l1, l, k, .. } = *constants;
    let c = c.value();
    let [p, q, r, z1, z2, z3] = *state;
    let (re, im) = (p * p - q * q - c * z1, 2.0 * p * q - c * z2);
    let k = k.value();
    let missing = SVector::<f64, 4>::new(
        2.0 * (p * p + q * q) + r * r + 2.0 * c * z1 - 6.0 * l1.value(),
        2.0 * (p * z1 + q * z2) + r * z3 - 2.0 * l.value(),
        z1 * z1 + z2 * z2 + z3 * z3 - 1.0,
        re * re + im * im - k * k,
    );
    let [by_p, by_q] = [re * p + im * q, im * p - re * q].map(|x| 4.0 * x);
    let [by_z1, by_z2] = [re, im].map(|x| -2.0 * c * x);
    let gradients = SMatrix::<f64, 6, 4>::from([
        [4.0 * p, 4.0 * q, 2.0 * r, 2.0 * c, 0.0, 0.0],
        [2.0 * z1, 2.0 * z2, z3, 2.0 * p, 2.0 * q, r],
        [0.0, 0.0, 0.0, 2.0 * z1, 2.0 * z2, 2.0 * z3],
        [by_p, by_q, 0.0, by_z1, by_z2, 0.0],
    ]);
    // The smaller a slope below LEAST_SLOPE, the less its condition is followed: it says little about the state.
    let square: Matrix4<f64> =
        gradients.transpose() * gradients + Matrix4::identity() * (LEAST_SLOPE * LEAST_SLOPE);
    let Some(factors) = square.cholesky() else {
        return *state;
    };
    let change = gradients * factors.solve(&missing);
    core::array::from_fn(|i| state[i] - change[i])
}
// ANCHOR_END: projection

/// A turn about the third axis, as a unit quaternion.
pub(super) fn about_third(angle: f64) -> Quaternion<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Quaternion::new(cosine, 0.0, 0.0, sine)
}

/// The shortest turn of a unit vector onto the third axis, as a unit quaternion; for a vector in the lower half, after half a turn about axis 1.
pub(super) fn shortest([x, y, z]: [f64; 3]) -> Quaternion<f64> {
    let onto = |x: f64, y: f64, z: f64| {
        let turn = Quaternion::new(1.0 + z, y, -x, 0.0);
        turn / turn.norm()
    };
    if z < 0.0 {
        onto(x, -y, -z) * Quaternion::new(0.0, 1.0, 0.0, 0.0)
    } else {
        onto(x, y, z)
    }
}
