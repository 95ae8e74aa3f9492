//! What can be at work on a body on a table: gravity, friction, resistance to rolling and pivoting.

use nalgebra::Vector3;

use crate::error::{Result, positive};
use crate::scene::effect::{Absent, Effect};
use crate::tippe_top::{Coulomb, Couple, Holding, Regularised, Resistance, Traction, Viscous};

/// Gravity, downwards; what presses the body to the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    strength: f64,
}

impl Gravity {
    /// Of this strength, m/s².
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(strength: f64) -> Result<Self> {
        let strength = positive("gravity", strength)?;
        Ok(Self { strength })
    }

    /// Its strength, m/s².
    pub const fn strength(&self) -> f64 {
        self.strength
    }
}

impl Effect for Gravity {
    const PRESENT: bool = true;
    const NAME: &'static str = "gravity";
}

/// The slot of gravity.
pub trait Pull: Effect {
    /// The strength, if there is any.
    fn pull(&self) -> Option<f64>;
}

impl Pull for Gravity {
    fn pull(&self) -> Option<f64> {
        Some(self.strength)
    }
}

impl Pull for Absent {
    fn pull(&self) -> Option<f64> {
        None
    }
}

/// The rolling constraint: the point in contact never slips, whatever force that takes.
///
/// Where the reaction falls to zero while a level force is still needed, no table can do both, and the body cannot take off either if
/// that force held it up: the run ends there with [`Error::Integration`](crate::Error::Integration). [`Coulomb`] slides first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NoSlip;

impl Traction for NoSlip {
    const ACTS: bool = false;

    fn traction(&self, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }

    fn sharpness(&self) -> f64 {
        0.0
    }

    fn holding(&self) -> Holding {
        Holding::Grips
    }
}

/// The slot of friction at the contact.
pub trait Grip: Effect + Traction {}

impl Traction for Absent {
    const ACTS: bool = false;

    fn traction(&self, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }

    fn sharpness(&self) -> f64 {
        f64::INFINITY
    }
}

/// The slot of the couple that resists turning.
pub trait Resist: Effect + Couple {}

impl Couple for Absent {
    const ACTS: bool = false;

    fn couple(&self, _: &Vector3<f64>, _: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }
}

impl Resist for Absent {}

impl Effect for Resistance {
    const PRESENT: bool = true;
    const NAME: &'static str = "resistance";
}

impl Resist for Resistance {}

impl Grip for Absent {}

macro_rules! grip {
    ($($law:ty, $name:literal;)*) => {$(
        impl Grip for $law {}

        impl Effect for $law {
            const PRESENT: bool = true;
            const NAME: &'static str = $name;
        }
    )*};
}

grip! {
    Viscous, "viscous_friction";
    Regularised, "regularised_friction";
    NoSlip, "no_slip";
    Coulomb, "coulomb_friction";
}
