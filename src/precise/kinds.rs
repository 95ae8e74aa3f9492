//! The operations of both kinds of number.

use super::angle::angle;
use super::double_double::DoubleDouble;
use super::extended::{Extended, shifted};
use super::logarithm::logarithm;
use super::number::{Number, Operators};
use super::quick;

impl Operators for DoubleDouble {}
impl Operators for Extended {}

impl Number for DoubleDouble {
    fn from_parts(digits: DoubleDouble, exponent: i32) -> Self {
        Extended { digits, exponent }.narrow()
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
    fn product(a: f64, b: f64) -> Self {
        let (high, low) = quick::exact_product(a, b);
        Self::new(high, low)
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
        let odd = self.exponent & 1;
        let digits = self.digits.scaled(f64::from(1 + odd)).square_root();
        Self::from_parts(digits, (self.exponent - odd) / 2)
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
        let third = self.exponent.div_euclid(3);
        let rest = f64::from(1 << self.exponent.rem_euclid(3));
        Self::from_double((self.digits.high() * rest).cbrt()).raised(third)
    }

    fn from_parts(digits: DoubleDouble, exponent: i32) -> Self {
        if digits.high() == 0.0 {
            return Self::zero();
        }
        Self { digits, exponent }
    }

    fn angle(cosine: Self, sine: Self) -> DoubleDouble {
        angle(cosine.quotient(sine).narrow(), DoubleDouble::from(1.0))
    }
}
