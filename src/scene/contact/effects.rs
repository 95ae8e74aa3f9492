//! What can be at work on a body on a table: gravity, friction, resistance to rolling and pivoting.

use nalgebra::Vector3;

use super::{State, TableTop};
use crate::error::{Result, positive};
use crate::scene::Scene;
use crate::scene::effect::choose;
use crate::scene::effect::{Absent, Effect};
use crate::tippe_top::{
    ConvexBody, Coulomb, Couple, Holding, Regularised, Resistance, Start, Traction, Viscous,
};

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

/// The friction that a scene file lists.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Friction {
    /// Coulomb's law, with slip and roll as events.
    Coulomb(Coulomb),
    /// Coulomb's law, smoothed.
    Regularised(Regularised),
    /// In proportion to the slip.
    Viscous(Viscous),
    /// Pure rolling.
    NoSlip,
}

/// Effects as a scene file lists them: some there, some not, known only when the program runs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Gravity, if any.
    pub gravity: Option<Gravity>,
    /// Friction at the contact, if any.
    pub friction: Option<Friction>,
    /// Resistance to rolling and pivoting, if any.
    pub resistance: Option<Resistance>,
}

impl Listed {
    /// The scene of the type that has these effects and no others: one of twenty. Only their equations are compiled twenty times.
    pub fn on(self, body: ConvexBody, start: Start) -> Box<dyn Scene<State = State>> {
        let free = TableTop::new(body, start);
        choose!((gravity = self.gravity) (resistance = self.resistance) => {
            // An absent effect in a slot is what an empty slot holds.
            let scene = TableTop { body: free.body, start: free.start, gravity, friction: Absent, resistance };
            match self.friction {
                None => Box::new(scene),
                Some(Friction::Coulomb(law)) => Box::new(scene.with_friction(law)),
                Some(Friction::Regularised(law)) => Box::new(scene.with_friction(law)),
                Some(Friction::Viscous(law)) => Box::new(scene.with_friction(law)),
                Some(Friction::NoSlip) => Box::new(scene.with_friction(NoSlip)),
            }
        })
    }
}
