//! Methods that know they are turning a body: the attitude stays a rotation, |L| stays, and most keep more than that.
//!
//! | method | for | order | what a step is |
//! |---|---|---|---|
//! | [`FreeSplitting`] | free bodies | 2, 4, 6 | exact rotations about two principal axes in turn |
//! | [`MoserVeselov`] | free bodies | 2, 4, 6, 10 | the discrete free top, itself integrable, its moments of inertia chosen to fit |
//! | [`GroupMidpoint`] | free bodies | 2 | the implicit midpoint rule with rotations for sums |
//! | [`HeavySplitting`] | torques of the attitude | 2, 4, 6 | kicks by the torque and exact rotations in turn |
//! | [`MuntheKaas`] | any torque | 4 | Runge–Kutta in the rotation vector |
//!
//! A method is an [`Integrator`]: it prepares a [`Stepper`] for a phase and a step. The stepper keeps what steps share, and what rounding leaves over
//! (Kahan): over 10⁷ steps, taken together or one by one, |L| is off by 4e-15, the energy by no more than its oscillation (symplectic methods) or
//! 9e-14 (implicit ones, a random walk). [`follow`] gives samples at any times.
//!
//! What each method keeps is measured by `tests/sections/integrators/preservation.rs`; what a step costs, by `cargo bench -p lab --bench integrators`.
//!
//! ```
//! use spinning_bodies::frame::{Attitude, BodyVector};
//! use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
//! let racket = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
//! let start = Phase::new(BodyVector::new(0.01, 2.0, 0.0), &Attitude::identity());
//! let mut forward = racket.start(&start, 0.02)?;
//! for _ in 0..100_000 {
//!     forward.step()?;
//! }
//! let far = forward.phase()?;
//! let size = |p: &Phase| p.angular_momentum().norm();
//! assert!((size(&far) / size(&start) - 1.0).abs() < 1e-14);
//! // Back again, all steps in one call.
//! let mut backward = racket.start(&far, -0.02)?;
//! backward.advance(100_000)?;
//! assert!((backward.phase()?.l[1] - start.l[1]).abs() < 1e-11);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod cayley;
mod coefficients;
mod follow;
mod munthe_kaas;
mod preprocessing;
mod splitting;
mod stepper;
mod torque;

pub use super::real::Real;
pub use crate::precise::DoubleDouble;
pub use cayley::{GroupMidpoint, MoserVeselov, VeselovOrder};
pub use follow::follow;
pub use munthe_kaas::MuntheKaas;
pub use splitting::{FreeSplitting, HeavySplitting, Order};
pub use stepper::{Integrator, Phase, Stepper};
pub use torque::{Torque, Weight};
