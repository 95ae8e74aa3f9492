//! Exact fractions, in which identities are equalities.

use num_rational::Ratio;

pub type R = Ratio<i128>;

pub const ZERO: R = R::new_raw(0, 1);
pub const ONE: R = R::new_raw(1, 1);
pub const TWO: R = R::new_raw(2, 1);

pub fn whole(number: i128) -> R {
    R::from_integer(number)
}

pub fn rational(numerator: i128, denominator: i128) -> R {
    Ratio::new(numerator, denominator)
}

/// The nearest number: both parts are small, so this is one correctly rounded division.
pub fn exact(r: R) -> f64 {
    *r.numer() as f64 / *r.denom() as f64
}
