//! The Jacobi functions and the amplitude.

use super::crest::{Hyperbolic, hyperbolic};
use super::kernel;
use super::kernel::ROUNDER;
use super::modulus::{COUNTABLE, Modulus, Reduction, Side};
use super::parameter::Parameter;
use super::quarter;
use super::series::{Corrections, Series};
use crate::error::{Error, Result, finite};
use crate::precise::{DoubleDouble, quick};

/// The three Jacobi functions and the amplitude at one argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobi {
    /// sn u = sin am u.
    pub sn: f64,
    /// cn u = cos am u.
    pub cn: f64,
    /// dn u = √(1 − m sn² u), never negative.
    pub dn: f64,
    /// The amplitude am u, in radians: grows by π with each 2K.
    pub am: f64,
}

/// π/2 in three words, of which the first two are so short that a count times either is exact.
pub(super) const QUARTER_PARTS: [f64; 3] = [
    1.570_796_310_901_641_8,
    1.589_325_471_229_585_7e-8,
    6.123_233_995_736_766e-17,
];

impl Modulus {
    /// sn u, cn u, dn u and the amplitude am u, at any argument up to 2⁵³ quarter periods.
    ///
    /// u is reduced by multiples of K in two words, in three where the remainder is unluckily small; then the theta
    /// functions of the smaller nome. m = 0 gives sine, cosine, 1 and u; m = 1 gives tanh, sech, sech and the
    /// Gudermannian, and there is no jump in between. dn is never negative and never below √mc.
    ///
    /// Error: relative, in units in the last place, over 9700 arguments of the committed table and six like it
    /// (|u| to 10¹⁵, m and mc to 10⁻³⁰⁰, neighbours of multiples of K): sn 4.0, cn 3.2, dn 2.9, am 2.6 at most, with no
    /// allowance for exponentially small values; 2.8·10⁻¹⁶ absolute. am does not fall over successive floats across
    /// multiples of K.
    ///
    /// Cost: 37–66 ns. Beyond 2²⁵ quarter periods 60–90 ns, unlucky arguments (one in 10⁴ at |u| = 10¹¹, most at 10¹⁵)
    /// 2–5 µs.
    ///
    /// # Errors
    ///
    /// If u is not finite, or greater than 2⁵³ quarter periods.
    ///
    /// ```
    /// use spinning_bodies::elliptic::{Modulus, Parameter};
    /// let modulus = Modulus::new(Parameter::from_parameter(0.5)?);
    /// let at = modulus.jacobi(modulus.quarter_period() / 2.0)?;
    /// // sn²(K/2) = 1/(1 + √mc).
    /// assert!((at.sn * at.sn - 1.0 / (1.0 + 0.5f64.sqrt())).abs() < 4e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn jacobi(&self, u: f64) -> Result<Jacobi> {
        self.evaluate(u)
    }

    /// sn u, cn u and dn u, the very values of [`Modulus::jacobi`], without the amplitude.
    ///
    /// Cost: 27–37 ns, two thirds of what it is with the amplitude.
    ///
    /// # Errors
    ///
    /// If u is not finite, or greater than 2⁵³ quarter periods.
    pub fn sn_cn_dn(&self, u: f64) -> Result<(f64, f64, f64)> {
        // Written out in place, so that the compiler leaves the amplitude away.
        let Jacobi { sn, cn, dn, .. } = self.evaluate(u)?;
        Ok((sn, cn, dn))
    }

    /// `high + low` times the rate, the product rounded: on the circular side, where it stays below 0.8, half an
    /// ulp of the angle is half an ulp of the result.
    #[inline(always)]
    pub(super) fn turned_by(&self, high: f64, low: f64) -> (f64, f64) {
        let product = high * self.rate.high();
        (product, high * self.rate.low() + low * self.rate.high())
    }

    #[inline(always)]
    fn evaluate(&self, u: f64) -> Result<Jacobi> {
        if !self.reduction.refuses(u) {
            let Reduced {
                rounded,
                high,
                low,
                unlucky,
            } = self.reduction.apply(u);
            if !unlucky {
                let rest = (high, low);
                return Ok(self.at(rounded.to_bits(), rounded - ROUNDER, rest));
            }
        }
        self.long(u)
    }

    /// Arguments beyond 2²⁵ quarter periods, unluckily close to one, or out of bounds.
    #[cold]
    fn long(&self, u: f64) -> Result<Jacobi> {
        let u = finite("argument u", u)?;
        let greatest = COUNTABLE * self.quarter.high();
        if u.abs() > greatest {
            return Err(Error::OutOfRange {
                quantity: "argument u",
                value: u,
                least: -greatest,
                greatest,
            });
        }
        Ok(self.jacobi_dd(DoubleDouble::from(u)))
    }

    /// The functions at an argument of 106 bits, not beyond 2⁵³ quarter periods.
    pub(crate) fn jacobi_dd(&self, u: DoubleDouble) -> Jacobi {
        let (quarters, rest) = self.reduce(u);
        let rest = (rest.high(), rest.low());
        self.at(quarters as i64 as u64, quarters, rest)
    }

    /// u = (quarters) K + rest with |rest| ≤ K/2 and a little more.
    pub(crate) fn reduce(&self, u: DoubleDouble) -> (f64, DoubleDouble) {
        if self.quarter.high() == f64::INFINITY {
            return (0.0, u);
        }
        let mut count = (u.high() / self.quarter.high()).round_ties_even();
        if count == 0.0 {
            return (count, u);
        }
        let mut rest = u - self.quarter * DoubleDouble::from(count);
        let again = (rest.high() / self.quarter.high()).round_ties_even();
        if again != 0.0 {
            count += again;
            rest = rest - self.quarter * DoubleDouble::from(again);
        }
        if rest.high().abs() < FEW_BITS_LEFT * u.high().abs() {
            rest = quarter::remainder(self.parameter, u, count);
        }
        (count, rest)
    }

    /// `high + low` times the rate.
    #[inline(always)]
    pub(super) fn multiplied(&self, high: f64, low: f64) -> (f64, f64) {
        let (product, error) = quick::exact_product(high, self.rate.high());
        let low = error + (high * self.rate.low() + low * self.rate.high());
        (product, low)
    }

    #[inline(always)]
    fn at(&self, bits: u64, quarters: f64, (high, low): (f64, f64)) -> Jacobi {
        match self.side {
            Side::Circular => {
                let (v, v_low) = self.turned_by(high, low);
                let Circular { sn, cn, dn, ahead } = circular(&self.series, bits, v, v_low);
                let ahead = kernel::small_arcsine(ahead) + v_low;
                Jacobi {
                    sn,
                    cn,
                    dn,
                    am: turned(quarters, v, ahead),
                }
            }
            Side::Hyperbolic => {
                let (v, v_low) = self.multiplied(high, low);
                let series = if bits & 1 == 0 {
                    &self.series.even
                } else {
                    &self.series.odd
                };
                let Hyperbolic { sn, cn, dn } = hyperbolic(&self.series, series, bits, v, v_low);
                let angle = if bits & 1 == 0 {
                    kernel::angle(sn.abs(), cn.abs())
                } else {
                    kernel::angle(cn.abs(), sn.abs())
                };
                Jacobi {
                    sn,
                    cn,
                    dn,
                    am: turned(quarters, angle.copysign(v), 0.0),
                }
            }
        }
    }
}

