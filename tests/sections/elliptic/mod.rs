//! Jacobi functions and elliptic integrals against tables of 34 digits, over successive floats, at their ends, and on
//! bad input. The tables and the scripts that made them lie in `tests/reference`.

mod common;
mod ends;
mod integrals;
mod jacobi;
mod refusals;
