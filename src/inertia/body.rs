//! What dynamics can notice of a body: mass, centre, inertia matrix (tutorial 2.4, 2.5, 2.8).

use nalgebra::{Matrix3, Vector3};

use super::matrix::{InertiaMatrix, particle_term};
use crate::error::{Error, Result, finite, positive, within};
use crate::frame::{Attitude, BodyVector};

/// Mass, centre of mass, and the inertia matrix about the centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Unchecked")
)]
pub struct MassProperties {
    mass: f64,
    center: BodyVector,
    inertia: InertiaMatrix,
}

/// The fields of a body as read from a file, not yet checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Unchecked {
    mass: f64,
    center: BodyVector,
    inertia: InertiaMatrix,
}

#[cfg(feature = "serde")]
impl TryFrom<Unchecked> for MassProperties {
    type Error = crate::Error;

    fn try_from(unchecked: Unchecked) -> Result<Self> {
        Self::new(unchecked.mass, unchecked.center, unchecked.inertia)
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
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::{InertiaMatrix, MassProperties}};
    /// let inertia = InertiaMatrix::diagonal(13.0, 10.0, 5.0)?;
    /// let body = MassProperties::new(12.0, BodyVector::new(0.0, 0.0, 1.0), inertia)?;
    /// assert_eq!((body.mass(), body.center().z(), body.inertia()), (12.0, 1.0, inertia));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(mass: f64, center: BodyVector, inertia: InertiaMatrix) -> Result<Self> {
        positive("the mass", mass)?;
        for coordinate in center.components().iter() {
            let quantity = "a coordinate of the centre of mass";
            within(quantity, *coordinate, -FARTHEST, FARTHEST)?;
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
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::MassProperties};
    /// let particle = MassProperties::particle(2.0, BodyVector::new(0.0, 3.0, 0.0))?;
    /// // Its moment about itself is zero, about the origin mr².
    /// assert_eq!(particle.inertia().matrix()[(0, 0)], 0.0);
    /// assert_eq!(particle.about(BodyVector::zero())?.matrix()[(0, 0)], 18.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn particle(mass: f64, position: BodyVector) -> Result<Self> {
        Self::new(mass, position, InertiaMatrix::diagonal(0.0, 0.0, 0.0)?)
    }

    /// Several bodies taken as one rigid body (2.8).
    ///
    /// The centre is the weighted mean of the centres; each part's matrix is moved there by parallel axes.
    /// Offsets are differences of centres, counted from the heaviest part, never from the origin: a body far from the origin, or a
    /// light part far from the others, loses nothing beyond the rounding of its coordinates. Cost: three passes over the parts.
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
        // The common centre is near it: no offset of a heavy part is a small difference of great ones.
        let heaviest = parts
            .iter()
            .reduce(|a, b| if b.mass > a.mass { b } else { a });
        let heaviest = heaviest.ok_or(Error::Empty {
            quantity: "the list of bodies to compose",
        })?;
        let mass = finite("the mass", parts.iter().map(|part| part.mass).sum())?;
        let origin = heaviest.center.components();
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
    ///
    /// ```
    /// assert_eq!(spinning_bodies::inertia::shapes::ball(5.0, 2.0)?.mass(), 5.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Centre of mass, m, from the origin of the body's axes.
    ///
    /// ```
    /// // The centre of a cone is the origin of its shape.
    /// let cone = spinning_bodies::inertia::shapes::cone(10.0, 1.0, 2.0)?;
    /// assert_eq!(cone.center().components().norm(), 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn center(&self) -> BodyVector {
        self.center
    }

    /// Inertia matrix about the centre of mass, kg m².
    ///
    /// ```
    /// let ball = spinning_bodies::inertia::shapes::ball(5.0, 2.0)?;
    /// assert_eq!(ball.inertia().matrix().diagonal().as_slice(), [8.0; 3]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn inertia(&self) -> InertiaMatrix {
        self.inertia
    }

    /// Inertia matrix about another point, kg m²: parallel axes (2.8).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the point or on overflow.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::shapes};
    /// // A rod about its end: Ml²/3.
    /// let end = shapes::rod(3.0, 2.0)?.about(BodyVector::new(0.0, 0.0, 1.0))?;
    /// assert!((end.matrix()[(0, 0)] - 4.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn about(&self, point: BodyVector) -> Result<InertiaMatrix> {
        self.inertia
            .shifted_from_center(self.mass, self.center - point)
    }

    /// The same body displaced by `displacement`, m: only the centre changes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::shapes};
    /// let ball = shapes::ball(5.0, 2.0)?.moved(BodyVector::new(0.0, 0.0, 3.0))?;
    /// assert_eq!((ball.center().z(), ball.inertia().matrix()[(0, 0)]), (3.0, 8.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moved(&self, displacement: BodyVector) -> Result<Self> {
        Self::new(self.mass, self.center + displacement, self.inertia)
    }

    /// The same body turned about the origin of its axes: centre R c, inertia matrix R I Rᵀ.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, inertia::shapes};
    /// let quarter = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2)?;
    /// let brick = shapes::cuboid(12.0, [1.0, 2.0, 3.0])?.turned(&quarter);
    /// assert!((brick.inertia().matrix()[(0, 0)] - 10.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn turned(&self, attitude: &Attitude) -> Self {
        let center = attitude.to_space(self.center).components();
        Self {
            mass: self.mass,
            center: BodyVector::from_components(center),
            inertia: self.inertia.rotated(attitude),
        }
    }
}
