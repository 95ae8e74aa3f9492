//! One word or two: what the constants of an exact motion are formed in.
//!
//! Two words keep a phase over 10⁹ periods. One is five times as fast and good for the first few radians.

use crate::angle::angle;
use crate::double_double::DoubleDouble;

/// What one word, two words and two words with an exponent have in common.
pub(crate) trait Arithmetic: Copy {
    /// Of a finite double.
    fn from_double(value: f64) -> Self;
    fn multiply(self, other: Self) -> Self;
    /// The quotient; zero by anything is zero.
    fn divide(self, other: Self) -> Self;
    /// The sum of terms that do not cancel.
    fn add(self, other: Self) -> Self;
    fn subtract(self, other: Self) -> Self;
    fn negated(self) -> Self;
    fn square_root(self) -> Self;
    /// The leading digits: zero if and only if the number is.
    fn leading(self) -> f64;

    fn is_zero(self) -> bool {
        self.leading() == 0.0
    }
}

/// A number of one double or of two.
pub(crate) trait Words: Arithmetic {
    fn from_two(value: DoubleDouble) -> Self;
    fn two(self) -> DoubleDouble;
    fn scaled(self, power_of_two: f64) -> Self;
    /// √(1 + x²).
    fn hypotenuse_with_one(self) -> Self;
    /// The nearest double.
    fn value(self) -> f64;
    /// The angle of the point (cosine, sine) in the first quadrant.
    fn angle(cosine: Self, sine: Self) -> Self;
}

impl Arithmetic for DoubleDouble {
    #[inline]
    fn from_double(value: f64) -> Self {
        Self::from(value)
    }

    #[inline]
    fn multiply(self, other: Self) -> Self {
        self.multiply(other)
    }

    #[inline]
    fn divide(self, other: Self) -> Self {
        if self.high() == 0.0 {
            self
        } else {
            self.divide(other)
        }
    }

    #[inline]
    fn add(self, other: Self) -> Self {
        self.add_alike(other)
    }

    #[inline]
    fn subtract(self, other: Self) -> Self {
        self.subtract(other)
    }

    #[inline]
    fn negated(self) -> Self {
        self.negated()
    }

    #[inline]
    fn square_root(self) -> Self {
        self.square_root()
    }

    #[inline]
    fn leading(self) -> f64 {
        self.high()
    }
}

impl Words for DoubleDouble {
    #[inline]
    fn from_two(value: DoubleDouble) -> Self {
        value
    }

    #[inline]
    fn two(self) -> DoubleDouble {
        self
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Self {
        self.scaled(power_of_two)
    }

    #[inline]
    fn hypotenuse_with_one(self) -> Self {
        self.hypotenuse_with_one()
    }

    #[inline]
    fn value(self) -> f64 {
        self.value()
    }

    fn angle(cosine: Self, sine: Self) -> Self {
        angle(cosine, sine)
    }
}

impl Arithmetic for f64 {
    #[inline]
    fn from_double(value: f64) -> Self {
        value
    }

    #[inline]
    fn multiply(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn divide(self, other: Self) -> Self {
        if self == 0.0 { self } else { self / other }
    }

    #[inline]
    fn add(self, other: Self) -> Self {
        self + other
    }

    #[inline]
    fn subtract(self, other: Self) -> Self {
        self - other
    }

    #[inline]
    fn negated(self) -> Self {
        -self
    }

    #[inline]
    fn square_root(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn leading(self) -> f64 {
        self
    }
}

impl Words for f64 {
    #[inline]
    fn from_two(value: DoubleDouble) -> Self {
        value.value()
    }

    #[inline]
    fn two(self) -> DoubleDouble {
        DoubleDouble::from(self)
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Self {
        self * power_of_two
    }

    #[inline]
    fn hypotenuse_with_one(self) -> Self {
        if self.abs() > 1e20 {
            self.abs()
        } else {
            (1.0 + self * self).sqrt()
        }
    }

    #[inline]
    fn value(self) -> f64 {
        self
    }

    #[inline]
    fn angle(cosine: Self, sine: Self) -> Self {
        sine.atan2(cosine)
    }
}
