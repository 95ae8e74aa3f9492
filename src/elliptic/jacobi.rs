//! The Jacobi functions and the amplitude.

use super::kernel;
use super::modulus::{Modulus, Series, Side};
use super::quarter;
use crate::double_double::DoubleDouble;
use crate::error::{Error, Result, finite};

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

/// π/2 to 106 bits.
const QUARTER: DoubleDouble =
    DoubleDouble::new(core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);

/// The greatest number of quarter periods that a double counts.
const COUNTABLE: f64 = 9_007_199_254_740_992.0;

impl Modulus {
    /// sn u, cn u, dn u and am u.
    ///
    /// # Errors
    ///
    /// If u is not finite, or greater than 2⁵³ quarter periods.
    pub fn jacobi(&self, u: f64) -> Result<Jacobi> {
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
        let argument = rest.multiply(self.rate);
        match self.side {
            Side::Circular => self.circular(quarters, argument),
            Side::Hyperbolic => self.hyperbolic(quarters, argument),
        }
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
        let mut rest = u.subtract(self.quarter.multiply(DoubleDouble::from(count)));
        let again = (rest.high() / self.quarter.high()).round_ties_even();
        if again != 0.0 {
            count += again;
            rest = rest.subtract(self.quarter.multiply(DoubleDouble::from(again)));
        }
        // Both sides agree here: a rest above this has 52 bits and more that are right.
        const FEW_BITS_LEFT: f64 = 1.0 / (1_u64 << 52) as f64;
        if rest.high().abs() < FEW_BITS_LEFT * u.high().abs() {
            rest = quarter::remainder(self.parameter, u, count);
        }
        (count, rest)
    }

    fn circular(&self, quarters: f64, v: DoubleDouble) -> Jacobi {
        let (sine, cosine) = kernel::sine_cosine(v.high(), v.low());
        let (s, c) = match (quarters as i64) & 3 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
        let series = &self.series;
        let (s2, c2) = (s * s, c * c);
        let inverse = 1.0 / cubic(&series.even, s2);
        let sn = c2 * cubic(&series.sn, s2) * inverse;
        let cn = s2 * cubic(&series.cn, s2) * inverse;
        let dn = s2 * cubic(&series.dn, s2) * inverse;
        // sin(am − v) = sn cos v − cn sin v, where the leading parts cancel by themselves.
        let ahead = (s * c * (sn - cn)).asin();
        Jacobi {
            sn: (s + s * sn).clamp(-1.0, 1.0),
            cn: c + c * cn,
            dn: 1.0 + dn,
            am: turned(quarters, v, ahead),
        }
    }

    fn hyperbolic(&self, quarters: f64, x: DoubleDouble) -> Jacobi {
        let sign = 1.0_f64.copysign(x.high());
        let x = x.scaled(sign);
        let wave = Wave::new(x);
        let Series {
            root,
            complementary_modulus,
            ..
        } = self.series;
        let series = &self.series;
        let z = (root * wave.growth() * wave.sine).min(2.0);
        let z = z * z;
        let quadrant = (quarters as i64) & 3;
        let turn = if quadrant >= 2 { -1.0 } else { 1.0 };
        if quadrant & 1 == 0 {
            let inverse = 1.0 / cubic(&series.even, z);
            let tanh = wave.sine / wave.cosine;
            let sech = wave.decay() / wave.cosine;
            let sn = (tanh + tanh * (cubic(&series.sn, z) * inverse)).min(1.0);
            let cn = sech + sech * (cubic(&series.cn, z) * inverse);
            let dn = (sech + sech * (cubic(&series.dn, z) * inverse)).min(1.0);
            Jacobi {
                sn: turn * sign * sn,
                cn: turn * cn,
                dn,
                am: turned(quarters, DoubleDouble::from(0.0), sign * sn.atan2(cn)),
            }
        } else {
            let inverse = 1.0 / cubic(&series.odd, z);
            let sine = complementary_modulus * wave.growth() * wave.sine;
            let cosine = complementary_modulus * wave.growth() * wave.cosine;
            let sn = (1.0 + cubic(&series.sn_odd, z) * inverse).min(1.0);
            let cn = sine + sine * (cubic(&series.cn_odd, z) * inverse);
            let dn = cosine + cosine * (cubic(&series.dn_odd, z) * inverse);
            Jacobi {
                sn: turn * sn,
                cn: -turn * sign * cn,
                dn: dn.max(complementary_modulus),
                am: turned(quarters, DoubleDouble::from(0.0), sign * cn.atan2(sn)),
            }
        }
    }
}

#[inline(always)]
fn cubic(a: &[f64; 4], x: f64) -> f64 {
    ((a[3] * x + a[2]) * x + a[1]) * x + a[0]
}

/// quarters · π/2 + v + ahead, rounded once.
fn turned(quarters: f64, v: DoubleDouble, ahead: f64) -> f64 {
    if quarters == 0.0 && v.high() == 0.0 {
        return ahead + v.high();
    }
    QUARTER
        .multiply(DoubleDouble::from(quarters))
        .add(v)
        .add(DoubleDouble::from(ahead))
        .value()
}

/// sinh x and cosh x for x ≥ 0, both divided by the power of two 2^j next to e^x.
struct Wave {
    sine: f64,
    cosine: f64,
    exponent: i32,
}

impl Wave {
    fn new(x: DoubleDouble) -> Self {
        // Beyond 760 the hyperbolic secant is zero.
        let (high, low) = if x.high() > 760.0 {
            (760.0, 0.0)
        } else {
            (x.high(), x.low())
        };
        const LN2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
        let j = (high * core::f64::consts::LOG2_E).round_ties_even();
        let leading = j * LN2[0] - high;
        let g = leading + j * LN2[1];
        let rest = ((leading - g) + j * LN2[1]) - low;
        let (s, c) = kernel::hyperbolic(g, rest);
        let exponent = j as i32;
        let tiny = 0.5_f64.powi(2 * exponent);
        // sinh x = (2^j e^−g − 2^−j e^g)/2, and likewise cosh.
        let (less, more) = (1.0 - tiny, 1.0 + tiny);
        Self {
            sine: 0.5 * (less + (less * c - more * s)),
            cosine: 0.5 * (more + (more * c - less * s)),
            exponent,
        }
    }

    /// 2^j, or so much of it as a double holds.
    fn growth(&self) -> f64 {
        2.0_f64.powi(self.exponent.min(1023))
    }

    /// 2^−j.
    fn decay(&self) -> f64 {
        let half = self.exponent / 2;
        0.5_f64.powi(half) * 0.5_f64.powi(self.exponent - half)
    }
}
