//! Places of many arguments, one a lane, in pieces without a branch: the compiler lays the lanes out side by side.
//!
//! What [`Modulus::place`] and [`Modulus::triple`] do for one argument, from coefficients that may differ from lane to lane.

pub(crate) mod descent;

use super::crest::{Crest, Hyperbolic, Wave, hyperbolic_at};
use super::jacobi::{Circular, QUARTER_PARTS, circular_at, in_quadrant};
use super::kernel::{self, ROUNDER};
use super::modulus::Modulus;
use super::series::Corrections;
use crate::precise::{DoubleDouble, quick};

/// The greatest count, of quarter periods and of right angles, whose products with the short words are exact.
pub(crate) use super::modulus::EXACT_COUNT;

/// Four polynomials: the denominator and the corrections of sn, cn and dn.
pub(crate) type Polynomials = [[f64; 4]; 4];

/// What a modulus gives to a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Coefficients {
    /// 1/K.
    pub(crate) inverse: f64,
    /// K in three words, of which the first two are short.
    pub(crate) parts: [f64; 3],
    /// π/(2K), or π/(2K′), in two words.
    pub(crate) pace: [f64; 2],
    /// Next to an even multiple of K; on the circular side everywhere.
    pub(crate) even: Polynomials,
    /// Next to an odd one.
    pub(crate) odd: Polynomials,
    /// 2q′^{1/4}.
    pub(crate) root: f64,
    /// √mc.
    pub(crate) complementary_modulus: f64,
}

impl Modulus {
    /// What a lane needs.
    pub(crate) fn coefficients(&self) -> Coefficients {
        let list = |set: &Corrections| [set.denominator, set.sn, set.cn, set.dn];
        Coefficients {
            inverse: self.reduction.inverse,
            parts: self.reduction.parts,
            pace: [self.rate.high(), self.rate.low()],
            even: list(&self.series.even),
            odd: list(&self.series.odd),
            root: self.series.root,
            complementary_modulus: self.series.complementary_modulus,
        }
    }
}

fn corrections([denominator, sn, cn, dn]: Polynomials) -> Corrections {
    Corrections {
        denominator,
        sn,
        cn,
        dn,
    }
}

/// An argument as a number of units and what is left of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rest {
    pub(crate) count: f64,
    /// The count, in the lowest bits.
    pub(crate) bits: u64,
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// `high + low` less the nearest multiple of a unit in three words, at most [`EXACT_COUNT`] of them.
#[inline(always)]
pub(crate) fn reduced([high, low]: [f64; 2], inverse: f64, parts: [f64; 3]) -> Rest {
    let rounded = high * inverse + ROUNDER;
    let count = rounded - ROUNDER;
    // The first difference is exact: its terms are within a factor of two, or the count is zero.
    let first = high - count * parts[0];
    let rest = DoubleDouble::difference(first, count * parts[1]);
    let low = rest.low() + (low - count * parts[2]);
    // In order, unless what is left is so small that it does not matter.
    let (high, low) = quick::ordered_sum(rest.high(), low);
    Rest {
        count,
        bits: rounded.to_bits(),
        high,
        low,
    }
}

/// Times a factor of two words, rounded: half an ulp of an angle, which is less than one.
#[inline(always)]
pub(crate) fn scaled(rest: &Rest, [high, low]: [f64; 2]) -> [f64; 2] {
    [rest.high * high, rest.high * low + rest.low * high]
}

/// Sine and cosine of an angle of two words, at most [`EXACT_COUNT`] right angles.
#[inline(always)]
pub(crate) fn sine_cosine(angle: [f64; 2]) -> (f64, f64) {
    let rest = reduced(angle, core::f64::consts::FRAC_2_PI, QUARTER_PARTS);
    let (sine, cosine) = kernel::sine_cosine(rest.high, rest.low);
    in_quadrant(rest.bits, sine, cosine)
}

/// After as many right angles as the lowest bits say.
#[inline(always)]
pub(crate) fn turned(bits: u64, sine: f64, cosine: f64) -> (f64, f64) {
    in_quadrant(bits, sine, cosine)
}

