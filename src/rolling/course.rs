//! From event to event: a round body under dry friction, rolling resistance, a steady pull and a moving sheet.
//!
//! Per mass, with friction f, the couple m of rolling resistance, a pull p along the table and its moment q about the centre:
//! V' = p + f and κ(RΩ)' = q + m − f. As long as the contact slips one way, or sticks, all of these are constants; so positions
//! are quadratics in time, and the times at which something changes are roots of linear and quadratic equations.

use super::sheet::Sheet;
use super::stretch::{Hold, Laws, State, Stretch};
use crate::error::{Error, Result, finite, not_negative};

/// Coulomb's law: μ times the reaction against the slip; up to `grip` times the reaction while the contact sticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    kinetic: f64,
    grip: f64,
}

impl Coulomb {
    /// One coefficient μ (dimensionless) for slipping and sticking.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    pub fn new(coefficient: f64) -> Result<Self> {
        Self::with_grip(coefficient, coefficient)
    }

    /// A coefficient for slipping, and a greater one that has to be overcome first.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`]; [`Error::Condition`] if the grip is less than the sliding friction.
    pub fn with_grip(kinetic: f64, grip: f64) -> Result<Self> {
        let kinetic = not_negative("the coefficient of friction", kinetic)?;
        let grip = not_negative("the coefficient of static friction", grip)?;
        if grip < kinetic {
            return Err(Error::Condition {
                condition: "static friction must not be less than sliding friction",
                value: grip,
            });
        }
        Ok(Self { kinetic, grip })
    }

    /// Coefficient while the contact slips.
    pub const fn kinetic(&self) -> f64 {
        self.kinetic
    }

    /// Greatest ratio of friction to reaction while it sticks.
    pub const fn grip(&self) -> f64 {
        self.grip
    }
}

/// Rolling resistance: the reaction acts ahead of the centre by `arm` radii, a couple against the turning.
///
/// A body that rolls freely then slows down by arm·g/(1+κ), and one that is towed at constant speed takes a force of arm times
/// its weight. Billiard cloth: 0.005 to 0.015.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingResistance {
    arm: f64,
}

impl RollingResistance {
    /// The coefficient, dimensionless.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    pub fn new(arm: f64) -> Result<Self> {
        let arm = not_negative("the coefficient of rolling resistance", arm)?;
        Ok(Self { arm })
    }

    /// Lever arm of the reaction over the radius.
    pub const fn arm(&self) -> f64 {
        self.arm
    }
}

