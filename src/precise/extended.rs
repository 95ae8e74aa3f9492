//! Numbers with 106 bits and an exponent of their own, so that no tilt underflows and no phase loses digits;
//! exact sums of products; powers of two.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::double_double::{DoubleDouble, power_of_two_below};
use super::number::Number;

/// `digits · 2^exponent`: squares of tilts down to 1e-300 do not underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extended {
    pub(crate) digits: DoubleDouble,
    pub(crate) exponent: i32,
}

/// The sum of products of doubles, to 106 bits whatever cancels; zero only if the exact sum is zero.
///
/// The exact sum is kept as a list of words that do not overlap, in ascending order; adding a word by error-free sums
/// leaves it such a list (J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997).
pub(crate) fn sum_of_products<const N: usize>(products: &[[f64; N]]) -> Extended {
    let mut sum: Vec<Extended> = Vec::new();
    for factors in products {
        let mut product = vec![Extended::from_double(factors[0])];
        for &factor in &factors[1..] {
            let factor = Extended::from_double(factor);
            // The product of two numbers of one word each fits into two words: no bit is lost.
            let parts = product.iter().flat_map(|word| (*word * factor).words());
            product = parts.filter(|word| !word.is_zero()).collect();
        }
        for mut word in product {
            for kept in &mut sum {
                [*kept, word] = exact_sum(*kept, word);
            }
            sum.push(word);
        }
        sum.retain(|word| !word.is_zero());
    }
    // From the greatest down: cancellation between the leading words loses nothing, and their sum exceeds all words that follow.
    sum.into_iter()
        .rfold(Extended::zero(), |sum, word| sum + word)
}

/// The sum of two numbers of one word each, as the nearest such number and the remainder, the remainder first.
fn exact_sum(a: Extended, b: Extended) -> [Extended; 2] {
    let ordered = a.exponent < b.exponent;
    let (small, large) = if ordered { (a, b) } else { (b, a) };
    // So far apart that the sum rounds to the larger: unchanged. Otherwise no digit underflows; zero counts as far from everything.
    let shifted = small.digits.high() * power(small.exponent - large.exponent);
    let digits = DoubleDouble::sum(large.digits.high(), shifted);
    if digits.high() == large.digits.high() {
        return [small, large];
    }
    let exponent = large.exponent;
    Extended { digits, exponent }.words()
}

impl Extended {
    /// Its two words as separate numbers, the lower first.
    fn words(self) -> [Self; 2] {
        [self.digits.low(), self.digits.high()]
            .map(|word| Self::from_double(word).raised(self.exponent))
    }

    /// The number as another kind.
    pub(crate) fn as_number<N: Number>(self) -> N {
        N::from_parts(self.digits, self.exponent)
    }

    /// The number times 2^exponent.
    pub(crate) fn raised(mut self, exponent: i32) -> Self {
        self.exponent += exponent;
        self
    }

    /// Zero, with an exponent so low that it never shifts the other term of a sum.
    pub(crate) fn zero() -> Self {
        let (digits, exponent) = (DoubleDouble::from(0.0), i32::MIN / 8);
        Self { digits, exponent }
    }

    /// The nearest double.
    pub(crate) fn value(self) -> f64 {
        shifted(self.digits.value(), self.exponent)
    }
}

impl Add for Extended {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let exponent = self.exponent.max(other.exponent);
        let first = self.digits.scaled(power(self.exponent - exponent));
        let second = other.digits.scaled(power(other.exponent - exponent));
        Self::from_parts(first + second, exponent)
    }
}

impl Sub for Extended {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Extended {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let exponent = self.exponent + other.exponent;
        Self::from_parts(self.digits * other.digits, exponent)
    }
}

impl Div for Extended {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let exponent = self.exponent - other.exponent;
        Self::from_parts(self.digits / other.digits, exponent)
    }
}

impl Neg for Extended {
    type Output = Self;

    fn neg(self) -> Self {
        let digits = -self.digits;
        Self { digits, ..self }
    }
}

impl From<DoubleDouble> for Extended {
    fn from(number: DoubleDouble) -> Self {
        if number.high().is_subnormal() {
            // Scaled up, so that its leading digit is that of a normal number.
            return Self::from(number.scaled(power(1000))).raised(-1000);
        }
        let unit = power_of_two_below(number.high().abs());
        Self::from_parts(number.scaled(1.0 / unit), exponent_of(unit))
    }
}

/// The exponent of a power of two, exactly.
pub(crate) fn exponent_of(power_of_two: f64) -> i32 {
    // The cast is lossless: the exponent has eleven bits.
    ((power_of_two.to_bits() >> 52) as i32) - 1023
}

/// 2^exponent; zero below the smallest normal number, where adding it to 1 has no effect.
pub(crate) fn power(exponent: i32) -> f64 {
    let biased = exponent.clamp(-1023, 1023) + 1023;
    f64::from_bits(u64::from(biased.unsigned_abs()) << 52)
}

/// `value · 2^exponent`, in steps that overflow or underflow only if the result does.
pub(crate) fn shifted(value: f64, exponent: i32) -> f64 {
    let (mut shifted, mut left) = (value, exponent.clamp(-4000, 4000));
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        shifted *= power(step);
        left -= step;
    }
    shifted
}

#[cfg(test)]
mod tests {
    use super::{Extended, shifted, sum_of_products};
    use crate::precise::Number;

    #[test]
    fn sums_of_products_keep_every_bit() {
        let (x, y) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON / 2.0);
        // x² − x·x; x² = (1 + ε)² less all its terms, plus ε³ = 2⁻¹⁵⁶; 10⁻⁶⁰⁰ beside two products that cancel.
        assert!(sum_of_products(&[[x, x], [-x, x]]).is_zero());
        let eps = f64::EPSILON;
        let rest = sum_of_products(&[
            [x, x],
            [-1.0, 1.0],
            [-2.0, eps],
            [-eps, eps],
            [eps * eps, eps],
        ]);
        assert_eq!(rest.value(), eps * eps * eps);
        let rest = sum_of_products(&[[x, y], [1e-300, 1e-300], [-y, x]]);
        assert_eq!(rest.square_root().value(), 1e-300);
        let rest = sum_of_products(&[
            [f64::MAX, f64::MAX],
            [5e-324, 5e-324],
            [f64::MAX, -f64::MAX],
        ]);
        assert_eq!(rest.square_root().value(), 5e-324);
        assert!(sum_of_products(&[[0.0, 1.0], [-0.0, 5.0]]).is_zero());
    }

    #[test]
    fn extended_numbers_keep_the_square_of_a_tiny_tilt() {
        let tilt = Extended::from_double(5e-324);
        assert_eq!(tilt.value(), 5e-324);
        assert_eq!(tilt.square().square_root().value(), 5e-324);
        let gap = Extended::difference(1.0f64.next_up(), 1.0);
        assert_eq!(gap.value(), f64::EPSILON);
        assert_eq!(shifted(3.0, -1074), 1.5e-323);
    }
}
