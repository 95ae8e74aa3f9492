//! The operations that formulas need, so that they are written once for [`DoubleDouble`] and [`Extended`].

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{DoubleDouble, Extended, angle, logarithm, quick, shifted};

/// A number in which the constants of an exact motion are formed. Sums and differences keep its digits however much cancels.
pub(crate) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + From<DoubleDouble>
{
    /// The number equal to a finite double.
    #[inline]
    fn from_double(value: f64) -> Self {
        Self::from(DoubleDouble::from(value))
    }

    /// a − b, exact even where the difference of doubles is rounded.
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        Self::from(DoubleDouble::sum(a, -b))
    }

    fn from_extended(number: Extended) -> Self;
    /// The number without its own exponent: infinite or zero outside the range of doubles.
    fn narrow(self) -> DoubleDouble;
    /// The leading word: zero if and only if the number is.
    fn leading(self) -> f64;
    fn square_root(self) -> Self;
    /// The natural logarithm of a positive number.
    fn logarithm(self) -> DoubleDouble;
    /// The cube root to the precision of a double.
    fn rough_cube_root(self) -> Self;

    /// The angle of the point (cosine, sine) in the first quadrant.
    fn angle(cosine: Self, sine: Self) -> DoubleDouble {
        angle(cosine.quotient(sine).narrow(), DoubleDouble::from(1.0))
    }

    /// √(self/divisor) as a double, with any exponents.
    #[inline]
    fn root_of_quotient(self, divisor: Self) -> f64 {
        self.quotient(divisor).square_root().narrow().value()
    }

    #[inline]
    fn exceeds(self, other: Self) -> bool {
        (self - other).leading() > 0.0
    }

    /// a b, exactly, for doubles whose product and trailing word stay in range.
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        Self::from_double(a).times(b)
    }

    /// The product to 104 bits, if it and its trailing word stay in range.
    #[inline(always)]
    fn quick_product(self, other: Self) -> Self {
        self * other
    }

    /// The quotient to 103 bits, if neither number is zero and the result and its trailing word stay in range.
    #[inline(always)]
    fn quick_quotient(self, divisor: Self) -> Self {
        self / divisor
    }

    /// The sum of terms that do not cancel, without the care for those that do.
    #[inline]
    fn add_alike(self, other: Self) -> Self {
        self + other
    }

    /// The quotient; zero divided by anything is zero.
    #[inline]
    fn quotient(self, divisor: Self) -> Self {
        if self.is_zero() { self } else { self / divisor }
    }

    #[inline]
    fn is_zero(self) -> bool {
        self.leading() == 0.0
    }

    #[inline]
    fn square(self) -> Self {
        self * self
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        self * Self::from_double(factor)
    }

    /// Multiplied by a power of two, exactly.
    #[inline]
    fn scaled(self, power_of_two: f64) -> Self {
        self.times(power_of_two)
    }

    /// With the opposite sign if `sign` is negative.
    #[inline]
    fn signed(self, sign: f64) -> Self {
        if sign < 0.0 { -self } else { self }
    }

    /// The quotient as a double.
    #[inline]
    fn ratio(self, divisor: Self) -> f64 {
        self.quotient(divisor).narrow().value()
    }

    #[inline]
    fn magnitude(self) -> Self {
        self.signed(self.leading())
    }

    #[inline]
    fn greater(self, other: Self) -> Self {
        if other.exceeds(self) { other } else { self }
    }
}

impl Number for DoubleDouble {
    #[inline]
    fn product(a: f64, b: f64) -> Self {
        let (high, low) = quick::exact_product(a, b);
        Self::new(high, low)
    }

    fn from_extended(number: Extended) -> Self {
        number.narrow()
    }

    #[inline]
    fn narrow(self) -> Self {
        self
    }

    #[inline]
    fn leading(self) -> f64 {
        self.high()
    }

    #[inline]
    fn square_root(self) -> Self {
        if self.high() == 0.0 {
            return Self::from(0.0);
        }
        let (root, rest) = quick::root(self.high(), self.low());
        Self::ordered_sum(root, rest)
    }

    #[inline(always)]
    fn quick_product(self, b: Self) -> Self {
        let (high, error) = quick::exact_product(self.high(), b.high());
        let cross = self.high() * b.low() + self.low() * b.high();
        Self::ordered_sum(high, error + cross)
    }

    #[inline(always)]
    fn quick_quotient(self, b: Self) -> Self {
        let inverse = 1.0 / b.high();
        let leading = self.high() * inverse;
        let (product, error) = quick::exact_product(leading, b.high());
        let rest = ((self.high() - product) - error) + (self.low() - leading * b.low());
        Self::ordered_sum(leading, rest * inverse)
    }

    #[inline]
    fn root_of_quotient(self, divisor: Self) -> f64 {
        if self.high() == 0.0 {
            0.0
        } else {
            (self.value() / divisor.value()).sqrt()
        }
    }

    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self.high() > other.high() || (self.high() == other.high() && self.low() > other.low())
    }

    fn logarithm(self) -> Self {
        logarithm(self, 0)
    }

    fn rough_cube_root(self) -> Self {
        Self::from(self.high().cbrt())
    }

    fn angle(cosine: Self, sine: Self) -> Self {
        angle(cosine, sine)
    }

    #[inline]
    fn add_alike(self, other: Self) -> Self {
        let leading = Self::sum(self.high(), other.high());
        Self::ordered_sum(leading.high(), leading.low() + (self.low() + other.low()))
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        let leading = DoubleDouble::product(self.high(), factor);
        Self::ordered_sum(leading.high(), leading.low() + self.low() * factor)
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Self {
        Self::new(self.high() * power_of_two, self.low() * power_of_two)
    }

    #[inline]
    fn ratio(self, divisor: Self) -> f64 {
        self.value() / divisor.value()
    }
}

impl Number for Extended {
    fn leading(self) -> f64 {
        self.digits.high()
    }

    fn square_root(self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let odd = self.exponent & 1;
        Self {
            digits: self.digits.scaled(f64::from(1 + odd)).square_root(),
            exponent: (self.exponent - odd) / 2,
        }
    }

    fn narrow(self) -> DoubleDouble {
        let high = shifted(self.digits.high(), self.exponent);
        if high.is_infinite() {
            return DoubleDouble::new(high, 0.0);
        }
        DoubleDouble::sum(high, shifted(self.digits.low(), self.exponent))
    }

    fn logarithm(self) -> DoubleDouble {
        logarithm(self.digits, self.exponent)
    }

    fn rough_cube_root(self) -> Self {
        if self.is_zero() {
            return self;
        }
        let third = self.exponent.div_euclid(3);
        let rest = f64::from(1 << self.exponent.rem_euclid(3));
        Self::from_double((self.digits.high() * rest).cbrt()).raised(third)
    }

    fn from_extended(number: Extended) -> Self {
        number
    }
}
