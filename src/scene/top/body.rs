//! The body of a top and how it starts.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::error::{Result, each, each_finite, finite, not_negative, positive, refused};
use crate::euler_equations::AxisMoments;
use crate::frame::{Attitude, BodyVector, finite_vector};
use crate::inertia::{InertiaMatrix, MassProperties, PrincipalMoments, principal_axes_of};
use crate::integrators::geometric::Phase;
use crate::precise::{Extended, Number, power_of_two_below};
use crate::scene::engine::{DOUBT, tilted};

/// A rigid body with a fixed point: mass, principal moments about the pivot in the order of the axes, centre of mass relative to the pivot.
///
/// A body may have [axes of its own](Self::along_own_axes) that are not principal. Its start and its states are then along its own axes, and its tilt is
/// that of the third of them; the computation is along the principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Written"))]
pub struct Body {
    pub(super) mass: f64,
    pub(super) moments: [f64; 3],
    /// Centre of mass, along the principal axes.
    pub(super) center: [f64; 3],
    /// Turns components along the principal axes into those along the body's own, if these differ.
    pub(super) own: Option<Attitude>,
}

/// A serialised body before its check.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
struct Written {
    mass: f64,
    moments: [f64; 3],
    center: BodyVector,
    own: Option<Attitude>,
}

#[cfg(feature = "serde")]
impl TryFrom<Written> for Body {
    type Error = crate::Error;

    fn try_from(written: Written) -> Result<Self> {
        let (own, body) = (written.own, Self::new(written.moments)?);
        let body = body.with_center_of_mass(written.mass, written.center)?;
        Ok(Self { own, ..body })
    }
}

/// The shortest turn of this direction onto the third axis; about the first, if they are opposite.
pub(super) fn onto_third(direction: BodyVector) -> UnitQuaternion<f64> {
    let direction = direction.components();
    // In units of its size: the squares of a small or large vector leave the range of doubles.
    let direction = direction / power_of_two_below(direction.amax());
    UnitQuaternion::rotation_between(&direction, &Vector3::z())
        .unwrap_or_else(|| UnitQuaternion::new_unchecked(Quaternion::new(0.0, 1.0, 0.0, 0.0)))
}

