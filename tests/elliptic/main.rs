//! Jacobi functions and elliptic integrals against tables of 34 digits, over successive floats, at their ends, and on
//! bad input. The tables and the scripts that made them lie in `tests/reference`.

#[path = "../support/any.rs"]
mod any;
mod common;
#[path = "../support/decimal.rs"]
mod decimal;
mod ends;
mod integrals;
mod jacobi;
mod refusals;
