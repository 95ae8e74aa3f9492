//! Euler's equations (tutorial 5.1): how the angular velocity changes, seen by a rider on the body.
//!
//! In space the law is short, dL/dt = N, but the inertia matrix turns with the body. On the body the matrix
//! is constant and the law gets a second term: ∂L/∂t + Ω∧L = N. Written out along principal axes:
//!
//! I₁ ∂Ω₁/∂t = (I₂ − I₃) Ω₂Ω₃ + N₁, and cyclic.
//!
//! * [`rate`] is these three equations, [`rate_in_any_axes`] the same for a full inertia matrix, [`rate_in_space`] the same
//!   along axes at rest;
//! * [`rate_about`] takes torque and inertia about the point you choose: the centre of mass, a pivot, or any
//!   point of the body whose acceleration you know;
//! * [`flow`] shows the equations as a flow of L on its sphere;
//! * [`HeavyTop`] adds gravity, and tells which tops have a further integral (5.3); `series` has the power series of their motion.

mod flow;
mod heavy;
mod series;
mod springs;

pub use flow::{Equilibrium, Nature, equilibria, fastest_flow, flow, separatrix_slope, streamline};
pub(crate) use heavy::classify;
pub use heavy::{HeavyTop, Integrability, Integral, TopState};
pub(crate) use series::{Coefficients, Numeral, Series};
pub use springs::SpringBody;

use crate::error::{Result, each, positive};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::inertia::{InertiaMatrix, MassProperties, PrincipalMoments};

/// Principal moments I₁, I₂, I₃ in kg m² **in the order of the body's axes**, each positive.
///
/// [`PrincipalMoments`] are sorted; here the first number belongs to the first axis, whatever its size, as
/// Ω₁ does. A rod (a moment zero) is refused: no equation governs its spin about its own line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisMoments([f64; 3]);

impl AxisMoments {
    /// The moments along axes 1, 2, 3, checked (2.4).
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite), [`Error::TriangleInequality`](crate::Error::TriangleInequality) (slack 4 eps).
    ///
    /// ```
    /// use spinning_bodies::euler_equations::AxisMoments;
    /// assert_eq!(AxisMoments::new(4.0, 2.0, 3.0)?.values(), [4.0, 2.0, 3.0]);
    /// assert!(AxisMoments::new(0.0, 1.0, 1.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(i1: f64, i2: f64, i3: f64) -> Result<Self> {
        each(positive, "a principal moment", [i1, i2, i3])?;
        PrincipalMoments::new(i1, i2, i3)?;
        Ok(Self([i1, i2, i3]))
    }

    /// The moments of a body that may be a rod, for uses that do not divide by them.
    pub(crate) const fn allowing_rods(moments: [f64; 3]) -> Self {
        Self(moments)
    }

    /// I₁, I₂, I₃, kg m².
    ///
    /// ```
    /// use spinning_bodies::euler_equations::AxisMoments;
    /// assert_eq!(AxisMoments::new(3.0, 1.0, 2.0)?.values(), [3.0, 1.0, 2.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn values(&self) -> [f64; 3] {
        self.0
    }

    /// Angular momentum L = IΩ, kg m²/s; `omega` in rad/s (2.2).
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::AxisMoments, frame::BodyVector};
    /// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
    /// assert_eq!(moments.angular_momentum(BodyVector::new(1.0, 1.0, 1.0)), BodyVector::new(1.0, 2.0, 3.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum(&self, omega: BodyVector) -> BodyVector {
        let [i1, i2, i3] = self.0;
        BodyVector::new(i1 * omega.x(), i2 * omega.y(), i3 * omega.z())
    }

    /// Angular velocity I⁻¹L, rad/s; `l` in kg m²/s (2.2).
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::AxisMoments, frame::BodyVector};
    /// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
    /// assert_eq!(moments.angular_velocity(BodyVector::new(1.0, 1.0, 6.0)), BodyVector::new(1.0, 0.5, 2.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_velocity(&self, l: BodyVector) -> BodyVector {
        let [i1, i2, i3] = self.0;
        BodyVector::new(l.x() / i1, l.y() / i2, l.z() / i3)
    }

    /// Rotational energy ½⟨IΩ, Ω⟩, J; `omega` in rad/s (2.3). Without torque it is constant, and so is |L| (5.1).
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::AxisMoments, frame::BodyVector};
    /// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
    /// assert_eq!(moments.energy(BodyVector::new(2.0, 1.0, 2.0)), 9.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self, omega: BodyVector) -> f64 {
        0.5 * self.angular_momentum(omega).dot(&omega)
    }
}