/// What rubs: friction of the table, rolling resistance, and a sheet between the two, each if it is there.
pub type Contact<'a> = (
    Option<Coulomb>,
    Option<RollingResistance>,
    Option<&'a Sheet>,
);

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
        Self::moving(0.0, 0.0)
    }

    /// At the origin with this velocity and rim speed (m/s), over ground at rest. Where the slip is known better than as the difference of
    /// the two, set it.
    pub const fn moving(velocity: f64, rim_speed: f64) -> Self {
        let slip = velocity - rim_speed;
        Self::of(&[0.0, velocity, rim_speed, slip, 0.0, 0.0, 0.0, 0.0])
    }

    /// The numbers in the order of the fields, and a place for the distance from a sheet's edge.
    pub(crate) const fn state(&self) -> State {
        let Self {
            position: x,
            velocity,
            rim_speed,
            slip,
            turned,
            heat,
            work,
        } = *self;
        [x, velocity, rim_speed, slip, turned, heat, work, 0.0]
    }

    /// The moment of these numbers.
    pub(crate) const fn of(
        &[position, velocity, rim_speed, slip, turned, heat, work, _]: &State,
    ) -> Self {
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

/// A motion from event to event, whole.
#[derive(Debug, Clone)]
pub struct Course {
    stretches: Vec<Stretch>,
    events: Vec<Event>,
    has_sheet: bool,
}

/// More stretches than this and something is wrong.
const MOST_STRETCHES: usize = 1_000_000;

impl Course {
    /// The course of a body of inertia factor `kappa`, from `start`, up to the time `until` (s), under the friction of the table, rolling resistance
    /// and a sheet, each if it is there.
    ///
    /// `start.slip` is taken as given; make it V − RΩ − (speed of the ground). Position is exact in each stretch: the errors are
    /// roundings. Observed against DOP853 with events: 3e-15 of the largest speed. Cost: a few microseconds a course.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the reaction or κ; [`Error::NotFinite`], also where a place, a speed or the heat leaves the range of doubles;
    /// [`Error::Integration`] after a million events.
    pub fn new(
        kappa: f64,
        load: Load,
        contact: Contact<'_>,
        start: Moment,
        until: f64,
    ) -> Result<Self> {
        let until = finite("the time", until)?.max(0.0);
        Self::under(&Laws::new(kappa, load, contact)?, start, until)
    }

    /// The same under these laws.
    pub(crate) fn under(laws: &Laws<'_>, start: Moment, until: f64) -> Result<Self> {
        for value in [start.position, start.velocity, start.rim_speed, start.slip] {
            finite("the start", value)?;
        }
        let mut course = Self {
            stretches: Vec::new(),
            events: Vec::new(),
            has_sheet: laws.sheet.is_some(),
        };
        let mut stretch = laws.first(start);
        let mut sticks = start.slip == 0.0;
        while course.stretches.len() < MOST_STRETCHES {
            if sticks && matches!(stretch.pace.slipping, Hold::Goes(_)) {
                course.note(&stretch, Happening::SlippingBegins);
            }
            sticks = stretch.pace.slipping == Hold::Held;
            course.stretches.push(stretch);
            within_range(&stretch.state)?;
            let longest = stretch.leg_ends.min(until) - stretch.start;
            let next = stretch.next(longest);
            let wait = next.map_or(longest, |(wait, _)| wait);
            let end = stretch.at(wait);
            if next.is_none() && stretch.leg_ends >= until {
                within_range(&end)?;
                return Ok(course);
            }
            let happened;
            (stretch, happened) = laws.after(&stretch, wait, &end, next.map(|(_, what)| what));
            if let Some(what) = happened {
                course.note(&stretch, what);
            }
        }
        Err(Error::Integration {
            reason: "more than a million events",
            time: stretch.start,
        })
    }

    fn note(&mut self, stretch: &Stretch, what: Happening) {
        let (time, moment) = (stretch.start, Moment::of(&stretch.state));
        self.events.push(Event { time, what, moment });
    }

    /// The body at the time `t` (s), 0 up to the end of the course; outside, the nearest of the two stretches is continued.
    pub fn at(&self, t: f64) -> Moment {
        Moment::of(&self.state(t))
    }

    /// From the sheet's edge to the point of contact at the time `t` (s), m; negative: the body is off the sheet. None without a sheet.
    pub fn margin(&self, t: f64) -> Option<f64> {
        self.has_sheet.then(|| self.state(t)[7])
    }

    /// The body and its distance from the sheet's edge.
    pub(crate) fn state(&self, t: f64) -> State {
        let place = self.stretches.partition_point(|s| s.start <= t);
        let stretch = &self.stretches[place.saturating_sub(1)];
        stretch.at(t - stretch.start)
    }

    /// What happens, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The first of a kind.
    pub fn first(&self, what: Happening) -> Option<&Event> {
        self.events.iter().find(|event| event.what == what)
    }

    /// How many closed forms it is made of.
    pub fn stretches(&self) -> usize {
        self.stretches.len()
    }
}

/// Nothing, if these are numbers that doubles can tell.
fn within_range(state: &State) -> Result<()> {
    const QUANTITIES: [&str; 7] = [
        "the position",
        "the velocity",
        "the rim speed",
        "the slip",
        "the turned way of the rim",
        "the heat of friction",
        "the work done",
    ];
    for (quantity, &value) in QUANTITIES.into_iter().zip(state) {
        finite(quantity, value)?;
    }
    Ok(())
}
