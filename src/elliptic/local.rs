//! An argument reduced to the nearest multiple of K, and the elementary functions there that everything else is made of.

use super::jacobi::Wave;
use super::kernel;
use super::modulus::{Modulus, Side};
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

impl Modulus {
    /// Where the argument lies.
    pub(crate) fn place(&self, u: DoubleDouble) -> Place {
        let (quarters, rest) = self.reduce(u);
        let (high, low) = self.multiplied(rest.high(), rest.low());
        let local = match self.side {
            Side::Circular => {
                let (sine, cosine) = kernel::sine_cosine(high, low);
                let (sine, cosine) = match (quarters as i64) & 3 {
                    0 => (sine, cosine),
                    1 => (cosine, -sine),
                    2 => (-sine, -cosine),
                    _ => (-cosine, sine),
                };
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
