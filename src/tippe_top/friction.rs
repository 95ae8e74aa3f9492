//! What a table does to a body that slides, rolls or pivots on it.

use nalgebra::Vector3;

use crate::error::{Result, not_negative, positive};

/// A law of sliding friction: force per normal force, f(v), for every velocity v of the point in contact.
pub trait Traction: Copy {
    /// Whether there is any.
    const ACTS: bool = true;

    /// f(v), opposite to the level slip v (m/s).
    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64>;

    /// The slip over which the law bends, m/s; infinite for a linear law.
    fn sharpness(&self) -> f64;

    /// How a contact can hold.
    fn holding(&self) -> Holding {
        Holding::Slides
    }
}

/// How a contact can hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Holding {
    /// Force follows slip; the contact always slides.
    Slides,
    /// Coulomb's law: it sticks while the force needed is at most μ times the normal one.
    Cone {
        /// Coefficient of friction.
        mu: f64,
    },
    /// It never slips.
    Grips,
}

/// Coulomb's law, f = −μ v/|v| while the body slides; at rest any force up to μ times the normal one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    mu: f64,
}

impl Coulomb {
    /// The law with this coefficient of friction μ.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(mu: f64) -> Result<Self> {
        let mu = not_negative("the coefficient of friction", mu)?;
        Ok(Self { mu })
    }

    /// μ.
    pub const fn mu(&self) -> f64 {
        self.mu
    }
}

impl Traction for Coulomb {
    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        let size = slip.norm();
        if size == 0.0 {
            Vector3::zeros()
        } else {
            slip * (-self.mu / size)
        }
    }

    fn sharpness(&self) -> f64 {
        0.0
    }

    fn holding(&self) -> Holding {
        // Without friction nothing ever sticks, not even where the slip is nil.
        if self.mu == 0.0 {
            Holding::Slides
        } else {
            Holding::Cone { mu: self.mu }
        }
    }
}

/// Coulomb's law smoothed over slips of size ε: f = −μ v/√(v² + ε²). A body that "rolls" creeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularised {
    mu: f64,
    epsilon: f64,
}

impl Regularised {
    /// The law with coefficient μ and slip scale ε (m/s). ε = 1 mm/s is converged to 0.2° of tilt for tops of 2 cm.
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(mu: f64, epsilon: f64) -> Result<Self> {
        let mu = not_negative("the coefficient of friction", mu)?;
        let epsilon = positive("the slip scale of friction", epsilon)?;
        Ok(Self { mu, epsilon })
    }
}

impl Traction for Regularised {
    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        slip * (-self.mu / (slip.norm_squared() + self.epsilon * self.epsilon).sqrt())
    }

    fn sharpness(&self) -> f64 {
        self.epsilon
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
    pub fn new(coefficient: f64) -> Result<Self> {
        let coefficient = not_negative("the viscous coefficient of friction", coefficient)?;
        Ok(Self { coefficient })
    }
}

impl Traction for Viscous {
    fn traction(&self, slip: &Vector3<f64>) -> Vector3<f64> {
        slip * -self.coefficient
    }

    fn sharpness(&self) -> f64 {
        f64::INFINITY
    }
}

/// A couple at the contact, per normal force, that resists turning: τ(Ω), in metres.
pub trait Couple: Copy {
    /// Whether there is any.
    const ACTS: bool = true;

    /// τ for the angular velocity Ω (rad/s) and the unit vertical, in body axes.
    fn couple(&self, omega: &Vector3<f64>, up: &Vector3<f64>) -> Vector3<f64>;
}

/// Resistance to rolling and to pivoting in proportion to the rate: τ = −a Ω_level − b Ω_vertical.
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
    pub fn new(rolling: f64, pivoting: f64) -> Result<Self> {
        Ok(Self {
            rolling: not_negative("the resistance to rolling", rolling)?,
            pivoting: not_negative("the resistance to pivoting", pivoting)?,
        })
    }
}

impl Couple for Resistance {
    fn couple(&self, omega: &Vector3<f64>, up: &Vector3<f64>) -> Vector3<f64> {
        let vertical = up * up.dot(omega);
        (omega - vertical) * -self.rolling - vertical * self.pivoting
    }
}

/// No force along the table, no couple.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Smooth;

impl Traction for Smooth {
    const ACTS: bool = false;

    fn traction(&self, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }

    fn sharpness(&self) -> f64 {
        f64::INFINITY
    }
}

impl Couple for Smooth {
    const ACTS: bool = false;

    fn couple(&self, _: &Vector3<f64>, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }
}
