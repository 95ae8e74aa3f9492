//! The inertia matrix itself (tutorial 2.2 to 2.4, 2.7, 2.8).

use nalgebra::{Matrix3, Vector3};

use super::moments::possible;
use super::principal::{PrincipalAxes, principal_axes_of, symmetric, symmetric_axes};
use crate::error::{Error, Result, each_finite, finite, not_negative, within};
use crate::frame::{Attitude, BodyVector, finite_vector};
use crate::precise::power_of_two_below;

/// The inertia matrix I about some point, kg m²: symmetric, with moments that a body can have.
///
/// The point is not stored: [`MassProperties`](super::MassProperties) keeps the matrix about the centre of
/// mass and knows where that is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "[[f64; 3]; 3]", into = "[[f64; 3]; 3]")
)]
pub struct InertiaMatrix(Matrix3<f64>);

#[cfg(feature = "serde")]
impl TryFrom<[[f64; 3]; 3]> for InertiaMatrix {
    type Error = Error;

    fn try_from(rows: [[f64; 3]; 3]) -> Result<Self> {
        // The widest slack of all constructors, so that every matrix that was written can be read.
        Self::with_slack(rows.into(), SLACK_OF_SUMS)
    }
}

#[cfg(feature = "serde")]
impl From<InertiaMatrix> for [[f64; 3]; 3] {
    fn from(inertia: InertiaMatrix) -> Self {
        inertia.0.into()
    }
}

/// Slack, in units of eps times the largest moment, for matrices that have been rounded entry by entry.
const SLACK: f64 = 16.0 * f64::EPSILON;
/// The same for a thin body whose moments come out of sums over many triangles.
pub(super) const SLACK_OF_SUMS: f64 = 1e-12;

impl InertiaMatrix {
    /// The inertia matrix with these entries, checked (2.4, 2.7).
    ///
    /// Domain: symmetric up to 16 eps times the largest entry (mirror entries are averaged), finite, with a
    /// finite trace, and with principal moments that are not negative and obey I₁ + I₂ ≥ I₃, up to 16 eps·I₃:
    /// a rod or a lamina in tilted axes does not survive rounding better than that.
    /// Cost: one [`principal_axes`](Self::principal_axes).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotSymmetric`], [`Error::Negative`], [`Error::TriangleInequality`].
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// use nalgebra::Matrix3;
    /// assert!(InertiaMatrix::from_matrix(Matrix3::from_diagonal(&[1.0, 2.0, 3.0].into())).is_ok());
    /// // No body: I₁ + I₂ < I₃.
    /// let refused = InertiaMatrix::from_matrix(Matrix3::from_diagonal(&[1e307, 1e307, 3e307].into()));
    /// assert!(refused.unwrap_err().to_string().contains("1e307 + 1e307 < 3e307"));
    /// ```
    pub fn from_matrix(matrix: Matrix3<f64>) -> Result<Self> {
        Self::with_slack(matrix, SLACK)
    }

    /// The same with another slack, in units of the largest entry and of the largest moment.
    pub(super) fn with_slack(matrix: Matrix3<f64>, relative: f64) -> Result<Self> {
        let slack = relative * matrix.amax();
        symmetric("an entry of the inertia matrix", &matrix, slack)?;
        let symmetric = symmetrised(&matrix);
        finite("the trace of the inertia matrix", symmetric.trace())?;
        let moments = principal_axes_of(&symmetric)?.moments;
        let [smallest, _, largest] = moments;
        let slack = relative * largest.abs().max(smallest.abs());
        if smallest < -slack {
            return Err(Error::Negative {
                quantity: "a principal moment",
                value: smallest,
            });
        }
        possible(moments, slack)?;
        Ok(Self(symmetric))
    }

