//! The laboratory of the book *Spinning Bodies*: it measures the errors of methods, and their times.
//!
//! | module | what it holds |
//! |---|---|
//! | [`accuracy`] | every method on eight motions of tops: error against cost |
//! | [`follow`] | a common trait for methods that follow the motion of a body, and order 8 written for one |
//! | [`general`] | methods for any equations, also applied to a body; like `accuracy` behind the feature `general`, a default |
//! | [`hard_cases`] | textbook formulas beside the library's, where digits are lost |
//! | [`stopwatch`] | the least time of repeated calls |
//!
//! The benches print tables of time and error: `cargo bench -p lab`, or with other libraries measured in the same run
//! `cargo bench -p lab --features peers`.
//!
//! | `--bench …` | what | beside |
//! |---|---|---|
//! | `elliptic` | sn, cn, dn | GSL, if `lab/peers/build.sh` was run |
//! | `elliptic_accuracy` | errors of the elliptic integrals | ellip (`peers`) |
//! | `ensembles` | many free tops at once | one at a time |
//! | `euler_top` | one state of a free top | GSL and Boost.Math on request |
//! | `hard_cases` | the library's formulas | the textbook's |
//! | `inertia` | mesh integrals, principal axes | parry3d (`peers`), nalgebra |
//! | `integrators` | one step of each geometric method, and 10⁷ steps | Runge–Kutta, DOP853 |
//! | `kovalevskaya_top` | one state of Kovalevskaya's top | Runge–Kutta, DOP853 |
//! | `lagrange_top` | one state of Lagrange's top | Runge–Kutta, DOP853, rapier3d (`peers`) |
//! | `scenes` | a scene with an effect | the same without |

#[cfg(feature = "general")]
pub mod accuracy;
pub mod follow;
#[cfg(feature = "general")]
pub mod general;
pub mod hard_cases;
pub mod stopwatch;
mod table;

use spinning_bodies::Error;
pub use spinning_bodies::Result;

/// The value, if it is finite.
const fn finite(quantity: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity, value })
    }
}
