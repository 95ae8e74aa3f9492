//! Methods for a turning body: the attitude stays a rotation, |L| is conserved, and most methods conserve more.
//!
//! | method | for | order | what a step is |
//! |---|---|---|---|
//! | [`FreeSplitting`] | free bodies | 2, 4, 6 | exact rotations about two principal axes in turn |
//! | [`MoserVeselov`] | free bodies | 2, 4, 6, 10 | the discrete free top, itself integrable, with modified moments of inertia |
//! | [`GroupMidpoint`] | free bodies | 2 | the implicit midpoint rule with rotations in place of sums |
//! | [`HeavySplitting`] | torques that depend on the attitude | 2, 4, 6 | kicks by the torque and exact rotations in turn |
//! | [`MuntheKaas`] | any torque | 4 | a Runge–Kutta step of the rotation vector |
//!
//! A method is an [`Integrator`]: it prepares a [`Stepper`] for a phase and a step. The stepper keeps what the steps share, and their rounding errors
//! (Kahan): over 10⁷ steps, in one call or one by one, |L| is off by 4e-15, the energy by no more than its oscillation (symplectic methods) or
//! 9e-14 (implicit ones, a random walk). [`follow`] gives samples at any times.
//!
//! `tests/sections/integrators/preservation.rs` measures what each method conserves, `cargo bench -p lab --bench integrators` what a step costs.
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
pub(crate) use stepper::unit;
pub use stepper::{Integrator, Phase, Stepper};
pub use torque::{Torque, Weight};
