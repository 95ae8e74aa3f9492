//! Where a rolling body is, what acts on it steadily, and what can happen to it.

use crate::error::{Result, finite};

/// A steady load on the body, per mass, m/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Pull along the table.
    pub push: f64,
    /// Moment about the centre over MR, positive the way the body rolls.
    pub twist: f64,
    /// Reaction of the ground; positive.
    pub reaction: f64,
}

impl Load {
    /// Weight alone, for gravity g (m/s²).
    pub const fn weight(gravity: f64) -> Self {
        Self {
            push: 0.0,
            twist: 0.0,
            reaction: gravity,
        }
    }
}

/// Where the body is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Position of the centre along the table, m.
    pub position: f64,
    /// Velocity V of the centre, m/s.
    pub velocity: f64,
    /// Rim speed RΩ, m/s.
    pub rim_speed: f64,
    /// Velocity of the contact point over the ground under it, m/s. While the ground rests it is V − RΩ, kept apart from the two
    /// so that nothing cancels when it is small.
    pub slip: f64,
    /// What the rim has turned, R times the angle, m.
    pub turned: f64,
    /// Heat of friction and rolling resistance so far, J/kg.
    pub heat: f64,
    /// Work that the pull and a moving sheet have done on the body so far, J/kg.
    pub work: f64,
}

impl Moment {
    /// At rest at the origin.
    pub const fn at_rest() -> Self {
        Self {
            position: 0.0,
            velocity: 0.0,
            rim_speed: 0.0,
            slip: 0.0,
            turned: 0.0,
            heat: 0.0,
            work: 0.0,
        }
    }

    /// At the origin with this velocity and rim speed (m/s), over ground at rest. Where the slip is known better than as the difference of
    /// the two, set it.
    pub const fn moving(velocity: f64, rim_speed: f64) -> Self {
        Self {
            velocity,
            rim_speed,
            slip: velocity - rim_speed,
            ..Self::at_rest()
        }
    }

    /// Nothing, if it is a moment that doubles can tell.
    pub(super) fn within_range(&self) -> Result<()> {
        for (quantity, value) in [
            ("the position", self.position),
            ("the velocity", self.velocity),
            ("the rim speed", self.rim_speed),
            ("the slip", self.slip),
            ("the turned way of the rim", self.turned),
            ("the heat of friction", self.heat),
            ("the work done", self.work),
        ] {
            finite(quantity, value)?;
        }
        Ok(())
    }

    /// Kinetic energy per mass, ½(V² + κ(RΩ)²), J/kg.
    pub fn energy(&self, kappa: f64) -> f64 {
        0.5 * (self.velocity * self.velocity + kappa * self.rim_speed * self.rim_speed)
    }

    /// Angular momentum about the line of contact over MR: V + κRΩ, m/s. No friction changes it.
    pub fn about_the_table(&self, kappa: f64) -> f64 {
        self.velocity + kappa * self.rim_speed
    }
}

/// What happens between two stretches of a course.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Happening {
    /// The contact stops slipping: rolling begins.
    RollingBegins,
    /// The contact begins to slip.
    SlippingBegins,
    /// The turning stops for an instant or for good.
    TurningStops,
    /// The body has come to rest on the ground.
    Rest,
    /// The sheet's edge has passed under the body: now it is on the table.
    LeavesSheet,
    /// The sheet has come back under the body.
    MountsSheet,
}

/// What happened, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Time, s.
    pub time: f64,
    /// What.
    pub what: Happening,
    /// The body then.
    pub moment: Moment,
}
