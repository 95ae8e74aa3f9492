//! An argument reduced to the nearest multiple of K, and the elementary functions there that everything else is made of.

pub(crate) use super::crest::Crest;
use super::crest::{Hyperbolic, hyperbolic_at};
use super::jacobi::{Circular, QUARTER_PARTS, circular_at, in_quadrant};
use super::kernel::{self, ROUNDER};
use super::modulus::{EXACT_COUNT, Modulus, Side};
use crate::precise::DoubleDouble;

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
    /// sinh and cosh of π rest/(2K′), both divided by e^x or nearly so.
    Hyperbolic(Crest),
}

/// 2⁶² radians, the greatest angle of two words of which sine and cosine are of use: 106 bits leave 10⁻¹³ of it.
pub(crate) const GREATEST_ANGLE: f64 = 4.6e18;

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
    in_quadrant(count as i64 as u64, sine, cosine)
}

impl Modulus {
    /// Where the argument lies.
    pub(crate) fn place(&self, u: DoubleDouble) -> Place {
        let (quarters, rest) = self.reduced(u);
        let (high, low) = self.multiplied(rest.high(), rest.low());
        let local = match self.side {
            Side::Circular => {
                let (sine, cosine) = kernel::sine_cosine(high, low);
                let (sine, cosine) = in_quadrant(quarters as i64 as u64, sine, cosine);
                Local::Circular { sine, cosine }
            }
            Side::Hyperbolic => Local::Hyperbolic(Crest::new(self.series.root, high, low)),
        };
        Place { quarters, local }
    }

    /// u = (quarters) K + rest. The error is a part of u, not of the rest as in [`reduce`](Self::reduce): a place needs no more.
    #[inline(always)]
    fn reduced(&self, u: DoubleDouble) -> (f64, DoubleDouble) {
        let reduction = &self.reduction;
        if u.high().abs() > reduction.limit {
            return self.reduced_from_afar(u);
        }
        let count = (u.high() * reduction.inverse + ROUNDER) - ROUNDER;
        let first = u.high() - count * reduction.parts[0];
        let rest = DoubleDouble::difference(first, count * reduction.parts[1]);
        let low = rest.low() + (u.low() - count * reduction.parts[2]);
        (count, DoubleDouble::sum(rest.high(), low))
    }

    /// The same with more quarter periods than a short K can be multiplied with exactly.
    #[cold]
    fn reduced_from_afar(&self, u: DoubleDouble) -> (f64, DoubleDouble) {
        let count = (u.high() / self.quarter.high()).round_ties_even();
        let rest = u - self.quarter * DoubleDouble::from(count);
        let again = (rest.high() / self.quarter.high()).round_ties_even();
        let rest = rest - self.quarter * DoubleDouble::from(again);
        (count + again, rest)
    }

    /// sn, cn and dn there.
    pub(crate) fn triple(&self, place: &Place) -> [f64; 3] {
        let bits = place.quarters as i64 as u64;
        match &place.local {
            Local::Circular { sine, cosine } => {
                let Circular { sn, cn, dn, .. } = circular_at(&self.series.even, *sine, *cosine);
                [sn, cn, dn]
            }
            Local::Hyperbolic(crest) => {
                let set = if bits & 1 == 0 {
                    &self.series.even
                } else {
                    &self.series.odd
                };
                let Hyperbolic { sn, cn, dn } =
                    hyperbolic_at(self.series.complementary_modulus, set, bits, crest);
                [sn, cn, dn]
            }
        }
    }
}
