//! From phase to phase: sliding, rolling, in the air.

use core::cell::Cell;

use crate::error::{Error, Result};
use crate::integrators::{Cost, Effort, Method, Passage, Stop, System, until};
use crate::tippe_top::equations::{Contact, Ground, NUMBERS, Numbers, Pose, Table};
use crate::tippe_top::flight::{Airborne, Flight};
use crate::tippe_top::{Holding, Smooth};

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

impl Place {
    pub(super) const fn aloft(numbers: Numbers, height: f64, climb: f64) -> Self {
        Self {
            numbers,
            height,
            climb,
            support: Support::Airborne,
        }
    }
}

#[derive(Debug, Clone)]
pub(super) struct History {
    pub(super) places: Vec<Place>,
    pub(super) phases: Vec<Phase>,
    pub(super) cost: Cost,
}

/// A motion that is being followed.
pub(super) struct Run<'a> {
    pub(super) ground: &'a dyn Ground,
    pub(super) scales: &'a Numbers,
    pub(super) method: Method,
    pub(super) tolerance: f64,
    /// Slip below which Coulomb's law sticks, if it can.
    pub(super) still: f64,
}

/// A body that changes its support more often than this chatters, and is not followed further.
const MOST_PHASES: usize = 100_000;

/// Reaction over weight below which a body that has met an event takes off. Take-off is located to rounding; rest, which also is an
/// event, says nothing of the reaction.
const LIFTED: f64 = 1e-6;

/// Where a phase has ended.
struct Ended {
    time: f64,
    numbers: Numbers,
    /// What holds the body after it; nothing if the time was up.
    next: Option<Support>,
}

