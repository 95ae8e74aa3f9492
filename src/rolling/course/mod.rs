//! From event to event: a round body under dry friction, rolling resistance, a steady pull and a moving sheet.
//!
//! Per mass, with friction f, the couple m of rolling resistance, a pull p along the table and its moment q about the centre:
//! V' = p + f and κ(RΩ)' = q + m − f. As long as the contact slips one way, or sticks, all of these are constants; so positions
//! are quadratics in time, and the times at which something changes are roots of linear and quadratic equations.
//!
//! What may be absent is a type parameter; for the type that is not there ([`Friction::ACTS`] false) nothing is compiled.

mod forces;
mod laws;
mod moment;
mod stretch;

pub use forces::{Coulomb, Friction, Nothing, Resistance, RollingResistance};
pub use moment::{Event, Happening, Load, Moment};

pub(crate) use laws::{Hold, Laws, Pace, on, settle};

use super::sheet::Support;
use crate::error::{Error, Result, finite, positive};
use stretch::Stretch;

/// A motion from event to event, whole.
#[derive(Debug, Clone)]
pub struct Course {
    kappa: f64,
    stretches: Vec<Stretch>,
    events: Vec<Event>,
    has_sheet: bool,
}

/// More stretches than this and something is wrong.
const MOST_STRETCHES: usize = 1_000_000;

impl Course {
    /// The course of a body of inertia factor `kappa`, from `start`, up to the time `until` (s).
    ///
    /// `start.slip` is taken as given; make it V − RΩ − (speed of the ground). Position is exact in each stretch: the errors are
    /// roundings. Observed against DOP853 with events: 3e-15 of the largest speed. Cost: a few microseconds a course.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for the reaction or κ; [`Error::NotFinite`], also where a place, a speed or the heat leaves the range of doubles;
    /// [`Error::Integration`] after a million events.
    pub fn new<F: Friction, C: Resistance, S: Support>(
        kappa: f64,
        load: Load,
        (friction, resistance, sheet): (F, C, S),
        start: Moment,
        until: f64,
    ) -> Result<Self> {
        let kappa = positive("the inertia factor", kappa)?;
        positive("the reaction of the ground", load.reaction)?;
        finite("the pull", load.push)?;
        finite("the twist", load.twist)?;
        let until = finite("the time", until)?.max(0.0);
        for value in [start.position, start.velocity, start.rim_speed, start.slip] {
            finite("the start", value)?;
        }
        let laws = Laws {
            kappa,
            load,
            friction,
            resistance,
        };
        let mut course = Self {
            kappa,
            stretches: Vec::new(),
            events: Vec::new(),
            has_sheet: S::ACTS,
        };
        course.run::<F, C, S>(&laws, sheet, start, until)?;
        Ok(course)
    }