impl Body {
    /// The body with these moments (kg m², any order), without mass and lever: gravity does not turn it.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative), [`Error::TriangleInequality`](crate::Error::TriangleInequality).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let motion = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.simulate(&Request::at([10.0])?)?;
    /// assert_eq!(motion.rows[0].1.energy, 6.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3]) -> Result<Self> {
        let [i1, i2, i3] = moments;
        PrincipalMoments::new(i1, i2, i3)?;
        Ok(Self {
            mass: 0.0,
            moments,
            center: [0.0; 3],
            own: None,
        })
    }

    /// The body with this inertia matrix about the pivot, along axes of its own, without mass and lever. If these are principal axes already, nothing is
    /// turned and no bit changes.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    ///
    /// ```
    /// use nalgebra::Matrix3;
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// use spinning_bodies::scene::{Request, Scene, top::{Body, Start, Top}};
    /// // Moments 1, 3 and 2, the first two along the diagonals between the axes.
    /// let matrix = Matrix3::new(2.0, -1.0, 0.0, -1.0, 2.0, 0.0, 0.0, 0.0, 2.0);
    /// let body = Body::along_own_axes(&InertiaMatrix::from_matrix(matrix)?)?;
    /// let start = Start::with_omega(BodyVector::new(1.0, 1.0, 0.0), Attitude::identity());
    /// let motion = Top::new(body, start)?.simulate(&Request::at([7.0])?)?;
    /// let omega = motion.rows[0].1.omega; // about a principal axis: it stays
    /// assert!((omega.x() - 1.0).abs() < 1e-14 && (omega.y() - 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn along_own_axes(inertia: &InertiaMatrix) -> Result<Self> {
        let matrix = inertia.matrix();
        if [matrix.m12, matrix.m13, matrix.m23] == [0.0; 3] {
            return Self::new(matrix.diagonal().into());
        }
        let principal = inertia.principal_axes();
        let own = Some(principal.turn().into());
        let body = Self::new(principal.principal_moments().values())?;
        Ok(Self { own, ..body })
    }

    /// A body whose moments about this axis through its origin and about all lines across it are exactly these.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub(crate) fn symmetric_about(axis: BodyVector, axial: f64, transverse: f64) -> Result<Self> {
        let own = Some(onto_third(axis).inverse().into());
        let body = Self::new([transverse, transverse, axial])?;
        Ok(Self { own, ..body })
    }

    /// The body held at `pivot` (m, along its own axes, from their origin).
    ///
    /// # Errors
    /// As for [`new`](Self::new); [`Error::NotFinite`](crate::Error::NotFinite) for the point.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::shapes, scene::top::Body};
    /// // Any body, held anywhere but where it would have no moment.
    /// assert!(Body::held_at(&shapes::cuboid(12.0, [1.0, 2.0, 3.0])?, BodyVector::new(0.0, 0.0, -1.5)).is_ok());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn held_at(body: &MassProperties, pivot: BodyVector) -> Result<Self> {
        let held = Self::along_own_axes(&body.about(pivot)?)?;
        held.with_center_of_mass(body.mass(), body.center() - pivot)
    }

    /// Sets the mass (kg) and the centre of mass C, relative to the pivot, along the body's axes (m).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for the mass.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, effects::Gravity, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let body = Body::new([1.0, 1.0, 0.5])?.with_center_of_mass(2.0, BodyVector::new(0.0, 0.0, 0.1))?;
    /// let motion = Top::new(body, start)?.with(Gravity::new(10.0)?)?.simulate(&Request::at([0.0])?)?;
    /// // ½·½·2² J of turning and 2 kg · 10 m/s² · 0.1 m of height.
    /// assert!((motion.rows[0].1.energy - 3.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with_center_of_mass(mut self, mass: f64, center: BodyVector) -> Result<Self> {
        let center = finite_vector("the centre of mass", center)?;
        self.center = self.inward(center).into();
        self.mass = not_negative("the mass", mass)?;
        each_finite("mass times centre of mass", self.arm())?;
        Ok(self)
    }

    /// A vector, from the body's own axes to the principal ones.
    pub(super) fn inward(&self, vector: BodyVector) -> BodyVector {
        let components = vector.components();
        let inward = |own: Attitude| own.quaternion().inverse_transform_vector(&components);
        self.own
            .map_or(vector, |own| BodyVector::from_components(inward(own)))
    }

    /// The attitude of the principal axes.
    pub(super) fn attitude_inward(&self, attitude: Attitude) -> Attitude {
        self.own.map_or(attitude, |own| attitude * own)
    }

    /// Attitude and Ω, from the principal axes to the body's own.
    pub(super) fn outward(&self, attitude: Attitude, omega: BodyVector) -> (Attitude, BodyVector) {
        self.own.map_or((attitude, omega), |own| {
            let omega = BodyVector::from_components(own.quaternion() * omega.components());
            (attitude * own.inverse(), omega)
        })
    }

    /// The body beside this one that its principal axes might have come from: the matrix along them is off by half of the first [`DOUBT`], small moments
    /// by as little as they are small. No turn is blind to both senses. Two equal moments were never rounded apart.
    pub(super) fn beside(&self, sense: f64) -> Result<Self> {
        let [i1, i2, i3] = self.moments;
        let mut beside = Self { own: None, ..*self };
        if self.own.is_some() && i1 != i2 && i2 != i3 {
            let moments = Vector3::from(self.moments);
            let roots = moments.map(f64::sqrt);
            let off = Matrix3::new(1.0, sense, sense, sense, 0.0, sense, sense, sense, -1.0);
            let off = off.component_mul(&(roots * roots.transpose())) * (0.5 * DOUBT[0]);
            let principal = principal_axes_of(&(Matrix3::from_diagonal(&moments) + off))?;
            beside.moments = principal.principal_moments().values();
            beside.own = Some(principal.turn().into());
        }
        Ok(beside)
    }

    pub(super) const fn axis_moments(&self) -> AxisMoments {
        AxisMoments::allowing_rods(self.moments)
    }

    /// MC, kg m.
    pub(super) fn arm(&self) -> [f64; 3] {
        self.center.map(|component| self.mass * component)
    }

    /// MgC without rounding, to 106 bits, N m.
    pub(super) fn exact_lever(&self, gravity: f64) -> [Extended; 3] {
        let number = Extended::from_double;
        let weight = number(self.mass) * number(gravity);
        self.center.map(|component| weight * number(component))
    }

    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for an axis without moment.
    pub(super) fn has_every_moment(&self) -> Result<()> {
        let quantity = "a principal moment of a body without a closed form";
        each(positive, quantity, self.moments)
    }

    /// Whether axis 3 is an axis of symmetry with C on it.
    pub(super) fn is_symmetric_about_third(&self) -> bool {
        let [x, y, _] = self.arm();
        self.own.is_none() && self.moments[0] == self.moments[1] && x == 0.0 && y == 0.0
    }
}

