//! The Jacobi functions and the amplitude: of a prepared modulus, or from scratch.

use super::landen;
use super::modulus::{Modulus, Reduction};
use super::parameter::{Parameter, Side};
use super::theta::{Corrections, Series};
use crate::error::{Result, within};
use crate::precise::DoubleDouble;
use crate::precise::quick::{self, QUARTER_PARTS, ROUNDER, in_quadrant, polynomial, reduced};

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

impl Modulus {
    /// sn u, cn u, dn u and the amplitude am u, at any argument up to 2⁵³ quarter periods.
    ///
    /// u is reduced by multiples of K in two words, in three where the remainder is unluckily small; then the theta
    /// functions of the smaller nome. m = 0 gives sine, cosine, 1 and u; m = 1 gives tanh, sech, sech and the
    /// Gudermannian, and there is no jump in between. dn is never negative, and below √mc by a rounding at most.
    ///
    /// Error: relative, in units in the last place, over 9700 arguments of the committed table and six like it
    /// (|u| to 10¹⁵, m and mc to 10⁻³⁰⁰, neighbours of multiples of K): sn 4.0, cn 3.6, dn 2.9, am 2.6 at most, with no
    /// allowance for exponentially small values; 3.6·10⁻¹⁶ absolute. am never decreases from one float to the next across
    /// multiples of K.
    ///
    /// Cost: 24–40 ns, beyond 2²⁵ quarter periods 40–50 ns. With unlucky arguments (one in 10⁴ at |u| = 10¹¹, most at 10¹⁵)
    /// 0.2–0.7 µs.
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

    /// sn u, cn u and dn u, to the bit as [`Modulus::jacobi`] gives them, without the amplitude.
    ///
    /// Cost: 16–24 ns, two thirds of the cost with the amplitude.
    ///
    /// # Errors
    ///
    /// If u is not finite, or greater than 2⁵³ quarter periods.
    ///
    /// ```
    /// use spinning_bodies::elliptic::{Modulus, Parameter};
    /// let (sn, cn, dn) = Modulus::new(Parameter::from_parameter(0.64)?).sn_cn_dn(0.7)?;
    /// assert!((sn * sn + cn * cn - 1.0).abs() < 1e-15 && (dn * dn + 0.64 * sn * sn - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn sn_cn_dn(&self, u: f64) -> Result<(f64, f64, f64)> {
        // Inlined here, so that the compiler drops the amplitude.
        let Jacobi { sn, cn, dn, .. } = self.evaluate(u)?;
        Ok((sn, cn, dn))
    }

    #[inline(always)]
    fn evaluate(&self, u: f64) -> Result<Jacobi> {
        if !self.reduction.refuses(u) {
            // The words are in order unless the argument is unlucky. Adding −0 is free, adding +0 is not.
            let Reduction { inverse, parts } = self.reduction;
            let (rounded, [high, low]) = reduced([u, -0.0], inverse, parts);
            // Written so that NaN counts as unlucky.
            if high.abs() >= FEW_BITS_LEFT * u.abs() {
                return Ok(self.at(rounded.to_bits(), rounded - ROUNDER, (high, low)));
            }
        }
        self.long(u)
    }

    /// Arguments beyond 2²⁵ quarter periods, unluckily close to a multiple of K, or out of bounds.
    #[cold]
    fn long(&self, u: f64) -> Result<Jacobi> {
        let greatest = self.greatest_argument();
        let u = within("argument u", u, -greatest, greatest)?;
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
        let quarter = self.quarter_period_dd();
        if quarter.high() == f64::INFINITY {
            return (0.0, u);
        }
        let mut count = (u.high() / quarter.high()).round_ties_even();
        if count == 0.0 {
            return (count, u);
        }
        let mut rest = u - quarter * DoubleDouble::from(count);
        let again = (rest.high() / quarter.high()).round_ties_even();
        if again != 0.0 {
            count += again;
            rest = rest - quarter * DoubleDouble::from(again);
        }
        if rest.high().abs() < FEW_BITS_LEFT * u.high().abs() {
            let finer = landen::remainder(self.parameter, u, count);
            // A top's mc may be below the range of doubles, and then the prepared K is the right one.
            if (finer - rest).high().abs() < SAME_QUARTER * u.high().abs() {
                rest = finer;
            }
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
        match self.side() {
            Side::Circular => {
                // The product stays below 0.8: half an ulp of it is half an ulp of the result.
                let v = high * self.rate.high();
                let v_low = high * self.rate.low() + low * self.rate.high();
                let (sine, cosine) = quick::small_sine_cosine(v, v_low);
                let (s, c) = in_quadrant(bits, sine, cosine);
                let ([sn, cn, dn], ahead) = circular_at(&self.series.corrections, s, c);
                let am = turned(quarters, v, quick::small_arcsine(ahead) + v_low);
                Jacobi { sn, cn, dn, am }
            }
            Side::Hyperbolic => {
                let (v, v_low) = self.multiplied(high, low);
                let odd = bits & 1 != 0;
                let argument = Hyperbolic::new(self.series.root, v, v_low);
                let [sn, cn, dn] = hyperbolic_at(&self.series, bits, &argument);
                let (sine, cosine) = if odd { (cn, sn) } else { (sn, cn) };
                let angle = quick::angle(sine.abs(), cosine.abs());
                let am = turned(quarters, angle.copysign(v), 0.0);
                Jacobi { sn, cn, dn, am }
            }
        }
    }
}

