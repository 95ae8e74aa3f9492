//! From phase to phase: sliding, rolling, in the air.

use core::cell::Cell;

use super::effects::{Grip, Holding, Resist};
use crate::error::{Error, Result};
use crate::integrators::{Cost, Effort, Event, Method, Passage, Stop, System, until};
use crate::tippe_top::equations::{NUMBERS, Numbers, Pose, Table};
use crate::tippe_top::flight::{Airborne, Flight, Landed};

/// How the body is supported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// On the table, slipping.
    Sliding,
    /// On the table, without slip.
    Rolling,
    /// Off the table.
    Airborne,
}

/// A stretch of a motion on one kind of support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// When it begins, s.
    pub start: f64,
    /// The support.
    pub support: Support,
}

/// The numbers of a state at one time, and what the contact does not say.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) numbers: Numbers,
    pub(super) height: f64,
    pub(super) climb: f64,
    pub(super) support: Support,
}

#[derive(Debug, Clone)]
pub(super) struct History {
    pub(super) places: Vec<Place>,
    pub(super) phases: Vec<Phase>,
    pub(super) cost: Cost,
}

/// A motion that is being followed.
pub(super) struct Run<'a, F, R> {
    pub(super) table: &'a Table<F, R>,
    pub(super) scales: &'a Numbers,
    pub(super) method: Method,
    pub(super) tolerance: f64,
    /// Slip below which Coulomb's law sticks, if it can.
    pub(super) still: f64,
}

/// A body that changes its support more often than this chatters, and is not followed further.
const MOST_PHASES: usize = 100_000;

