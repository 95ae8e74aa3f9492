//! An argument reduced to the nearest multiple of K, and the elementary functions there that everything else is made of.

use super::jacobi::{Wave, cubic};
use super::kernel;
use super::modulus::{Modulus, Side};
use crate::double_double::DoubleDouble;

/// The place of an argument: how many quarter periods, and the elementary functions of what is left.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// u = (quarters) K + rest.
    pub(crate) quarters: f64,
    pub(crate) local: Local,
}

/// The elementary functions.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Local {
    /// sin and cos of πu/(2K) itself, the quarters included.
    Circular { sine: f64, cosine: f64 },
    /// sinh and cosh of |π rest/(2K′)|, both divided by e^x or nearly so; z = 4 √q′ sinh².
    Hyperbolic {
        sign: f64,
        sine: f64,
        cosine: f64,
        growth: f64,
        decay: f64,
        z: f64,
    },
}

impl Modulus {
    /// Where the argument lies.
    pub(crate) fn place(&self, u: DoubleDouble) -> Place {
        let (quarters, rest) = self.reduce(u);
        let v = rest.multiply(self.rate);
        let local = match self.side {
            Side::Circular => {
                let (sine, cosine) = kernel::sine_cosine(v.high(), v.low());
                let (sine, cosine) = match (quarters as i64) & 3 {
                    0 => (sine, cosine),
                    1 => (cosine, -sine),
                    2 => (-sine, -cosine),
                    _ => (-cosine, sine),
                };
                Local::Circular { sine, cosine }
            }
            Side::Hyperbolic => {
                let sign = 1.0_f64.copysign(v.high());
                let wave = Wave::new(v.scaled(sign));
                let (growth, decay) = (wave.growth(), wave.decay());
                let root_of_z = (self.series.root * growth * wave.sine).min(2.0);
                Local::Hyperbolic {
                    sign,
                    sine: wave.sine,
                    cosine: wave.cosine,
                    growth,
                    decay,
                    z: root_of_z * root_of_z,
                }
            }
        };
        Place { quarters, local }
    }

    /// sn, cn and dn there.
    pub(crate) fn triple(&self, place: &Place) -> [f64; 3] {
        let series = &self.series;
        match place.local {
            Local::Circular { sine, cosine } => {
                let (s2, c2) = (sine * sine, cosine * cosine);
                let inverse = 1.0 / cubic(&series.even, s2);
                let sn = c2 * cubic(&series.sn, s2) * inverse;
                let cn = s2 * cubic(&series.cn, s2) * inverse;
                let dn = s2 * cubic(&series.dn, s2) * inverse;
                [
                    (sine + sine * sn).clamp(-1.0, 1.0),
                    cosine + cosine * cn,
                    1.0 + dn,
                ]
            }
            Local::Hyperbolic {
                sign,
                sine,
                cosine,
                growth,
                decay,
                z,
            } => {
                let quadrant = (place.quarters as i64) & 3;
                let turn = if quadrant >= 2 { -1.0 } else { 1.0 };
                if quadrant & 1 == 0 {
                    let inverse = 1.0 / cubic(&series.even, z);
                    let tanh = sine / cosine;
                    let sech = decay / cosine;
                    let sn = (tanh + tanh * (cubic(&series.sn, z) * inverse)).min(1.0);
                    let cn = sech + sech * (cubic(&series.cn, z) * inverse);
                    let dn = (sech + sech * (cubic(&series.dn, z) * inverse)).min(1.0);
                    [turn * sign * sn, turn * cn, dn]
                } else {
                    let inverse = 1.0 / cubic(&series.odd, z);
                    let sine = series.complementary_modulus * growth * sine;
                    let cosine = series.complementary_modulus * growth * cosine;
                    let sn = (1.0 + cubic(&series.sn_odd, z) * inverse).min(1.0);
                    let cn = sine + sine * (cubic(&series.cn_odd, z) * inverse);
                    let dn = cosine + cosine * (cubic(&series.dn_odd, z) * inverse);
                    [
                        turn * sn,
                        -turn * sign * cn,
                        dn.max(series.complementary_modulus),
                    ]
                }
            }
        }
    }
}