/// sn u, cn u and dn u from scratch, for a modulus that is not used again; to the bit as [`Modulus::jacobi`] gives them.
///
/// Cost: 50–150 ns with [`Parameter::new`], less than [`Modulus::new`] and [`Modulus::sn_cn_dn`] together, since nothing is stored.
///
/// # Errors
///
/// If u is not finite, or greater than 2⁵³ quarter periods.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, sn_cn_dn};
/// // At m = 0 they are sine, cosine and 1.
/// let (sn, cn, dn) = sn_cn_dn(0.5, Parameter::from_parameter(0.0)?)?;
/// assert!((sn - 0.5_f64.sin()).abs() + (cn - 0.5_f64.cos()).abs() < 2e-16 && dn == 1.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn sn_cn_dn(u: f64, parameter: Parameter) -> Result<(f64, f64, f64)> {
    let Jacobi { sn, cn, dn, .. } = Modulus::prepared(parameter).evaluate(u)?;
    Ok((sn, cn, dn))
}

/// If less than this fraction of the argument remains, too few bits are right, and K is taken to 150 bits instead.
/// Both sides agree here: the prepared K, of 101 bits and more, leaves 51 right ones.
const FEW_BITS_LEFT: f64 = 1.0 / (1_u64 << 50) as f64;

/// The most by which two remainders differ, as a fraction of the argument, if both use the same K: the prepared K has 101 bits.
const SAME_QUARTER: f64 = 1.0 / (1_u128 << 96) as f64;

impl Reduction {
    /// Whether an argument has too many quarter periods. NaN passes, and is then found unlucky.
    #[inline(always)]
    pub(super) fn refuses(&self, u: f64) -> bool {
        u.abs() * self.inverse > quick::EXACT_COUNT
    }
}

/// sn, cn and dn from the sine and the cosine of v after a number of quarter turns, and the sine of the amplitude's lead over v.
#[inline(always)]
pub(super) fn circular_at(set: &Corrections, s: f64, c: f64) -> ([f64; 3], f64) {
    let (s2, c2) = (s * s, c * c);
    let inverse = 1.0 / polynomial(&set.denominator, s2);
    let (near, far) = (c2 * inverse, s2 * inverse);
    let sn = near * polynomial(&[set.sn[0], set.sn[1], set.sn[2]], s2);
    let cn = far * polynomial(&[set.cn[0], set.cn[1], set.cn[2]], s2);
    let dn = far * polynomial(&[set.dn[0], set.dn[1], set.dn[2]], s2);
    let functions = [
        quick::lesser(quick::greater(s + s * sn, -1.0), 1.0),
        c + c * cn,
        1.0 + dn,
    ];
    // sin(am − v) = sn cos v − cn sin v, where the leading parts cancel by themselves.
    (functions, s * c * (sn - cn))
}

/// quarters · π/2 + v + ahead, rounded once.
#[inline(always)]
fn turned(quarters: f64, v: f64, ahead: f64) -> f64 {
    // Beyond 2²⁵ quarters the products are inexact: the error of the first is added as a second word, that of the second is
    // far below the last place of the sum.
    let (first, error) = if quarters.abs() <= quick::EXACT_COUNT {
        (quarters * QUARTER_PARTS[0], 0.0)
    } else {
        quick::exact_product(quarters, QUARTER_PARTS[0])
    };
    let sum = DoubleDouble::sum(first, v);
    let all = DoubleDouble::sum(sum.high(), quarters * QUARTER_PARTS[1]);
    let rest = (all.low() + sum.low()) + (error + quarters * QUARTER_PARTS[2] + ahead);
    all.high() + rest
}

