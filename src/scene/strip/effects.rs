//! The effects of a strip in their slots.

use crate::falling_strip::{
    AddedMass, Drag, Gravity, Inertia, Lift, Load, Masses, Moving, Plate, RotationalDamping, Term,
};
use crate::scene::effect::{Absent, Effect};

impl Term for Absent {
    fn add(&self, _: &Plate, _: &Moving, _: &mut Load) {}
}

impl Inertia for Absent {
    fn masses(&self, plate: &Plate) -> Masses {
        plate.own()
    }
}

/// Weight in a slot: it has a potential energy as well.
pub trait Weight: Term + Effect {
    /// Energy at this height, J/m.
    fn potential(&self, plate: &Plate, height: f64) -> f64;
    /// g, m/s².
    fn acceleration(&self) -> f64;
}

impl Weight for Absent {
    fn potential(&self, _: &Plate, _: f64) -> f64 {
        0.0
    }
    fn acceleration(&self) -> f64 {
        0.0
    }
}

impl Weight for Gravity {
    fn potential(&self, plate: &Plate, height: f64) -> f64 {
        plate.mass() * self.acceleration * height
    }
    fn acceleration(&self) -> f64 {
        self.acceleration
    }
}

macro_rules! effects {
    ($($effect:ty: $name:literal,)*) => {
        $(impl Effect for $effect {
            const PRESENT: bool = true;
            const NAME: &'static str = $name;
        })*
    };
}

effects! {
    Gravity: "gravity",
    Lift: "lift",
    Drag: "drag",
    RotationalDamping: "rotational_damping",
    AddedMass: "added_mass",
}
