//! The effects of a yo-yo, and what each slot asks of what fills it.

use crate::error::{Error, Result, not_negative, positive};
use crate::scene::effect::{Absent, Effect};

/// A yo-yo on its way through a turn: what the effects of the turn take and give.
#[derive(Debug, Clone, Copy)]
pub struct Passed {
    /// Spin, rad/s.
    pub omega: f64,
    /// Energy of the whole, J.
    pub energy: f64,
    /// Lost in the turn, J.
    pub heat: f64,
    /// Done by the hand in the turn, J.
    pub work: f64,
}

/// Weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    /// g, m/s², positive.
    pub acceleration: f64,
}

/// Every turn leaves this fraction of the spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurnLoss {
    /// Spin after over spin before, 0…1.
    pub restitution: f64,
}

/// The hand does this much work at every turn, by being raised a little while the string pulls hardest: see [`Turn::work_of_lift`](crate::yo_yo::Turn::work_of_lift).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hand {
    /// J, not negative.
    pub work: f64,
}

/// The string ends in a loop: the yo-yo falls asleep at the lowest point, and a jerk wakes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sleep {
    /// How long it is left asleep, s, not negative.
    pub duration: f64,
}

/// Friction of the loop on the axle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxleFriction {
    /// Constant torque, N m, not negative.
    pub torque: f64,
}

/// A torque c ω² of the air against the spin, all the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirDrag {
    /// c, kg m², not negative.
    pub coefficient: f64,
}

macro_rules! effects {
    ($($effect:ident: $name:literal, $field:ident, $check:expr;)*) => {
        $(impl Effect for $effect {
            const PRESENT: bool = true;
            const NAME: &'static str = $name;
        }

        impl $effect {
            pub(super) fn checked(self) -> Result<Self> {
                let check: fn(f64) -> Result<f64> = $check;
                check(self.$field)?;
                Ok(self)
            }
        })*
    };
}

effects! {
    Gravity: "gravity", acceleration, |g| positive("gravity", g);
    TurnLoss: "turn_loss", restitution, |e| {
        if (0.0..=1.0).contains(&e) {
            Ok(e)
        } else {
            Err(Error::OutOfRange { quantity: "the restitution of the turn", value: e, least: 0.0, greatest: 1.0 })
        }
    };
    Hand: "hand", work, |work| not_negative("the work of the hand", work);
    Sleep: "sleep", duration, |duration| not_negative("the duration of the sleep", duration);
    AxleFriction: "axle_friction", torque, |torque| not_negative("the friction of the axle", torque);
    AirDrag: "air_drag", coefficient, |c| not_negative("the resistance of the air", c);
}

/// What the slot of the weight asks.
pub trait Weight: Effect {
    /// g, m/s².
    fn acceleration(&self) -> f64;
}

impl Weight for Gravity {
    fn acceleration(&self) -> f64 {
        self.acceleration
    }
}

impl Weight for Absent {
    fn acceleration(&self) -> f64 {
        0.0
    }
}

/// What the slot of the turn's loss asks.
pub trait TurnTerm: Effect {
    /// Takes spin and energy, and gives heat; `kinetic` tells the energy of a spin.
    fn pass(&self, passed: &mut Passed, kinetic: &dyn Fn(f64) -> f64);
}

impl TurnTerm for TurnLoss {
    fn pass(&self, passed: &mut Passed, kinetic: &dyn Fn(f64) -> f64) {
        let e = self.restitution;
        passed.heat = (1.0 - e) * (1.0 + e) * kinetic(passed.omega);
        passed.energy -= passed.heat;
        passed.omega *= e;
    }
}

impl TurnTerm for Absent {
    fn pass(&self, _: &mut Passed, _: &dyn Fn(f64) -> f64) {}
}

/// What the slot of the hand asks.
pub trait HandTerm: Effect {
    /// Gives spin and energy; `inertia` is I + m r².
    fn pass(&self, passed: &mut Passed, inertia: f64);
}

impl HandTerm for Hand {
    fn pass(&self, passed: &mut Passed, inertia: f64) {
        passed.work = self.work;
        passed.energy += self.work;
        passed.omega = (passed.omega * passed.omega + 2.0 * self.work / inertia).sqrt();
    }
}

impl HandTerm for Absent {
    fn pass(&self, _: &mut Passed, _: f64) {}
}

/// What the slot of the sleep asks.
pub trait SleepTerm: Effect {
    /// How long it is left asleep, s.
    fn duration(&self) -> f64;
}

impl SleepTerm for Sleep {
    fn duration(&self) -> f64 {
        self.duration
    }
}

impl SleepTerm for Absent {
    fn duration(&self) -> f64 {
        0.0
    }
}

/// What the slot of the axle asks.
pub trait AxleTerm: Effect {
    /// N m.
    fn torque(&self) -> f64;
}

impl AxleTerm for AxleFriction {
    fn torque(&self) -> f64 {
        self.torque
    }
}

impl AxleTerm for Absent {
    fn torque(&self) -> f64 {
        0.0
    }
}

/// What the slot of the air asks.
pub trait AirTerm: Effect {
    /// c, kg m².
    fn coefficient(&self) -> f64;
}

impl AirTerm for AirDrag {
    fn coefficient(&self) -> f64 {
        self.coefficient
    }
}

impl AirTerm for Absent {
    fn coefficient(&self) -> f64 {
        0.0
    }
}
