//! Body and space axes (tutorial 2.2, 5.1): vectors that know whose axes they are written in.
//!
//! A vector's three numbers mean nothing until one says whose axes they refer to. The knack of this
//! subject is to keep angular velocity and angular momentum apart, and the second knack is to keep
//! their components along the body's axes apart from those along the axes of space. Here the
//! compiler does the second: a [`BodyVector`] and a [`SpaceVector`] cannot be added, and only an
//! [`Attitude`] turns one into the other.
//!
//! ```
//! use spinning_bodies::frame::{Attitude, BodyVector};
//!
//! let quarter_turn = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2)?;
//! let nose = quarter_turn.to_space(BodyVector::new(1.0, 0.0, 0.0));
//! assert!((nose.y() - 1.0).abs() < 1e-15);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```
//!
//! ```compile_fail
//! use spinning_bodies::frame::{BodyVector, SpaceVector};
//! let nonsense = BodyVector::new(1.0, 0.0, 0.0) + SpaceVector::new(1.0, 0.0, 0.0);
//! ```

use core::f64::consts::TAU;
use core::fmt;
use core::marker::PhantomData;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3};

use crate::error::{Result, each_finite, finite, not_zero};
use crate::precise::power_of_two_below;

/// Axes attached to the body, turning with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {}

/// Axes at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Space {}

/// Three components along the axes `Axes`; the unit is that of the quantity it holds. With the feature `serde`: `[x, y, z]`.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound = "Axes: Clone", from = "[f64; 3]", into = "[f64; 3]")
)]
pub struct FrameVector<Axes> {
    components: Vector3<f64>,
    axes: PhantomData<Axes>,
}

/// A vector by its components along the body's axes.
pub type BodyVector = FrameVector<Body>;

/// A vector by its components along axes at rest.
pub type SpaceVector = FrameVector<Space>;

impl<Axes> FrameVector<Axes> {
    /// The vector with these three components.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// let omega = BodyVector::new(0.0, 3.0, 4.0);
    /// assert_eq!((omega.y(), omega.norm()), (3.0, 5.0));
    /// ```
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self::from_components(Vector3::new(x, y, z))
    }

    /// The vector with the components of an ordinary `Vector3`.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// let vector = BodyVector::from_components(nalgebra::Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(vector, BodyVector::new(1.0, 2.0, 3.0));
    /// ```
    pub const fn from_components(components: Vector3<f64>) -> Self {
        Self {
            components,
            axes: PhantomData,
        }
    }

    /// The zero vector.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::zero().norm(), 0.0);
    /// ```
    pub const fn zero() -> Self {
        Self::new(0.0, 0.0, 0.0)
    }

    /// The components, stripped of their axes.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(1.0, 2.0, 3.0).components().sum(), 6.0);
    /// ```
    pub const fn components(&self) -> Vector3<f64> {
        self.components
    }

    /// First component.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(1.0, 2.0, 3.0).x(), 1.0);
    /// ```
    pub fn x(&self) -> f64 {
        self.components.x
    }

    /// Second component.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(1.0, 2.0, 3.0).y(), 2.0);
    /// ```
    pub fn y(&self) -> f64 {
        self.components.y
    }

    /// Third component.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(1.0, 2.0, 3.0).z(), 3.0);
    /// ```
    pub fn z(&self) -> f64 {
        self.components.z
    }

    /// Scalar product ⟨a, b⟩.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(1.0, 2.0, 3.0).dot(&BodyVector::new(3.0, 2.0, 1.0)), 10.0);
    /// ```
    pub fn dot(&self, other: &Self) -> f64 {
        self.components.dot(&other.components)
    }

    /// Vector product a ∧ b.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// let (x, y) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(0.0, 1.0, 0.0));
    /// assert_eq!(x.cross(&y), BodyVector::new(0.0, 0.0, 1.0));
    /// ```
    pub fn cross(&self, other: &Self) -> Self {
        Self::from_components(self.components.cross(&other.components))
    }

    /// Length, without overflow or underflow on the way.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert!((BodyVector::new(3e200, 0.0, 4e200).norm() / 5e200 - 1.0).abs() < 1e-15);
    /// ```
    pub fn norm(&self) -> f64 {
        self.x().hypot(self.y()).hypot(self.z())
    }

    /// Whether all three components are finite.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert!(BodyVector::new(0.0, 1e308, 0.0).is_finite());
    /// assert!(!BodyVector::new(0.0, f64::NAN, 0.0).is_finite());
    /// ```
    pub fn is_finite(&self) -> bool {
        self.components.iter().all(|c| c.is_finite())
    }

    /// The unit vector of the same direction.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) and [`Error::ZeroVector`](crate::Error::ZeroVector), in which the vector is called `quantity`.
    ///
    /// ```
    /// use spinning_bodies::frame::BodyVector;
    /// assert_eq!(BodyVector::new(0.0, 0.0, 1e-300).direction("the axis")?, BodyVector::new(0.0, 0.0, 1.0));
    /// assert!(BodyVector::zero().direction("the axis").is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn direction(&self, quantity: &'static str) -> Result<Self> {
        each_finite(quantity, <[f64; 3]>::from(self.components))?;
        let largest = not_zero(quantity, self.components.amax())?;
        let scaled = self.components / largest;
        Ok(Self::from_components(scaled / scaled.norm()))
    }
}

