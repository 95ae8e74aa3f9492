//! What dynamics can notice of a body: mass, centre, inertia matrix (tutorial 2.4, 2.5, 2.8).

use nalgebra::{Matrix3, Vector3};

use super::InertiaMatrix;
use super::matrix::particle_term;
use crate::error::{Error, Result, finite, positive, within};
use crate::frame::{Attitude, BodyVector};

/// Mass, centre of mass, and the inertia matrix about the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Written")
)]
pub struct MassProperties {
    mass: f64,
    center: BodyVector,
    inertia: InertiaMatrix,
}

/// A body as it was written, not yet known to be one.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Written {
    mass: f64,
    center: BodyVector,
    inertia: InertiaMatrix,
}

#[cfg(feature = "serde")]
impl TryFrom<Written> for MassProperties {
    type Error = crate::Error;

    fn try_from(written: Written) -> Result<Self> {
        Self::new(written.mass, written.center, written.inertia)
    }
}

/// Coordinates of centres stay below this, so that turning a body cannot overflow.
const FARTHEST: f64 = 1e307;

impl MassProperties {
    /// The body with this mass (kg), centre of mass (m) and inertia matrix about that centre (kg m²).
    ///
    /// # Errors
    /// [`Error::NotPositive`] or [`Error::NotFinite`] for the mass, [`Error::OutOfRange`] or [`Error::NotFinite`] for a
    /// centre whose coordinates exceed 1e307 m.
    pub fn new(mass: f64, center: BodyVector, inertia: InertiaMatrix) -> Result<Self> {
        positive("the mass", mass)?;
        for coordinate in center.components().iter() {
            let value = finite("a coordinate of the centre of mass", *coordinate)?;
            within(
                "a coordinate of the centre of mass",
                value,
                -FARTHEST,
                FARTHEST,
            )?;
        }
        Ok(Self {
            mass,
            center,
            inertia,
        })
    }

    /// A particle: its inertia matrix about itself is zero.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn particle(mass: f64, position: BodyVector) -> Result<Self> {
        Self::new(mass, position, InertiaMatrix::diagonal(0.0, 0.0, 0.0)?)
    }

    /// Several bodies taken as one rigid body (2.8).
    ///
    /// The centre is the weighted mean of the centres; each part's matrix is moved there by parallel axes.
    /// Offsets are differences of centres, never distances from the origin, so a body far from the origin loses
    /// nothing beyond the rounding of its coordinates. Cost: two passes over the parts.
    ///
    /// # Errors
    /// [`Error::Empty`] for no parts, [`Error::NotFinite`] on overflow.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::MassProperties};
    /// let dumbbell = MassProperties::compose(&[
    ///     MassProperties::particle(1.0, BodyVector::new(0.0, 0.0, -1.0))?,
    ///     MassProperties::particle(1.0, BodyVector::new(0.0, 0.0, 1.0))?,
    /// ])?;
    /// assert_eq!(dumbbell.inertia().matrix()[(0, 0)], 2.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn compose(parts: &[Self]) -> Result<Self> {
        let first = parts.first().ok_or(Error::Empty {
            quantity: "the list of bodies to compose",
        })?;
        let mass = finite("the mass", parts.iter().map(|part| part.mass).sum())?;
        let origin = first.center.components();
        let mut offset = Vector3::zeros();
        for part in parts {
            offset += (part.mass / mass) * (part.center.components() - origin);
        }
        let center = origin + offset;
        let mut inertia = Matrix3::zeros();
        for part in parts {
            // Distance from the common centre by way of the reference point: both differences are small.
            let d = (part.center.components() - origin) - offset;
            inertia += part.inertia.matrix() + particle_term(part.mass, &d);
        }
        Self::new(
            mass,
            BodyVector::from_components(center),
            InertiaMatrix::checked(inertia)?,
        )
    }

    /// Mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Centre of mass, m, from the origin of the body's axes.
    pub const fn center(&self) -> BodyVector {
        self.center
    }

    /// Inertia matrix about the centre of mass, kg m².
    pub const fn inertia(&self) -> InertiaMatrix {
        self.inertia
    }

    /// Inertia matrix about another point, kg m²: parallel axes (2.8).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the point or on overflow.
    pub fn about(&self, point: BodyVector) -> Result<InertiaMatrix> {
        self.inertia
            .shifted_from_center(self.mass, self.center - point)
    }

    /// The same body displaced by `displacement`, m: only the centre changes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn moved(&self, displacement: BodyVector) -> Result<Self> {
        Self::new(self.mass, self.center + displacement, self.inertia)
    }

    /// The same body turned about the origin of its axes: centre R c, inertia matrix R I Rᵀ.
    pub fn turned(&self, attitude: &Attitude) -> Self {
        let center = attitude.to_space(self.center).components();
        Self {
            mass: self.mass,
            center: BodyVector::from_components(center),
            inertia: self.inertia.rotated(attitude),
        }
    }
}
