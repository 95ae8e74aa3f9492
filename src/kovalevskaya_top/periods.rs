//! The period matrix of the curve w² = P(s), and the point on it that belongs to the vertical (8.2).

use super::constants::{Complex, Constants};
use super::separation::{Separation, beside};
use crate::precise::{DoubleDouble, Number as _};

/// A half period ½(n + τm) of the curve, with n and m modulo 2.
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

    /// The sum, modulo whole periods.
    pub fn plus(self, other: Self) -> Self {
        let sum = |a: [u8; 2], b: [u8; 2]| [a[0] ^ b[0], a[1] ^ b[1]];
        Self {
            n: sum(self.n, other.n),
            m: sum(self.m, other.m),
        }
    }
}

/// The four m of the half periods ½(n + τm).
pub(super) const MEASURES: [[u8; 2]; 4] = [[0, 0], [0, 1], [1, 0], [1, 1]];

/// The period matrix τ and points on the torus, in turns of the two phases.
///
/// The two integrals are normalized: the first gains 1 as s₁ goes round its interval and 0 as s₂ does, the second 0 and 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    /// Y = Im τ.
    pub y: [[f64; 2]; 2],
    /// Re τ: ½ everywhere if two roots are complex, and 0 otherwise.
    pub real: f64,
    /// The half periods from ∞ to the roots e₁ … e₅.
    pub roots: [Half; 5],
    /// Turns of the phases a unit of time, halved.
    pub advance: [DoubleDouble; 2],
    /// The half period with which θ vanishes where s₁ or s₂ is infinite, counted from s₁ = A and s₂ = C.
    pub infinite: Half,
}

impl Curve {
    // ANCHOR: curve
    /// From −∞ the real line has in turn the cut of s₂, a gap, a cut, and if all roots are real another gap and another cut; integrals over the gaps give τ. `None` if the half periods do not fit.
    pub fn prepare(separation: &Separation) -> Option<Self> {
        let real = &separation.real;
        let [a, _, c] = separation.ends;
        // s₁ moves on the second cut or on the third.
        let far = real[1] != a;
        let over_gap = |from: usize, to: usize, sign: usize| {
            let whole = across(separation, real[from], separation.apart[to]);
            let sign = 1.0_f64.copysign(whole[sign].im);
            whole.map(|x| x * sign)
        };
        let gap = || over_gap(0, real[1], 1).map(|x| x.im);
        let plus = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        // The upper one of two complex roots, and the number of real ones to its left: only if that is 1, the root lies opposite the first gap.
        let mut pair = Half::default();
        let [first, second] = if let Some(upper) = separation.upper() {
            let left = |i: &&usize| separation.apart[upper][**i].re > 0.0;
            let left = real.iter().filter(left).count();
            let (from, sign) = [(0, 1), (1, 0), (1, 0), (2, 0)][left];
            let whole = over_gap(from, upper, sign);
            // The integral to it contains half of a column of τ, and real parts of a quarter.
            let n = whole.map(|x| (x.re - 0.5).round().rem_euclid(2.0) as u8);
            let m = [1 - sign as u8, sign as u8];
            pair = to(far, from).plus(Half { n, m });
            let column = whole.map(|x| x.im);
            match left {
                0 => [plus(column, gap().map(|x| -x)), column],
                1 => [column, over_gap(0, upper, 1).map(|x| x.im)],
                _ => [column, plus(column, gap())],
            }
        } else {
            let first = over_gap(2, real[3], 0).map(|x| x.im);
            [first, if far { gap() } else { plus(first, gap()) }]
        };
        // The complex ones are e₂ and e₃.
        let mut roots = [pair; 5];
        roots[2] = pair.plus(Half::along([1, 1]));
        for (place, root) in real.iter().enumerate() {
            roots[*root] = to(far, place);
        }
        // The half period that is odd, together with all of its sums with those of the roots.
        let odd = |half: Half| (half.n[0] & half.m[0]) ^ (half.n[1] & half.m[1]) == 1;
        let all = MEASURES
            .iter()
            .flat_map(|&n| MEASURES.map(|m| Half { n, m }));
        let constant = all
            .into_iter()
            .find(|&half| odd(half) && roots.iter().all(|&r| odd(half.plus(r))))?;
        Some(Self {
            y: [[first[0], first[1]], [first[1], second[1]]],
            real: if real.len() < 5 { 0.5 } else { 0.0 },
            roots,
            advance: separation.frequencies().map(|n| n.scaled(0.5)),
            infinite: constant.plus(roots[a]).plus(roots[c]),
        })
    }
    // ANCHOR_END: curve

