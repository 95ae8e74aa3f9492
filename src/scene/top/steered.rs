//! A run of order 8 that knows its own error: what it loses of what is conserved tells, and in long runs a cheap one beside it.

use crate::error::{Error, Result};
use crate::integrators::Cost;

/// What came out.
pub(super) struct Steered<S> {
    /// One a time.
    pub states: Vec<S>,
    /// The most that any of them may be off.
    pub error: f64,
    pub cost: Cost,
}

/// What one run shows.
pub(super) struct Shown<S> {
    /// One a time.
    pub states: Vec<S>,
    pub cost: Cost,
    /// By how much the end of any step fails what is conserved, at most; relative.
    pub drift: f64,
}

/// A problem as the steering sees it.
pub(super) struct Wheel<'a, R, D> {
    /// One run with this tolerance, states at these times.
    pub run: R,
    /// The distance of two states.
    pub distance: D,
    pub times: &'a [f64],
    /// The greatest rate at which the body turns, rad/s.
    pub fastest: f64,
    /// The angle (radians) up to which an error grows no faster than in proportion to the time.
    pub calm: f64,
    pub accuracy: f64,
}

/// Up to here heavy tops without a closed form have shown no exponential growth: of 700 random ones one did; of those that turned further, one of seven.
pub(super) const CALM: f64 = 40.0;

/// The least tolerance; below it the error estimate of a step is rounding.
const LEAST: f64 = 1e-15;
const GREATEST: f64 = 3e-3;
/// An error is told as no less than tolerance times angle times this: the drift may be small by chance.
const FLOOR: f64 = 0.2;
/// How much looser the run beside a long one is: of order 8 it costs a quarter.
const LOOSER: f64 = 1e5;
const LOOSEST: f64 = 1e-2;
/// A long run is so much tighter than the loose run's drift would have it: the growth is known only when both are done.
const WARY: f64 = 5.0;
/// Two runs further apart than this (radians) have nothing to say of each other.
const TOGETHER: f64 = 0.2;
/// Integrable motions from this angle on take a fifth of the tolerance: in one of 360 tops of Kovalevskaya the error grew ten times as fast as usual.
const FAR: f64 = 60.0;
/// A loose run's distance from the better one, over its drift, is the error of the better one over its own, but for this.
const MARGIN: f64 = 1.2;
const WILD_MARGIN: f64 = 6.0;
/// An error follows the tolerance no faster than this: the drift may be small by chance.
const SLOWEST: f64 = 0.7;
/// Where the accuracy leaves room for it, so much more is told than was estimated: one estimate of eight is below the error.
const ROOM: f64 = 2.5;
/// What rounding adds to the tolerance.
const ROUNDING: f64 = 4e-16;
/// A drift this small is rounding.
const ROUNDED: f64 = 2e-15;