/// sn u, cn u and dn u of a modulus that is not used again: the very values of [`Modulus::jacobi`].
///
/// Cost: 107–250 ns, less than [`Modulus::new`] and [`Modulus::sn_cn_dn`] together, since nothing is stored.
///
/// # Errors
///
/// If u is not finite, or greater than 2⁵³ quarter periods.
pub fn sn_cn_dn(u: f64, parameter: Parameter) -> Result<(f64, f64, f64)> {
    let Jacobi { sn, cn, dn, .. } = Modulus::prepared(parameter).evaluate(u)?;
    Ok((sn, cn, dn))
}

/// A remainder with less of the argument left than this is too short in bits, and K is taken to 150 bits instead.
/// Both sides agree here: the prepared K, of 101 bits and more, leaves 51 right ones.
const FEW_BITS_LEFT: f64 = 1.0 / (1_u64 << 50) as f64;

/// An argument less a count of quarter periods.
pub(super) struct Reduced {
    /// The count with [`ROUNDER`] added.
    pub(super) rounded: f64,
    pub(super) high: f64,
    pub(super) low: f64,
    pub(super) unlucky: bool,
}

impl Reduction {
    /// Whether an argument has too many quarter periods. One that is not a number comes out unlucky.
    #[inline(always)]
    pub(super) fn refuses(&self, u: f64) -> bool {
        u.abs() > self.limit
    }