impl<Axes> From<[f64; 3]> for FrameVector<Axes> {
    fn from(components: [f64; 3]) -> Self {
        Self::from_components(components.into())
    }
}

impl<Axes> From<FrameVector<Axes>> for [f64; 3] {
    fn from(vector: FrameVector<Axes>) -> Self {
        vector.components.into()
    }
}

impl<Axes> fmt::Debug for FrameVector<Axes> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axes = core::any::type_name::<Axes>();
        let axes = axes.rsplit("::").next().unwrap_or(axes);
        write!(f, "{axes}({}, {}, {})", self.x(), self.y(), self.z())
    }
}

impl<Axes> Add for FrameVector<Axes> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from_components(self.components + other.components)
    }
}

impl<Axes> AddAssign for FrameVector<Axes> {
    fn add_assign(&mut self, other: Self) {
        self.components += other.components;
    }
}

impl<Axes> Sub for FrameVector<Axes> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from_components(self.components - other.components)
    }
}

impl<Axes> SubAssign for FrameVector<Axes> {
    fn sub_assign(&mut self, other: Self) {
        self.components -= other.components;
    }
}

impl<Axes> Neg for FrameVector<Axes> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::from_components(-self.components)
    }
}

impl<Axes> Mul<f64> for FrameVector<Axes> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::from_components(self.components * factor)
    }
}

impl<Axes> Mul<FrameVector<Axes>> for f64 {
    type Output = FrameVector<Axes>;
    fn mul(self, vector: FrameVector<Axes>) -> FrameVector<Axes> {
        vector * self
    }
}

impl<Axes> Div<f64> for FrameVector<Axes> {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        Self::from_components(self.components / divisor)
    }
}

impl<Axes> core::iter::Sum for FrameVector<Axes> {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::zero(), Add::add)
    }
}

/// Euler's angles: the attitude is a turn by ψ about the third axis, then by θ about the horizontal x-axis, then by φ about the vertical.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EulerAngles {
    /// θ, the tilt of the third axis from the vertical, 0 … π.
    pub theta: f64,
    /// φ, how far the line of nodes has gone round the vertical, −π … π.
    pub phi: f64,
    /// ψ, the spin about the third axis from the line of nodes, −π … π.
    pub psi: f64,
}

/// An angle less the whole turns nearest to it, in −π … π.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round_ties_even()
}

