//! The Euler–Poisson equations solved by power series, and the projection onto the surface of the constants (8.2).

use nalgebra::{Matrix4, Quaternion, SMatrix, SVector};

use super::constants::{Constants, Phase, WidePhase};
use crate::precise::{DoubleDouble, Operators};

/// One double or two.
pub(super) trait Numeral: Operators + From<f64> + Into<DoubleDouble> {}

impl Numeral for f64 {}
impl Numeral for DoubleDouble {}

/// A state together with its attitude.
pub(super) type FullState = (Phase, Quaternion<f64>);

/// Power series of a motion about time 0: of Ω and z, and if K = 10 of the attitude as well, dq/dt = ½ qΩ.
pub(super) struct Series<N, const K: usize> {
    terms: Vec<[N; K]>,
    /// The longest step that leaves the last terms below rounding.
    pub reach: f64,
}

impl Series<f64, 10> {
    pub fn of(c: f64, (state, attitude): &FullState) -> Self {
        let [p, q, r, z1, z2, z3] = *state;
        let Quaternion { coords } = attitude;
        let start = [p, q, r, z1, z2, z3, coords.w, coords.x, coords.y, coords.z];
        Self::about(c, start, 24, 1e-17)
    }

    pub fn full_state(&self, h: f64) -> FullState {
        let [p, q, r, z1, z2, z3, w, x, y, z] = self.after(h);
        ([p, q, r, z1, z2, z3], Quaternion::new(w, x, y, z))
    }
}

impl Series<DoubleDouble, 6> {
    pub fn of(c: DoubleDouble, state: &WidePhase) -> Self {
        Self::about(c, *state, 36, 1e-33)
    }
}

impl<N: Numeral, const K: usize> Series<N, K> {
    /// Terms up to `order`; `reach` is the step at which the last ones are the fraction `part` of the first.
    fn about(c: N, start: [N; K], order: usize, part: f64) -> Self {
        let terms = grown(c, start, order, |terms, n, m| {
            product(&terms[m], &terms[n - m])
        });
        let size = |n: usize| {
            let sizes = terms[n].map(|x| x.into().high().abs());
            sizes.into_iter().fold(0.0, f64::max)
        };
        let reach = [order - 1, order]
            .map(|n| (part * size(0) / size(n)).powf(1.0 / n as f64))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        Self { terms, reach }
    }

    pub fn after(&self, h: N) -> [N; K] {
        sum(&self.terms, h)
    }

    /// The deviation after `h` of a neighbouring motion whose deviation at 0 is `off`, to first order.
    pub fn nearby(&self, c: N, off: &[N; 6], h: N) -> [N; 6] {
        let known: Vec<[N; 6]> = self
            .terms
            .iter()
            .map(|x| core::array::from_fn(|i| x[i]))
            .collect();
        let terms = grown(c, *off, known.len() - 1, |terms, n, m| {
            let [a, b] = [
                product(&terms[m], &known[n - m]),
                product(&known[m], &terms[n - m]),
            ];
            core::array::from_fn(|i| a[i] + b[i])
        });
        sum(&terms, h)
    }
}

// ANCHOR: series
/// The terms of a series up to this order; the nth term of a product is Σ `product`(…, n, m) over m.
fn grown<N: Numeral, const K: usize>(
    c: N,
    start: [N; K],
    order: usize,
    product: impl Fn(&[[N; K]], usize, usize) -> [N; K],
) -> Vec<[N; K]> {
    let mut terms = Vec::with_capacity(order + 1);
    terms.push(start);
    for n in 0..order {
        let mut next = product(&terms, n, 0);
        for m in 1..=n {
            let more = product(&terms, n, m);
            next = core::array::from_fn(|i| next[i] + more[i]);
        }
        next[1] = next[1] + c * terms[n][5];
        next[2] = -(c * terms[n][4]);
        let place = N::from((n + 1) as f64);
        // The rates of Ω₁, Ω₂ and the quaternion are half of this.
        terms.push(core::array::from_fn(|i| {
            let part = if (2..6).contains(&i) { 1.0 } else { 0.5 };
            next[i] / place * N::from(part)
        }));
    }
    terms
}

/// The products in the rates: ΩΩ₃, z ∧ Ω and qΩ, with Ω, z and q of one state and the second factor of another.
fn product<N: Numeral, const K: usize>(one: &[N; K], other: &[N; K]) -> [N; K] {
    let [p, q, r] = [other[0], other[1], other[2]];
    let mut all = [N::from(0.0); K];
    (all[0], all[1]) = (one[1] * r, -(one[0] * r));
    for i in 0..3 {
        let (next, last) = ((i + 1) % 3, (i + 2) % 3);
        all[3 + i] = one[3 + next] * other[last] - one[3 + last] * other[next];
    }
    if K > 6 {
        let [w, x, y, z] = [one[6], one[7], one[8], one[9]];
        all[6] = -(x * p + y * q + z * r);
        all[7] = w * p + y * r - z * q;
        all[8] = w * q + z * p - x * r;
        all[9] = w * r + x * q - y * p;
    }
    all
}
// ANCHOR_END: series

fn sum<N: Numeral, const K: usize>(terms: &[[N; K]], h: N) -> [N; K] {
    let zero = [N::from(0.0); K];
    terms.iter().rev().fold(zero, |sum, term| {
        core::array::from_fn(|i| h * sum[i] + term[i])
    })
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
