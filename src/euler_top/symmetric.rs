//! The symmetric free top, I₁ = I₂ (tutorial 6.5): exact rotation rate and attitude at any time.

use super::motion::EulerTop;
use crate::error::{Result, not_negative, positive};
use crate::frame::{Attitude, BodyVector};
use crate::inertia::PrincipalMoments;
use crate::precise::{DoubleDouble, Number, power_of_two_below};

/// Whether the axial moment is greater than, equal to or less than the transverse one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// I₃ > I₁, flat like a disc or the Earth: seen from the body, Ω circles the axis in the sense of the spin.
    Oblate,
    /// I₃ = I₁: Ω is constant (6.4).
    Spherical,
    /// I₃ < I₁, long like a cigar: seen from the body, Ω circles the axis against the spin.
    Prolate,
}

/// Half-angles of the two cones of the free symmetric top, radians, in 0…π: the body cone rolls on the space cone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cones {
    /// From the axis x₃ to Ω: the cone that Ω traces in the body.
    pub body: f64,
    /// From L to Ω: the cone that Ω traces in space.
    pub space: f64,
    /// From L to the axis x₃: the cone that the axis traces in space.
    pub nutation: f64,
}

/// A body with I₁ = I₂, free of torque; x₃ is its axis of symmetry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SymmetricTop {
    transverse: f64,
    axial: f64,
    /// Oblate, spherical or prolate.
    pub shape: Shape,
    /// I₃/I₁ − 1, from the exact difference of the moments.
    excess: DoubleDouble,
}

