//! A run of order 8 that knows its own error: a loose run beside it, and what the loose run lost of what is conserved.

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

/// A problem as the steering sees it.
pub(super) struct Wheel<'a, R, D, I> {
    /// One run with this tolerance, states at these times.
    pub run: R,
    /// The distance of two states.
    pub distance: D,
    /// By how much a state fails what is conserved, relative.
    pub drift: I,
    pub times: &'a [f64],
    /// The greatest rate at which the body turns, rad/s.
    pub fastest: f64,
    pub accuracy: f64,
}

/// The least tolerance; below it the error estimate of a step is rounding.
const LEAST: f64 = 1e-15;
const GREATEST: f64 = 3e-3;
/// How much looser the loose run is: for order 8 it costs 0.56 and 0.42 of the other.
const LOOSER: f64 = 100.0;
const MUCH_LOOSER: f64 = 1000.0;
/// The share of the drift's worth that the error is taken for when the tolerance is chosen: observed 0.03 to 1, in the middle 0.25.
const SHARE: f64 = 1.0;
/// By this the estimates are multiplied.
const MARGIN: f64 = 1.0;
/// What rounding adds to the tolerance.
const ROUNDING: f64 = 4e-16;

impl<S, R, D, I> Wheel<'_, R, D, I>
where
    R: Fn(f64, &[f64]) -> Result<(Vec<S>, Cost)>,
    D: Fn(&S, &S) -> f64,
    I: Fn(&S) -> f64,
{
    /// The states, with an error below the accuracy.
    ///
    /// The error of a run follows its tolerance in proportion, with a factor that grows with the turns (observed: 0.1 to 800). The loose run shows that
    /// factor by what it lost of the energy, the better one is run with the tolerance that follows, and the distance of the two is the error of the
    /// loose one. That of the better is as much smaller as its tolerance, or where few steps or many samples keep it from following that, as the
    /// tenth power of its steps. What rounding does is magnified by the same factor. Where this is not enough there is a further run.
    pub fn steer(&self) -> Result<Steered<S>> {
        let checks = self.checks();
        let every: Vec<f64> = self.times.iter().chain(&checks.added).copied().collect();
        let seldom: Vec<f64> = checks.places.iter().map(|&n| every[n]).collect();
        let last = every.iter().fold(0.0_f64, |a, &b| a.max(b.abs()));
        let angle = self.fastest * last;
        let turns = (angle / core::f64::consts::TAU).max(1.0);
        let usual = 1.6 * turns.powf(1.4);
        let looser = if self.accuracy < 3e-7 {
            MUCH_LOOSER
        } else {
            LOOSER
        };
        let mut worse = (looser * self.accuracy / usual).clamp(30.0 * LEAST, GREATEST);
        let (mut before, mut cost) = (self.run)(worse, &seldom)?;
        let mut steps = cost.steps;
        let mut lost = greatest(before.iter(), |state| (self.drift)(state));
        let factor = if lost > 0.0 {
            (SHARE * lost * (1.0 + angle) / worse).clamp(usual / 30.0, usual * 30.0)
        } else {
            usual
        };
        let mut tolerance = (self.accuracy / (MARGIN * factor)).clamp(LEAST, worse / 10.0);
        loop {
            let (mut states, spent) = (self.run)(tolerance, &every)?;
            cost += spent;
            let pairs = before.iter().zip(&checks.places);
            let apart = greatest(pairs, |(a, &n)| (self.distance)(a, &states[n]));
            let error_before = apart.max(0.5 * lost);
            let shorter = steps as f64 / spent.steps.max(1) as f64;
            let share = (tolerance / worse).max(shorter.powi(10)).min(1.0);
            let margin = MARGIN * (1.0 + 1.0 / spent.steps.max(1) as f64);
            let error = margin * error_before * share + error_before / worse * ROUNDING;
            let error = error.max(tolerance);
            if error <= self.accuracy {
                states.truncate(self.times.len());
                return Ok(Steered {
                    states,
                    error,
                    cost,
                });
            }
            if tolerance <= LEAST || !error.is_finite() {
                return Err(Error::Accuracy {
                    asked: self.accuracy,
                    reached: error,
                });
            }
            let next = tolerance * (0.5 * self.accuracy / error).clamp(1e-4, 0.3);
            lost = greatest(checks.places.iter(), |&n| (self.drift)(&states[n]));
            before = picked(states, &checks.places);
            (worse, steps) = (tolerance, spent.steps);
            tolerance = next.max(LEAST);
        }
    }

    /// Where two runs are compared: at a single time they may agree by chance, at all of many the loose run would have to stop for each.
    fn checks(&self) -> Checks {
        let count = self.times.len();
        let last = self
            .times
            .iter()
            .copied()
            .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        let turns = self.fastest * last.abs() / core::f64::consts::TAU;
        let wanted = (0.7 * turns).floor().clamp(0.0, MOST_CHECKS as f64 - 1.0) as usize + 1;
        if count < wanted {
            let missing = wanted - count;
            let added = (1..=missing).map(|n| last * n as f64 / (missing + 1) as f64);
            return Checks {
                added: added.collect(),
                places: (0..wanted).collect(),
            };
        }
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&i, &j| self.times[i].total_cmp(&self.times[j]));
        let kept = count.min(wanted.max(2));
        let mut places: Vec<usize> = (0..kept)
            .map(|n| order[(count - 1) * n / (kept - 1).max(1)])
            .collect();
        places.push(order[count - 1]);
        places.sort_unstable();
        places.dedup();
        Checks {
            added: Vec::new(),
            places,
        }
    }
}

/// Two runs are compared at so many times at most.
const MOST_CHECKS: usize = 7;

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