    #[inline(always)]
    pub(super) fn apply(&self, u: f64) -> Reduced {
        let rounded = u * self.inverse + ROUNDER;
        let count = rounded - ROUNDER;
        // The first difference is exact: its terms are within a factor of two, or the count is zero.
        let first = u - count * self.parts[0];
        let rest = DoubleDouble::difference(first, count * self.parts[1]);
        // In order, unless the argument is unlucky.
        let (high, low) = quick::ordered_sum(rest.high(), rest.low() - count * self.parts[2]);
        // So written that not-a-number is unlucky.
        let lucky = high.abs() >= FEW_BITS_LEFT * u.abs();
        Reduced {
            rounded,
            high,
            low,
            unlucky: !lucky,
        }
    }
}

pub(super) struct Circular {
    pub(super) sn: f64,
    pub(super) cn: f64,
    pub(super) dn: f64,
    /// Sine of what the amplitude is ahead of v by.
    pub(super) ahead: f64,
}

/// The functions at v = `high + low` after as many quarter turns as the lowest bits say.
#[inline(always)]
pub(super) fn circular(series: &Series, bits: u64, high: f64, low: f64) -> Circular {
    let (sine, cosine) = kernel::sine_cosine(high, low);
    let (s, c) = in_quadrant(bits, sine, cosine);
    circular_at(&series.even, s, c)
}

const SIGN: u64 = 1 << 63;

/// Sine and cosine after as many right angles as the lowest bits say.
#[inline(always)]
pub(crate) fn in_quadrant(bits: u64, sine: f64, cosine: f64) -> (f64, f64) {
    let odd = (bits & 1).wrapping_neg();
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    // Exchanged by the bits in which they differ.
    let exchange = (s ^ c) & odd;
    // Quadrants 2 and 3 turn the sign of the sine, 1 and 2 that of the cosine.
    let sign = (bits << 62) & SIGN;
    (
        f64::from_bits(s ^ exchange ^ sign),
        f64::from_bits(c ^ exchange ^ sign ^ (bits << 63)),
    )
}

/// The functions from the sine and the cosine of v.
#[inline(always)]
pub(super) fn circular_at(set: &Corrections, s: f64, c: f64) -> Circular {
    let (s2, c2) = (s * s, c * c);
    let inverse = 1.0 / kernel::polynomial(&set.denominator, s2);
    let (near, far) = (c2 * inverse, s2 * inverse);
    let sn = near * kernel::polynomial(&[set.sn[0], set.sn[1], set.sn[2]], s2);
    let cn = far * kernel::polynomial(&[set.cn[0], set.cn[1], set.cn[2]], s2);
    let dn = far * kernel::polynomial(&[set.dn[0], set.dn[1], set.dn[2]], s2);
    Circular {
        sn: kernel::lesser(kernel::greater(s + s * sn, -1.0), 1.0),
        cn: c + c * cn,
        dn: 1.0 + dn,
        // sin(am − v) = sn cos v − cn sin v, where the leading parts cancel by themselves.
        ahead: s * c * (sn - cn),
    }
}

/// quarters · π/2 + v + ahead, rounded once.
#[inline(always)]
fn turned(quarters: f64, v: f64, ahead: f64) -> f64 {
    // Beyond 2²⁵ quarters the first two products are inexact, but then far below the last place of the sum: the
    // second word makes it up.
    let (first, error) = if quarters.abs() <= 33_554_432.0 {
        (quarters * QUARTER_PARTS[0], 0.0)
    } else {
        quick::exact_product(quarters, QUARTER_PARTS[0])
    };
    let sum = DoubleDouble::sum(first, v);
    let second = quarters * QUARTER_PARTS[1];
    let (sum, rest) = {
        let all = DoubleDouble::sum(sum.high(), second);
        (all.high(), all.low() + sum.low())
    };
    sum + (rest + (error + quarters * QUARTER_PARTS[2] + ahead))
}
