//! Jacobi's elliptic functions and the elliptic integrals, with the complement of every parameter as an argument.
//!
//! # Conventions
//!
//! - The parameter is m = k², k the modulus, mc = 1 − m the complement: [`Parameter`] carries both, so that next to
//!   the separatrix, m → 1, nothing is lost. `m` and `mc` lie in 0…1, the ends included.
//! - K = ∫₀^{π/2} dθ/√(1 − m sin²θ); am is the inverse of F: F(am u) = u; sn = sin am, cn = cos am, dn = √(1 − m sn²).
//! - Π has the factor 1/(1 − n sin²θ): positive n up to 1 makes it greater than F. For n > 1 it is the principal
//!   value, and goes on with the period π in φ like F does.
//! - Angles in radians; a function of two angles takes the amplitude φ, never its sine.

pub mod carlson;
mod complete;
mod incomplete;
mod inverse;
mod jacobi;
mod kernel;
pub(crate) mod landen;
pub(crate) mod local;
mod logarithm;
mod modulus;
mod parameter;
mod quarter;
mod third;

pub use complete::{complete_b, complete_d, complete_first, complete_second};
pub use incomplete::{incomplete_first, incomplete_second};
pub use inverse::{inverse_cn, inverse_dn, inverse_sn};
pub use jacobi::Jacobi;
pub use modulus::Modulus;
pub(crate) use modulus::Side;
pub use parameter::Parameter;
pub use third::{Characteristic, complete_third, incomplete_third};
