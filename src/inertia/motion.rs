//! Momentum and energy of a body in motion, split as in tutorial 2.1 to 2.3.

use super::body::MassProperties;
use crate::error::{Result, each_finite};
use crate::frame::{BodyVector, finite_vector};

/// An instant of rigid motion: the base point O, its velocity U, and the angular velocity Ω (2.2).
///
/// All three along the body's axes: metres, m/s, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RigidMotion {
    /// The base point O, m.
    pub base: BodyVector,
    /// Velocity U of the base point, m/s.
    pub velocity: BodyVector,
    /// Angular velocity Ω, rad/s; the same for every base point.
    pub omega: BodyVector,
}

/// Angular momentum about the base point, kg m²/s, in its two parts (2.2).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AngularMomentumSplit {
    /// M(C−O)∧U, due to the base point's motion; zero if O = C, if U = 0, or if U is parallel to C−O.
    pub of_motion: BodyVector,
    /// IΩ, with I about the base point.
    pub of_rotation: BodyVector,
}

/// Kinetic energy, J, in its three parts (2.3).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EnergySplit {
    /// ½M|U|².
    pub of_motion: f64,
    /// ⟨U, Ω∧M(C−O)⟩; zero if O = C or U = 0.
    pub cross: f64,
    /// ½⟨IΩ, Ω⟩, with I about the base point.
    pub of_rotation: f64,
}

impl RigidMotion {
    /// Velocity of the body's point at `x`, m/s: U + Ω∧(x−O) (2.2).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::RigidMotion};
    /// let motion = RigidMotion { base: BodyVector::zero(), velocity: BodyVector::new(1.0, 0.0, 0.0), omega: BodyVector::new(0.0, 0.0, 2.0) };
    /// assert_eq!(motion.velocity_at(BodyVector::new(0.0, 0.5, 0.0)), BodyVector::zero());
    /// ```
    pub fn velocity_at(&self, x: BodyVector) -> BodyVector {
        self.velocity + self.omega.cross(&(x - self.base))
    }

    /// The same motion described from another base point (2.2): U changes by Ω∧P, P from the old point to the new; Ω does not change.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::RigidMotion};
    /// let motion = RigidMotion { base: BodyVector::zero(), velocity: BodyVector::new(1.0, 0.0, 0.0), omega: BodyVector::new(0.0, 0.0, 2.0) };
    /// let contact = motion.seen_from(BodyVector::new(0.0, 0.5, 0.0));
    /// assert_eq!((contact.velocity, contact.omega), (BodyVector::zero(), motion.omega));
    /// ```
    pub fn seen_from(&self, base: BodyVector) -> Self {
        Self {
            base,
            velocity: self.velocity_at(base),
            omega: self.omega,
        }
    }

    /// Momentum of the body, kg m/s: mass times velocity of its centre (2.1).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::{RigidMotion, shapes}};
    /// let motion = RigidMotion { base: BodyVector::zero(), velocity: BodyVector::new(2.0, 0.0, 0.0), omega: BodyVector::zero() };
    /// assert_eq!(motion.momentum(&shapes::ball(5.0, 2.0)?), BodyVector::new(10.0, 0.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn momentum(&self, body: &MassProperties) -> BodyVector {
        body.mass() * self.velocity_at(body.center())
    }

    /// Angular momentum of the body about the base point, in its two parts (2.2).
    ///
    /// # Errors
    /// As [`MassProperties::about`] for the base point; [`Error::NotFinite`](crate::Error::NotFinite) for a part.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::{RigidMotion, shapes}};
    /// let motion = RigidMotion { base: BodyVector::zero(), velocity: BodyVector::zero(), omega: BodyVector::new(0.0, 0.0, 2.0) };
    /// assert_eq!(motion.angular_momentum(&shapes::ball(5.0, 2.0)?)?.of_rotation.z(), 16.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum(&self, body: &MassProperties) -> Result<AngularMomentumSplit> {
        let arm = body.center() - self.base;
        let of_motion = (body.mass() * arm).cross(&self.velocity);
        let of_rotation = body.about(self.base)?.angular_momentum(self.omega);
        Ok(AngularMomentumSplit {
            of_motion: finite_vector("the angular momentum of the motion", of_motion)?,
            of_rotation: finite_vector("the angular momentum of the rotation", of_rotation)?,
        })
    }

    /// Kinetic energy of the body, in its three parts (2.3).
    ///
    /// # Errors
    /// As [`MassProperties::about`] for the base point; [`Error::NotFinite`](crate::Error::NotFinite) for a part.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::{RigidMotion, shapes}};
    /// let motion = RigidMotion { base: BodyVector::zero(), velocity: BodyVector::zero(), omega: BodyVector::new(0.0, 0.0, 2.0) };
    /// assert_eq!(motion.energy(&shapes::ball(5.0, 2.0)?)?.of_rotation, 16.0);
    /// // A heavy body that creeps: U² is below every double.
    /// let creeping = RigidMotion { velocity: BodyVector::new(1e-200, 0.0, 0.0), ..motion };
    /// assert!((creeping.energy(&shapes::ball(2e300, 1e-20)?)?.of_motion / 1e-100 - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self, body: &MassProperties) -> Result<EnergySplit> {
        let arm = body.center() - self.base;
        let split = EnergySplit {
            of_motion: 0.5 * (body.mass() * self.velocity).dot(&self.velocity),
            cross: self.velocity.dot(&self.omega.cross(&(body.mass() * arm))),
            of_rotation: body.about(self.base)?.rotational_energy(self.omega),
        };
        let parts = [split.of_motion, split.cross, split.of_rotation];
        each_finite("a part of the energy", parts)?;
        Ok(split)
    }
}