impl<S, R, D> Wheel<'_, R, D>
where
    R: Fn(f64, &[f64]) -> Result<Shown<S>>,
    D: Fn(&S, &S) -> f64,
{
    /// The states, with an error below the accuracy.
    ///
    /// One run, mostly: its tolerance follows from the angle, and its drift, times the angle, tells its error. Where an error may grow faster than in
    /// proportion a looser run goes before: how far it ends from the better one, over what it has lost, belongs to the motion and not to the
    /// tolerance; times what the better one has lost it is the error of that. Where the error is above the accuracy there is a further run.
    ///
    /// # Errors
    /// [`Error::Accuracy`]; those of the run.
    pub fn steer(&self) -> Result<Steered<S>> {
        let angle = self.fastest * self.last().abs();
        let mut cost = Cost::default();
        if angle <= self.calm {
            // Far on, integrable motions near their separatrices are worse than the others.
            let far = if angle > FAR { 1.0 } else { 0.0 };
            let share = share(angle) * (1.0 + 2.0 * far);
            let mut tolerance = tolerance(angle, self.accuracy) / (1.0 + 4.0 * far);
            loop {
                let shown = (self.run)(tolerance, self.times)?;
                cost += shown.cost;
                let told = (share * shown.drift).max(FLOOR * tolerance);
                let error = (1.0 + angle) * (told + ROUNDING);
                if error <= self.accuracy {
                    return Ok(self.done(shown.states, error, cost));
                }
                tolerance = self.tighter(tolerance, error)?;
            }
        }
        let checks = self.checks();
        let every: Vec<f64> = self.times.iter().chain(&checks.added).copied().collect();
        let seldom: Vec<f64> = checks.places.iter().map(|&n| every[n]).collect();
        let tolerance = (self.accuracy / (1.5 * angle)).clamp(LEAST, GREATEST);
        let mut worse = (LOOSER * tolerance).min(LOOSEST).max(10.0 * tolerance);
        let mut before = (self.run)(worse, &seldom)?;
        cost += before.cost;
        let factor = share(angle) * angle * before.drift / worse;
        let mut tolerance = tolerance.min((self.accuracy / (WARY * factor)).max(LEAST));
        loop {
            let shown = (self.run)(tolerance, &every)?;
            cost += shown.cost;
            let pairs = before.states.iter().zip(&checks.places);
            let apart = greatest(pairs, |(a, &n)| (self.distance)(a, &shown.states[n]));
            let error = if apart <= TOGETHER {
                let grown = (apart / worse).max(0.1 * angle);
                let less =
                    ((shown.drift + ROUNDED) / before.drift).max(SLOWEST * tolerance / worse);
                let by_drift = 0.1 * angle * shown.drift;
                // Where errors grow fast, those made early count most, and the drift does not tell which they were.
                let margin = if apart > angle * before.drift {
                    WILD_MARGIN
                } else {
                    MARGIN
                };
                (margin * apart * less.min(1.0)).max(by_drift) + grown * ROUNDING
            } else {
                // The looser one has lost its way: it shows nothing, but what grew so much is not small here.
                self.accuracy.max(apart * (tolerance / worse).min(1.0)) * 3.0
            };
            if error <= self.accuracy {
                return Ok(self.done(shown.states, error, cost));
            }
            let next = self.tighter(tolerance, error)?;
            let Shown { states, drift, .. } = shown;
            before = Shown {
                states: picked(states, &checks.places),
                cost: Cost::default(),
                drift,
            };
            (worse, tolerance) = (tolerance, next);
        }
    }

    fn done(&self, mut states: Vec<S>, error: f64, cost: Cost) -> Steered<S> {
        states.truncate(self.times.len());
        Steered {
            states,
            error: self.accuracy.min(ROOM * error),
            cost,
        }
    }

    /// The tolerance of the next run, after one that was off by this.
    fn tighter(&self, tolerance: f64, error: f64) -> Result<f64> {
        if tolerance <= LEAST || !error.is_finite() {
            return Err(Error::Accuracy {
                asked: self.accuracy,
                reached: error,
            });
        }
        let less = (0.3 * self.accuracy / error).clamp(1e-4, 0.3);
        Ok((tolerance * less).max(LEAST))
    }

    /// The time furthest from the start.
    fn last(&self) -> f64 {
        let further = |a: f64, &b: &f64| if b.abs() > a.abs() { b } else { a };
        self.times.iter().fold(0.0, further)
    }

    /// Where two runs are compared: at a single time they may agree by chance, at all of many the loose run would have to stop for each.
    fn checks(&self) -> Checks {
        let count = self.times.len();
        if count < CHECKS {
            let missing = CHECKS - count;
            let (last, parts) = (self.last(), (missing + 1) as f64);
            return Checks {
                added: (1..=missing).map(|n| last * n as f64 / parts).collect(),
                places: (0..CHECKS).collect(),
            };
        }
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&i, &j| self.times[i].total_cmp(&self.times[j]));
        let mut places: Vec<usize> = (0..CHECKS)
            .map(|n| order[(count - 1) * n / (CHECKS - 1)])
            .collect();
        places.sort_unstable();
        Checks {
            added: Vec::new(),
            places,
        }
    }
}

/// The share of drift times angle that the error is taken for: observed, of 4 radians 0.1 to 1.3, of 150 radians 0.02 to 0.5 and seldom more.
fn share(angle: f64) -> f64 {
    0.2 + 0.2 / (1.0 + angle / 20.0)
}

/// The tolerance of a run that turns by `angle`.
///
/// Its error is the tolerance times the angle times, observed in 500 tops of every kind at all tolerances up to 40 radians, 0.15 in the middle, 1 in one
/// case of twenty, 4 at most, and of short runs less: their steps are few. Of order 8 this much in reserve costs 1.2 of what the luckiest tolerance would.
pub(super) fn tolerance(angle: f64, accuracy: f64) -> f64 {
    let angle = angle.max(2.0);
    (accuracy / (angle * (1.0 + 0.1 * angle).min(2.5))).clamp(LEAST, GREATEST)
}

/// Two runs are compared at so many times.
const CHECKS: usize = 6;

struct Checks {
    /// Times beside those asked for.
    added: Vec<f64>,
    /// Places among the times asked for and added.
    places: Vec<usize>,
}

/// The states at these places, which ascend.
fn picked<S>(states: Vec<S>, places: &[usize]) -> Vec<S> {
    let mut wanted = places.iter().peekable();
    let all = states.into_iter().enumerate();
    all.filter_map(|(n, state)| wanted.next_if_eq(&&n).map(|_| state))
        .collect()
}

fn greatest<T>(items: impl Iterator<Item = T>, size: impl Fn(T) -> f64) -> f64 {
    // What is not a number must not pass for small.
    items.map(size).fold(0.0, |m, d| if d <= m { m } else { d })
}