impl<F: Grip, R: Resist> Run<'_, F, R> {
    /// The places at `times` (ascending, not negative).
    pub(super) fn follow(&self, start: &Numbers, times: &[f64]) -> Result<History> {
        let end = times.last().copied().unwrap_or(0.0);
        let mut history = History {
            places: Vec::with_capacity(times.len()),
            phases: Vec::new(),
            cost: Cost::default(),
        };
        let (mut now, mut y) = (0.0, *start);
        let mut support = match self.table.friction.hold() {
            Holding::Grips => Support::Rolling,
            Holding::Slides => Support::Sliding,
            Holding::Cone { mu } => self.settled(&mut y, mu)?,
        };
        if support == Support::Rolling {
            y = self.table.rolled(&y);
        }
        let (mut height, mut climb) = self.table.height(&Pose::of(&y));
        loop {
            if support != Support::Airborne && self.reaction(&y, support) <= 0.0 {
                support = Support::Airborne;
                (height, climb) = self.table.height(&Pose::of(&y));
            }
            history.phases.push(Phase {
                start: now,
                support,
            });
            if history.phases.len() > MOST_PHASES {
                return Err(Error::Integration {
                    reason: "the body changes between sliding, rolling and hopping too often",
                    time: now,
                });
            }
            let left = &times[history.places.len()..];
            let ended = if support == Support::Airborne {
                let flight = Flight::from(&self.table.body, self.table.gravity, &y, height, climb)?;
                let landing = flight.landing(end - now)?;
                let reached = landing.map_or(end, |t| now + t);
                for &time in left.iter().take_while(|&&time| time <= reached) {
                    history.places.push(airborne(&flight.at(time - now)?));
                }
                if let Some(t) = landing {
                    let place = flight.at(t)?;
                    let hold = self.table.friction.hold();
                    let (landed, kind, cost) = self.table.land(&place, hold.into())?;
                    history.cost += cost;
                    y = landed;
                    support = match kind {
                        Landed::Rolling => self.after_sticking(&mut y)?,
                        Landed::Sliding => Support::Sliding,
                    };
                }
                now = reached;
                landing.is_none()
            } else {
                let passage = self.in_contact(now, &y, left, support)?;
                for numbers in &passage.states {
                    history.places.push(self.place(numbers, support));
                }
                history.cost += passage.cost;
                (now, y) = (passage.time, passage.end);
                if passage.stopped == Stop::AtTheEvent {
                    support = self.changed(&mut y, support)?;
                    (height, climb) = self.table.height(&Pose::of(&y));
                }
                passage.stopped == Stop::AtTheEnd
            };
            if ended {
                return Ok(history);
            }
        }
    }

    /// From sample to sample, since the method's steps are more exact than what it says between them.
    fn in_contact(
        &self,
        now: f64,
        y: &Numbers,
        times: &[f64],
        support: Support,
    ) -> Result<Passage<NUMBERS>> {
        let mut passage = Passage {
            states: Vec::with_capacity(times.len()),
            time: now,
            end: *y,
            stopped: Stop::AtTheEnd,
            cost: Cost::default(),
        };
        for &time in times {
            let event = |_: f64, y: &Numbers| self.margin(y, support);
            let leg = self.leg(passage.time, &passage.end, time, &event, support)?;
            passage.cost += leg.cost;
            if leg.stopped == Stop::AtTheEvent {
                let never = |_: f64, _: &Numbers| 1.0;
                let again = self.leg(passage.time, &passage.end, leg.time, &never, support)?;
                passage.cost += again.cost;
                (passage.time, passage.end) = self.corrected(leg.time, &again.end, support);
                passage.stopped = Stop::AtTheEvent;
                return Ok(passage);
            }
            (passage.time, passage.end) = (time, leg.end);
            passage.states.push(leg.end);
        }
        Ok(passage)
    }

    fn leg(
        &self,
        now: f64,
        y: &Numbers,
        end: f64,
        event: &dyn Event<NUMBERS>,
        support: Support,
    ) -> Result<Passage<NUMBERS>> {
        let effort = Effort::Tolerance(self.tolerance);
        let rates = |_: f64, y: &Numbers| self.rates(y, support);
        // By reference to a trait, so that the methods are compiled once, not once a list of effects.
        let rates: &dyn System<NUMBERS> = &rates;
        until(
            rates,
            now,
            y,
            self.scales,
            &[],
            end,
            event,
            self.method,
            effort,
        )
    }

    fn rates(&self, y: &Numbers, support: Support) -> Numbers {
        match support {
            Support::Rolling => self.table.rolling_rates(y),
            _ => self.table.sliding_rates(y),
        }
    }

    /// An event located on the method's interpolation, moved along the true rate to where its margin is zero.
    fn corrected(&self, time: f64, y: &Numbers, support: Support) -> (f64, Numbers) {
        let rate = self.rates(y, support);
        let moved = |dt: f64| core::array::from_fn(|i| y[i] + dt * rate[i]);
        let here = self.margin(y, support);
        // So short that Euler's step is exact to rounding, so long that the margin changes.
        let probe = 1e-8 / (1.0 + self.scales[4]);
        let step = -here * probe / (self.margin(&moved(probe), support) - here);
        if step.is_finite() && step.abs() < 10.0 * probe {
            (time + step, moved(step))
        } else {
            (time, *y)
        }
    }

    /// Positive while the phase lasts: the reaction over the weight, and how far sliding is from rest or rolling from the cone's rim.
    fn margin(&self, y: &Numbers, support: Support) -> f64 {
        let pose = Pose::of(y);
        let weight = self.table.body.mass() * self.table.gravity;
        match (support, self.table.friction.hold()) {
            (Support::Rolling, hold) => {
                let contact = self.table.rolling(&pose.up, &pose.omega);
                let pressed = contact.reaction / weight;
                match hold {
                    Holding::Cone { mu } => pressed.min(mu - contact.traction.norm()),
                    _ => pressed,
                }
            }
            (_, hold) => {
                let contact = self.table.sliding(&pose.up, &pose.omega, &pose.level);
                let pressed = contact.reaction / weight;
                match hold {
                    Holding::Cone { .. } => pressed.min(contact.slip.norm() / self.still - 1.0),
                    _ => pressed,
                }
            }
        }
    }

    fn reaction(&self, y: &Numbers, support: Support) -> f64 {
        let pose = Pose::of(y);
        match support {
            Support::Rolling => self.table.rolling(&pose.up, &pose.omega).reaction,
            _ => {
                self.table
                    .sliding(&pose.up, &pose.omega, &pose.level)
                    .reaction
            }
        }
    }

    /// The support after an event on the table, and the state with which it begins.
    fn changed(&self, y: &mut Numbers, support: Support) -> Result<Support> {
        let Holding::Cone { mu } = self.table.friction.hold() else {
            return Ok(Support::Airborne);
        };
        let pose = Pose::of(y);
        let weight = self.table.body.mass() * self.table.gravity;
        let pressed = self.reaction(y, support) / weight;
        // Rest is passed faster than any event can be located, the reaction is not: what still presses has not taken off.
        match support {
            Support::Sliding => {
                if pressed <= 1e-6 {
                    return Ok(Support::Airborne);
                }
                self.stuck(y, mu)
            }
            _ => {
                if pressed <= 1e-6 {
                    return Ok(Support::Airborne);
                }
                *y = self.table.rolled(y);
                self.kick(y);
                Ok(Support::Sliding)
            }
        }
    }

    /// Rolling where the slip is nil and the cone allows it, else sliding.
    fn settled(&self, y: &mut Numbers, mu: f64) -> Result<Support> {
        let pose = Pose::of(y);
        let slip = self.table.sliding(&pose.up, &pose.omega, &pose.level).slip;
        if slip.norm() > self.still {
            return Ok(Support::Sliding);
        }
        self.stuck(y, mu)
    }

    /// The slip taken away; rolling if the cone then allows it, else sliding the way the force pulls that it would take.
    fn stuck(&self, y: &mut Numbers, mu: f64) -> Result<Support> {
        let pose = Pose::of(y);
        let (height, climb) = self.table.height(&pose);
        let place = Airborne {
            pose,
            numbers: *y,
            height,
            climb,
        };
        let (stuck, _, _) = self.table.land(&place, Holding::Grips.into())?;
        *y = stuck;
        let pose = Pose::of(y);
        let rolling = self.table.rolling(&pose.up, &pose.omega);
        if rolling.traction.norm() <= mu || rolling.reaction <= 0.0 {
            return Ok(Support::Rolling);
        }
        self.kick(y);
        Ok(Support::Sliding)
    }

    fn after_sticking(&self, y: &mut Numbers) -> Result<Support> {
        match self.table.friction.hold() {
            Holding::Cone { mu } => self.settled(y, mu),
            _ => Ok(Support::Rolling),
        }
    }

    /// A slip of half the size that counts as none, the way the body begins to slide: against the force that no longer suffices.
    fn kick(&self, y: &mut Numbers) {
        let pose = Pose::of(y);
        let pull = self.table.rolling(&pose.up, &pose.omega).traction;
        let slip = pose.turn * (pull * (-0.5 * self.still / pull.norm()));
        let kinetic = |y: &Numbers| 0.5 * self.table.body.mass() * (y[7] * y[7] + y[8] * y[8]);
        let before = kinetic(y);
        y[7] += slip.x;
        y[8] += slip.y;
        y[11] += before - kinetic(y);
    }

    fn place(&self, numbers: &Numbers, support: Support) -> Place {
        let numbers = match support {
            Support::Rolling => self.table.rolled(numbers),
            _ => *numbers,
        };
        let (height, climb) = self.table.height(&Pose::of(&numbers));
        Place {
            numbers,
            height,
            climb,
            support,
        }
    }
}