/// The vector, if all its components are finite.
pub(crate) fn finite_vector<Axes>(
    quantity: &'static str,
    vector: FrameVector<Axes>,
) -> Result<FrameVector<Axes>> {
    each_finite(quantity, <[f64; 3]>::from(vector.components))?;
    Ok(vector)
}

/// How the body stands in space: the rotation that turns body axes into space axes, as a unit quaternion. With the feature `serde`:
/// `[w, x, y, z]`; a quaternion of norm 1 is read untouched, any other is normalised, and zero is refused. (`{:?}` has nalgebra's order: x, y, z, w.)
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "[f64; 4]", into = "[f64; 4]")
)]
pub struct Attitude(UnitQuaternion<f64>);

impl Attitude {
    /// Body axes and space axes coincide.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
    /// let up = Attitude::identity().to_space(BodyVector::new(0.0, 0.0, 1.0));
    /// assert_eq!(up, SpaceVector::new(0.0, 0.0, 1.0));
    /// ```
    pub fn identity() -> Self {
        Self(UnitQuaternion::identity())
    }

    /// The attitude with quaternion `w + x i + y j + z k`, normalised.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if a component is not finite, [`Error::ZeroVector`](crate::Error::ZeroVector) if all are zero.
    ///
    /// ```
    /// use spinning_bodies::frame::Attitude;
    /// // Any length except zero is allowed.
    /// assert_eq!(Attitude::from_quaternion(2.0, 0.0, 0.0, 0.0)?, Attitude::identity());
    /// assert!(Attitude::from_quaternion(0.0, 0.0, 0.0, 0.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_quaternion(w: f64, x: f64, y: f64, z: f64) -> Result<Self> {
        each_finite("a quaternion component", [w, x, y, z])?;
        let quaternion = Quaternion::new(w, x, y, z);
        let largest = not_zero("the attitude quaternion", quaternion.coords.amax())?;
        Ok(Self(UnitQuaternion::from_quaternion(quaternion / largest)))
    }

    /// The attitude with a quaternion whose norm is 1 up to rounding.
    pub(crate) fn from_unit(quaternion: Quaternion<f64>) -> Self {
        Self(UnitQuaternion::new_unchecked(quaternion))
    }

    /// The attitude after a turn by `angle` (radians, right-handed) about an axis, from the identity.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for the axis or the angle, [`Error::ZeroVector`](crate::Error::ZeroVector) for the axis.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
    /// let quarter = Attitude::about_axis(BodyVector::new(0.0, 0.0, 5.0), std::f64::consts::FRAC_PI_2)?;
    /// let x = quarter.to_space(BodyVector::new(1.0, 0.0, 0.0));
    /// assert!((x - SpaceVector::new(0.0, 1.0, 0.0)).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn about_axis(axis: BodyVector, angle: f64) -> Result<Self> {
        let axis = axis.direction("the axis of rotation")?;
        let angle = finite("the angle of rotation", angle)?;
        let axis = Unit::new_unchecked(axis.components());
        Ok(Self(UnitQuaternion::from_axis_angle(&axis, angle)))
    }

    /// The attitude after a turn by ψ about the third axis, then by θ about the horizontal x-axis, then by φ about the vertical (7.1); the
    /// inverse of [`euler_angles`](Self::euler_angles). Error: a few 10⁻¹⁶ rad, however many turns the angles count.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, EulerAngles};
    /// let attitude = Attitude::from_euler_angles(EulerAngles { theta: 0.5, phi: 1.0, psi: 2.0 })?;
    /// let angles = attitude.euler_angles();
    /// assert!((angles.theta - 0.5).abs() + (angles.phi - 1.0).abs() + (angles.psi - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_euler_angles(EulerAngles { theta, phi, psi }: EulerAngles) -> Result<Self> {
        each_finite("an angle of Euler", [theta, phi, psi])?;
        // Turn by turn: after many turns φ + ψ and φ − ψ would be rounded.
        let turn = |axis, angle| UnitQuaternion::from_axis_angle(&axis, angle);
        let (x, z) = (Vector3::x_axis(), Vector3::z_axis());
        Ok(Self(turn(z, phi) * turn(x, theta) * turn(z, psi)))
    }

    /// The rotation that turns space axes into body axes.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let attitude = Attitude::about_axis(BodyVector::new(1.0, 2.0, 3.0), 0.7)?;
    /// assert!((attitude.inverse().quaternion() * attitude.quaternion()).angle() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self(self.0.inverse())
    }

    /// The quaternion. Its matrix, whose columns are the body's axes in space, is nalgebra's `to_rotation_matrix`.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let quaternion = Attitude::about_axis(BodyVector::new(0.0, 1.0, 0.0), 1.0)?.quaternion();
    /// assert!((quaternion.w - 0.5_f64.cos()).abs() + (quaternion.j - 0.5_f64.sin()).abs() < 1e-15);
    /// // Axis 3 leans towards the x axis of space.
    /// assert!((quaternion.to_rotation_matrix()[(0, 2)] - 1.0_f64.sin()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn quaternion(&self) -> UnitQuaternion<f64> {
        self.0
    }

    /// The components along the axes of space of a vector given along the body's axes.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
    /// let half = Attitude::from_quaternion(0.0, 1.0, 0.0, 0.0)?; // half a turn about x
    /// assert_eq!(half.to_space(BodyVector::new(1.0, 2.0, 3.0)), SpaceVector::new(1.0, -2.0, -3.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn to_space(&self, vector: BodyVector) -> SpaceVector {
        SpaceVector::from_components(self.0 * vector.components())
    }

    /// The components along the body's axes of a vector given along the axes of space.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
    /// let half = Attitude::from_quaternion(0.0, 1.0, 0.0, 0.0)?; // half a turn about x
    /// assert_eq!(half.to_body(SpaceVector::new(1.0, 2.0, 3.0)), BodyVector::new(1.0, -2.0, -3.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[inline]
    pub fn to_body(&self, vector: SpaceVector) -> BodyVector {
        BodyVector::from_components(self.0.inverse_transform_vector(&vector.components()))
    }

    /// Euler's angles θ, φ, ψ in radians (7.1).
    ///
    /// Near θ = 0 only φ + ψ is well determined, near π only φ − ψ, and it is right to rounding. The other combination keeps the digits that the
    /// attitude still has of it; at θ = 0 or π exactly it is taken as zero. Cost: three arctangents.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// // Tilted about the x-axis only: θ alone is not zero.
    /// let angles = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.25)?.euler_angles();
    /// assert!((angles.theta - 0.25).abs() < 1e-16 && angles.phi + angles.psi == 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn euler_angles(&self) -> EulerAngles {
        let q = self.0.quaternion();
        // A negative zero becomes one: next to it an arctangent is ±π.
        let half_sum = (q.k + 0.0).atan2(q.w + 0.0);
        let half_difference = (q.j + 0.0).atan2(q.i + 0.0);
        EulerAngles {
            theta: 2.0 * q.i.hypot(q.j).atan2(q.w.hypot(q.k)),
            phi: wrapped(half_sum + half_difference),
            psi: wrapped(half_sum - half_difference),
        }
    }

    /// Angle of the rotation between two attitudes, radians, in 0…π; accurate for small angles.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let turned = Attitude::about_axis(BodyVector::new(1.0, 2.0, 2.0), 1e-9)?;
    /// assert!((Attitude::identity().angle_to(&turned) - 1e-9).abs() < 1e-24);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angle_to(&self, other: &Self) -> f64 {
        let difference = self.0.inverse() * other.0;
        let sine = difference.imag();
        // Over a power of two, for the squares of small angles are numbers then.
        let unit = power_of_two_below(sine.amax());
        2.0 * ((sine / unit).norm() * unit).atan2(difference.w.abs())
    }
}

