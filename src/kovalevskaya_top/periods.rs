//! The rest of the curve w² = P(s): its period matrix, and the point that the vertical belongs to (8.2).

use nalgebra::Complex;

use super::constants::{Constants, Root};
use super::separation::Separation;

type Number = Complex<f64>;

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
    /// Z is where s = l² − l₁, P(s) = −l²(m²−k²)²/4 with m = 3l₁ − 2l²; it lies in a gap between s₂ and s₁. None beside a double root.
    pub fn prepare(constants: &Constants, separation: &Separation) -> Option<Self> {
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
        let apart = separation.apart();
        let imaginary = |from: usize, to: &[Number; 5]| {
            // From the real root next to it, either complex one is seen under the way at no more than a right angle.
            let step = if twisted { 0.25 } else { 0.5 };
            let integrals = straight(separation, &apart[from], from, to, step);
            separation.normalized(integrals.map(|x| 2.0 * x.im))
        };
        let over_gap =
            |from: usize, to: usize, sign: usize| upward(imaginary(real[from], &apart[to]), sign);
        let plus = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        let across = || over_gap(0, real[1], 1);
        // The upper one of two complex roots, and how many real ones are to its left: only where that is one it is seen under the near gap.
        let upper = (0..5).find(|&i| separation.roots[i].imaginary.high() > 0.0);
        let left = upper.map(|upper| real.iter().filter(|&&i| apart[upper][i].re > 0.0).count());
        let [first, second] = match upper.zip(left) {
            None => {
                let [first, near] = [over_gap(2, real[3], 0), across()];
                [first, if far { near } else { plus(first, near) }]
            }
            Some((upper, 0)) => {
                let second = over_gap(0, upper, 1);
                [plus(second, across().map(|x| -x)), second]
            }
            Some((upper, 1)) => [over_gap(1, upper, 0), over_gap(0, upper, 1)],
            Some((upper, left)) => {
                let first = over_gap(left - 1, upper, 0);
                [first, plus(first, across())]
            }
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
        // From the end that is nearer, or on this side of the complex roots; which sign the roots have is open as long as the half periods are.
        let middle = 0.5 * apart[real[base + 1]][real[base]].re;
        let middle = upper.map_or(middle, |upper| apart[real[base + 1]][upper].re);
        let nearer = base + usize::from(-over(real[base + 1]) < middle);
        let z = separation.roots.map(|root| Root::on_axis(s).from(&root));
        let inside = imaginary(real[nearer], &z);
        let Half { n, m } = to(nearer).plus(to(place(4)?));
        let twist = if twisted { 0.5 } else { 0.0 };
        let [n, m] = [n, m].map(|x| x.map(f64::from));
        let point = [
            // A quarter of a turn of each besides: v is counted from where s₁ = A and s₂ = C.
            [0, 1].map(|i| 0.25 * (1.0 + n[i] + twist * (m[0] + m[1]))),
            [0, 1].map(|i| 0.25 * inside[i] + 0.25 * (y[i][0] * m[0] + y[i][1] * m[1])),
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

/// Where roots are as near as this, as a part of the greatest distance, the theta functions are small against their terms: observed 1e-12 rad at 1e-11.
const DOUBLE: f64 = 1e-10;

/// With the sign that makes this component positive.
fn upward(vector: [f64; 2], component: usize) -> [f64; 2] {
    let sign = 1.0_f64.copysign(vector[component]);
    vector.map(|x| sign * x)
}

/// ∫ds/√P and ∫(s−σ)ds/√P straight from a root to a place, of which the distances from all roots are given.
///
/// With s = (root + e^x place)/(1 + e^x) every root beyond the ends is at Im x = ±π, however near it is to an end, and one that sees the way at an angle φ at ±(π−φ): the
/// trapezoidal rule errs by e^{−2π(π−φ)/step}, and what is left out is e^{−40}. Each s − e is a sum of two distances of one sign, rounded once.
fn straight(
    separation: &Separation,
    start: &[Number; 5],
    from: usize,
    place: &[Number; 5],
    step: f64,
) -> [Number; 2] {
    let (first, length) = (separation.over_middle(from), place[from]);
    let (mut sums, mut last) = ([Number::default(); 2], Number::default());
    let most = (80.0 / step) as i32;
    for n in -most..=most {
        let g = (step * f64::from(n)).exp();
        let [near, far] = [1.0 / (1.0 + g), g / (1.0 + g)];
        let product: Number = start
            .iter()
            .zip(place)
            .map(|(u, t)| u * near + t * far)
            .product();
        // The root that continues the one before.
        let next = root(product);
        last = if (next * last.conj()).re < 0.0 {
            -next
        } else {
            next
        };
        // √P = 2i√Π(s−e).
        let value = length * (near * far) / (last * Number::new(0.0, 2.0));
        sums[0] += value;
        sums[1] += value * (first + length * far);
    }
    sums.map(|sum| sum * step)
}

/// The root with a positive real part, straight from the parts: twice as fast as by way of the angle.
fn root(z: Number) -> Number {
    let norm = (z.re * z.re + z.im * z.im).sqrt();
    let large = (0.5 * (norm + z.re.abs())).sqrt();
    let small = 0.5 * z.im.abs() / large;
    let (re, im) = if z.re < 0.0 {
        (small, large)
    } else {
        (large, small)
    };
    Number::new(re, im.copysign(z.im))
}