impl SymmetricTop {
    /// The top with moments I₁ = I₂ = `transverse` and I₃ = `axial`, kg m².
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) for I₁, [`Error::Negative`](crate::Error::Negative) for I₃ (zero is a thin rod);
    /// [`Error::TriangleInequality`](crate::Error::TriangleInequality) if I₃ > 2I₁ by more than four units in the last place, which no body has (2.4).
    ///
    /// ```
    /// use spinning_bodies::euler_top::SymmetricTop;
    /// assert_eq!(SymmetricTop::new(1.0, 1.5)?.axial(), 1.5);
    /// // No body: I₃ > 2I₁.
    /// assert!(SymmetricTop::new(1.0, 2.5).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(transverse: f64, axial: f64) -> Result<Self> {
        let transverse = positive("the transverse moment", transverse)?;
        let axial = not_negative("the axial moment", axial)?;
        PrincipalMoments::new(transverse, transverse, axial)?;
        let shape = if axial > transverse {
            Shape::Oblate
        } else if axial < transverse {
            Shape::Prolate
        } else {
            Shape::Spherical
        };
        let unit = power_of_two_below(transverse);
        let excess = DoubleDouble::difference(axial / unit, transverse / unit)
            / DoubleDouble::from(transverse / unit);
        Ok(Self {
            transverse,
            axial,
            shape,
            excess,
        })
    }

    /// I₃, kg m².
    ///
    /// ```
    /// use spinning_bodies::euler_top::SymmetricTop;
    /// assert_eq!(SymmetricTop::new(1.0, 1.5)?.axial(), 1.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn axial(&self) -> f64 {
        self.axial
    }

    /// Rate at which Ω circles the axis, seen from the body: Ω₃(I₃/I₁ − 1), rad/s; positive means with the spin (6.5).
    ///
    /// The difference of the moments is exact. Error: one unit in the last place, however nearly spherical the body is.
    ///
    /// ```
    /// use spinning_bodies::euler_top::SymmetricTop;
    /// // A thrown plate, I₃ = 2I₁: seen from the plate, Ω circles as fast as it spins.
    /// assert_eq!(SymmetricTop::new(1.0, 2.0)?.wobble_rate(3.0), 3.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn wobble_rate(&self, omega3: f64) -> f64 {
        (self.excess * DoubleDouble::from(omega3)).value()
    }

    /// Period of that circle, seen from the body: 2π/|Ω₃(I₃/I₁ − 1)|, s, whatever Ω₁ and Ω₂ (6.5).
    ///
    /// Infinite for a spherical top and for one that does not spin. Error: two units in the last place.
    ///
    /// ```
    /// use spinning_bodies::euler_top::SymmetricTop;
    /// assert_eq!(SymmetricTop::new(1.0, 1.5)?.wobble_period(2.0), 2.0 * std::f64::consts::PI);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn wobble_period(&self, omega3: f64) -> f64 {
        core::f64::consts::TAU / self.wobble_rate(omega3).abs()
    }

    /// Angular velocity after `t` seconds, in body axes: Ω₁ + iΩ₂ turned by the angle Ω₃(I₃/I₁ − 1)t, Ω₃ unchanged (6.5).
    ///
    /// The angle is formed and reduced in 106 bits: its error is 2⁻¹⁰² of the angle, below a unit in the last place for
    /// a million million turns, where a plain product would be wrong by eps times the angle. Observed: 2 units in the last place
    /// of the transverse part up to t = 10¹². Cost: about 90 additions and multiplications, one sine, one cosine.
    /// An argument that is not finite, or an angle that overflows, gives components that are not finite.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::SymmetricTop, frame::BodyVector};
    /// let top = SymmetricTop::new(1.0, 2.0)?;
    /// let start = BodyVector::new(0.1, 0.0, std::f64::consts::PI);
    /// // Half a turn of the plate, half a turn of Ω about its axis.
    /// assert!((top.omega_at(start, 1.0) - BodyVector::new(-0.1, 0.0, std::f64::consts::PI)).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn omega_at(&self, omega0: BodyVector, t: f64) -> BodyVector {
        let (sin, cos) = self.wobble_angle(omega0.z(), t).sin_cos();
        BodyVector::new(
            omega0.x() * cos - omega0.y() * sin,
            omega0.x() * sin + omega0.y() * cos,
            omega0.z(),
        )
    }

    /// Attitude after `t` seconds, from body axes along the space axes at t = 0: the turn |L|t/I₁ about L after the turn
    /// −Ω₃(I₃/I₁ − 1)t about x₃ (6.5, seen from space).
    ///
    /// From [`EulerTop`]: a few units in the last place of a radian at any time. A top at rest stays at rest.
    ///
    /// # Errors
    /// As those of [`EulerTop::from_omega`] and [`EulerTop::at`].
    ///
    /// ```
    /// use spinning_bodies::{euler_top::SymmetricTop, frame::BodyVector};
    /// use spinning_bodies::frame::Attitude;
    /// // About its axis it simply spins.
    /// let attitude = SymmetricTop::new(1.0, 1.5)?.attitude_at(BodyVector::new(0.0, 0.0, 2.0), 0.7)?;
    /// let spun = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), 1.4)?;
    /// assert!(attitude.angle_to(&spun) < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn attitude_at(&self, omega0: BodyVector, t: f64) -> Result<Attitude> {
        let moments = [self.transverse, self.transverse, self.axial];
        let top = EulerTop::from_omega(moments, omega0, Attitude::identity())?;
        Ok(top.at(t)?.attitude)
    }

    /// Rate at which the axis of symmetry circles L, seen from space: |L|/I₁, rad/s (6.5). Error: two units in the last place.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::SymmetricTop, frame::BodyVector};
    /// // A plate thrown almost flat wobbles twice as fast as it spins.
    /// let rate = SymmetricTop::new(1.0, 2.0)?.axis_rate_in_space(BodyVector::new(1e-9, 0.0, 3.0));
    /// assert!((rate - 6.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn axis_rate_in_space(&self, omega: BodyVector) -> f64 {
        let axial = self.axial / self.transverse * omega.z();
        BodyVector::new(omega.x(), omega.y(), axial).norm()
    }

    /// The half-angles of the cones of 6.5: of Ω about the axis, of Ω about L, of the axis about L.
    ///
    /// Ω, L and the axis lie in one plane. The small angle of the space cone is not formed as a difference of the other two, but as
    /// the arctangent of |Ω₃(I₃/I₁ − 1)Ω⊥| over Ω₃²I₃/I₁ + Ω⊥². Error: a few units in the last place even for the roundest body.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::ZeroVector`](crate::Error::ZeroVector) for Ω.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::SymmetricTop, frame::BodyVector};
    /// // L = (1, 0, 1.5) for Ω = (1, 0, 1).
    /// let cones = SymmetricTop::new(1.0, 1.5)?.cones(BodyVector::new(1.0, 0.0, 1.0))?;
    /// assert!((cones.nutation - (1.0_f64 / 1.5).atan()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn cones(&self, omega: BodyVector) -> Result<Cones> {
        let direction = omega.direction("the angular velocity")?;
        let (across, along) = (direction.x().hypot(direction.y()), direction.z());
        let l3 = self.axial / self.transverse * along;
        Ok(Cones {
            body: across.atan2(along),
            space: (self.wobble_rate(along) * across)
                .abs()
                .atan2(l3 * along + across * across),
            nutation: across.atan2(l3),
        })
    }

    fn wobble_angle(&self, omega3: f64, t: f64) -> DoubleDouble {
        self.excess * DoubleDouble::product(omega3, t)
    }
}