/// The product of two attitudes: first the turn on the right, then the one on the left, both about axes of space.
///
/// ```
/// use spinning_bodies::frame::{Attitude, BodyVector};
/// let quarter = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2)?;
/// let there = (quarter * quarter).to_space(BodyVector::new(1.0, 0.0, 0.0));
/// assert!((there.x() + 1.0).abs() < 1e-15);
/// assert!((quarter * quarter.inverse()).angle_to(&Attitude::identity()) < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
impl Mul for Attitude {
    type Output = Self;
    fn mul(self, first: Self) -> Self {
        Self(self.0 * first.0)
    }
}

#[cfg(feature = "serde")]
impl TryFrom<[f64; 4]> for Attitude {
    type Error = crate::Error;

    fn try_from([w, x, y, z]: [f64; 4]) -> Result<Self> {
        let quaternion = Quaternion::new(w, x, y, z);
        // An attitude that was written is read back to the bit. At the threshold, normalising would change it by no more than 1e-14.
        if (quaternion.norm_squared() - 1.0).abs() < 1e-14 {
            return Ok(Self::from_unit(quaternion));
        }
        Self::from_quaternion(w, x, y, z)
    }
}

impl From<Attitude> for [f64; 4] {
    fn from(attitude: Attitude) -> Self {
        let q = attitude.0;
        [q.w, q.i, q.j, q.k]
    }
}

