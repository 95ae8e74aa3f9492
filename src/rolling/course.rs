//! The motion, from event to event, of a round body under dry friction, rolling resistance, a constant pull and a moving sheet.

use super::moment::{Contact, Happening, Load, Moment, State};
use super::stretch::{Laws, Stretch};
use crate::error::{Result, each_finite, finite, stopped};

/// An event of a course.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Time, s.
    pub time: f64,
    /// The kind of event.
    pub what: Happening,
    /// The body at that time.
    pub moment: Moment,
}

/// A whole motion, from event to event.
///
/// Per mass, with friction f, the couple m of rolling resistance, a pull p along the table and its moment q about the centre:
/// V' = p + f and κ(RΩ)' = q + m − f. As long as the contact slips one way, or sticks, all of these are constant; so positions
/// are quadratic in time, and events are roots of linear and quadratic equations.
#[derive(Debug, Clone)]
pub struct Course {
    pub(crate) stretches: Vec<Stretch>,
    /// The events, in order.
    pub events: Vec<Event>,
}

/// Most stretches followed.
const MOST_STRETCHES: usize = 1_000_000;

impl Course {
    /// The course of a body of inertia factor `kappa`, from `start`, up to the time `until` (s), under the friction of the table, rolling resistance
    /// and a sheet, each if it is there.
    ///
    /// `start.slip` is used as given; it must be V − RΩ − (speed of the ground before any jump at time 0). Each stretch is a closed form, so that only rounding
    /// remains. Observed over 2500 courses, against 50 digits: 3e-15 of the largest speed; ten times that where the pull and the friction nearly balance, or a
    /// sheet's edge passes slowly. Cost: a few microseconds a course.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the reaction or κ; [`Error::NotFinite`](crate::Error::NotFinite), also where a position, a speed or the heat overflows;
    /// [`Error::Integration`](crate::Error::Integration) after a million events.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, Course, Load, Moment};
    /// // A ball pushed at 7 m/s without spin, μg = 2 m/s²: it slides for a second and rolls with 5 m/s.
    /// let (load, felt) = (Load::weight(10.0), Coulomb::new(0.2)?);
    /// let course = Course::new(0.4, load, (Some(felt), None, None), Moment::moving(7.0, 0.0), 3.0)?;
    /// assert!((course.at(3.0).velocity - 5.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        kappa: f64,
        load: Load,
        contact: Contact<'_>,
        start: Moment,
        until: f64,
    ) -> Result<Self> {
        let until = finite("the time", until)?.max(0.0);
        Self::under(Laws::new(kappa, load, contact).checked()?, start, until)
    }

    /// The same under these laws.
    pub(crate) fn under(laws: &Laws, start: Moment, until: f64) -> Result<Self> {
        each_finite("the start", start.state())?;
        let (stretches, events) = (Vec::new(), Vec::new());
        let mut course = Self { stretches, events };
        let mut stretch = laws.first(start);
        let mut sticks = start.slip == 0.0;
        while course.stretches.len() < MOST_STRETCHES {
            let slipping = stretch.pace.slipping;
            if sticks && slipping.is_some_and(|sense| sense != 0.0) {
                course.note(&stretch, Happening::SlippingBegins);
            }
            sticks = slipping.is_none();
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
        stopped("more than a million events", stretch.start)
    }

    fn note(&mut self, stretch: &Stretch, what: Happening) {
        let (time, moment) = (stretch.start, Moment::of(&stretch.state));
        self.events.push(Event { time, what, moment });
    }

    /// The body at the time `t` (s), from 0 to the end of the course; outside, the first or the last stretch is continued.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, Course, Load, Moment};
    /// // A ball pushed at 7 m/s without spin, μg = 2 m/s²: it slides for a second and rolls with 5 m/s.
    /// let (load, felt) = (Load::weight(10.0), Coulomb::new(0.2)?);
    /// let course = Course::new(0.4, load, (Some(felt), None, None), Moment::moving(7.0, 0.0), 3.0)?;
    /// assert!((course.at(0.5).velocity - 6.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> Moment {
        Moment::of(&self.state(t))
    }

    /// Distance from the sheet's edge to the point of contact at the time `t` (s), m; negative if the body is off the sheet. `None` without a sheet.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, Course, Load, Moment};
    /// // A ball pushed at 7 m/s without spin, μg = 2 m/s²: it slides for a second and rolls with 5 m/s.
    /// let (load, felt) = (Load::weight(10.0), Coulomb::new(0.2)?);
    /// let course = Course::new(0.4, load, (Some(felt), None, None), Moment::moving(7.0, 0.0), 3.0)?;
    /// assert_eq!(course.margin(1.0), None);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn margin(&self, t: f64) -> Option<f64> {
        let sheet = self.stretches.first()?.on_sheet;
        sheet.map(|_| self.state(t)[7])
    }

    /// The body and its distance from the sheet's edge.
    pub(crate) fn state(&self, t: f64) -> State {
        let place = self.stretches.partition_point(|s| s.start <= t);
        let stretch = &self.stretches[place.saturating_sub(1)];
        stretch.at(t - stretch.start)
    }

    /// The first event of a kind.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, Course, Happening, Load, Moment};
    /// // A ball pushed at 7 m/s without spin, μg = 2 m/s²: it slides for a second and rolls with 5 m/s.
    /// let (load, felt) = (Load::weight(10.0), Coulomb::new(0.2)?);
    /// let course = Course::new(0.4, load, (Some(felt), None, None), Moment::moving(7.0, 0.0), 3.0)?;
    /// let rolls = course.first(Happening::RollingBegins).unwrap();
    /// assert!((rolls.moment.position - 6.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn first(&self, what: Happening) -> Option<&Event> {
        self.events.iter().find(|event| event.what == what)
    }
}

/// Refuses a state in which a number of the body is not finite.
fn within_range(state: &State) -> Result<()> {
    const QUANTITIES: [&str; 7] = [
        "the position",
        "the velocity",
        "the rim speed",
        "the slip",
        "the distance turned by the rim",
        "the heat of friction",
        "the work done",
    ];
    for (quantity, &value) in QUANTITIES.into_iter().zip(state) {
        finite(quantity, value)?;
    }
    Ok(())
}
