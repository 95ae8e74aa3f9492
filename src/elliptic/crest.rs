//! Beyond m = 1/2: hyperbolic functions of what an argument is away from the nearest multiple of K, and sn, cn, dn from them.

use super::kernel::{self, ROUNDER};
use super::series::{Corrections, Series};

pub(crate) struct Hyperbolic {
    pub(crate) sn: f64,
    pub(crate) cn: f64,
    pub(crate) dn: f64,
}

/// The functions at v = `high + low` after as many quarter periods as the lowest bits say, with the corrections
/// that belong to the lowest.
#[inline(always)]
pub(super) fn hyperbolic(
    series: &Series,
    set: &Corrections,
    bits: u64,
    high: f64,
    low: f64,
) -> Hyperbolic {
    let crest = Crest::new(series.root, high, low);
    hyperbolic_at(series.complementary_modulus, set, bits, &crest)
}

/// sinh and cosh of |v|, the sign of v as a bit, and z = 4 √q′ sinh² v.
pub(crate) struct Crest {
    pub(crate) sign: u64,
    pub(crate) wave: Wave,
    pub(crate) z: f64,
}

impl Crest {
    /// At v = `high + low`; `root` is 2q′^{1/4}.
    #[inline(always)]
    pub(crate) fn new(root: f64, high: f64, low: f64) -> Self {
        let sign = high.to_bits() & (1 << 63);
        let (high, low) = (high.abs(), f64::from_bits(low.to_bits() ^ sign));
        let wave = Wave::new(high, low);
        let root = kernel::lesser(root * wave.growth * wave.sine, 2.0);
        Self {
            sign,
            wave,
            z: root * root,
        }
    }
}

/// The functions from the hyperbolic functions of v.
#[inline(always)]
pub(crate) fn hyperbolic_at(
    complementary_modulus: f64,
    set: &Corrections,
    bits: u64,
    crest: &Crest,
) -> Hyperbolic {
    let odd = (bits & 1).wrapping_neg();
    let Crest { sign, wave, z } = crest;
    let inverse = 1.0 / kernel::polynomial(&set.denominator, *z);
    let upper = complementary_modulus * wave.growth;
    let below = 1.0 / wave.cosine;
    let sech = wave.decay(below);
    let s = kernel::select(odd, 1.0, wave.sine / wave.cosine);
    let c = kernel::select(odd, upper * wave.sine, sech);
    let d = kernel::select(odd, upper * wave.cosine, sech);
    let sn = s + s * (kernel::polynomial(&set.sn, *z) * inverse);
    let cn = c + c * (kernel::polynomial(&set.cn, *z) * inverse);
    let dn = d + d * (kernel::polynomial(&set.dn, *z) * inverse);
    // Near even multiples sn is odd in v, near odd ones cn is, with the other sign.
    let half = (bits & 2) << 62;
    let sn_sign = half ^ (sign & !odd);
    let cn_sign = half ^ ((sign ^ (1 << 63)) & odd);
    Hyperbolic {
        sn: f64::from_bits(kernel::lesser(sn, 1.0).to_bits() ^ sn_sign),
        cn: f64::from_bits(cn.to_bits() ^ cn_sign),
        dn: kernel::lesser(kernel::greater(dn, complementary_modulus), 1.0),
    }
}

/// sinh x and cosh x for x ≥ 0, both divided by the power of two 2^j next to e^x.
pub(crate) struct Wave {
    pub(crate) sine: f64,
    pub(crate) cosine: f64,
    /// 2^j, or so much of it as a double holds.
    pub(crate) growth: f64,
    /// 2^−j as a product, so that it may be less than the least double.
    pub(super) decay: [f64; 2],
}

impl Wave {
    #[inline(always)]
    pub(super) fn new(high: f64, low: f64) -> Self {
        const LN2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
        // Beyond 760 the hyperbolic secant is zero.
        let low = if high > 760.0 { 0.0 } else { low };
        let high = kernel::lesser(high, 760.0);
        let rounded = high * core::f64::consts::LOG2_E + ROUNDER;
        let j = rounded - ROUNDER;
        let leading = j * LN2[0] - high;
        let g = leading + j * LN2[1];
        let rest = ((leading - g) + j * LN2[1]) - low;
        let (s, c) = kernel::hyperbolic(g, rest);
        // 2^−j in two factors, 4^−j, and 2^j: where an exponent does not fit it is cut off, and does not count.
        let half = (0.5 * j + ROUNDER) - ROUNDER;
        let decay = [
            kernel::power_of_two(ROUNDER - half),
            kernel::power_of_two(ROUNDER - (j - half)),
        ];
        let tiny = kernel::power_of_two(ROUNDER - kernel::lesser(2.0 * j, 1022.0));
        // sinh x = (2^j e^−g − 2^−j e^g)/2, and likewise cosh.
        let (less, more) = (1.0 - tiny, 1.0 + tiny);
        Self {
            sine: 0.5 * (less + (less * c - more * s)),
            cosine: 0.5 * (more + (more * c - less * s)),
            growth: kernel::power_of_two(ROUNDER + kernel::lesser(j, 1023.0)),
            decay,
        }
    }

    #[inline(always)]
    pub(crate) fn decay(&self, x: f64) -> f64 {
        x * self.decay[0] * self.decay[1]
    }
}
