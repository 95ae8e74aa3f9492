//! What changes momentum and angular momentum (tutorial 3.2).

use crate::error::{Result, positive};
use crate::frame::{SpaceVector, finite_vector};

/// A total force and its total torque about a stated point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceAndTorque {
    /// F, newtons.
    pub force: SpaceVector,
    /// N about the stated point, newton metres: the dimension of an energy, although it is a vector (3.2).
    pub torque: SpaceVector,
}

/// Force Mg and torque (C−O)∧Mg of uniform gravity on a body of any shape (tutorial 3.2): gravity acts at
/// the centre of mass, and has no torque about it.
///
/// `mass` in kg, `center` and `about` in metres, `gravity` the vector **g** in m/s².
/// [`Particles::force_and_torque`](super::Particles::force_and_torque) sums the same over points.
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) or [`Error::NotFinite`](crate::Error::NotFinite) for the
/// mass, `NotFinite` for a vector, or where force or torque overflows.
///
/// ```
/// use spinning_bodies::{conservation::uniform_gravity, frame::SpaceVector};
/// let down = SpaceVector::new(0.0, 0.0, -10.0);
/// let pull = uniform_gravity(3.0, SpaceVector::new(2.0, 0.0, 0.0), SpaceVector::zero(), down)?;
/// assert_eq!((pull.force.z(), pull.torque.y()), (-30.0, 60.0));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn uniform_gravity(
    mass: f64,
    center: SpaceVector,
    about: SpaceVector,
    gravity: SpaceVector,
) -> Result<ForceAndTorque> {
    let mass = positive("the mass", mass)?;
    finite_vector("the centre of mass", center)?;
    finite_vector("the point that torque is taken about", about)?;
    finite_vector("gravity", gravity)?;
    let force = finite_vector("the weight", mass * gravity)?;
    let torque = (center - about).cross(&force);
    Ok(ForceAndTorque {
        force,
        torque: finite_vector("the torque of the weight", torque)?,
    })
}

/// dL/dt about a point O that moves at `point_velocity` U: N − U∧P (tutorial 3.2, the reason for its hypothesis 2.2).
///
/// `torque` N is the total outside torque about O in N m, `momentum` P in kg m/s. The extra term vanishes exactly
/// if U is parallel to P: for O at rest, for O = C, and for the contact point of a body that rolls straight.
/// The velocities in L are relative to axes at rest. An argument that is not finite makes the result not finite.
///
/// ```
/// use spinning_bodies::{conservation::angular_momentum_rate, frame::SpaceVector};
/// // Even without torque, L about a point that moves across the momentum changes.
/// let (moving, momentum) = (SpaceVector::new(1.0, 0.0, 0.0), SpaceVector::new(0.0, 2.0, 0.0));
/// let rate = angular_momentum_rate(SpaceVector::zero(), moving, momentum);
/// assert_eq!(rate, SpaceVector::new(0.0, 0.0, -2.0));
/// ```
pub fn angular_momentum_rate(
    torque: SpaceVector,
    point_velocity: SpaceVector,
    momentum: SpaceVector,
) -> SpaceVector {
    torque - point_velocity.cross(&momentum)
}
