//! A rigid body that can stand on a table, and its state at the start.

use nalgebra::{Matrix3, Vector3};

use super::surface::{Surface, mirrored};
use crate::error::{Error, Result, finite, positive};
use crate::frame::{Attitude, BodyVector, SpaceVector, finite_vector};
use crate::inertia::InertiaMatrix;
use crate::precise::power_of_two_below;

/// A rigid body with a smooth convex surface (tutorial 4.7). Its reference point is the centre of mass C.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConvexBody {
    pub(super) mass: f64,
    pub(super) inertia: InertiaMatrix,
    pub(super) inverse: Matrix3<f64>,
    /// The surface.
    pub(crate) surface: Surface,
    pub(super) center: Vector3<f64>,
}

/// The inverse, by Cramer's rule in units of its size: a product of three entries may leave the range of doubles.
#[inline]
pub(super) fn inverse(matrix: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let unit = power_of_two_below(matrix.trace()).recip();
    let [a, b, c] = [0, 1, 2].map(|n| matrix.column(n) * unit);
    let cofactors = Matrix3::from_columns(&[b.cross(&c), c.cross(&a), a.cross(&b)]);
    let determinant = a.dot(&cofactors.column(0));
    (determinant != 0.0).then(|| cofactors.transpose() / determinant * unit)
}

impl ConvexBody {
    /// The body of this mass (kg) and inertia matrix about C (kg m²), whose surface has its centre K at `center` (m, from C).
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the mass; [`Error::NotFinite`]; [`Error::Condition`] for a body that lies on a line, since no equation governs
    /// its spin about that line.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// // Upright, C is R − a above the table.
    /// assert_eq!(body.lowest_point(BodyVector::new(0.0, 0.0, 1.0))?.z(), -0.75);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        mass: f64,
        inertia: InertiaMatrix,
        surface: Surface,
        center: BodyVector,
    ) -> Result<Self> {
        let mass = positive("the mass", mass)?;
        finite_vector("the centre of the surface", center)?;
        let inverse = inverse(&inertia.matrix());
        let inverse = inverse.filter(|m| m.iter().all(|x| x.is_finite()));
        let inverse = inverse.ok_or(Error::Condition {
            condition: "a body on a table must have three positive moments of inertia",
            value: inertia.principal_axes().moments[0],
        })?;
        Ok(Self {
            mass,
            inertia,
            inverse,
            surface,
            center: center.components(),
        })
    }

    /// Mass, kg.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// assert_eq!(body.mass(), 4.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Inertia matrix about C, kg m².
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// assert_eq!(*body.inertia(), inertia);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn inertia(&self) -> &InertiaMatrix {
        &self.inertia
    }

    /// CK, from the centre of mass to the centre of the surface, m.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// assert_eq!(body.center().z(), 0.25);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn center(&self) -> BodyVector {
        BodyVector::from_components(self.center)
    }

    /// The mirror image in the plane through the body's first and third axis. That of a chiral body is not the same body turned.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// // This one is its own mirror image.
    /// assert_eq!(body.mirrored(), body);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mut image = *self;
        image.inverse = mirrored(&self.inverse);
        image.surface = self.surface.mirrored();
        image.center.y = -self.center.y;
        // The mirror image of an inertia matrix is an inertia matrix.
        let inertia = InertiaMatrix::from_matrix(mirrored(&self.inertia.matrix()));
        image.inertia = inertia.unwrap_or(self.inertia);
        image
    }

    /// CR, from C to the lowest point (m), if the upward vertical is `up`; its normal component is minus the height of C.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix, tippe_top::{ConvexBody, Surface}};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let body = ConvexBody::new(4.0, inertia, Surface::sphere(1.0)?, BodyVector::new(0.0, 0.0, 0.25))?;
    /// assert_eq!(body.lowest_point(BodyVector::new(0.0, 0.0, -1.0))?.z(), 1.25);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn lowest_point(&self, up: BodyVector) -> Result<BodyVector> {
        let up = up.direction("the vertical")?;
        Ok(BodyVector::from_components(self.arm(&up.components())))
    }

    /// ρ = CK − S(n), from C to the point of contact.
    pub(super) fn arm(&self, up: &Vector3<f64>) -> Vector3<f64> {
        self.center - self.surface.support(up)
    }

    /// Jellett's integral −⟨L, ρ⟩ (J s m), for a body on a sphere: ⟨L, R z − ε e⟩ with e the unit vector along CK and ε its length.
    ///
    /// Constant under any force at the contact if the body has an inertial axis of symmetry through K
    /// (see [`has_jellett_integral`](Self::has_jellett_integral)).
    pub(crate) fn jellett(&self, up: BodyVector, omega: BodyVector) -> f64 {
        let l = self.inertia.matrix() * omega.components();
        -l.dot(&self.arm(&up.components()))
    }

    /// Whether the surface is a sphere about a point of an inertial axis of symmetry, to rounding (tutorial 4.7; Jellett 1872).
    pub(crate) fn has_jellett_integral(&self) -> bool {
        if self.surface.radius().is_none() {
            return false;
        }
        let Some(axis) = self.center.try_normalize(0.0) else {
            // K = C: ⟨L, z⟩, which friction changes only through the arm R z, parallel to z.
            return true;
        };
        let inertia = self.inertia.matrix();
        let axial = axis.dot(&(inertia * axis));
        let transverse = 0.5 * (inertia.trace() - axial);
        let symmetric =
            Matrix3::identity() * transverse + axis * axis.transpose() * (axial - transverse);
        (inertia - symmetric).amax() <= 8.0 * f64::EPSILON * inertia.amax()
    }

    /// √(gR), the speed with which slips are compared, m/s.
    pub(crate) fn speed_scale(&self, gravity: f64) -> f64 {
        (gravity * self.surface.size).sqrt()
    }

    /// Kinetic energy (J) at this angular velocity and velocity of C.
    pub(crate) fn kinetic_energy(&self, omega: &Vector3<f64>, velocity: &Vector3<f64>) -> f64 {
        0.5 * (omega.dot(&(self.inertia.matrix() * omega)) + self.mass * velocity.norm_squared())
    }
}

