//! Jacobi's elliptic functions and the elliptic integrals, with the complement of every parameter as an argument.
//!
//! # Conventions
//!
//! - The parameter is m = k², k the modulus, mc = 1 − m the complement: [`Parameter`] carries the lesser, so that next to
//!   the separatrix, m → 1, nothing is lost. For the functions `m` and `mc` lie in 0…1, the ends included; the integrals are
//!   taken for any m at which they are real.
//! - K = ∫₀^{π/2} dθ/√(1 − m sin²θ); am is the inverse of F: F(am u) = u; sn = sin am, cn = cos am, dn = √(1 − m sn²).
//! - Π has the factor 1/(1 − n sin²θ): for 0 < n < 1 it is greater than F. For n > 1 it is the principal
//!   value, and continues beyond π/2 in φ as F does.
//! - Angles in radians; a function of two angles takes the amplitude φ, never its sine.
//!
//! # Contents
//!
//! | | |
//! |---|---|
//! | [`Parameter`], [`Characteristic`] | m and mc in 0…1; n and nc of any size, or an m outside 0…1 in the integrals |
//! | [`Modulus`] | prepared once; then sn, cn, dn, am of any argument |
//! | [`complete_first`] K, [`complete_first_excess`] K − π/2, [`complete_second`] E, [`complete_d`] D, [`complete_b`] B, [`complete_third`] Π | complete integrals |
//! | [`incomplete_first`] F, [`incomplete_second`] E, [`incomplete_third`] Π | at any angle |
//! | [`inverse_sn`], [`inverse_cn`], [`inverse_dn`], [`inverse_cn_sn`] | the argument that belongs to a value |
//! | [`rf`], [`rc`], [`rd`], [`rj`], [`rg`] | Carlson's symmetric forms R_F, R_C, R_D, R_J, R_G of any doubles |
//!
//! # Accuracy
//!
//! Errors are measured against references of 34 digits at exact arguments; the scripts that make them use two independent
//! routes each. For the Jacobi functions see [`Modulus::jacobi`]. The integrals are formed in twice the precision, complete ones of the second
//! and third kind to 63 bits and more, and rounded once:
//! at most 0.47 ε in 1800 rows, 600 of them over the whole range of doubles, and 0.60 ε in 1200 with another seed, no row left out. For comparison, the crate `ellip` 1.2 was measured on
//! the 1232 rows of `elliptic_integrals.csv` whose functions it has, once with m and n rounded and once through Bulirsch's forms, which take √mc and nc. The table shows the better of the two: the
//! greatest error of its finite answers in ε, and the rows on which it has none, because it refuses or returns infinity or NaN:
//!
//! | | ours | `ellip`, ordinary arguments | `ellip`, hard ones |
//! |---|---|---|---|
//! | K | 0.32 | 1.0 | none on 9 rows of 16 next to m = 1 |
//! | E, D | 0.45 | 2.0 | 2.1, D none on 9 rows of 16 next to m = 1 |
//! | B | 0.30 | 1.9 | 2.5, none on 9 rows of 16 next to m = 1 |
//! | F | 0.38 | 1.3 | 53 next to π/2 and at long angles, none on 8 rows of 36 |
//! | E(φ) | 0.37 | 2.0 | 1.3 |
//! | Π | 0.46 | 2.5, none on 1 row of 9 | principal value 2.4, none on 15 rows of 24; n = −10³⁰⁰ with mc = 10⁻³⁰⁰ none |
//! | Π(φ) | 0.45 | no digit right in the worst row | no digit right in the worst rows: n ≪ 0, n → 1, principal values, m = 0, m = 1 |
//! | R_F, R_C, R_D | 0.46 | 2.2 | 1.4 |
//! | R_J | 0.43 | 2.5 | principal value 8.8 |
//! | R_G | 0.43 | 1.5 | 8.5 with arguments 10^±140 |
//!
//! `cargo bench -p lab --bench elliptic_accuracy` prints the whole comparison. The price is time: 0.03–0.3 µs a
//! complete integral and 0.3–9 µs an incomplete one, where `ellip` itself reports 0.01–0.3 µs. Relative to Boost in long double, which has 64 bits, in one
//! run: F 1.7 of its time, E(φ) 0.9, Π(φ) 0.7–0.8, R_F 1.9–2.0, R_D 0.6, R_J 0.7–0.8, R_C 1.8–2.1, R_G 1.5 (`cargo bench -p lab --bench elliptic` prints them).

mod carlson;
mod integrals;
mod jacobi;
pub(crate) mod landen;
pub(crate) mod lanes;
pub(crate) mod modulus;
mod parameter;
pub(crate) mod theta;

pub use carlson::{rc, rd, rf, rg, rj};
pub use integrals::{
    complete_b, complete_d, complete_first, complete_first_excess, complete_second, complete_third,
    incomplete_first, incomplete_second, incomplete_third, inverse_cn, inverse_cn_sn, inverse_dn,
    inverse_sn,
};
pub use jacobi::{Jacobi, sn_cn_dn};
pub use modulus::Modulus;
pub(crate) use parameter::Side;
pub use parameter::{Characteristic, Parameter};
