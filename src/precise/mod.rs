//! Numbers that hold more than a double: two words with 106 bits, also with a wider exponent.
//!
//! | module | what it holds |
//! |---|---|
//! | [`number`], [`kinds`] | the operations that formulas need, as a trait, so that they are written once for both kinds of number |
//! | [`double_double`] | an unevaluated sum of two doubles |
//! | [`extended`] | two words with an exponent of their own, whose products neither overflow nor underflow; exact sums of products |
//! | [`quick`] | elementary steps without branches |
//! | [`logarithm`], [`angle`] | logarithm and arctangent in two words |
//!
//! The operators keep the digits of a sum however much cancels. `add_alike` is the quick sum, for terms that do not cancel.

mod angle;
mod double_double;
mod extended;
mod kinds;
mod logarithm;
mod number;
pub(crate) mod quick;

pub use double_double::DoubleDouble;
pub(crate) use double_double::{RIGHT_ANGLE, RIGHT_ANGLE_REST, power_of_two_below};
pub(crate) use extended::{Extended, exponent_of, power, shifted, sum_of_products};
pub(crate) use logarithm::{FIFTH, THIRD, logarithm_of_quotient};
pub(crate) use number::{Number, Operators};
