//! Dry friction and rolling resistance.

use core::f64::consts::FRAC_PI_2;

use crate::error::{Result, not_negative, positive, refused, within};

/// Coulomb's law: friction is μ times the reaction, against the slip; while the contact sticks it is up to `grip` times the reaction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    /// Coefficient while the contact slips.
    pub(crate) kinetic: f64,
    /// Greatest ratio of friction to reaction while it sticks.
    pub(crate) grip: f64,
}

impl Coulomb {
    /// One coefficient μ (dimensionless) for slipping and sticking.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    ///
    /// ```
    /// use spinning_bodies::rolling::Coulomb;
    /// assert!(Coulomb::new(0.2).is_ok());
    /// assert!(Coulomb::new(-0.2).is_err());
    /// ```
    pub fn new(coefficient: f64) -> Result<Self> {
        Self::with_grip(coefficient, coefficient)
    }

    /// A coefficient for slipping, and a greater one, for sticking, that has to be overcome first.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative); [`Error::Condition`](crate::Error::Condition) if the grip is less than the sliding friction.
    ///
    /// ```
    /// use spinning_bodies::rolling::Coulomb;
    /// assert!(Coulomb::with_grip(0.2, 0.3).is_ok());
    /// // Static friction less than sliding friction is refused.
    /// assert!(Coulomb::with_grip(0.3, 0.2).is_err());
    /// ```
    pub fn with_grip(kinetic: f64, grip: f64) -> Result<Self> {
        let kinetic = not_negative("the coefficient of friction", kinetic)?;
        let grip = not_negative("the coefficient of static friction", grip)?;
        if grip < kinetic {
            return refused(
                "static friction must not be less than sliding friction",
                grip,
            );
        }
        Ok(Self { kinetic, grip })
    }

    /// Whether it can do anything.
    pub(crate) const fn acts(&self) -> bool {
        self.grip > 0.0
    }
}

/// Rolling resistance: the reaction acts `arm` radii ahead of the centre, which makes a couple against the rotation.
///
/// A freely rolling body then decelerates at arm·g/(1+κ), and towing one at constant speed takes a force of arm times
/// its weight. On billiard cloth arm is 0.005 to 0.015.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingResistance {
    /// Lever arm of the reaction over the radius.
    pub(crate) arm: f64,
}

impl RollingResistance {
    /// The coefficient, dimensionless.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative).
    ///
    /// ```
    /// use spinning_bodies::rolling::RollingResistance;
    /// assert!(RollingResistance::new(0.01).is_ok() && RollingResistance::new(-0.01).is_err());
    /// ```
    pub fn new(arm: f64) -> Result<Self> {
        let arm = not_negative("the coefficient of rolling resistance", arm)?;
        Ok(Self { arm })
    }
}

/// The coefficient of friction above which a rod sliding on its lower end has no motion with finite forces: Painlevé's paradox.
///
/// `kappa` is I/(Mr²) about the centre of mass at the distance r from that end, 1/3 for a uniform rod; `tilt` the angle between rod and table
/// (rad, 0 to π/2), the end sliding ahead of the centre. A reaction N accelerates the end upward by (N/M)(1 + cos θ(cos θ − μ sin θ)/κ), which is
/// positive only below μ = (κ + cos²θ)/(sin θ cos θ): at least 2√(κ(1+κ)), 4/3 for the uniform rod. Infinite for a rod that lies. Observed error: 2 ε.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive) for κ, [`Error::OutOfRange`](crate::Error::OutOfRange) for the angle.
///
/// ```
/// let tilt = 2f64.atan();
/// assert!((spinning_bodies::rolling::painleve_friction(1.0 / 3.0, tilt)? - 4.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn painleve_friction(kappa: f64, tilt: f64) -> Result<f64> {
    let kappa = positive("the inertia factor", kappa)?;
    let (sine, cosine) = within("the tilt of the rod", tilt, 0.0, FRAC_PI_2)?.sin_cos();
    Ok((kappa + cosine * cosine) / (sine * cosine))
}
