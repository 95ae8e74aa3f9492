//! The rest of the curve w² = P(s): the gaps between its bands, its period matrix, and the point that the vertical belongs to (8.2).

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::constants::Constants;
use super::separation::Separation;
use super::series::{Quadratures, mean};

/// A half period ½(n + τm) of the curve, n and m even or odd.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Half {
    pub n: [u8; 2],
    pub m: [u8; 2],
}

impl Half {
    const fn along(n: [u8; 2]) -> Self {
        Self { n, m: [0, 0] }
    }

    const fn across(m: [u8; 2]) -> Self {
        Self { n: [0, 0], m }
    }

    /// The sum, whole periods left out.
    pub fn plus(self, other: Self) -> Self {
        let sum = |a: [u8; 2], b: [u8; 2]| [a[0] ^ b[0], a[1] ^ b[1]];
        Self {
            n: sum(self.n, other.n),
            m: sum(self.m, other.m),
        }
    }

    /// All sixteen.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..16_u8).map(|bits| Self {
            n: [bits & 1, bits >> 1 & 1],
            m: [bits >> 2 & 1, bits >> 3],
        })
    }
}

/// The period matrix τ and two places on the torus, in turns of the two phases.
///
/// Both integrals are normalized: the first gains 1 as s₁ goes round its band and 0 as s₂ does, the second 0 and 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    /// Y = Im τ.
    pub y: [[f64; 2]; 2],
    /// Whether two roots are complex: Re τ is ½ everywhere then, 0 otherwise.
    pub twisted: bool,
    /// The half period from e₄ to e₅.
    pub between: Half,
    /// Half of the integrals from ∞ to Z, real and imaginary parts.
    pub point: [[f64; 2]; 2],
}

impl Curve {
    // ANCHOR: curve
    /// Gaps and cuts in turn from −∞: the cut of s₂, a gap, a band, and if all roots are real another gap and another band.
    ///
    /// Z is where s = l² − l₁, P(s) = −l²(m²−k²)²/4 with m = 3l₁ − 2l²; it lies in a gap between s₂ and s₁. None if a quadrature needs too many terms.
    pub fn prepare(constants: &Constants, separation: &Separation) -> Option<Self> {
        // Two roots in one or nearly, as when z starts along axis 3: a period is infinite.
        if separation.narrowest() < DOUBLE {
            return None;
        }
        let real = separation.in_order();
        let twisted = real.len() < 5;
        // The band of s₁ is the second cut or the third.
        let far = real[1] != separation.ends[0];
        let s = constants.l * constants.l - constants.l1;
        let over = |root: usize| (s - separation.roots[root].real).value();
        // In which of the gaps Z lies.
        let base = if far && over(real[2]) > -over(real[1]) {
            2
        } else {
            0
        };
        let gap = Quadratures::prepare(LONGEST_GAP, separation.gap([real[base], real[base + 1]]))?;
        let round = |place: usize| {
            let means = if place == base {
                gap.means
            } else {
                mean(separation.gap([real[place], real[place + 1]]))?
            };
            Some(separation.normalized(means.map(|x| TAU * x)))
        };
        let across_near = upward(round(0)?, 1);
        let first = if twisted {
            to_the_complex(separation, real[2])?
        } else {
            round(2)?
        };
        let first = upward(first, 0);
        let second = if far {
            across_near
        } else {
            [first[0] + across_near[0], first[1] + across_near[1]]
        };
        let y = [[first[0], first[1]], [first[1], second[1]]];
        let steps = [
            Half::along([0, 1]),
            Half::across(if far { [0, 1] } else { [1, 1] }),
            Half::along(if far { [1, 1] } else { [1, 0] }),
            Half::across([1, 0]),
            Half::along(if far { [1, 0] } else { [1, 1] }),
        ];
        // From ∞ to the root that is number `place` from below.
        let to = |place: usize| {
            steps[..=place]
                .iter()
                .fold(Half::default(), |sum, step| sum.plus(*step))
        };
        let place = |root: usize| real.iter().position(|&r| r == root);
        let between = to(place(3)?).plus(to(place(4)?));
        let [up, down] = [over(real[base]), -over(real[base + 1])].map(|x| x.max(0.0).sqrt());
        let inside = separation.normalized(gap.whole(2.0 * up.atan2(down)));
        let Half { n, m } = to(base).plus(to(place(4)?));
        let twist = if twisted { 0.5 } else { 0.0 };
        let [n, m] = [n, m].map(|x| x.map(f64::from));
        let point = [
            // A quarter of a turn of each besides: v is counted from where s₁ = A and s₂ = C.
            [0, 1].map(|i| 0.25 * (1.0 + n[i] + twist * (m[0] + m[1]))),
            [0, 1].map(|i| 0.5 * inside[i] + 0.25 * (y[i][0] * m[0] + y[i][1] * m[1])),
        ];
        Some(Self {
            y,
            twisted,
            between,
            point,
        })
    }
    // ANCHOR_END: curve