impl From<UnitQuaternion<f64>> for Attitude {
    /// The attitude of this quaternion, to the bit.
    fn from(quaternion: UnitQuaternion<f64>) -> Self {
        Self(quaternion)
    }
}

impl From<Attitude> for UnitQuaternion<f64> {
    fn from(attitude: Attitude) -> Self {
        attitude.0
    }
}

/// Transport theorem (5.1), towards space: dA/dt = ∂A/∂t + Ω ∧ A.
///
/// `rate_seen_from_body` is ∂A/∂t, the rate of A's body components; `omega` is Ω in rad/s. The result is
/// dA/dt, the rate an observer at rest sees, written along the body's axes.
///
/// ```
/// use spinning_bodies::frame::{BodyVector, rate_seen_from_space};
/// // A vector fixed in the body moves in space: Ω ∧ A.
/// let (omega, arm) = (BodyVector::new(0.0, 0.0, 2.0), BodyVector::new(1.0, 0.0, 0.0));
/// assert_eq!(rate_seen_from_space(BodyVector::zero(), omega, arm), BodyVector::new(0.0, 2.0, 0.0));
/// ```
pub fn rate_seen_from_space(
    rate_seen_from_body: BodyVector,
    omega: BodyVector,
    vector: BodyVector,
) -> BodyVector {
    rate_seen_from_body + omega.cross(&vector)
}

/// Transport theorem (5.1), towards the body: ∂A/∂t = dA/dt − Ω ∧ A.
///
/// `rate_seen_from_space` is dA/dt, the rate an observer at rest sees, written along the axes of
/// space, as are `omega` and `vector`. The result is ∂A/∂t, the rate a rider on the body sees, still written
/// along the axes of space.
///
/// ```
/// use spinning_bodies::frame::{SpaceVector, rate_seen_from_body};
/// // A vector fixed in space moves backwards as seen from the body.
/// let (omega, star) = (SpaceVector::new(0.0, 0.0, 2.0), SpaceVector::new(1.0, 0.0, 0.0));
/// assert_eq!(rate_seen_from_body(SpaceVector::zero(), omega, star), SpaceVector::new(0.0, -2.0, 0.0));
/// ```
pub fn rate_seen_from_body(
    rate_seen_from_space: SpaceVector,
    omega: SpaceVector,
    vector: SpaceVector,
) -> SpaceVector {
    rate_seen_from_space - omega.cross(&vector)
}
