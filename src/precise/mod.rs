//! Numbers that hold more than a double: of two words, 106 bits, and with an exponent of their own.
//!
//! | module | what it holds |
//! |---|---|
//! | [`number`] | what formulas ask of a number, so that they are written once: two words, and two with an exponent |
//! | [`double_double`] | an unevaluated sum of two doubles |
//! | [`extended`] | the same with a wide exponent: no product is too large or too small; exact sums of products |
//! | [`quick`] | the pieces that have no branch |
//! | [`logarithm`], [`angle`] | of two words |
//!
//! Operators are safe: sums keep their digits however much cancels. `add_alike` is the quick sum of terms that do not cancel.

mod angle;
mod double_double;
mod extended;
mod logarithm;
mod number;
pub(crate) mod quick;

pub(crate) use angle::{RIGHT_ANGLE, angle};
pub use double_double::DoubleDouble;
pub(crate) use double_double::power_of_two_below;
pub(crate) use extended::{Extended, exponent_of, power, shifted, sum_of_products};
pub(crate) use logarithm::{FIFTH, THIRD, logarithm};
pub(crate) use number::Number;
