//! From phase to phase: sliding, rolling, in the air.

use core::cell::Cell;

use crate::error::{Error, Result};
use crate::integrators::{Cost, Effort, Method, Passage, Stop, System, until};
use crate::scene::Budget;
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
    pub(super) budget: &'a Budget,
}

/// A body that changes its support more often than this chatters, and is not followed further.
const MOST_CHANGES: usize = 100_000;

/// Reaction over weight below which a body that has met an event takes off. Take-off is located to rounding; rest, which also is an
/// event, says nothing of the reaction.
const LIFTED: f64 = 1e-6;

/// How a stretch of a motion is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    Sliding,
    /// Sliding, but from rest, and not yet fast enough for rest to be an event.
    Leaving,
    Rolling,
    Airborne,
}

impl Mode {
    const fn support(self) -> Support {
        match self {
            Self::Sliding | Self::Leaving => Support::Sliding,
            Self::Rolling => Support::Rolling,
            Self::Airborne => Support::Airborne,
        }
    }
}

/// How far within the cone a body that leaves its rest must be to roll again, in weights.
const AT_THE_RIM: f64 = 1e-9;

/// Where a stretch has ended.
struct Ended {
    time: f64,
    numbers: Numbers,
    /// How it goes on; nothing if the time was up.
    next: Option<Mode>,
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
        let mut mode = self.settled(&mut y)?;
        for _ in 0..MOST_CHANGES {
            if mode != Mode::Airborne && self.contact(&y, mode).reaction <= 0.0 {
                mode = Mode::Airborne;
                self.released(now, &y)?;
            }
            let support = mode.support();
            if history.phases.last().map(|phase| phase.support) != Some(support) {
                history.phases.push(Phase {
                    start: now,
                    support,
                });
            }
            let ended = if mode == Mode::Airborne {
                self.fly(now, &y, times, end, &mut history)?
            } else {
                self.touch(now, &y, mode, times, end, &mut history)?
            };
            (now, y) = (ended.time, ended.numbers);
            match ended.next {
                Some(next) if now < end => mode = next,
                _ => {
                    // An event at the very end leaves the last samples to the state after it.
                    while history.places.len() < times.len() {
                        history.places.push(self.place(&y, mode));
                    }
                    return Ok(history);
                }
            }
        }
        Err(Error::Integration {
            reason: "the body changes between sliding, rolling and hopping more than a hundred thousand times; end the run earlier, or let it slide by a viscous law",
            time: now,
        })
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
        let landing = flight.landing(end - now, &|t| self.budget.spend(1, now + t))?;
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
        mode: Mode,
        times: &[f64],
        end: f64,
        history: &mut History,
    ) -> Result<Ended> {
        let sliding = |_: f64, y: &Numbers| self.ground.sliding_rates(y);
        let rolling = |_: f64, y: &Numbers| self.ground.rolling_rates(y);
        let rates: &dyn System<NUMBERS> = match mode {
            Mode::Rolling => &rolling,
            _ => &sliding,
        };
        let left = &times[history.places.len()..];
        let event = |_: f64, y: &Numbers| self.margin(y, mode);
        let effort = Effort::Tolerance(self.tolerance);
        let (scales, method) = (self.scales, self.method);
        let passage: Passage<[f64; NUMBERS]> = until(
            &self.budget.counted(rates),
            now,
            y,
            scales,
            left,
            end,
            &event,
            method,
            effort,
        )?;
        history.cost += passage.cost;
        for numbers in &passage.states {
            history.places.push(self.place(numbers, mode));
        }
        let (mut time, mut numbers) = (passage.time, passage.end);
        if passage.stopped == Stop::AtTheEnd {
            return Ok(Ended {
                time,
                numbers,
                next: None,
            });
        }
        let cone = matches!(self.ground.holding(), Holding::Cone { .. });
        let pressed = self.contact(&numbers, mode).reaction > LIFTED * self.weight();
        if mode == Mode::Sliding && cone && pressed {
            let left = self.time_to_rest(&numbers);
            let at_rest = time + left;
            while let Some(&sample) = times.get(history.places.len())
                && sample <= at_rest
            {
                let place = self.coasted(&numbers, sample - time);
                history.places.push(self.place(&place, mode));
            }
            numbers = self.coasted(&numbers, left);
            time = at_rest;
        }
        let next = match mode {
            _ if !(cone && pressed) => Mode::Airborne,
            Mode::Sliding => self.stuck(&mut numbers)?,
            Mode::Leaving if self.slip(&numbers) > 1.5 * self.still() => Mode::Sliding,
            Mode::Leaving => {
                // Before it has gone anywhere rolling is possible again.
                self.hold(&mut numbers)?;
                Mode::Rolling
            }
            _ => {
                numbers = self.ground.body().rolled(&numbers);
                self.kick(&mut numbers);
                Mode::Leaving
            }
        };
        Ok(Ended {
            time,
            numbers,
            next: Some(next),
        })
    }

    /// Slip at which a sliding body is taken to its rest in one step of second order, m/s. A step of the method overshoots rest by some
    /// hundreds of its tolerance, since its error estimate sees little of the jump of the force there.
    fn still(&self) -> f64 {
        (1000.0 * self.tolerance)
            .min(1e-3)
            .max(10.0 * self.tolerance)
            * self.scales[7]
    }

    fn slip(&self, y: &Numbers) -> f64 {
        self.contact(y, Mode::Sliding).slip.norm()
    }

    /// Time until the slip is nil, by a secant; zero where the slip does not go down.
    fn time_to_rest(&self, y: &Numbers) -> f64 {
        let slip = self.slip(y);
        let probe = 0.05 * slip / self.ground.gravity();
        let left = probe * slip / (slip - self.slip(&self.coasted(y, probe)));
        let longest = 0.1 * self.still() / self.tolerance.max(1e-12) / self.ground.gravity();
        if left > 0.0 && left < longest.min(0.01 / self.scales[4]) {
            left
        } else {
            0.0
        }
    }

    /// A sliding state a very short while later, by the midpoint rule.
    fn coasted(&self, y: &Numbers, time: f64) -> Numbers {
        let rate = self.ground.sliding_rates(y);
        let middle: Numbers = core::array::from_fn(|i| y[i] + 0.5 * time * rate[i]);
        let rate = self.ground.sliding_rates(&middle);
        core::array::from_fn(|i| y[i] + time * rate[i])
    }

    fn contact(&self, y: &Numbers, mode: Mode) -> Contact {
        let pose = Pose::of(y);
        match mode {
            Mode::Rolling => self.ground.rolls(&pose),
            _ => self.ground.slides(&pose),
        }
    }

    fn weight(&self) -> f64 {
        self.ground.body().mass() * self.ground.gravity()
    }

    /// Positive while the stretch lasts: the reaction over the weight, how far sliding is from rest, how far rolling is from the cone's
    /// rim; and for a body that leaves its rest, how far it is from a slip of its own and from being able to roll.
    fn margin(&self, y: &Numbers, mode: Mode) -> f64 {
        let contact = self.contact(y, mode);
        let pressed = contact.reaction / self.weight();
        let Holding::Cone { mu } = self.ground.holding() else {
            return pressed;
        };
        match mode {
            Mode::Rolling => pressed.min(pressed * (mu - contact.traction.norm())),
            Mode::Leaving => {
                let rolled = self.contact(&self.ground.body().rolled(y), Mode::Rolling);
                let weight = self.weight();
                let pulled = (rolled.reaction * rolled.traction.norm()).abs() / weight;
                let beyond = pulled - mu * rolled.reaction / weight;
                pressed
                    .min(2.0 - contact.slip.norm() / self.still())
                    // A body starts at the rim itself; rounding must not put it past the event.
                    .min(beyond + AT_THE_RIM)
            }
            _ => pressed.min(contact.slip.norm() / self.still() - 1.0),
        }
    }

    /// How a body that touches the table goes on.
    fn settled(&self, y: &mut Numbers) -> Result<Mode> {
        match self.ground.holding() {
            Holding::Slides => Ok(Mode::Sliding),
            Holding::Grips => {
                *y = self.ground.body().rolled(y);
                Ok(Mode::Rolling)
            }
            Holding::Cone { .. } if self.slip(y) > self.still() => Ok(Mode::Sliding),
            Holding::Cone { .. } => self.stuck(y),
        }
    }

    /// The slip taken away; rolling if the cone then allows it, else sliding the way the force pulls that it would take.
    fn stuck(&self, y: &mut Numbers) -> Result<Mode> {
        self.hold(y)?;
        // At the rim a run that rolls would see no event: the margin has to fall through zero.
        if self.margin(y, Mode::Rolling) > 0.0 {
            return Ok(Mode::Rolling);
        }
        self.kick(y);
        Ok(Mode::Leaving)
    }

    /// The blow that takes away what slip there is.
    fn hold(&self, y: &mut Numbers) -> Result<()> {
        let pose = Pose::of(y);
        let (height, climb) = self.ground.body().height(&pose);
        let place = Airborne {
            pose,
            numbers: *y,
            height,
            climb,
        };
        (*y, _) = self.ground.land(&place, Holding::Grips)?;
        Ok(())
    }

    /// A slip of the size of a step's error, the way the body begins to slide: against the force that no longer suffices.
    ///
    /// The slip then grows: between forces along one line that both keep the body on the table, acceleration along it follows force.
    fn kick(&self, y: &mut Numbers) {
        let pose = Pose::of(y);
        let pull = self.ground.rolls(&pose).traction;
        if pull.norm() == 0.0 {
            return;
        }
        let slip = pose.turn * (pull * (-3.0 * self.tolerance * self.scales[7] / pull.norm()));
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

    fn place(&self, numbers: &Numbers, mode: Mode) -> Place {
        let body = self.ground.body();
        let numbers = match mode {
            Mode::Rolling => body.rolled(numbers),
            _ => *numbers,
        };
        let (height, climb) = body.height(&Pose::of(&numbers));
        Place {
            numbers,
            height,
            climb,
            support: mode.support(),
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
            // Of no use any more, and they may be long.
            drop((coarse, fine));
            coarse = counted(tolerance)?;
        }
    }
}

const FACTOR: f64 = 30.0;

/// Below this the error estimate of a step is rounding.
const LEAST_TOLERANCE: f64 = 1e-15;