/// ∂Ω/∂t in rad/s², along the principal axes: Euler's equations (5.1).
///
/// I₁ ∂Ω₁/∂t = (I₂ − I₃) Ω₂Ω₃ + N₁ and cyclic, with `omega` in rad/s and `torque` in N m about the same point as the
/// moments: the centre of mass or a point of the body that is at rest (else [`rate_about`]).
///
/// Domain: any vectors; if one is not finite, or a term (I₂ − I₃)Ω₂Ω₃ or its beginning overflows, the result is not finite. By 5.1 it is dΩ/dt as well:
/// for Ω itself the two derivatives agree. Error: each component to 5 ulp of the larger of its two terms, because the
/// differences of moments are formed first. Cost: three divisions and nine multiplications. No errors.
///
/// ```
/// use spinning_bodies::{euler_equations::{AxisMoments, rate}, frame::BodyVector};
/// let plate = AxisMoments::new(1.0, 2.0, 3.0)?;
/// let change = rate(&plate, BodyVector::new(1.0, 1.0, 1.0), BodyVector::zero());
/// assert_eq!(change, BodyVector::new(-1.0, 1.0, -1.0 / 3.0));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rate(moments: &AxisMoments, omega: BodyVector, torque: BodyVector) -> BodyVector {
    // ANCHOR: rate
    let [i1, i2, i3] = moments.values();
    let (o1, o2, o3) = (omega.x(), omega.y(), omega.z());
    BodyVector::new(
        ((i2 - i3) * o2 * o3 + torque.x()) / i1,
        ((i3 - i1) * o3 * o1 + torque.y()) / i2,
        ((i1 - i2) * o1 * o2 + torque.z()) / i3,
    )
    // ANCHOR_END: rate
}

/// ∂Ω/∂t in rad/s², along any axes of the body: I ∂Ω/∂t = IΩ∧Ω + N (5.1).
///
/// Domain: every moment positive. Method: along the principal axes by [`rate`], so that for a nearly round body the
/// differences of moments keep their digits. Observed error: 4e-16 of |I|·|Ω|²/I₁ for random bodies. Cost: one
/// [`InertiaMatrix::principal_axes`]; for many calls, change to principal axes once and use [`rate`].
///
/// # Errors
/// [`Error::NotPositive`](crate::Error::NotPositive) for a rod or a particle.
///
/// ```
/// use spinning_bodies::{euler_equations::rate_in_any_axes, frame::BodyVector, inertia::InertiaMatrix};
/// // Along principal axes I₁Ω₁' = (I₂ − I₃)Ω₂Ω₃.
/// let inertia = InertiaMatrix::diagonal(1.0, 2.0, 3.0)?;
/// let rate = rate_in_any_axes(&inertia, BodyVector::new(0.0, 2.0, 3.0), BodyVector::zero())?;
/// assert_eq!(rate, BodyVector::new(-6.0, 0.0, 0.0));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rate_in_any_axes(
    inertia: &InertiaMatrix,
    omega: BodyVector,
    torque: BodyVector,
) -> Result<BodyVector> {
    let principal = inertia.principal_axes();
    let [i1, i2, i3] = principal.moments;
    let axes = principal.axes;
    each(positive, "a principal moment", [i1, i2, i3])?;
    let along = |v: BodyVector| BodyVector::from_components(axes.tr_mul(&v.components()));
    let change = rate(&AxisMoments([i1, i2, i3]), along(omega), along(torque));
    Ok(BodyVector::from_components(axes * change.components()))
}

/// dΩ/dt in rad/s², along axes at rest: I(t) dΩ/dt = N − Ω∧I(t)Ω with I(t) = R I Rᵀ (3.2, 5.1).
///
/// The same change as [`rate`], seen from space: `omega` and `torque` along the axes of space, the moments along those
/// of the body, which stands at `attitude`. The result is that of [`rate`], turned: by the transport theorem, because
/// Ω∧Ω = 0. Error: that of two more rotations, 1e-15 relative observed. Cost: three rotations. No errors.
///
/// ```
/// use spinning_bodies::{euler_equations::{AxisMoments, rate_in_space}, frame::{Attitude, SpaceVector}};
/// let moments = AxisMoments::new(1.0, 2.0, 3.0)?;
/// // While the axes coincide, so do the two rates: Ω ∧ Ω = 0.
/// let rate = rate_in_space(&moments, &Attitude::identity(), SpaceVector::new(0.0, 2.0, 3.0), SpaceVector::zero());
/// assert_eq!(rate, SpaceVector::new(-6.0, 0.0, 0.0));
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rate_in_space(
    moments: &AxisMoments,
    attitude: &Attitude,
    omega: SpaceVector,
    torque: SpaceVector,
) -> SpaceVector {
    let (omega, torque) = (attitude.to_body(omega), attitude.to_body(torque));
    attitude.to_space(rate(moments, omega, torque))
}

