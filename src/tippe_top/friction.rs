//! Friction and resistance of a table to a body that slides, rolls or pivots on it.

use nalgebra::Vector3;

use crate::error::{Result, not_negative, positive};
use crate::rolling::Coulomb;

/// Coulomb's law smoothed over slips of size ε: f = −μ v/√(v² + ε²). A body that would roll creeps instead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularised {
    mu: f64,
    epsilon: f64,
}

impl Regularised {
    /// The law with coefficient μ and slip scale ε (m/s). With ε = 1 mm/s the tilt of tops of 2 cm is right to 0.2°.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Regularised;
    /// assert!(Regularised::new(0.3, 1e-3).is_ok() && Regularised::new(0.3, 0.0).is_err());
    /// ```
    pub fn new(mu: f64, epsilon: f64) -> Result<Self> {
        let mu = not_negative("the coefficient of friction", mu)?;
        let epsilon = positive("the slip scale of friction", epsilon)?;
        Ok(Self { mu, epsilon })
    }
}

/// Viscous friction, f = −c v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscous {
    coefficient: f64,
}

impl Viscous {
    /// The law with this coefficient c (s/m).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Viscous;
    /// assert!(Viscous::new(0.1).is_ok() && Viscous::new(-0.1).is_err());
    /// ```
    pub fn new(coefficient: f64) -> Result<Self> {
        let coefficient = not_negative("the viscous coefficient of friction", coefficient)?;
        Ok(Self { coefficient })
    }
}

/// The rolling constraint: the point in contact never slips, whatever force that takes (4.7).
///
/// If the reaction falls to zero while a level force is still needed, the constraint cannot be satisfied; and if that force is what holds the body
/// on the table, it cannot take off either. The run ends there with [`Error::Integration`](crate::Error::Integration). With [`Coulomb`] friction the body would slide before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NoSlip;

/// A law of sliding friction: level force per normal force, f(v), for every velocity v of the point in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Friction {
    /// f = −μ v/|v| while the body slides; at rest any force up to the grip times the normal one.
    Coulomb(Coulomb),
    /// The same, smoothed over a small slip.
    Regularised(Regularised),
    /// In proportion to the slip.
    Viscous(Viscous),
    /// Pure rolling.
    NoSlip,
}

impl Friction {
    /// Whether the law has any effect.
    pub(crate) fn acts(&self) -> bool {
        match self {
            Self::Coulomb(law) => law.acts(),
            Self::Regularised(law) => law.mu > 0.0,
            Self::Viscous(law) => law.coefficient > 0.0,
            Self::NoSlip => true,
        }
    }

    /// f(v), opposite to the level slip v (m/s). Zero for pure rolling, which has no slip.
    #[inline]
    pub(crate) fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        let square = slip.norm_squared();
        slip * -match *self {
            Self::Coulomb(law) if square > 0.0 => law.kinetic / square.sqrt(),
            Self::Regularised(law) => law.mu / (square + law.epsilon * law.epsilon).sqrt(),
            Self::Viscous(law) => law.coefficient,
            Self::Coulomb(_) | Self::NoSlip => 0.0,
        }
    }

    /// A smooth law with its coefficient multiplied by `part`.
    pub(crate) fn weakened(mut self, part: f64) -> Self {
        match &mut self {
            Self::Regularised(law) => law.mu *= part,
            Self::Viscous(law) => law.coefficient *= part,
            Self::Coulomb(_) | Self::NoSlip => {}
        }
        self
    }

    /// The slip over which the law bends, m/s; infinite for a linear law, zero for one without a derivative at rest.
    pub(crate) const fn sharpness(&self) -> f64 {
        match self {
            Self::Coulomb(_) | Self::NoSlip => 0.0,
            Self::Regularised(law) => law.epsilon,
            Self::Viscous(_) => f64::INFINITY,
        }
    }
}

macro_rules! from {
    ($($law:ident)*) => {$(
        impl From<$law> for Friction {
            fn from(law: $law) -> Self {
                Self::$law(law)
            }
        }
    )*};
}
from!(Coulomb Regularised Viscous);

/// A couple at the contact that resists rolling and pivoting in proportion to the rate: per normal force τ = −a Ω_level − b Ω_vertical. It belongs to a contact that
/// lasts: impacts are computed without it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resistance {
    rolling: f64,
    pivoting: f64,
}

impl Resistance {
    /// The law with coefficients a against rolling and b against pivoting (m s).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::tippe_top::Resistance;
    /// assert!(Resistance::new(1e-3, 0.0).is_ok() && Resistance::new(-1e-3, 0.0).is_err());
    /// ```
    pub fn new(rolling: f64, pivoting: f64) -> Result<Self> {
        let rolling = not_negative("the resistance to rolling", rolling)?;
        let pivoting = not_negative("the resistance to pivoting", pivoting)?;
        Ok(Self { rolling, pivoting })
    }

    pub(crate) fn acts(&self) -> bool {
        self.rolling > 0.0 || self.pivoting > 0.0
    }

    /// τ (m) for the angular velocity Ω (rad/s) and the unit vertical, in body axes.
    #[inline]
    pub(crate) fn couple(&self, omega: &Vector3<f64>, up: &Vector3<f64>) -> Vector3<f64> {
        let vertical = up * up.dot(omega);
        (omega - vertical) * -self.rolling - vertical * self.pivoting
    }
}
