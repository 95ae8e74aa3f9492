//! A round body at one moment, the forces on it, and the events that can happen to it.

use super::friction::{Coulomb, RollingResistance};
use super::sheet::Sheet;

/// The contact: friction of the table, rolling resistance, and a sheet between body and table, each if it is there.
pub(crate) type Contact<'a> = (
    Option<Coulomb>,
    Option<RollingResistance>,
    Option<&'a Sheet>,
);

/// The numbers of a [`Moment`], and the distance from the sheet's edge to the point of contact.
pub(crate) type State = [f64; 8];

/// A constant load on the body, per mass, m/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Pull along the table.
    pub push: f64,
    /// Moment about the centre over MR, positive in the sense of rolling forward.
    pub twist: f64,
    /// Reaction of the ground; positive.
    pub reaction: f64,
}

impl Load {
    /// Weight alone, for gravity g (m/s²).
    ///
    /// ```
    /// assert_eq!(spinning_bodies::rolling::Load::weight(9.81).reaction, 9.81);
    /// ```
    pub const fn weight(gravity: f64) -> Self {
        Self {
            push: 0.0,
            twist: 0.0,
            reaction: gravity,
        }
    }
}

/// The position and the motion of the body at one time; by default at rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Moment {
    /// Position of the centre along the table, m.
    pub position: f64,
    /// Velocity V of the centre, m/s.
    pub velocity: f64,
    /// Rim speed RΩ, m/s.
    pub rim_speed: f64,
    /// Velocity of the contact point relative to the ground under it, m/s. On ground at rest it is V − RΩ; it is stored separately
    /// so that nothing cancels when it is small.
    pub slip: f64,
    /// Distance that the rim has turned, R times the angle, m.
    pub turned: f64,
    /// Heat of friction and rolling resistance so far, J/kg.
    pub heat: f64,
    /// Work that the pull and a moving sheet have done on the body so far, J/kg.
    pub work: f64,
}

impl Moment {
    /// At the origin with this velocity and rim speed (m/s), over ground at rest. If the slip is known more accurately than as the difference of
    /// the two, set it afterwards.
    ///
    /// ```
    /// use spinning_bodies::rolling::Moment;
    /// assert_eq!(Moment::moving(3.0, 1.0).slip, 2.0);
    /// ```
    pub const fn moving(velocity: f64, rim_speed: f64) -> Self {
        let slip = velocity - rim_speed;
        Self::of(&[0.0, velocity, rim_speed, slip, 0.0, 0.0, 0.0, 0.0])
    }

    /// The numbers in the order of the fields, followed by a place for the distance from a sheet's edge.
    pub(crate) const fn state(&self) -> State {
        let [x, v, w] = [self.position, self.velocity, self.rim_speed];
        [x, v, w, self.slip, self.turned, self.heat, self.work, 0.0]
    }

    /// The moment of these numbers.
    pub(crate) const fn of(state: &State) -> Self {
        let [position, velocity, rim_speed, slip, turned, heat, work, _] = *state;
        Self {
            position,
            velocity,
            rim_speed,
            slip,
            turned,
            heat,
            work,
        }
    }

    /// Kinetic energy per mass, ½(V² + κ(RΩ)²), J/kg.
    ///
    /// ```
    /// use spinning_bodies::rolling::Moment;
    /// assert_eq!(Moment::moving(3.0, 1.0).energy(0.5), 4.75);
    /// ```
    pub fn energy(&self, kappa: f64) -> f64 {
        0.5 * (self.velocity * self.velocity + kappa * self.rim_speed * self.rim_speed)
    }

    /// Angular momentum about the line of contact over MR: V + κRΩ, m/s. No friction changes it.
    pub(crate) fn about_the_table(&self, kappa: f64) -> f64 {
        self.velocity + kappa * self.rim_speed
    }
}

/// The event between two stretches of a course.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Happening {
    /// The contact stops slipping: rolling begins.
    RollingBegins,
    /// The contact begins to slip.
    SlippingBegins,
    /// The rotation stops for an instant or for good.
    TurningStops,
    /// The body has come to rest on the ground.
    Rest,
    /// The sheet's edge has passed under the body, which is now on the table.
    LeavesSheet,
    /// The sheet has come back under the body.
    MountsSheet,
}