/// The point about which torque and inertia are taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ReferencePoint {
    /// The centre of mass, however it moves.
    Center,
    /// A point of the body that is at rest in space; its coordinates along the body's axes, m.
    Pivot(BodyVector),
    /// A point of the body whose motion is prescribed: its coordinates, m, and its acceleration dU/dt, m/s², along the
    /// body's axes. The equation then has the inertial torque −M(C−O)∧dU/dt.
    Carried {
        /// The point O.
        point: BodyVector,
        /// Its acceleration.
        acceleration: BodyVector,
    },
}

/// ∂Ω/∂t in rad/s² of a body whose torque is known about a point of your choice (3.2, 5.1).
///
/// I_O ∂Ω/∂t + Ω∧I_OΩ = N_O − M(C−O)∧dU/dt, where O is the point, U its velocity, N_O the torque about it in N m. The last
/// term vanishes about the centre C and about a pivot; for other points it must not be left out.
///
/// Domain: as [`rate_in_any_axes`]; for a point far from C the inertia about it is large, and the relative error of the
/// result grows by I_O/I_C. Cost: parallel axes and [`rate_in_any_axes`].
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite) for the point, [`Error::NotPositive`](crate::Error::NotPositive) if a moment about it is zero.
///
/// ```
/// use spinning_bodies::{euler_equations::{ReferencePoint, rate_about}, frame::BodyVector, inertia::shapes};
/// // A rod of 3 kg and 2 m, held at its end and pulled: Ml²/3 = 4 kg m².
/// let (rod, end) = (shapes::rod(3.0, 2.0)?, ReferencePoint::Pivot(BodyVector::new(0.0, 0.0, -1.0)));
/// let torque = BodyVector::new(8.0, 0.0, 0.0);
/// assert!(rate_about(&rod, end, BodyVector::zero(), torque).is_err(), "along itself it has no moment");
/// let brick = shapes::cuboid(12.0, [1.0, 2.0, 3.0])?;
/// assert_eq!(rate_about(&brick, ReferencePoint::Center, BodyVector::zero(), torque)?.x(), 8.0 / 13.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rate_about(
    body: &MassProperties,
    reference: ReferencePoint,
    omega: BodyVector,
    torque: BodyVector,
) -> Result<BodyVector> {
    match reference {
        ReferencePoint::Center => rate_in_any_axes(&body.inertia(), omega, torque),
        ReferencePoint::Pivot(point) => rate_in_any_axes(&body.about(point)?, omega, torque),
        ReferencePoint::Carried {
            point,
            acceleration,
        } => {
            let lever = body.mass() * (body.center() - point);
            let of_inertia = lever.cross(&acceleration);
            rate_in_any_axes(&body.about(point)?, omega, torque - of_inertia)
        }
    }
}

/// dq/dt for the attitude's quaternion q: ½ qΩ, components w, x, y, z (2.2, 5.1).
///
/// It states that the body's axes turn with it, de/dt = Ω∧e, in the form that integrators take. Cost: twelve multiplications.
///
/// ```
/// use spinning_bodies::{euler_equations::quaternion_rate, frame::BodyVector};
/// assert_eq!(quaternion_rate([1.0, 0.0, 0.0, 0.0], BodyVector::new(2.0, 4.0, 6.0)), [0.0, 1.0, 2.0, 3.0]);
/// ```
pub fn quaternion_rate(quaternion: [f64; 4], omega: BodyVector) -> [f64; 4] {
    let [w, x, y, z] = quaternion;
    let (o1, o2, o3) = (omega.x(), omega.y(), omega.z());
    [
        0.5 * (-x * o1 - y * o2 - z * o3),
        0.5 * (w * o1 + y * o3 - z * o2),
        0.5 * (w * o2 + z * o1 - x * o3),
        0.5 * (w * o3 + x * o2 - y * o1),
    ]
}

/// One step of the classical Runge–Kutta method for an autonomous system; error of a step O(h⁵).
pub(crate) fn runge_kutta<const N: usize>(
    rate: impl Fn(&[f64; N]) -> [f64; N],
    y: &[f64; N],
    h: f64,
) -> [f64; N] {
    let shifted = |k: &[f64; N], h: f64| core::array::from_fn(|i| h.mul_add(k[i], y[i]));
    let k1 = rate(y);
    let k2 = rate(&shifted(&k1, 0.5 * h));
    let k3 = rate(&shifted(&k2, 0.5 * h));
    let k4 = rate(&shifted(&k3, h));
    core::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}
