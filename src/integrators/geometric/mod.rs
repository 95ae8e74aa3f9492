//! Methods that know they are turning a body: the attitude stays a rotation, |L| stays, and most keep more than that.
//!
//! | method | for | order | what a step is |
//! |---|---|---|---|
//! | [`FreeSplitting`] | free bodies | 2, 4, 6 | exact rotations about two principal axes in turn |
//! | [`MoserVeselov`] | free bodies | 2, 4, 6, 10 | the discrete free top, itself integrable, its moments of inertia chosen to fit |
//! | [`GroupMidpoint`] | free bodies | 2 | the implicit midpoint rule with rotations for sums |
//! | [`HeavySplitting`] | any torque | 2, 4, 6 | exact kicks by the torque between exact free motions |
//! | [`MuntheKaas`] | any torque | 4 | Runge–Kutta in the rotation vector |
//! | [`DormandPrince8`] | any torque | 8 | explicit Runge–Kutta with error control, the quaternion kept at norm 1 |
//!
//! All share [`Integrator`]: a phase, a step, a number of steps. Long runs keep what rounding leaves over (Kahan): over 10⁷ steps |L| is off by
//! 4e-15, the energy by no more than its oscillation (symplectic methods) or 9e-14 (implicit ones, a random walk).
//!
//! [`Follow`] is the wider trait: samples at given times, asked by a step or a tolerance. What each method keeps is measured by
//! `tests/integrators/preservation.rs`; what a step costs, by `cargo bench -p lab --bench integrators`.
//!
//! ```
//! use spinning_bodies::frame::{Attitude, BodyVector};
//! use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
//! let racket = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
//! let start = Phase::new(BodyVector::new(0.01, 2.0, 0.0), &Attitude::identity());
//! let mut phase = start;
//! racket.advance(&mut phase, 0.02, 100_000)?;
//! let size = |p: &Phase| p.angular_momentum().norm();
//! assert!((size(&phase) / size(&start) - 1.0).abs() < 1e-14);
//! // Back again, step by step.
//! racket.advance(&mut phase, -0.02, 100_000)?;
//! assert!((phase.l[1] - start.l[1]).abs() < 1e-11);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod cayley;
mod coefficients;
mod dormand_prince;
mod drift;
mod follow;
mod heavy;
mod munthe_kaas;
mod preprocessing;
mod splitting;

pub use super::real::Real;
pub use crate::precise::DoubleDouble;
pub use cayley::{GroupMidpoint, MoserVeselov, VeselovOrder};
pub use dormand_prince::DormandPrince8;
pub use drift::{Drift, Rotations, SymmetricDrift, UnequalDrift};
pub use follow::{Course, Follow, Watched};
pub use heavy::{HeavySplitting, Kick, LinearFriction, Nothing, Torque, Weight};
pub use munthe_kaas::MuntheKaas;
pub use splitting::FreeSplitting;

use super::Cost;
use super::real::{Sums, product};
use crate::error::{Error, Result, finite};
use crate::euler_equations::AxisMoments;
use crate::frame::{Attitude, BodyVector};

/// A body at one time: all that a geometric method carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase<T = f64> {
    /// L along the body's principal axes, kg m²/s.
    pub l: [T; 3],
    /// The attitude's quaternion (w, x, y, z), body to space; every method begins by giving it norm 1.
    pub q: [T; 4],
}

impl Phase {
    /// With this L and attitude.
    pub fn new(l: BodyVector, attitude: &Attitude) -> Self {
        let q = attitude.quaternion();
        Self {
            l: l.components().into(),
            q: [q.w, q.i, q.j, q.k],
        }
    }

    /// L along the body's axes.
    pub fn angular_momentum(&self) -> BodyVector {
        let [x, y, z] = self.l;
        BodyVector::new(x, y, z)
    }

    /// How the body stands in space.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::ZeroVector`] for a quaternion that is none.
    pub fn attitude(&self) -> Result<Attitude> {
        let [w, x, y, z] = self.q;
        Attitude::from_quaternion(w, x, y, z)
    }
}

impl<T: Real> Phase<T> {
    /// The same in other numbers.
    pub fn cast<U: Real>(&self) -> Phase<U> {
        Phase {
            l: self.l.map(|x| U::from_double(x.to_double())),
            q: self.q.map(|x| U::from_double(x.to_double())),
        }
    }