    /// The inertia matrix along principal axes: diag(I₁, I₂, I₃), in the order given.
    ///
    /// # Errors
    /// As [`PrincipalMoments::new`](super::PrincipalMoments::new), and [`Error::NotFinite`] if the trace overflows.
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// assert_eq!(InertiaMatrix::diagonal(2.0, 3.0, 4.0)?.matrix().trace(), 9.0);
    /// assert!(InertiaMatrix::diagonal(1.0, 1.0, 3.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn diagonal(i1: f64, i2: f64, i3: f64) -> Result<Self> {
        super::PrincipalMoments::new(i1, i2, i3)?;
        finite("the trace of the inertia matrix", i1 + i2 + i3)?;
        Ok(Self(Matrix3::from_diagonal(&Vector3::new(i1, i2, i3))))
    }

    /// The inertia matrix of a particle at `position` from the reference point: m(|x|²δ − x xᵀ) (2.7, 2.8).
    ///
    /// Error: every entry to 2 ulp, unless the mass times a coordinate underflows. The trace of the result must be finite. Cost: a dozen multiplications.
    ///
    /// # Errors
    /// [`Error::Negative`] or [`Error::NotFinite`] for the mass, the position or an overflow.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// let matrix = InertiaMatrix::of_particle(2.0, BodyVector::new(1.0, 0.0, 2.0))?.matrix();
    /// assert_eq!((matrix[(0, 0)], matrix[(1, 1)], matrix[(0, 2)]), (8.0, 10.0, -4.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn of_particle(mass: f64, position: BodyVector) -> Result<Self> {
        not_negative("the mass", mass)?;
        finite_vector("a coordinate of the particle", position)?;
        Self::checked(particle_term(mass, &position.components()))
    }

    /// A matrix that is an inertia matrix by construction: only overflow is refused.
    pub(super) fn checked(matrix: Matrix3<f64>) -> Result<Self> {
        finite("the trace of the inertia matrix", matrix.trace())?;
        each_finite("an entry of the inertia matrix", matrix.iter().copied())?;
        Ok(Self(matrix))
    }

    /// The matrix, kg m², along the body's axes.
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// let matrix = InertiaMatrix::diagonal(2.0, 3.0, 4.0)?.matrix();
    /// assert_eq!((matrix[(1, 1)], matrix[(0, 1)]), (3.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn matrix(&self) -> Matrix3<f64> {
        self.0
    }

    /// The second moments S = ∫x xᵀρ = ½tr(I)δ − I, kg m² (2.5, 2.7).
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// let moments = InertiaMatrix::diagonal(5.0, 4.0, 3.0)?.second_moments();
    /// assert_eq!(moments.diagonal().as_slice(), [1.0, 2.0, 3.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn second_moments(&self) -> Matrix3<f64> {
        let [a, b, c] = [0, 1, 2].map(|i| 0.5 * self.0[(i, i)]);
        let mut moments = -self.0;
        (moments[(0, 0)], moments[(1, 1)], moments[(2, 2)]) =
            ((b - a) + c, (c - b) + a, (a - c) + b);
        moments
    }

    /// Angular momentum L = IΩ about the reference point, kg m²/s; `omega` in rad/s (2.2).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let l = inertia.angular_momentum(BodyVector::new(1.0, 1.0, 0.0));
    /// assert_eq!(l, BodyVector::new(1.0, 2.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum(&self, omega: BodyVector) -> BodyVector {
        BodyVector::from_components(self.0 * omega.components())
    }

    /// Rotational energy ½⟨IΩ, Ω⟩, J; `omega` in rad/s (2.3).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// assert_eq!(inertia.rotational_energy(BodyVector::new(2.0, 0.0, 2.0)), 8.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rotational_energy(&self, omega: BodyVector) -> f64 {
        0.5 * self.angular_momentum(omega).dot(&omega)
    }

    /// Moment of inertia ⟨Ie, e⟩ about an axis through the reference point, kg m²; `axis` of any length (2.4).
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::ZeroVector`] for the axis.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// assert!((inertia.moment_about(BodyVector::new(1.0, 1.0, 1.0))? - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moment_about(&self, axis: BodyVector) -> Result<f64> {
        let e = axis.direction("the axis")?.components();
        Ok(e.dot(&(self.0 * e)))
    }

    /// Angle between L = IΩ and Ω, radians (2.2).
    ///
    /// The moment about Ω is subtracted from the matrix before it is applied, so that a nearly round body's small angle keeps its digits.
    /// Never more than [`PrincipalMoments::greatest_angle`](super::PrincipalMoments::greatest_angle), but for the rounding of the moments that this is made from.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::ZeroVector`] for `omega`; [`Error::ZeroVector`] if L vanishes, as for a
    /// rod that turns about itself.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// // L = (1, 2, 0) and Ω = (1, 1, 0): tan of the angle is 1/3.
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let angle = inertia.angle_between_l_and_omega(BodyVector::new(1.0, 1.0, 0.0))?;
    /// assert!((angle - (1.0_f64 / 3.0).atan()).abs() < 1e-15);
    /// let small = InertiaMatrix::diagonal(1e-201, 2e-201, 3e-201)?;
    /// let angle = small.angle_between_l_and_omega(BodyVector::new(1.0, 1e-130, 0.0))?;
    /// assert!((angle / 1e-130 - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angle_between_l_and_omega(&self, omega: BodyVector) -> Result<f64> {
        let omega = omega.direction("the angular velocity")?;
        // Over a power of two, for small moments times the small components of a direction underflow.
        let matrix = self.0 / power_of_two_below(self.0.amax());
        let l = Self(matrix).angular_momentum(omega);
        l.direction("the angular momentum")?;
        let along = omega.dot(&l);
        let apart = Self(matrix - Matrix3::from_diagonal_element(along));
        let across = omega.cross(&apart.angular_momentum(omega));
        Ok(across.norm().atan2(along))
    }

    /// Parallel axes (2.8): from the centre of mass to a point, I_O = I_C + M(|d|²δ − d dᵀ).
    ///
    /// `self` must be about the centre of mass; `offset` is d = C − O (its sign is immaterial), metres.
    /// Error: 1 ulp of each entry beyond those of the two terms. Cost: a dozen multiplications.
    ///
    /// # Errors
    /// As [`of_particle`](Self::of_particle).
    pub(crate) fn shifted_from_center(&self, mass: f64, offset: BodyVector) -> Result<Self> {
        Self::checked(self.0 + Self::of_particle(mass, offset)?.0)
    }

    /// The inertia matrix of the body turned by `attitude`: R I Rᵀ.
    ///
    /// Equally: the same matrix by its components along the axes of space. Exactly symmetric.
    /// Cost: 50 multiplications.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, inertia::InertiaMatrix};
    /// let quarter = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2)?;
    /// let turned = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?.rotated(&quarter);
    /// assert!((turned.matrix()[(0, 0)] - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rotated(&self, attitude: &Attitude) -> Self {
        let r = attitude.quaternion().to_rotation_matrix();
        Self(symmetrised(&(r.matrix() * self.0 * r.matrix().transpose())))
    }

    /// Mean of the matrices that arise by turning the body about `axis` by all multiples of 2π/`order` (2.6).
    ///
    /// The mean is the inertia of a body with a symmetry of that order. From order 3 on it is that of a body of revolution,
    /// the same for every order: round a circle a symmetric matrix varies at most with the doubled angle, and three equally
    /// spaced points average that to zero.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::ZeroVector`] for the axis, [`Error::OutOfRange`] for order 0.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// // Threefold symmetry makes the two moments across the axis equal.
    /// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
    /// let mean = inertia.averaged_over_rotations(BodyVector::new(0.0, 0.0, 1.0), 3)?;
    /// assert!((mean.matrix() - InertiaMatrix::diagonal(1.5, 1.5, 3.0)?.matrix()).amax() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn averaged_over_rotations(&self, axis: BodyVector, order: u32) -> Result<Self> {
        let e = axis.direction("the axis")?.components();
        let most = u32::MAX.into();
        within("the order of the symmetry", order.into(), 1.0, most)?;
        match order {
            1 => Ok(*self),
            2 => {
                let half_turn = 2.0 * e * e.transpose() - Matrix3::identity();
                let turned = half_turn * self.0 * half_turn;
                Ok(Self(symmetrised(&(0.5 * self.0 + 0.5 * turned))))
            }
            _ => {
                let axial = e.dot(&(self.0 * e));
                let transverse = 0.5 * (self.0.trace() - axial);
                let matrix = Matrix3::from_diagonal_element(transverse)
                    + (axial - transverse) * e * e.transpose();
                Ok(Self(symmetrised(&matrix)))
            }
        }
    }

    /// Torque about the reference point, N m, of a field of force that is linear in position (2.5).
    ///
    /// The force on a particle m at x is m·A x, A in s⁻². N = ∫x∧(Ax)ρ depends on the body through this matrix alone.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, inertia::InertiaMatrix};
    /// use nalgebra::Matrix3;
    /// // A pull towards the middle in proportion to the distance has no torque.
    /// let torque = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?.torque_in_linear_field(&-Matrix3::identity());
    /// assert_eq!(torque, BodyVector::zero());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn torque_in_linear_field(&self, field: &Matrix3<f64>) -> BodyVector {
        // (A S)_kj = ∫(Ax)_k x_j ρ.
        let m = field * self.second_moments();
        BodyVector::new(
            m[(2, 1)] - m[(1, 2)],
            m[(0, 2)] - m[(2, 0)],
            m[(1, 0)] - m[(0, 1)],
        )
    }

    /// Principal moments, ascending, and principal axes (2.4).
    ///
    /// Accuracy: see [`PrincipalAxes`]. Cost: 0.1 µs.
    ///
    /// ```
    /// use spinning_bodies::inertia::InertiaMatrix;
    /// use nalgebra::Matrix3;
    /// let matrix = Matrix3::new(2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 4.0);
    /// let moments = InertiaMatrix::from_matrix(matrix)?.principal_axes().moments;
    /// assert!((moments[0] - 1.0).abs() < 1e-15 && (moments[1] - 3.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn principal_axes(&self) -> PrincipalAxes {
        symmetric_axes(&self.0).not_negative()
    }
}

/// m(|d|²δ − d dᵀ), the mass times a coordinate first: the squares of coordinates may leave the range of doubles where no moment does.
pub(super) fn particle_term(mass: f64, d: &Vector3<f64>) -> Matrix3<f64> {
    let md = mass * d;
    let (xx, yy, zz) = (md.x * d.x, md.y * d.y, md.z * d.z);
    let (xy, xz, yz) = (md.x * d.y, md.x * d.z, md.y * d.z);
    Matrix3::new(yy + zz, -xy, -xz, -xy, zz + xx, -yz, -xz, -yz, xx + yy)
}

/// The symmetric part; a matrix that is symmetric stays as it is, for the half of a subnormal number may be rounded.
fn symmetrised(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    matrix.zip_map(&matrix.transpose(), |a, b| {
        if a == b { a } else { a * 0.5 + b * 0.5 }
    })
}
