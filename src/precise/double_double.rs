//! Numbers of twice the precision: an unevaluated sum of two doubles, about 106 bits.
//!
//! Used where an exact difference or a long phase would otherwise lose digits that matter. The algorithms
//! are Dekker's and Knuth's error-free transformations; each operation is good to a few units of 2⁻¹⁰⁴.
//! Where the leading part overflows, the result is not a number; where the trailing part underflows, the
//! precision falls back to that of a double.

use core::f64::consts::TAU;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::quick;

/// `high + low`, where `low` is at most half a unit in the last place of `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// π/2 to 106 bits.
pub(crate) const RIGHT_ANGLE: DoubleDouble =
    DoubleDouble::new(core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);

/// π/2 less its value to 106 bits.
pub(crate) const RIGHT_ANGLE_REST: f64 = -1.497_384_904_859_169_8e-33;

/// Above this, the factor that splits a double overflows. A fused multiplication does not, but is a library call where the processor has none.
const SPLITTABLE: f64 = 1e300;

impl DoubleDouble {
    /// A constant in two words, `low` at most half a unit in the last place of `high`.
    pub(crate) const fn new(high: f64, low: f64) -> Self {
        Self { high, low }
    }

    /// The leading part.
    pub(crate) fn high(self) -> f64 {
        self.high
    }

    /// The trailing part.
    pub(crate) fn low(self) -> f64 {
        self.low
    }

    /// The sum of two doubles, exactly.
    #[inline]
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let (high, low) = quick::exact_sum(a, b);
        Self { high, low }
    }

    /// The exact sum of two doubles, the first not the smaller in size (Dekker).
    #[inline]
    pub(super) fn ordered_sum(a: f64, b: f64) -> Self {
        let (high, low) = quick::ordered_sum(a, b);
        Self { high, low }
    }

    /// The sum with a number that is not the greater in size, if the two do not cancel; by a few units in its last place the other may be the greater.
    #[inline(always)]
    pub(crate) fn add_lesser(self, lesser: Self) -> Self {
        let (high, low) = quick::ordered_sum(self.high, lesser.high);
        Self::new(high, low + (self.low + lesser.low))
    }

    /// The product of two doubles, exactly unless its tail underflows.
    #[inline]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        if a.abs().max(b.abs()) > SPLITTABLE {
            let high = a * b;
            return Self::new(high, a.mul_add(b, -high));
        }
        let (high, low) = quick::exact_product(a, b);
        Self { high, low }
    }

    /// The nearest double to the number.
    #[inline]
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    /// The number less a multiple of π/2, of which 160 bits are subtracted.
    pub(crate) fn less_right_angles(self, count: f64) -> Self {
        [RIGHT_ANGLE.high, RIGHT_ANGLE.low, RIGHT_ANGLE_REST]
            .into_iter()
            .fold(self, |rest, part| rest - Self::product(count, part))
    }

    /// Sine and cosine of the number in radians.
    ///
    /// Multiples of 2π are subtracted with 160 bits of 2π, so the absolute error is 2⁻¹⁰⁴ of the argument plus one
    /// unit in the last place of the result. An argument that is not finite gives not-a-number.
    pub(crate) fn sin_cos(self) -> (f64, f64) {
        let mut rest = self;
        // For every phase below 2¹⁰⁰, one round leaves at most a few turns.
        for _ in 0..3 {
            let turns = (rest.high / TAU).round();
            if turns == 0.0 {
                break;
            }
            rest = rest.less_right_angles(4.0 * turns);
        }
        let (sin, cos) = rest.high.sin_cos();
        (rest.low.mul_add(cos, sin), (-rest.low).mul_add(sin, cos))
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// The sum, to 104 bits of the result however much cancels.
    #[inline]
    fn add(self, other: Self) -> Self {
        let leading = Self::sum(self.high, other.high);
        let trailing = Self::sum(self.low, other.low);
        let first = Self::ordered_sum(leading.high, leading.low + trailing.high);
        Self::ordered_sum(first.high, first.low + trailing.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        let leading = Self::product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        Self::ordered_sum(leading.high, leading.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    #[inline]
    fn div(self, divisor: Self) -> Self {
        let first = self.high / divisor.high;
        let product = Self::product(first, divisor.high);
        // The first difference is exact, because the quotient is right to half an ulp.
        let rest = ((self.high - product.high) - product.low) + (self.low - first * divisor.low);
        Self::ordered_sum(first, rest / divisor.high)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.high, -self.low)
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

/// The greatest power of two not above a finite `size`, at least the least normal number: dividing by it does not round.
pub(crate) fn power_of_two_below(size: f64) -> f64 {
    const EXPONENT_BITS: u64 = 0x7ff0_0000_0000_0000;
    // The reciprocal of the greatest power of two, 2⁻¹⁰²³, is subnormal but exact; the reciprocal of a subnormal would overflow.
    f64::from_bits(size.to_bits() & EXPONENT_BITS).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::{DoubleDouble, RIGHT_ANGLE};
    use crate::precise::Number;

    /// The double next to π/2 has the cosine 6·10⁻¹⁷, the one next to π twice that as its sine.
    #[test]
    fn sine_and_cosine_are_those_of_both_words() {
        let (sine, cosine) = (RIGHT_ANGLE.scaled(2.0).sin_cos().0, RIGHT_ANGLE.sin_cos().1);
        assert!(sine.abs().max(cosine.abs()) < 1e-31, "{sine:e} {cosine:e}");
    }

    #[test]
    fn three_thirds_are_one_and_root_two_squares_to_two() {
        let [one, two, three] = [1.0, 2.0, 3.0].map(DoubleDouble::from);
        let rest = one - one / three * three;
        assert!(rest.value().abs() < 2f64.powi(-104), "{rest:?}");
        let rest = two.square_root().square() - two;
        assert!(rest.value().abs() < 2f64.powi(-102), "{rest:?}");
    }
}
