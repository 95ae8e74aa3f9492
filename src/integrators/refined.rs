//! A run that knows its own error.

use super::general::solve;
use super::problem::{Effort, Method, Solution, System};
use crate::error::{Error, Result};

/// The solution with a global error, by `distance` at every sample, below `accuracy`: solved with tolerances a factor 30 apart, tightened
/// until the distance of the last two tells that the better one is good enough.
///
/// The error follows the tolerance in proportion (observed over 25 swings of a pendulum for DOPRI5, DOP853 and Verner's method, within a
/// factor 5 for tolerances from 1e-7 to 1e-15). The distance of two runs is the error of the worse; of the better, ten times their ratio of
/// tolerances of that is taken for granted. Cost: all runs, about 1.7 times that of the last one if the first guess holds.
///
/// # Errors
/// As for [`solve`]; [`Error::Accuracy`] where rounding, amplified by the motion, is more than the accuracy asked for.
pub fn refined<const N: usize>(
    system: &dyn System<N>,
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    method: Method,
    accuracy: f64,
    distance: impl Fn(&[f64; N], &[f64; N]) -> f64,
) -> Result<Solution<N>> {
    let run = |effort: Effort| solve(system, 0.0, start, scales, times, method, effort);
    if method.is_adaptive() {
        tightened(
            |tolerance| run(Effort::Tolerance(tolerance)),
            accuracy,
            distance,
        )
    } else {
        let longest = times.iter().fold(0.0_f64, |a, &b| a.max(b.abs()));
        let first = if longest > 0.0 { longest / 64.0 } else { 1.0 };
        halved(|step| run(Effort::Step(step)), first, accuracy, distance)
    }
}

/// What [`refined`] does with adaptive methods, for any run at a given tolerance: one with events, say.
///
/// # Errors
/// As for [`refined`].
pub fn tightened<const N: usize>(
    run: impl Fn(f64) -> Result<Solution<N>>,
    accuracy: f64,
    distance: impl Fn(&[f64; N], &[f64; N]) -> f64,
) -> Result<Solution<N>> {
    let mut worse = (0.1 * accuracy).clamp(LEAST_TOLERANCE, 1e-6);
    let mut tolerance = (worse / 30.0).max(LEAST_TOLERANCE);
    let mut last = run(worse)?;
    let mut cost = last.cost;
    loop {
        let next = run(tolerance)?;
        cost += next.cost;
        let apart = greatest(&last, &next, &distance);
        let error = apart * (10.0 * tolerance / worse).min(1.0);
        if error <= 0.5 * accuracy {
            return Ok(Solution { cost, ..next });
        }
        if tolerance == LEAST_TOLERANCE || !error.is_finite() {
            return Err(Error::Accuracy {
                asked: accuracy,
                reached: 2.0 * error,
            });
        }
        // At least one more digit, at most four at once.
        let tighter = tolerance * (0.1 * accuracy / error).clamp(1e-4, 0.1);
        (worse, tolerance) = (tolerance, tighter.max(LEAST_TOLERANCE));
        last = next;
    }
}

/// Below this the error estimate of a step is rounding.
const LEAST_TOLERANCE: f64 = 1e-15;

/// What [`refined`] does with a method of fixed step and order 4: halves the step until the last two runs vouch for each other.
///
/// The error of the better is a fifteenth of their distance; an eighth is assumed. Cost: twice that of the last run.
///
/// # Errors
/// As for [`refined`]; [`Error::Accuracy`] also where 2²² steps are not enough.
pub fn halved<const N: usize>(
    run: impl Fn(f64) -> Result<Solution<N>>,
    first_step: f64,
    accuracy: f64,
    distance: impl Fn(&[f64; N], &[f64; N]) -> f64,
) -> Result<Solution<N>> {
    let mut last = run(first_step)?;
    let mut cost = last.cost;
    let mut error = f64::INFINITY;
    for halvings in 1..=16 {
        let next = run(first_step * 0.5_f64.powi(halvings))?;
        cost += next.cost;
        error = greatest(&last, &next, &distance) / 8.0;
        if error <= 0.5 * accuracy {
            return Ok(Solution { cost, ..next });
        }
        last = next;
    }
    Err(Error::Accuracy {
        asked: accuracy,
        reached: 2.0 * error,
    })
}

fn greatest<const N: usize>(
    a: &Solution<N>,
    b: &Solution<N>,
    distance: &impl Fn(&[f64; N], &[f64; N]) -> f64,
) -> f64 {
    let pairs = a.states.iter().zip(&b.states);
    // A distance that is not a number must not pass for a small one.
    pairs
        .map(|(a, b)| distance(a, b))
        .fold(0.0, |m, d| if d <= m { m } else { d })
}
