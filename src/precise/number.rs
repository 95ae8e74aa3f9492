//! The operations that formulas need, so that they are written once for [`DoubleDouble`] and [`Extended`].

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::double_double::DoubleDouble;

/// A number with the four operations.
pub trait Operators:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
}

impl Operators for f32 {}
impl Operators for f64 {}

/// A number in which the constants of an exact motion are formed. Sums and differences keep its digits however much cancels.
pub(crate) trait Number: Operators + From<DoubleDouble> {
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

    /// `digits · 2^exponent`, as far as the type holds it.
    fn from_parts(digits: DoubleDouble, exponent: i32) -> Self;
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
    fn angle(cosine: Self, sine: Self) -> DoubleDouble;

    /// √(self/divisor) as a double, with any exponents.
    #[inline]
    fn root_of_quotient(self, divisor: Self) -> f64 {
        self.quotient(divisor).square_root().narrow().value()
    }

    #[inline]
    fn exceeds(self, other: Self) -> bool {
        (self - other).leading() > 0.0
    }

    /// a b, exactly, for doubles below 10³⁰⁰ whose product and trailing word stay in range.
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
