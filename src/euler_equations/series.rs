//! The motion of a heavy top by power series in time, in one double or two (tutorial 8.1).

use super::AxisMoments;
use crate::precise::{DoubleDouble, Operators};

/// One double or two.
pub(crate) trait Numeral: Operators + From<f64> + Into<DoubleDouble> {}

impl Numeral for f64 {}
impl Numeral for DoubleDouble {}

/// The constants of the equations Ω₁′ = (I₂ − I₃)/I₁ · Ω₂Ω₃ + (z∧λ)₁/I₁ and cyclic.
#[derive(Clone, Copy)]
pub(crate) struct Coefficients<N> {
    /// (I₂ − I₃)/I₁ and cyclic.
    differences: [N; 3],
    /// 1/I₁, 1/I₂, 1/I₃.
    inverses: [N; 3],
    /// λ = MgC.
    lever: [N; 3],
}

impl<N: Numeral> Coefficients<N> {
    /// Those of a top with these moments, none of them zero, and the lever MgC.
    pub fn new(moments: &AxisMoments, lever: [N; 3]) -> Self {
        let moments = moments.values().map(N::from);
        let of = |k: usize| (moments[(k + 1) % 3] - moments[(k + 2) % 3]) / moments[k];
        Self {
            differences: [0, 1, 2].map(of),
            inverses: moments.map(|moment| N::from(1.0) / moment),
            lever,
        }
    }
}

/// Power series of a motion about time 0: of Ω and z, and if K = 10 of the attitude as well.
pub(crate) struct Series<N, const K: usize> {
    terms: Vec<[N; K]>,
    /// The longest step that leaves the last terms below rounding.
    pub reach: f64,
}

impl<N: Numeral, const K: usize> Series<N, K> {
    /// Terms up to `order`; `reach` is the step at which the last ones are the fraction `part` of the first.
    pub fn about(top: &Coefficients<N>, start: [N; K], order: usize, part: f64) -> Self {
        let terms = grown(top, start, order, |terms, n, m| {
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
    pub fn nearby(&self, top: &Coefficients<N>, off: &[N; 6], h: N) -> [N; 6] {
        let known: Vec<[N; 6]> = self
            .terms
            .iter()
            .map(|x| core::array::from_fn(|i| x[i]))
            .collect();
        let terms = grown(top, *off, known.len() - 1, |terms, n, m| {
            let [a, b] = [
                product(&terms[m], &known[n - m]),
                product(&known[m], &terms[n - m]),
            ];
            core::array::from_fn(|i| a[i] + b[i])
        });
        sum(&terms, h)
    }
}

/// The terms of a series up to this order; the nth term of a product is Σ `product`(…, n, m) over m.
fn grown<N: Numeral, const K: usize>(
    top: &Coefficients<N>,
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
        let accelerations: [N; 3] = core::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let torque = terms[n][3 + i] * top.lever[j] - terms[n][3 + j] * top.lever[i];
            top.differences[k] * next[k] + top.inverses[k] * torque
        });
        next[..3].copy_from_slice(&accelerations);
        let place = N::from((n + 1) as f64);
        // q′ = ½ qΩ.
        terms.push(core::array::from_fn(|i| {
            let part = if i < 6 { 1.0 } else { 0.5 };
            next[i] / place * N::from(part)
        }));
    }
    terms
}

/// The products in the rates: Ω₂Ω₃ and cyclic, z∧Ω and qΩ, with Ω, z and q of one state and the second factor of another.
fn product<N: Numeral, const K: usize>(one: &[N; K], other: &[N; K]) -> [N; K] {
    let [p, q, r] = [other[0], other[1], other[2]];
    let mut all = [N::from(0.0); K];
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        all[k] = one[i] * other[j];
        all[3 + k] = one[3 + i] * other[j] - one[3 + j] * other[i];
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

fn sum<N: Numeral, const K: usize>(terms: &[[N; K]], h: N) -> [N; K] {
    let zero = [N::from(0.0); K];
    terms.iter().rev().fold(zero, |sum, term| {
        core::array::from_fn(|i| h * sum[i] + term[i])
    })
}
