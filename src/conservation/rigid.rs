//! A rigid body in motion: its momentum, angular momentum and energy.

use super::particles::{AngularMomentumSplit, EnergySplit, finite_vector};
use crate::error::{Result, positive};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use nalgebra::Matrix3;

/// A rigid body caught in motion (tutorial 3.2): where its centre is, how it stands, V and Ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    mass: f64,
    inertia: Matrix3<f64>,
    center: SpaceVector,
    velocity: SpaceVector,
    attitude: Attitude,
    omega: BodyVector,
}

impl RigidMotion {
    /// A body of `mass` M (kg) with `inertia` I about its centre along the body's axes (kg m²), its centre at `center`
    /// (m) moving at `velocity` V (m/s), standing as `attitude` says and turning at `omega` Ω (rad/s, body axes).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the mass,
    /// [`Error::NotFinite`](crate::Error::NotFinite) for anything.
    pub fn new(
        mass: f64,
        inertia: Matrix3<f64>,
        center: SpaceVector,
        velocity: SpaceVector,
        attitude: Attitude,
        omega: BodyVector,
    ) -> Result<Self> {
        Ok(Self {
            mass: positive("the mass", mass)?,
            inertia,
            center: finite_vector("the centre of mass", center)?,
            velocity: finite_vector("the velocity of the centre", velocity)?,
            attitude,
            omega: finite_vector("the angular velocity", omega)?,
        })
    }

    /// Momentum P = MV (tutorial 2.2), kg m/s.
    pub fn momentum(&self) -> SpaceVector {
        self.mass * self.velocity
    }

    /// Angular momentum about `point`: (C−O)∧P of the centre and IΩ about it (tutorial 2.2), kg m²/s, space axes.
    pub fn angular_momentum_split(&self, point: SpaceVector) -> AngularMomentumSplit {
        let spin = BodyVector::from_components(self.inertia * self.omega.components());
        AngularMomentumSplit {
            orbital: (self.center - point).cross(&self.momentum()),
            spin: self.attitude.to_space(spin),
        }
    }

    /// Kinetic energy: ½MV² and ½⟨IΩ, Ω⟩ (tutorial 2.3), joules.
    pub fn energy_split(&self) -> EnergySplit {
        let spin = BodyVector::from_components(self.inertia * self.omega.components());
        EnergySplit {
            translational: 0.5 * self.mass * self.velocity.dot(&self.velocity),
            relative: 0.5 * spin.dot(&self.omega),
        }
    }

    /// Velocity of the material point at `point`, V + Ω∧(x−C) (tutorial 2.1), m/s.
    pub fn velocity_at(&self, point: SpaceVector) -> SpaceVector {
        self.velocity + self.attitude.to_space(self.omega).cross(&(point - self.center))
    }
}