/// sin and cos of z = πu/(2K), the quarters included.
#[inline(always)]
pub(crate) fn place(bits: u64, [high, low]: [f64; 2]) -> (f64, f64) {
    let (sine, cosine) = kernel::sine_cosine(high, low);
    in_quadrant(bits, sine, cosine)
}

/// sn, cn and dn there.
#[inline(always)]
pub(crate) fn circular(polynomials: Polynomials, sine: f64, cosine: f64) -> [f64; 3] {
    let Circular { sn, cn, dn, .. } = circular_at(&corrections(polynomials), sine, cosine);
    [sn, cn, dn]
}

/// Ones if the number of quarter periods is odd.
#[inline(always)]
pub(crate) fn odd_mask(bits: u64) -> u64 {
    (bits & 1).wrapping_neg()
}

/// `odd` where the bits of the mask are ones, `even` elsewhere.
#[inline(always)]
pub(crate) fn either(mask: u64, odd: f64, even: f64) -> f64 {
    kernel::select(mask, odd, even)
}

/// In which bits two numbers differ, in the shape of a number: with it, [`Choice::of`] is two instructions instead of three.
pub(crate) fn difference_of_bits(a: f64, b: f64) -> f64 {
    f64::from_bits(a.to_bits() ^ b.to_bits())
}

/// A polynomial next to even multiples of K, and the bits by which that next to odd ones differs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Choice {
    pub(crate) even: [f64; 4],
    pub(crate) change: [f64; 4],
}

impl Choice {
    /// The polynomial that belongs there.
    #[inline(always)]
    pub(crate) fn of(&self, mask: u64) -> [f64; 4] {
        let one =
            |k: usize| f64::from_bits(self.even[k].to_bits() ^ (self.change[k].to_bits() & mask));
        [one(0), one(1), one(2), one(3)]
    }
}

/// The hyperbolic functions of a row of lanes.
#[derive(Debug)]
pub(crate) struct Crests<const W: usize> {
    sign: [u64; W],
    sine: [f64; W],
    cosine: [f64; W],
    growth: [f64; W],
    decay: [[f64; W]; 2],
    z: [f64; W],
}

impl<const W: usize> Crests<W> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self {
            sign: [0; W],
            sine: [0.0; W],
            cosine: [0.0; W],
            growth: [0.0; W],
            decay: [[0.0; W]; 2],
            z: [0.0; W],
        }
    }

    /// Those of `high + low`; `root` is 2q′^{1/4}.
    #[inline(always)]
    pub(crate) fn set(&mut self, i: usize, root: f64, [high, low]: [f64; 2]) {
        let Crest { sign, wave, z } = Crest::new(root, high, low);
        self.sign[i] = sign;
        self.sine[i] = wave.sine;
        self.cosine[i] = wave.cosine;
        self.growth[i] = wave.growth;
        self.decay[0][i] = wave.decay[0];
        self.decay[1][i] = wave.decay[1];
        self.z[i] = z;
    }

    #[inline(always)]
    pub(crate) fn get(&self, i: usize) -> Crest {
        Crest {
            sign: self.sign[i],
            wave: Wave {
                sine: self.sine[i],
                cosine: self.cosine[i],
                growth: self.growth[i],
                decay: [self.decay[0][i], self.decay[1][i]],
            },
            z: self.z[i],
        }
    }
}

/// sn, cn and dn there, from the denominator and the corrections.
#[inline(always)]
pub(crate) fn hyperbolic(
    polynomials: [Choice; 4],
    complementary_modulus: f64,
    bits: u64,
    crest: &Crest,
) -> [f64; 3] {
    let mask = odd_mask(bits);
    let [a, b, c, d] = &polynomials;
    let set = corrections([a.of(mask), b.of(mask), c.of(mask), d.of(mask)]);
    let Hyperbolic { sn, cn, dn } = hyperbolic_at(complementary_modulus, &set, bits, crest);
    [sn, cn, dn]
}
