//! Where methods are judged, and where clocks run: the laboratory of the book *Spinning Bodies*.
//!
//! | module | what it holds |
//! |---|---|
//! | [`accuracy`] | every method on every kind of top: error against cost |
//! | [`follow`] | one way to ask any method for the motion of a body, and order 8 written for one |
//! | [`general`] | methods for any equations, and the same asked for the motion of a body; with `accuracy` behind the feature `general`, a default |
//! | [`hard_cases`] | textbook formulas beside the library's, where digits go |
//! | [`stopwatch`] | the least time of repeated calls |
//!
//! The benches print tables of time and error, ours and the peers' in one run: `cargo bench -p lab`, with those beside other libraries
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
//! | `integrators` | one step of each geometric method, and 10⁷ of them | Runge–Kutta, DOP853 |
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

/// What is no number is refused.
const fn finite(quantity: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { quantity, value })
    }
}
