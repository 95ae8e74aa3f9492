//! The adapter to the crate `differential-equations`: systems of N numbers, samples at given times, events.
//!
//! * this file: what is asked and what is answered;
//! * `run`: the crate's loop with one of its methods, and the short steps to samples and events;
//! * `track`: what a run leaves behind, in times from 0 to 1;
//! * `falling`: where between two steps a quantity falls through zero.

mod falling;
mod run;
mod track;

use crate::error::{Result, finite};
use run::Run;

/// Equations y' = f(t, y) for N numbers.
pub trait System<const N: usize> {
    /// f(t, y). May be called at states that the motion never reaches; a result that is not finite makes the step fail.
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// Told of the time after every step.
    ///
    /// # Errors
    /// Those that end the run: where a budget of evaluations is spent, say.
    fn reached(&self, _time: f64) -> Result<()> {
        Ok(())
    }
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> [f64; N]> System<N> for F {
    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self(t, y)
    }
}

/// A method of the crate `differential-equations`, by its usual name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// The classical Runge–Kutta method, order 4, fixed steps.
    Rk4,
    /// Dormand and Prince, order 5(4).
    Dopri5,
    /// Dormand and Prince as programmed by Hairer, order 8(5,3).
    Dop853,
    /// Verner's most efficient pair, order 9(8).
    Verner98,
    /// Gauss and Legendre's implicit method with three stages, order 6, fixed steps: symplectic and symmetric in time. A step costs ten times
    /// the evaluations of one of RK4 and several hundred times its time, for Newton's method differentiates by differences and solves 3N
    /// equations with matrices from the heap.
    ///
    /// The crate offers it with error control alone, by an estimate of order 2 that shrinks steps as if it were of order 6; and it counts
    /// rejected steps from the start of the run and calls the equations stiff at the hundredth. Here the step is held and nothing is rejected.
    Gauss,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Rk4,
        Self::Dopri5,
        Self::Dop853,
        Self::Verner98,
        Self::Gauss,
    ];

    /// The name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Verner98 => "verner98",
            Self::Gauss => "gauss",
        }
    }

    /// Whether the step is chosen by an error estimate, and [`Effort::Tolerance`] asked for; if not, [`Effort::Step`].
    pub const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4 | Self::Gauss)
    }
}

/// How hard a method works.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Effort {
    /// Steps of this length at most, s.
    Step(f64),
    /// Error of one step: this times |y| + scale, component by component.
    Tolerance(f64),
}

/// What a run has cost. The same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cost {
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
    /// Steps taken, accepted ones.
    pub steps: u64,
}

impl core::ops::AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.evaluations += other.evaluations;
        self.steps += other.steps;
    }
}

/// States at the times asked for, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution<const N: usize> {
    /// One state a time.
    pub states: Vec<[f64; N]>,
    /// What it has cost.
    pub cost: Cost,
}

/// A quantity whose zero ends a run.
pub trait Event<const N: usize> {
    /// g(t, y); the run ends where it falls through zero.
    fn value(&self, t: f64, y: &[f64; N]) -> f64;
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> f64> Event<N> for F {
    fn value(&self, t: f64, y: &[f64; N]) -> f64 {
        self(t, y)
    }
}

/// A run that ended by an event, or at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage<const N: usize> {
    /// States at those of the times asked for that were reached.
    pub states: Vec<[f64; N]>,
    /// Time at which the run ended.
    pub time: f64,
    /// State there.
    pub end: [f64; N],
    /// Whether an event ended it.
    pub stopped: Stop,
    /// What it has cost.
    pub cost: Cost,
}

/// What ended a [`Passage`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The time was up.
    AtTheEnd,
    /// The event's quantity fell through zero.
    AtTheEvent,
}

/// States at all of `times` (s, in any order, before and after `start_time` alike).
///
/// `scales` are the sizes below which a component counts as small: the error of a step may be tolerance × (|y| + scale) in each.
/// Each sample is reached by a step of its own from the last step before it, not by dense output, which is less exact by up to
/// four digits; it costs the evaluations of one step.
///
/// # Errors
/// [`NotFinite`](crate::Error::NotFinite) for times and start; [`NotPositive`](crate::Error::NotPositive) for the effort;
/// [`Integration`](crate::Error::Integration) where the method gives up.
pub fn solve<const N: usize>(
    system: &dyn System<N>,
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    method: Method,
    effort: Effort,
) -> Result<Solution<N>> {
    for &t in times {
        finite("the time", t)?;
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let first_after = order.partition_point(|&i| times[i] < start_time);
    let (before, after) = order.split_at(first_after);
    let before: Vec<usize> = before.iter().rev().copied().collect();
    let mut states = vec![*start; times.len()];
    let mut cost = Cost::default();
    for places in [before.as_slice(), after] {
        let Some(&last) = places.last() else { continue };
        let ordered: Vec<f64> = places.iter().map(|&i| times[i]).collect();
        let never = |_: f64, _: &[f64; N]| 1.0;
        let run = Run {
            system,
            scales,
            method,
            effort,
        };
        let passage = run.until(start_time, start, &ordered, times[last], &never)?;
        cost += passage.cost;
        for (&place, state) in places.iter().zip(passage.states) {
            states[place] = state;
        }
    }
    Ok(Solution { states, cost })
}

/// From `start` at `start_time` towards `end_time`, with states at `times` (ordered, all between the two), until the event's quantity
/// falls through zero.
///
/// It is asked for at the end of every step. Where a step ends without it that began with it, the moment is enclosed between states that
/// the method itself reaches, by secants kept within the enclosure and by halving, down to rounding: corners (the least of several
/// quantities) are no worse than smooth ones, and dense output has no part in it. Observed error: that of the run. Cost: one step of the
/// method for each of some ten trials.
///
/// What counts: a quantity that is zero at the start falls only after it has risen, and one that is negative at the start only after a
/// step has ended with it positive. What is missed: a quantity that falls and rises again within one step, and one that touches zero
/// without going through; give such a one a quantity that changes its sign. Of three crossings in one step one is found, not
/// necessarily the first.
///
/// # Errors
/// As for [`solve`].
#[expect(
    clippy::too_many_arguments,
    reason = "a problem, its samples, its end and a method: nothing can be left out"
)]
pub fn until<const N: usize>(
    system: &dyn System<N>,
    start_time: f64,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    end_time: f64,
    event: &dyn Event<N>,
    method: Method,
    effort: Effort,
) -> Result<Passage<N>> {
    Run {
        system,
        scales,
        method,
        effort,
    }
    .until(start_time, start, times, end_time, event)
}