fn airborne(place: &Airborne) -> Place {
    Place {
        numbers: place.numbers,
        height: place.height,
        climb: place.climb,
        support: Support::Airborne,
    }
}

/// Runs with tolerances a factor 30 apart, both tightened until they agree to four times `accuracy`: as
/// [`refined`](crate::integrators::refined), for motions with phases.
///
/// Errors go down in proportion to the tolerance or faster, so the second of the pair, which is returned, is better than their
/// distance by that factor: a margin of 7.
pub(super) fn tightened(
    accuracy: f64,
    run: impl Fn(f64) -> Result<History>,
    distance: impl Fn(&Place, &Place) -> f64,
) -> Result<History> {
    let total = Cell::new(Cost::default());
    let counted = |tolerance: f64| {
        let history = run(tolerance.max(LEAST_TOLERANCE))?;
        let mut sum = total.get();
        sum += history.cost;
        total.set(sum);
        Ok::<_, Error>(history)
    };
    let mut tolerance = accuracy;
    let mut coarse = counted(tolerance)?;
    loop {
        let fine = counted(tolerance / FACTOR)?;
        let pairs = coarse.places.iter().zip(&fine.places);
        let apart = pairs.map(|(a, b)| distance(a, b)).fold(0.0, f64::max);
        if apart <= 4.0 * accuracy {
            return Ok(History {
                cost: total.get(),
                ..fine
            });
        }
        if tolerance / FACTOR < LEAST_TOLERANCE {
            return Err(Error::Accuracy {
                asked: accuracy,
                reached: apart,
            });
        }
        // No more than three digits at once: an estimate that large is none.
        let wanted = tolerance * (2.0 * accuracy / apart).max(1e-3);
        if wanted >= tolerance / FACTOR {
            (tolerance, coarse) = (tolerance / FACTOR, fine);
        } else {
            tolerance = wanted;
            coarse = counted(tolerance)?;
        }
    }
}

const FACTOR: f64 = 30.0;

/// Below this the error estimate of a step is rounding.
const LEAST_TOLERANCE: f64 = 1e-15;