    fn run<F: Friction, C: Resistance, S: Support>(
        &mut self,
        laws: &Laws<F, C>,
        sheet: S,
        start: Moment,
        until: f64,
    ) -> Result<()> {
        let mut moment = start;
        let (mut now, mut leg, mut on_sheet) = (0.0, 0, S::ACTS);
        let mut about = start.about_the_table(laws.kappa);
        let mut margin = if S::ACTS { sheet.margin() } else { 0.0 };
        let mut slipped = moment.slip != 0.0;
        while self.stretches.len() < MOST_STRETCHES {
            let (motion, leg_ends) = ground_now(sheet, leg, now);
            let mut pace = if S::ACTS && on_sheet {
                on(sheet, laws).pace(sheet.law(), moment.slip, moment.rim_speed, motion[1])
            } else {
                laws.pace(laws.friction, moment.slip, moment.rim_speed, 0.0)
            };
            if pace.slipping == Hold::Held && pace.turning == Hold::Held {
                pace.rim_speed = 0.0;
            }
            let slips = pace.slipping != Hold::Held;
            if slips && !slipped && pace.slipping != Hold::Free {
                self.note(now, Happening::SlippingBegins, moment);
            }
            slipped = slips;
            let stretch = Stretch {
                start: now,
                moment,
                pace,
                load: laws.load,
                sheet: motion,
                margin,
                on_sheet,
            };
            self.stretches.push(stretch);
            moment.within_range()?;
            let ends = leg_ends.min(until);
            let Some((wait, what)) = stretch.next::<S>(ends - now) else {
                if leg_ends >= until {
                    return stretch.at(ends - now).within_range();
                }
                (moment, margin) = (stretch.at(ends - now), stretch.margin_at(ends - now));
                about += (ends - now) * laws.moment_about_the_table(&pace);
                now = ends;
                if S::ACTS && on_sheet {
                    moment.slip -= jerk(sheet, leg);
                }
                leg += 1;
                continue;
            };
            now += wait;
            about += wait * laws.moment_about_the_table(&pace);
            (moment, margin) = (stretch.at(wait), stretch.margin_at(wait));
            let sheet_speed = motion[0] + wait * motion[1];
            match what {
                Happening::LeavesSheet | Happening::MountsSheet => {
                    (on_sheet, margin) = (!on_sheet, 0.0);
                    let ground = if on_sheet { sheet_speed } else { 0.0 };
                    moment.slip = moment.velocity - moment.rim_speed - ground;
                    self.note(now, what, moment);
                }
                _ => {
                    let ground = if on_sheet { sheet_speed } else { 0.0 };
                    let what = settle(&mut moment, what, pace, ground, (&mut about, laws.kappa));
                    self.note(now, what, moment);
                }
            }
        }
        Err(Error::Integration {
            reason: "more than a million events",
            time: now,
        })
    }

    fn note(&mut self, time: f64, what: Happening, moment: Moment) {
        self.events.push(Event { time, what, moment });
    }

    /// The body at the time `t` (s), 0 up to the end of the course; outside, the nearest of the two stretches is continued.
    pub fn at(&self, t: f64) -> Moment {
        let stretch = self.stretch(t);
        stretch.at(t - stretch.start)
    }

    /// From the sheet's edge to the point of contact at the time `t` (s), m; negative: the body is off the sheet. None without a sheet.
    pub fn margin(&self, t: f64) -> Option<f64> {
        let stretch = self.stretch(t);
        self.has_sheet.then(|| stretch.margin_at(t - stretch.start))
    }

    fn stretch(&self, t: f64) -> &Stretch {
        let place = self.stretches.partition_point(|s| s.start <= t);
        &self.stretches[place.saturating_sub(1)]
    }

    /// What happens, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The first of a kind.
    pub fn first(&self, what: Happening) -> Option<&Event> {
        self.events.iter().find(|event| event.what == what)
    }

    /// Inertia factor κ.
    pub fn kappa(&self) -> f64 {
        self.kappa
    }

    /// How many closed forms it is made of.
    pub fn stretches(&self) -> usize {
        self.stretches.len()
    }
}

/// Speed and acceleration of the sheet now, and when its leg ends; at rest for ever without one.
pub(crate) fn ground_now<S: Support>(sheet: S, leg: usize, now: f64) -> ([f64; 2], f64) {
    if S::ACTS {
        let (from, to) = sheet.leg(leg);
        let slope = slope(from, to);
        ([from.1 + (now - from.0) * slope, slope], to.0)
    } else {
        ([0.0; 2], f64::INFINITY)
    }
}

/// By how much the sheet's speed jumps in this leg, if it is one of no duration.
pub(crate) fn jerk<S: Support>(sheet: S, leg: usize) -> f64 {
    let (from, to) = sheet.leg(leg);
    if to.0 > from.0 { 0.0 } else { to.1 - from.1 }
}

fn slope(from: (f64, f64), to: (f64, f64)) -> f64 {
    if to.0 > from.0 && to.0.is_finite() {
        (to.1 - from.1) / (to.0 - from.0)
    } else {
        0.0
    }
}
