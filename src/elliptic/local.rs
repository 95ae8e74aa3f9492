//! An argument reduced to the nearest multiple of K, and the elementary functions there that everything else is made of.

use super::jacobi::{QUARTER_PARTS, Wave};
use super::kernel::{self, ROUNDER};
use super::modulus::{EXACT_COUNT, Modulus, Side};
use crate::double_double::DoubleDouble;

/// The place of an argument: how many quarter periods, and the elementary functions of what is left.
pub(crate) struct Place {
    /// u = (quarters) K + rest.
    pub(crate) quarters: f64,
    pub(crate) local: Local,
}

/// The elementary functions.
pub(crate) enum Local {
    /// sin and cos of πu/(2K) itself, the quarters included.
    Circular { sine: f64, cosine: f64 },
    /// sinh and cosh of |π rest/(2K′)|, both divided by e^x or nearly so; z = 4 √q′ sinh².
    Hyperbolic { sign: f64, wave: Wave, z: f64 },
}

/// Sine and cosine of an angle of two words.
///
/// For at most 2²⁵ right angles; beyond, the slow way of [`DoubleDouble::sin_cos`], which agrees.
pub(crate) fn sine_cosine(angle: DoubleDouble) -> (f64, f64) {
    let count = (angle.high() * core::f64::consts::FRAC_2_PI + ROUNDER) - ROUNDER;
    if count.abs() > EXACT_COUNT {
        return angle.sin_cos();
    }
    // The first difference is exact: its terms are within a factor of two, or the count is zero.
    let first = angle.high() - count * QUARTER_PARTS[0];
    let rest = DoubleDouble::difference(first, count * QUARTER_PARTS[1]);
    let low = rest.low() + (angle.low() - count * QUARTER_PARTS[2]);
    let rest = DoubleDouble::sum(rest.high(), low);
    let (sine, cosine) = kernel::sine_cosine(rest.high(), rest.low());
    in_quadrant(count, sine, cosine)
}

/// Sine and cosine after as many right angles.
#[inline(always)]
fn in_quadrant(count: f64, sine: f64, cosine: f64) -> (f64, f64) {
    let bits = (count as i64) as u64;
    let odd = (bits & 1).wrapping_neg();
    let s = kernel::select(odd, cosine, sine);
    let c = kernel::select(odd, sine, cosine);
    (
        f64::from_bits(s.to_bits() ^ ((bits & 2) << 62)),
        f64::from_bits(c.to_bits() ^ (((bits ^ (bits << 1)) & 2) << 62)),
    )
}

impl Modulus {
    /// Where the argument lies.
    pub(crate) fn place(&self, u: DoubleDouble) -> Place {
        let (quarters, rest) = self.reduced(u);
        let (high, low) = self.multiplied(rest.high(), rest.low());
        let local = match self.side {
            Side::Circular => {
                let (sine, cosine) = kernel::sine_cosine(high, low);
                let (sine, cosine) = in_quadrant(quarters, sine, cosine);
                Local::Circular { sine, cosine }
            }
            Side::Hyperbolic => {
                let sign = 1.0_f64.copysign(high);
                let wave = Wave::new(high.abs(), low * sign);
                let root_of_z = (self.series.root * wave.growth * wave.sine).min(2.0);
                Local::Hyperbolic {
                    sign,
                    z: root_of_z * root_of_z,
                    wave,
                }
            }
        };
        Place { quarters, local }
    }

    /// The same as [`reduce`](Self::reduce), without a division where the count is exact; the error is a part of u, not of the rest.
    #[inline(always)]
    fn reduced(&self, u: DoubleDouble) -> (f64, DoubleDouble) {
        let reduction = &self.reduction;
        if u.high().abs() > reduction.limit {
            return self.reduce(u);
        }
        let count = (u.high() * reduction.inverse + ROUNDER) - ROUNDER;
        let first = u.high() - count * reduction.parts[0];
        let rest = DoubleDouble::difference(first, count * reduction.parts[1]);
        let low = rest.low() + (u.low() - count * reduction.parts[2]);
        (count, DoubleDouble::sum(rest.high(), low))
    }

    /// sn, cn and dn there.
    pub(crate) fn triple(&self, place: &Place) -> [f64; 3] {
        match &place.local {
            Local::Circular { sine, cosine } => {
                let set = &self.series.even;
                let (s2, c2) = (sine * sine, cosine * cosine);
                let inverse = 1.0 / kernel::polynomial(&set.denominator, s2);
                let sn = c2 * kernel::polynomial(&set.sn, s2) * inverse;
                let cn = s2 * kernel::polynomial(&set.cn, s2) * inverse;
                let dn = s2 * kernel::polynomial(&set.dn, s2) * inverse;
                [
                    (sine + sine * sn).clamp(-1.0, 1.0),
                    cosine + cosine * cn,
                    1.0 + dn,
                ]
            }
            Local::Hyperbolic { sign, wave, z } => {
                let quadrant = (place.quarters as i64) & 3;
                let turn = if quadrant >= 2 { -1.0 } else { 1.0 };
                let least = self.series.complementary_modulus;
                let even = quadrant & 1 == 0;
                let set = if even {
                    &self.series.even
                } else {
                    &self.series.odd
                };
                let inverse = 1.0 / kernel::polynomial(&set.denominator, *z);
                let [s, c, d] = if even {
                    let sech = wave.decay(1.0 / wave.cosine);
                    [wave.sine / wave.cosine, sech, sech]
                } else {
                    let upper = least * wave.growth;
                    [1.0, upper * wave.sine, upper * wave.cosine]
                };
                let sn = (s + s * (kernel::polynomial(&set.sn, *z) * inverse)).min(1.0);
                let cn = c + c * (kernel::polynomial(&set.cn, *z) * inverse);
                let dn = d + d * (kernel::polynomial(&set.dn, *z) * inverse);
                let dn = dn.clamp(least, 1.0);
                if even {
                    [turn * sign * sn, turn * cn, dn]
                } else {
                    [turn * sn, -turn * sign * cn, dn]
                }
            }
        }
    }
}
