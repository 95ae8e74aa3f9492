//! Two words without a branch: what [`DoubleDouble`] does, for the body of a loop over lanes.
//!
//! The formulas of a preparation are written once, for any [`Number`]; with this one the compiler may lay out several bodies side by
//! side. It is meant for sizes between 10⁻²⁸⁰ and 10²⁸⁰, and for zero.
//!
//! The words are not put in order after each operation, which is a third of the time that one operation waits for another: the trailing one may
//! be some units in the last place of the leading one. What is left out is the square of that: some 98 bits are right at the end,
//! where the states side by side need 80, since they reach no further than 2²⁴ half turns.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{DoubleDouble, Extended, Number, Words, quick};

/// A number of two words in a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lane(DoubleDouble);

/// Numbers of two words, one a lane: a row of leading and a row of trailing words.
pub(crate) type Two<const W: usize> = [[f64; W]; 2];

impl Lane {
    /// One of a row.
    #[inline(always)]
    pub(crate) fn of<const W: usize>(rows: &Two<W>, i: usize) -> Self {
        Self(DoubleDouble::new(rows[0][i], rows[1][i]))
    }

    #[inline(always)]
    pub(crate) fn put<const W: usize>(self, rows: &mut Two<W>, i: usize) {
        rows[0][i] = self.0.high();
        rows[1][i] = self.0.low();
    }

    #[inline(always)]
    pub(crate) fn new(number: DoubleDouble) -> Self {
        Self(number)
    }

    /// The product of two doubles, exactly.
    #[inline(always)]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let (high, low) = quick::exact_product(a, b);
        Self(DoubleDouble::new(high, low))
    }

    /// Leading and trailing word.
    #[inline(always)]
    pub(crate) fn words(self) -> [f64; 2] {
        [self.0.high(), self.0.low()]
    }

    #[inline(always)]
    fn pair(high: f64, low: f64) -> Self {
        Self(DoubleDouble::new(high, low))
    }

    /// The same with its words in order.
    #[inline(always)]
    pub(crate) fn ordered(self) -> Self {
        let (high, low) = quick::ordered_sum(self.0.high(), self.0.low());
        Self::pair(high, low)
    }
}

impl Words for Lane {
    #[inline(always)]
    fn from_two(value: DoubleDouble) -> Self {
        Self(value)
    }

    #[inline(always)]
    fn two(self) -> DoubleDouble {
        self.0
    }

    #[inline(always)]
    fn scaled(self, power_of_two: f64) -> Self {
        Self(self.0.scaled(power_of_two))
    }

    #[inline(always)]
    fn hypotenuse_with_one(self) -> Self {
        // Not beyond 10¹⁴⁰, where a square has no room: 2⁻¹⁰⁰ is the least that one number of a start is of another.
        (self * self)
            .add_alike(Self::from_double(1.0))
            .square_root()
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self.0.value()
    }

    fn angle(cosine: Self, sine: Self) -> Self {
        Self(DoubleDouble::angle(cosine.0, sine.0))
    }
}

impl Add for Lane {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([a, a_low], [b, b_low]) = (self.words(), other.words());
        let sum = DoubleDouble::sum(a, b);
        Self::pair(sum.high(), sum.low() + (a_low + b_low))
    }
}

impl Sub for Lane {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Lane {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let ([a, a_low], [b, b_low]) = (self.words(), other.words());
        let (high, low) = quick::exact_product(a, b);
        Self::pair(high, low + (a * b_low + a_low * b))
    }
}

impl Div for Lane {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let ([a, a_low], [b, b_low]) = (self.words(), other.words());
        let inverse = 1.0 / b;
        let leading = a * inverse;
        let (product, error) = quick::exact_product(leading, b);
        let rest = ((a - product) - error) + (a_low - leading * b_low);
        Self::pair(leading, rest * inverse)
    }
}

impl Neg for Lane {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Number for Lane {
    type Narrow = Self;

    #[inline(always)]
    fn from_double(value: f64) -> Self {
        Self(DoubleDouble::from(value))
    }

    #[inline(always)]
    fn leading(self) -> f64 {
        self.0.high()
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        let [high, low] = self.words();
        let root = high.sqrt();
        let (square, error) = quick::exact_product(root, root);
        // Of zero nothing is left to be divided.
        let inverse = 0.5
            / if root > f64::MIN_POSITIVE {
                root
            } else {
                f64::MIN_POSITIVE
            };
        Self::pair(root, (((high - square) - error) + low) * inverse)
    }

    #[inline(always)]
    fn quotient(self, divisor: Self) -> Self {
        self / divisor
    }

    #[inline(always)]
    fn difference(a: f64, b: f64) -> Self {
        Self(DoubleDouble::sum(a, -b))
    }

    #[inline(always)]
    fn from_narrow(number: Self) -> Self {
        number
    }

    #[inline(always)]
    fn narrow(self) -> Self {
        self
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        let [high, low] = self.words();
        let (product, error) = quick::exact_product(high, factor);
        Self::pair(product, error + low * factor)
    }

    #[inline(always)]
    fn root_of_quotient(self, divisor: Self) -> f64 {
        (self.value() / divisor.value()).sqrt()
    }

    /// By the leading words: where they are equal, it does not matter.
    #[inline(always)]
    fn exceeds(self, other: Self) -> bool {
        self.leading() > other.leading()
    }

    fn logarithm(self) -> Self {
        Self(Number::logarithm(self.0))
    }

    fn rough_cube_root(self) -> Self {
        Self(Number::rough_cube_root(self.0))
    }

    fn from_extended(number: Extended) -> Self {
        Self(number.narrow())
    }
}