    /// α but for whole turns of v: l − ½ of the mean of N/((s₁−s)(s₂−s)), N = l(m²−k²)/2, with s and m of Z.
    ///
    /// A₊′ = 2l − N/((s₁−s)(s₂−s)) − d arg R/dt with a function R of the state, and the mean is one of two integrals of the third kind, one in s₁ and one in s₂.
    /// None where Z is so near to a band that these need too many terms.
    pub fn rate(&self, constants: &Constants, separation: &Separation) -> Option<f64> {
        let square = constants.l * constants.l;
        let m = constants.l1.times(3.0) - square.scaled(2.0);
        let residue = (constants.l * (m - constants.k) * (m + constants.k))
            .scaled(0.5)
            .value();
        let mean = separation.third_kind(square - constants.l1)?;
        Some(constants.l.value() - 0.5 * residue * mean)
    }

    /// Re τx in one component, which is the same in both, from the sum of those of x.
    pub fn twist(&self, sum: f64) -> f64 {
        if self.twisted { 0.5 * sum } else { 0.0 }
    }

    /// y − Yx and x, whole numbers, so that the greatest terms of a theta function with imaginary part y are those about n = 0.
    ///
    /// Rounding of n·w would show if they were elsewhere; and all that changes is a factor e^{2πi x·v}, that is α by whole turns.
    pub fn reduced(&self, [y1, y2]: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let [[a, b], [_, c]] = self.y;
        let determinant = a * c - b * b;
        let x = [c * y1 - b * y2, a * y2 - b * y1].map(|x| (x / determinant).round());
        ([y1 - a * x[0] - b * x[1], y2 - b * x[0] - c * x[1]], x)
    }
}

/// Where roots are as near as this, as a part of the greatest distance, the rate α loses digits: observed 4e-14 too great at 3e-7.
const DOUBLE: f64 = 1e-5;

/// Longest series for a gap; where it takes more, two roots nearly meet.
const LONGEST_GAP: usize = 1 << 14;

/// With the sign that makes this component positive.
fn upward(vector: [f64; 2], component: usize) -> [f64; 2] {
    let sign = 1.0_f64.copysign(vector[component]);
    vector.map(|x| sign * x)
}

/// The imaginary part of twice the normalized integrals from a real root to one of the two complex ones, straight.
///
/// s = mean + half·cos x.
fn to_the_complex(separation: &Separation, from: usize) -> Option<[f64; 2]> {
    let roots = &separation.roots;
    let to = (0..3).find(|&i| roots[i].imaginary.high() > 0.0)?;
    let other = (0..3).find(|&i| roots[i].imaginary.high() < 0.0)?;
    let half = 0.5 * roots[to].from(&roots[from]);
    let mean_place = separation.over_middle(from) + half;
    let rest: Vec<usize> = (0..5).filter(|i| ![from, to].contains(i)).collect();
    // Distances of the middle from the other three, from differences that are rounded once.
    let apart: Vec<Complex<f64>> = rest
        .iter()
        .map(|&i| {
            if i == other {
                Complex::new(-half.re, 3.0 * half.im)
            } else {
                half - roots[i].from(&roots[from])
            }
        })
        .collect();
    let outer: Complex<f64> = apart.iter().map(|x| x.sqrt()).product();
    let integrals = mean(|x| {
        let ahead = half * x.cos();
        // Each quotient stays on a line through 1, away from the cut of the root.
        let inner: Complex<f64> = apart.iter().map(|x| root(1.0 + ahead / x)).product();
        let value = (outer * inner).inv();
        let next = (mean_place + ahead) * value;
        [value.im, next.im]
    })?;
    Some(separation.normalized(integrals.map(|x| PI * x)))
}

/// The root with a positive real part, straight from the parts: twice as fast as by way of the angle.
fn root(z: Complex<f64>) -> Complex<f64> {
    let norm = (z.re * z.re + z.im * z.im).sqrt();
    let large = (0.5 * (norm + z.re.abs())).sqrt();
    let small = 0.5 * z.im.abs() / large;
    let (re, im) = if z.re < 0.0 {
        (small, large)
    } else {
        (large, small)
    };
    Complex::new(re, im.copysign(z.im))
}