    /// Half of the integrals from ∞ to Z, for phases counted from s₁ = A and s₂ = C.
    ///
    /// Z lies in a gap between s₂ and s₁.
    pub fn point(&self, separation: &Separation) -> [Complex; 2] {
        let real = &separation.real;
        let over = |root: usize| -separation.apart[root][5].re;
        // The gap in which Z lies.
        let far = real[1] != separation.ends[0];
        let base = 2 * usize::from(far && over(real[2]) > -over(real[1]));
        // From the nearer end, or from the end on this side of the complex roots; the sign of the square root stays open until the half periods are chosen.
        let upper = separation.upper();
        let from = separation.apart[real[base + 1]];
        let middle = upper.map_or(0.5 * from[real[base]].re, |upper| from[upper].re);
        let nearer = base + usize::from(-over(real[base + 1]) < middle);
        let place = beside(separation.apart.map(|row| -row[5]));
        let inside = across(separation, real[nearer], place);
        let Half { n, m } = self.roots[real[nearer]].plus(self.roots[4]);
        let across = self.tau(m.map(f64::from));
        // Plus a quarter turn of each phase, because v is counted from s₁ = A and s₂ = C.
        [0, 1].map(|i| 0.25 * (across[i] + Complex::new(1.0 + f64::from(n[i]), inside[i].im)))
    }

    /// α up to whole turns of v: l − ½ of the mean of N/((s₁−s)(s₂−s)), where s is that of Z.
    ///
    /// A₊′ = 2l − N/((s₁−s)(s₂−s)) − d arg R/dt with a function R of the state, and the mean consists of two integrals of the third kind, one in s₁ and one in s₂.
    pub fn rate(constants: &Constants, separation: &Separation) -> DoubleDouble {
        constants.l - (separation.residue * separation.third_kind()).scaled(0.5)
    }

    /// τx.
    pub fn tau(&self, x: [f64; 2]) -> [Complex; 2] {
        let real = self.real * (x[0] + x[1]);
        let imaginary = self.y.map(|row| row[0] * x[0] + row[1] * x[1]);
        imaginary.map(|y| Complex::new(real, y))
    }

    /// Y⁻¹y.
    pub fn along(&self, [y1, y2]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [_, c]] = self.y;
        let determinant = a * c - b * b;
        [c * y1 - b * y2, a * y2 - b * y1].map(|x| x / determinant)
    }
}

/// Twice the normalized integrals from a root to a place.
fn across(separation: &Separation, from: usize, mut place: [Complex; 6]) -> [Complex; 2] {
    if place[from].norm() == 0.0 {
        return [Complex::default(); 2];
    }
    // Z does not enter.
    place[5] = f64::INFINITY.into();
    let [a, b, _] = separation.straight(from, &(place, 1.0));
    let [real, imaginary] = [0, 1].map(|part| {
        separation
            .normalized([a[part], b[part]])
            .map(|x| 2.0 * x.value())
    });
    [0, 1].map(|i| Complex::new(real[i], imaginary[i]))
}

/// The half period from ∞ to the real root number `place` from below: the sum over the cuts and gaps passed.
fn to(far: bool, place: usize) -> Half {
    let steps = [
        Half::along([0, 1]),
        Half::across(if far { [0, 1] } else { [1, 1] }),
        Half::along(if far { [1, 1] } else { [1, 0] }),
        Half::across([1, 0]),
        Half::along(if far { [1, 0] } else { [1, 1] }),
    ];
    steps[..=place]
        .iter()
        .fold(Half::default(), |sum, step| sum.plus(*step))
}
