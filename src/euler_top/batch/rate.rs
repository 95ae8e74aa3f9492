//! Rates of two words, times the times of many lanes.

use super::constants::Constant;
use crate::precise::DoubleDouble;

/// A rate of two words that times are multiplied with: the first also in halves, whose products are exact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rate<C> {
    pub(super) high: C,
    pub(super) upper: C,
    pub(super) lower: C,
    pub(super) low: C,
}

/// A time and its halves.
#[derive(Clone, Copy)]
pub(super) struct Time {
    t: f64,
    upper: f64,
    lower: f64,
}

impl Time {
    #[inline(always)]
    pub(super) fn new(t: f64) -> Self {
        let [upper, lower] = halves(t);
        Self { t, upper, lower }
    }
}

/// Upper 26 bits and the rest (Veltkamp).
#[inline(always)]
pub(super) fn halves(x: f64) -> [f64; 2] {
    let y = 134_217_729.0 * x;
    let upper = y - (y - x);
    [upper, x - upper]
}

impl Rate<f64> {
    pub(super) fn new(rate: DoubleDouble) -> Self {
        let [upper, lower] = halves(rate.high());
        Self {
            high: rate.high(),
            upper,
            lower,
            low: rate.low(),
        }
    }
}

impl<const W: usize> Rate<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            high: [0.0; W],
            upper: [0.0; W],
            lower: [0.0; W],
            low: [0.0; W],
        }
    }

    pub(super) fn gather(each: [&Rate<f64>; W]) -> Self {
        Self {
            high: each.map(|x| x.high),
            upper: each.map(|x| x.upper),
            lower: each.map(|x| x.lower),
            low: each.map(|x| x.low),
        }
    }
}

impl<C: Constant> Rate<C> {
    /// Rate times time in two words (Dekker).
    #[inline(always)]
    pub(super) fn times(&self, i: usize, Time { t, upper, lower }: Time) -> [f64; 2] {
        let (high, low) = (self.high.lane(i), self.low.lane(i));
        let product = high * t;
        let error = if cfg!(target_feature = "fma") {
            high.mul_add(t, -product)
        } else {
            let (a, b) = (self.upper.lane(i), self.lower.lane(i));
            ((a * upper - product) + (a * lower + b * upper)) + b * lower
        };
        [product, error + low * t]
    }
}