impl Run<'_> {
    /// The places at `times` (ascending, not negative).
    pub(super) fn follow(&self, start: &Numbers, times: &[f64]) -> Result<History> {
        let end = times.last().copied().unwrap_or(0.0);
        let mut history = History {
            places: Vec::with_capacity(times.len()),
            phases: Vec::new(),
            cost: Cost::default(),
        };
        let (mut now, mut y) = (0.0, *start);
        let mut support = self.settled(&mut y)?;
        loop {
            if support != Support::Airborne && self.contact(&y, support).reaction <= 0.0 {
                support = Support::Airborne;
                self.released(now, &y)?;
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
            let ended = if support == Support::Airborne {
                self.fly(now, &y, times, end, &mut history)?
            } else {
                self.touch(now, &y, support, times, end, &mut history)?
            };
            (now, y) = (ended.time, ended.numbers);
            match ended.next {
                Some(next) => support = next,
                None => return Ok(history),
            }
        }
    }

    fn fly(
        &self,
        now: f64,
        y: &Numbers,
        times: &[f64],
        end: f64,
        history: &mut History,
    ) -> Result<Ended> {
        let body = self.ground.body();
        let (height, climb) = body.height(&Pose::of(y));
        let flight = Flight::from(body, self.ground.gravity(), y, height, climb)?;
        let landing = flight.landing(end - now)?;
        let reached = landing.map_or(end, |t| now + t);
        let left = &times[history.places.len()..];
        for &time in left.iter().take_while(|&&time| time <= reached) {
            let place = flight.at(time - now)?;
            let place = Place::aloft(place.numbers, place.height, place.climb);
            history.places.push(place);
        }
        let Some(t) = landing else {
            return Ok(Ended {
                time: end,
                numbers: *y,
                next: None,
            });
        };
        let (mut numbers, cost) = self.ground.land(&flight.at(t)?, self.ground.holding())?;
        history.cost += cost;
        let next = Some(self.settled(&mut numbers)?);
        Ok(Ended {
            time: reached,
            numbers,
            next,
        })
    }

    fn touch(
        &self,
        now: f64,
        y: &Numbers,
        support: Support,
        times: &[f64],
        end: f64,
        history: &mut History,
    ) -> Result<Ended> {
        let sliding = |_: f64, y: &Numbers| self.ground.sliding_rates(y);
        let rolling = |_: f64, y: &Numbers| self.ground.rolling_rates(y);
        let rates: &dyn System<NUMBERS> = match support {
            Support::Rolling => &rolling,
            _ => &sliding,
        };
        let left = &times[history.places.len()..];
        let event = |_: f64, y: &Numbers| self.margin(y, support);
        let effort = Effort::Tolerance(self.tolerance);
        let (scales, method) = (self.scales, self.method);
        let passage: Passage<NUMBERS> =
            until(rates, now, y, scales, left, end, &event, method, effort)?;
        history.cost += passage.cost;
        for numbers in &passage.states {
            history.places.push(self.place(numbers, support));
        }
        let mut numbers = passage.end;
        let next = match passage.stopped {
            Stop::AtTheEnd => None,
            Stop::AtTheEvent => Some(self.changed(&mut numbers, support)?),
        };
        Ok(Ended {
            time: passage.time,
            numbers,
            next,
        })
    }

    fn contact(&self, y: &Numbers, support: Support) -> Contact {
        let pose = Pose::of(y);
        match support {
            Support::Rolling => self.ground.rolls(&pose),
            _ => self.ground.slides(&pose),
        }
    }

    fn weight(&self) -> f64 {
        self.ground.body().mass() * self.ground.gravity()
    }

    /// Positive while the phase lasts: the reaction over the weight, how far sliding is from rest, how far rolling is from the cone's rim.
    fn margin(&self, y: &Numbers, support: Support) -> f64 {
        let contact = self.contact(y, support);
        let pressed = contact.reaction / self.weight();
        match (support, self.ground.holding()) {
            (Support::Rolling, Holding::Cone { mu }) => {
                pressed.min(pressed * (mu - contact.traction.norm()))
            }
            (Support::Sliding, Holding::Cone { .. }) => {
                pressed.min(contact.slip.norm() / self.still - 1.0)
            }
            _ => pressed,
        }
    }

    /// The support after an event on the table, and the state with which it begins.
    fn changed(&self, y: &mut Numbers, support: Support) -> Result<Support> {
        if !matches!(self.ground.holding(), Holding::Cone { .. }) {
            return Ok(Support::Airborne);
        }
        if self.contact(y, support).reaction <= LIFTED * self.weight() {
            return Ok(Support::Airborne);
        }
        if support == Support::Sliding {
            return self.stuck(y);
        }
        *y = self.ground.body().rolled(y);
        self.kick(y);
        Ok(Support::Sliding)
    }

    /// How a body that touches the table goes on.
    fn settled(&self, y: &mut Numbers) -> Result<Support> {
        match self.ground.holding() {
            Holding::Slides => Ok(Support::Sliding),
            Holding::Grips => {
                *y = self.ground.body().rolled(y);
                Ok(Support::Rolling)
            }
            Holding::Cone { .. } => {
                let slip = self.contact(y, Support::Sliding).slip;
                if slip.norm() > self.still {
                    Ok(Support::Sliding)
                } else {
                    self.stuck(y)
                }
            }
        }
    }

    /// The slip taken away; rolling if the cone then allows it, else sliding the way the force pulls that it would take.
    fn stuck(&self, y: &mut Numbers) -> Result<Support> {
        let pose = Pose::of(y);
        let (height, climb) = self.ground.body().height(&pose);
        let place = Airborne {
            pose,
            numbers: *y,
            height,
            climb,
        };
        (*y, _) = self.ground.land(&place, Holding::Grips)?;
        // At the rim a run that rolls would see no event: the margin has to fall through zero.
        if self.margin(y, Support::Rolling) > 0.0 {
            return Ok(Support::Rolling);
        }
        self.kick(y);
        Ok(Support::Sliding)
    }

    /// A slip of twice the size that counts as none, the way the body begins to slide: against the force that no longer suffices.
    ///
    /// The slip then grows: between forces along one line that both keep the body on the table, acceleration along it follows force.
    fn kick(&self, y: &mut Numbers) {
        let pose = Pose::of(y);
        let pull = self.ground.rolls(&pose).traction;
        if pull.norm() == 0.0 {
            return;
        }
        let slip = pose.turn * (pull * (-2.0 * self.still / pull.norm()));
        let mass = self.ground.body().mass();
        let kinetic = |y: &Numbers| 0.5 * mass * (y[7] * y[7] + y[8] * y[8]);
        let before = kinetic(y);
        y[7] += slip.x;
        y[8] += slip.y;
        y[11] += before - kinetic(y);
    }

    /// Whether a body that no longer presses can take off: with the constraint of rolling it may be the level force that keeps it up.
    fn released(&self, now: f64, y: &Numbers) -> Result<()> {
        if self.ground.holding() != Holding::Grips {
            return Ok(());
        }
        let smooth = Table {
            body: *self.ground.body(),
            gravity: self.ground.gravity(),
            friction: Smooth,
            resistance: Smooth,
        };
        if smooth.slides(&Pose::of(y)).reaction < 0.0 {
            return Ok(());
        }
        Err(Error::Integration {
            reason: "pure rolling takes a level force where nothing presses the body to the table; let it slide by Coulomb's law",
            time: now,
        })
    }

    fn place(&self, numbers: &Numbers, support: Support) -> Place {
        let body = self.ground.body();
        let numbers = match support {
            Support::Rolling => body.rolled(numbers),
            _ => *numbers,
        };
        let (height, climb) = body.height(&Pose::of(&numbers));
        Place {
            numbers,
            height,
            climb,
            support,
        }
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
