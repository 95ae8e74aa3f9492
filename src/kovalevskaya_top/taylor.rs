//! The Euler–Poisson equations by their own power series, and the way back to the surface of the constants (8.2).

use nalgebra::{Matrix4, Quaternion, SMatrix, SVector};

use super::constants::{Constants, Phase, WidePhase};
use crate::precise::DoubleDouble;

/// Terms of a series.
const ORDER: usize = 24;

/// A state and its attitude quaternion (w, x, y, z).
pub(super) type Carried = (Phase, [f64; 4]);

/// Power series of a motion about the time 0, with the attitude: dq/dt = ½ qΩ.
pub(super) struct Series {
    terms: [[f64; 10]; ORDER + 1],
    /// The longest step that leaves the last terms below rounding.
    pub reach: f64,
}

impl Series {
    // ANCHOR: series
    pub fn at(c: f64, (state, attitude): &Carried) -> Self {
        let mut terms = [[0.0; 10]; ORDER + 1];
        terms[0][..6].copy_from_slice(state);
        terms[0][6..].copy_from_slice(attitude);
        for n in 0..ORDER {
            // The nth term of the product of two components.
            let of =
                |i: usize, j: usize| (0..=n).map(|m| terms[m][i] * terms[n - m][j]).sum::<f64>();
            let [z2, z3] = [terms[n][4], terms[n][5]];
            let next = [
                0.5 * of(1, 2),
                0.5 * (c * z3 - of(0, 2)),
                -c * z2,
                of(4, 2) - of(5, 1),
                of(5, 0) - of(3, 2),
                of(3, 1) - of(4, 0),
                -0.5 * (of(7, 0) + of(8, 1) + of(9, 2)),
                0.5 * (of(6, 0) + of(8, 2) - of(9, 1)),
                0.5 * (of(6, 1) + of(9, 0) - of(7, 2)),
                0.5 * (of(6, 2) + of(7, 1) - of(8, 0)),
            ];
            terms[n + 1] = next.map(|x| x / (n + 1) as f64);
        }
        let size = |n: usize| terms[n].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let reach = [ORDER - 1, ORDER]
            .map(|n| (1e-17 * size(0) / size(n)).powf(1.0 / n as f64))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        Self { terms, reach }
    }
    // ANCHOR_END: series

    /// How far off a motion nearby is after `h` that is off by so much at 0, to first order.
    pub fn nearby(&self, c: f64, off: &Phase, h: f64) -> Phase {
        let mut terms = [[0.0; 6]; ORDER + 1];
        terms[0] = *off;
        for n in 0..ORDER {
            let of = |i: usize, j: usize| {
                let both = (0..=n).map(|m| {
                    terms[m][i] * self.terms[n - m][j] + self.terms[m][i] * terms[n - m][j]
                });
                both.sum::<f64>()
            };
            let [z2, z3] = [terms[n][4], terms[n][5]];
            let next = [
                0.5 * of(1, 2),
                0.5 * (c * z3 - of(0, 2)),
                -c * z2,
                of(4, 2) - of(5, 1),
                of(5, 0) - of(3, 2),
                of(3, 1) - of(4, 0),
            ];
            terms[n + 1] = next.map(|x| x / (n + 1) as f64);
        }
        let mut sum = [0.0; 6];
        for term in terms.iter().rev() {
            for (s, x) in sum.iter_mut().zip(term) {
                *s = h.mul_add(*s, *x);
            }
        }
        sum
    }

    pub fn after(&self, h: f64) -> Carried {
        let mut sum = [0.0; 10];
        for term in self.terms.iter().rev() {
            for (s, x) in sum.iter_mut().zip(term) {
                *s = h.mul_add(*s, *x);
            }
        }
        let [p, q, r, z1, z2, z3, w, x, y, z] = sum;
        ([p, q, r, z1, z2, z3], [w, x, y, z])
    }
}

/// Terms of a series in 106 bits.
const WIDE_ORDER: usize = 36;

/// Power series of Ω and z in 106 bits.
pub(super) struct WideSeries {
    terms: Vec<WidePhase>,
    /// The longest step that leaves the last terms below rounding.
    pub reach: f64,
}

impl WideSeries {
    pub fn at(c: DoubleDouble, state: &WidePhase) -> Self {
        let mut terms = vec![*state];
        for n in 0..WIDE_ORDER {
            let of = |i: usize, j: usize| {
                (0..=n).fold(DoubleDouble::from(0.0), |sum, m| {
                    sum + terms[m][i] * terms[n - m][j]
                })
            };
            let [z2, z3] = [terms[n][4], terms[n][5]].map(|z| z * c);
            let next = [
                of(1, 2).scaled(0.5),
                (z3 - of(0, 2)).scaled(0.5),
                -z2,
                of(4, 2) - of(5, 1),
                of(5, 0) - of(3, 2),
                of(3, 1) - of(4, 0),
            ];
            let place = DoubleDouble::from((n + 1) as f64);
            terms.push(next.map(|x| x / place));
        }
        let size = |n: usize| terms[n].iter().fold(0.0_f64, |m, x| m.max(x.high().abs()));
        let reach = [WIDE_ORDER - 1, WIDE_ORDER]
            .map(|n| (1e-33 * size(0) / size(n)).powf(1.0 / n as f64))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        Self { terms, reach }
    }

    pub fn after(&self, h: DoubleDouble) -> WidePhase {
        let mut sum = [DoubleDouble::from(0.0); 6];
        for term in self.terms.iter().rev() {
            for (s, x) in sum.iter_mut().zip(term) {
                *s = h * *s + *x;
            }
        }
        sum
    }
}

/// The slope below which a condition is not followed.
const GENTLE: f64 = 3e-3;

// ANCHOR: projection
/// The state moved by the shortest way onto the surface E, L_vert, |z| and |K| of the start.
///
/// Rounding may push a state off the surface, never along: the direction along belongs to the phases, that is to time.
/// One step of Newton's method with the least change. Near a double root two of the four surfaces touch, and rounding would be
/// blown up; the change is therefore damped where the conditions say little, and is never more than 1/(2·GENTLE) of what is missing.
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
    let gradients = SMatrix::<f64, 4, 6>::from_row_slice(&[
        4.0 * p,
        4.0 * q,
        2.0 * r,
        2.0 * c,
        0.0,
        0.0,
        2.0 * z1,
        2.0 * z2,
        z3,
        2.0 * p,
        2.0 * q,
        r,
        0.0,
        0.0,
        0.0,
        2.0 * z1,
        2.0 * z2,
        2.0 * z3,
        4.0 * (re * p + im * q),
        4.0 * (im * p - re * q),
        0.0,
        -2.0 * c * re,
        -2.0 * c * im,
        0.0,
    ]);
    // A slope below GENTLE is followed the less the gentler it is: there the condition says little about the state.
    let square: Matrix4<f64> =
        gradients * gradients.transpose() + Matrix4::identity() * (GENTLE * GENTLE);
    let Some(factors) = square.cholesky() else {
        return *state;
    };
    let change = gradients.transpose() * factors.solve(&missing);
    core::array::from_fn(|i| state[i] - change[i])
}
// ANCHOR_END: projection

/// A turn about the third axis, as a unit quaternion.
pub(super) fn about_third(angle: f64) -> Quaternion<f64> {
    let (sine, cosine) = (0.5 * angle).sin_cos();
    Quaternion::new(cosine, 0.0, 0.0, sine)
}

/// The shortest turn of a unit vector onto the third axis, as a unit quaternion; from below by way of half a turn about axis 1.
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