/// The start of a body on the table: its attitude, its angular velocity, and the level part of the velocity of C.
///
/// The height of C and its vertical velocity follow from the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Attitude, from the body's axes to those of space, whose third axis points up.
    pub attitude: Attitude,
    /// Angular velocity, rad/s.
    pub omega: BodyVector,
    /// Level velocity of C, m/s; a vertical component is ignored, and in pure rolling the whole vector.
    pub velocity: SpaceVector,
}

impl Start {
    /// With angular velocity `omega` (rad/s) and C at rest.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, tippe_top::Start};
    /// let start = Start::spinning(Attitude::identity(), BodyVector::new(0.0, 0.0, 5.0))?;
    /// assert_eq!(start.velocity.norm(), 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn spinning(attitude: Attitude, omega: BodyVector) -> Result<Self> {
        finite_vector("the angular velocity", omega)?;
        Ok(Self {
            attitude,
            omega,
            velocity: SpaceVector::zero(),
        })
    }

    /// Spinning about the **vertical** at `spin` (rad/s, positive: anticlockwise seen from above), the body's third axis at `tilt`
    /// from it (rad); the vertical is (sin tilt cos azimuth, sin tilt sin azimuth, cos tilt) in the body's axes. C at rest.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Start;
    /// let start = Start::about_vertical(0.1, 0.0, 5.0)?;
    /// assert!((start.attitude.to_space(start.omega).z() - 5.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn about_vertical(tilt: f64, azimuth: f64, spin: f64) -> Result<Self> {
        let (attitude, up) = tilted(tilt, azimuth)?;
        Self::spinning(attitude, up * finite("the spin", spin)?)
    }

    /// Spinning about the body's own **third axis** at `spin`, tilted as in [`about_vertical`](Self::about_vertical). C at rest.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Start;
    /// assert_eq!(Start::about_third_axis(0.1, 0.0, 5.0)?.omega.z(), 5.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn about_third_axis(tilt: f64, azimuth: f64, spin: f64) -> Result<Self> {
        let (attitude, _) = tilted(tilt, azimuth)?;
        let spin = finite("the spin", spin)?;
        Self::spinning(attitude, BodyVector::new(0.0, 0.0, spin))
    }

    /// The mirror image of the start; with [`ConvexBody::mirrored`] it gives the mirror image of the motion.
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Start;
    /// let start = Start::about_third_axis(0.1, 0.0, 5.0)?;
    /// assert_eq!(start.mirrored().omega.z(), -5.0);
    /// assert_eq!(start.mirrored().mirrored(), start);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[must_use]
    pub fn mirrored(&self) -> Self {
        // A turn by q about an axis becomes the turn by −q about the mirrored axis.
        let q = self.attitude.quaternion();
        let image = nalgebra::Quaternion::new(q.w, -q.i, q.j, -q.k);
        let [x, y, z] = [self.omega.x(), self.omega.y(), self.omega.z()];
        let v = self.velocity;
        Self {
            attitude: Attitude::from_unit(image),
            omega: BodyVector::new(-x, y, -z),
            velocity: SpaceVector::new(v.x(), -v.y(), v.z()),
        }
    }
}

fn tilted(tilt: f64, azimuth: f64) -> Result<(Attitude, BodyVector)> {
    let tilt = finite("the tilt", tilt)?;
    let (sin, cos) = finite("the azimuth", azimuth)?.sin_cos();
    let axis = BodyVector::new(sin, -cos, 0.0);
    let attitude = Attitude::about_axis(axis, tilt)?;
    let up = attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
    Ok((attitude, up))
}