/// Beyond m = 1/2: sn, cn and dn from the hyperbolic functions of v, counted from the nearest multiple of K; the two lowest bits count the multiples.
#[inline(always)]
pub(super) fn hyperbolic_at(series: &Series, bits: u64, argument: &Hyperbolic) -> [f64; 3] {
    let odd = (bits & 1).wrapping_neg();
    let Hyperbolic {
        sign, growth, z, ..
    } = argument;
    let (sinh, cosh) = (argument.sine, argument.cosine);
    let set = &series.corrections;
    let [on_sn, on_cn, on_dn] = [&set.sn, &set.cn, &set.dn].map(|p| polynomial(p, *z));
    // A quarter period exchanges the theta functions: dn's becomes the denominator, the denominator dn's, and sn's and cn's change places.
    let [exchanged, on_sn, on_cn, on_dn] = if bits & 1 == 0 {
        [0.0, on_sn, on_cn, on_dn]
    } else {
        [on_dn, on_cn - on_dn, on_sn - on_dn, -on_dn]
    };
    let inverse = 1.0 / (polynomial(&set.denominator, *z) + exchanged);
    let upper = series.complementary_modulus * growth;
    let below = 1.0 / cosh;
    let sech = below * argument.decay[0] * argument.decay[1];
    let s = quick::select(odd, 1.0, sinh / cosh);
    let c = quick::select(odd, upper * sinh, sech);
    let d = quick::select(odd, upper * cosh, sech);
    let sn = s + s * (on_sn * inverse);
    let cn = c + c * (on_cn * inverse);
    let dn = d + d * (on_dn * inverse);
    // Near even multiples sn is odd in v, near odd ones cn is, with the other sign.
    let half = (bits & 2) << 62;
    let sn_sign = half ^ (sign & !odd);
    let cn_sign = half ^ ((sign ^ (1 << 63)) & odd);
    [
        f64::from_bits(quick::lesser(sn, 1.0).to_bits() ^ sn_sign),
        f64::from_bits(cn.to_bits() ^ cn_sign),
        quick::lesser(quick::greater(dn, series.complementary_modulus), 1.0),
    ]
}

/// sinh and cosh of x = |v|, both divided by the power of two 2^j next to e^x.
pub(super) struct Hyperbolic {
    /// The sign of v as a bit.
    pub(super) sign: u64,
    pub(super) sine: f64,
    pub(super) cosine: f64,
    /// 2^j, or the greatest power of two that a double holds.
    pub(super) growth: f64,
    /// 2^−j as a product, so that it may be less than the least double.
    pub(super) decay: [f64; 2],
    /// 4 √q′ sinh² v.
    pub(super) z: f64,
}

impl Hyperbolic {
    /// At v = `high + low`; `root` is 2q′^{1/4}.
    #[inline(always)]
    pub(super) fn new(root: f64, high: f64, low: f64) -> Self {
        const LN2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
        let sign = high.to_bits() & (1 << 63);
        let (high, low) = (high.abs(), f64::from_bits(low.to_bits() ^ sign));
        // Beyond 760 the hyperbolic secant is zero.
        let low = if high > 760.0 { 0.0 } else { low };
        let high = quick::lesser(high, 760.0);
        let rounded = high * core::f64::consts::LOG2_E + ROUNDER;
        let j = rounded - ROUNDER;
        let leading = j * LN2[0] - high;
        let g = leading + j * LN2[1];
        let rest = ((leading - g) + j * LN2[1]) - low;
        let (s, c) = quick::small_hyperbolic(g, rest);
        // 2^−j in two factors, 4^−j, and 2^j: exponents out of range are clamped, where the factor no longer matters.
        let half = (0.5 * j + ROUNDER) - ROUNDER;
        let decay = [
            quick::power_of_two(ROUNDER - half),
            quick::power_of_two(ROUNDER - (j - half)),
        ];
        let tiny = quick::power_of_two(ROUNDER - quick::lesser(2.0 * j, 1022.0));
        // sinh x = (2^j e^−g − 2^−j e^g)/2, and likewise cosh.
        let (less, more) = (1.0 - tiny, 1.0 + tiny);
        let sine = 0.5 * (less + (less * c - more * s));
        let growth = quick::power_of_two(ROUNDER + quick::lesser(j, 1023.0));
        let root = quick::lesser(root * growth * sine, 2.0);
        Self {
            sign,
            sine,
            cosine: 0.5 * (more + (more * c - less * s)),
            growth,
            decay,
            z: root * root,
        }
    }
}