    /// The upward unit vector z along the body's axes: the third row of the rotation matrix, divided by |q|² ≈ 1.
    #[inline(always)]
    pub fn up(&self) -> [T; 3] {
        let [w, x, y, z] = self.q;
        let two = T::from_double(2.0);
        [
            two * (x * z - w * y),
            two * (y * z + w * x),
            (w * w + z * z) - (x * x + y * y),
        ]
    }

    fn check(&self) -> Result<()> {
        for component in self.l {
            finite("the angular momentum", component.to_double())?;
        }
        for component in self.q {
            finite("the attitude's quaternion", component.to_double())?;
        }
        Ok(())
    }
}

/// A method with steps of one length.
pub trait Integrator<T: Real = f64> {
    /// Its name, as in the tables.
    fn name(&self) -> String;

    /// The order p: the error of a run is proportional to stepᵖ.
    fn order(&self) -> u32;

    /// `steps` steps of `step` seconds; negative ones run backwards.
    ///
    /// What the whole run shares, sums with their leftovers and factors of the motion that commute with the rest, is set up and settled once a
    /// call: one call for many steps is faster and more exact than many calls. The attitude's norm is 1 afterwards, to rounding.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for phase and step, before and after; [`Error::Integration`] where an implicit step has no solution.
    fn advance(&self, phase: &mut Phase<T>, step: T, steps: u64) -> Result<Cost>;
}

/// Order of a splitting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Strang's: one stage.
    Two,
    /// Blanes' and Moan's: six stages.
    Four,
    /// Blanes' and Moan's: ten stages, eleven with kicks.
    Six,
}

impl Order {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Two, Self::Four, Self::Six];

    /// As a number.
    pub const fn number(self) -> u32 {
        match self {
            Self::Two => 2,
            Self::Four => 4,
            Self::Six => 6,
        }
    }
}

/// What a run carries from step to step: the phase, each component with what rounding has left of it.
#[derive(Debug, Clone, Copy)]
pub struct Run<T> {
    l: Sums<T, 3>,
    q: Sums<T, 4>,
}

impl<T: Real> Run<T> {
    fn new(phase: &Phase<T>) -> Self {
        Self {
            l: Sums::new(phase.l),
            q: Sums::new(unit(phase.q)),
        }
    }

    /// The phase here, its norm not restored.
    #[inline(always)]
    pub fn phase(&self) -> Phase<T> {
        Phase {
            l: self.l.values,
            q: self.q.values,
        }
    }

    /// Adds to L.
    #[inline(always)]
    pub fn push(&mut self, change: [T; 3]) {
        self.l.add_all(change);
    }

    /// Turns the body by a rotation whose quaternion, less 1, is `turn`: q becomes q(1 + turn), L becomes what a rider sees of it.
    ///
    /// `change` is that change of L: the caller has it with fewer roundings than the quaternion would give it.
    #[inline(always)]
    pub fn turn(&mut self, turn: [T; 4], change: [T; 3]) {
        self.q.add_all(product(self.q.values, turn));
        self.l.add_all(change);
    }

    fn settle(&self, phase: &mut Phase<T>) -> Result<()> {
        phase.l = self.l.values;
        phase.q = unit(self.q.values);
        phase.check()
    }
}

/// The same quaternion with norm 1.
fn unit<T: Real>(q: [T; 4]) -> [T; 4] {
    let square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    let scale = square.square_root().reciprocal();
    q.map(|x| x * scale)
}

/// Moments that a body can have, each positive.
fn checked_moments(moments: [f64; 3]) -> Result<[f64; 3]> {
    let [a, b, c] = moments;
    Ok(AxisMoments::new(a, b, c)?.values())
}

fn checked_run<T: Real>(phase: &Phase<T>, step: T) -> Result<()> {
    phase.check()?;
    finite("the step", step.to_double())?;
    let size = phase.q.iter().map(|x| x.to_double().abs()).sum::<f64>();
    if size == 0.0 {
        return Err(Error::ZeroVector {
            quantity: "the attitude's quaternion",
        });
    }
    Ok(())
}