/// The reported error is this fraction of the effect of such a displacement.
pub(super) const DOUBTED: f64 = 0.15;

/// The start of a top: its attitude, and Ω or L along the body's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Start {
    pub(super) attitude: Attitude,
    pub(super) spin: Spin,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub(super) enum Spin {
    Omega(BodyVector),
    AngularMomentum(BodyVector),
}

impl Start {
    /// A start with Ω, rad/s.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let motion = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.simulate(&Request::at([0.0])?)?;
    /// assert_eq!(motion.rows[0].1.omega.z(), 2.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn with_omega(omega: BodyVector, attitude: Attitude) -> Self {
        let spin = Spin::Omega(omega);
        Self { attitude, spin }
    }

    /// A start with L, kg m²/s. The closed forms use L as it is, without a division.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{Request, Scene, top::{Body, Start, Top}}};
    /// let start = Start::with_angular_momentum(BodyVector::new(0.0, 0.0, 6.0), Attitude::identity());
    /// let motion = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.simulate(&Request::at([0.0])?)?;
    /// assert!((motion.rows[0].1.omega.z() - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn with_angular_momentum(l: BodyVector, attitude: Attitude) -> Self {
        let spin = Spin::AngularMomentum(l);
        Self { attitude, spin }
    }

    /// The start along the principal axes of this body.
    pub(super) fn inward(&self, body: &Body) -> Self {
        let attitude = body.attitude_inward(self.attitude);
        let spin = match self.spin {
            Spin::Omega(omega) => Spin::Omega(body.inward(omega)),
            Spin::AngularMomentum(l) => Spin::AngularMomentum(body.inward(l)),
        };
        Self { attitude, spin }
    }

    /// The phase: L along the body's axes, and the attitude.
    pub(super) fn phase(&self, body: &Body) -> Result<Phase> {
        let l = match self.spin {
            Spin::AngularMomentum(l) => l,
            Spin::Omega(omega) => body.axis_moments().angular_momentum(omega),
        };
        let l = finite_vector("the angular momentum", l)?;
        Ok(Phase::new(l, &self.attitude))
    }

    /// Ω without rounding, to 106 bits, rad/s.
    pub(super) fn exact_omega(&self, moments: [f64; 3]) -> [Extended; 3] {
        let number = Extended::from_double;
        match self.spin {
            Spin::Omega(omega) => <[f64; 3]>::from(omega.components()).map(number),
            Spin::AngularMomentum(l) => {
                let l: [f64; 3] = l.components().into();
                core::array::from_fn(|k| number(l[k]).quotient(number(moments[k])))
            }
        }
    }

    /// A start displaced by [`DOUBT`], turning a little faster or slower.
    pub(super) fn beside(&self, moments: [f64; 3], sense: f64) -> Result<Self> {
        let [a, b, c, ..] = DOUBT;
        let omega = self.omega(moments)?;
        let q = self.attitude.quaternion().into_inner();
        let q = q + tilted(q);
        let attitude = Attitude::from_quaternion(q.w, q.i, q.j, q.k)?;
        let moved = omega + BodyVector::new(a, b, c) * (sense * omega.norm());
        Ok(Self::with_omega(moved, attitude))
    }

    /// Ω, rad/s.
    pub(super) fn omega(&self, moments: [f64; 3]) -> Result<BodyVector> {
        match self.spin {
            Spin::Omega(omega) => finite_vector("the angular velocity", omega),
            Spin::AngularMomentum(l) => {
                let l: [f64; 3] = finite_vector("the angular momentum", l)?.into();
                let condition = "the angular momentum about an axis without moment must be zero";
                // About such an axis Ω is taken as zero.
                let rate = |k: usize| match (l[k], moments[k]) {
                    (0.0, _) => Ok(0.0),
                    (part, 0.0) => refused(condition, part),
                    (part, moment) => finite("a component of the angular velocity", part / moment),
                };
                Ok(BodyVector::new(rate(0)?, rate(1)?, rate(2)?))
            }
        }
    }
}
