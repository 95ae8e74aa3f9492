//! Jacobi functions and elliptic integrals against tables of 34 digits, over successive floats, at their ends, and on
//! bad input. The tables and the scripts that made them lie in `tests/reference`.

mod common;
mod ends;
mod integrals;
mod jacobi;
mod refusals;

use super::*;
use common::*;
use spinning_bodies::elliptic::{
    Characteristic, Jacobi, Modulus, Parameter, complete_b, complete_d, complete_first,
    complete_second, complete_third, incomplete_first, incomplete_second, incomplete_third,
    inverse_cn, inverse_cn_sn, inverse_dn, inverse_sn, rc, rd, rf, rg, rj,
};
use support::decimal::{hexadecimal, relative_error};
