//! A run that knows its own error.

use super::general::{Effort, Method, Solution, System, solve};
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
    system: &(impl System<N> + ?Sized),
    start: &[f64; N],
    scales: &[f64; N],
    times: &[f64],
    method: Method,
    accuracy: f64,
    distance: impl Fn(&[f64; N], &[f64; N]) -> f64,
) -> Result<Solution<N>> {
    let run = |tolerance: f64| {
        let effort = Effort::Tolerance(tolerance);
        solve(system, 0.0, start, scales, times, method, effort)
    };
    let mut worse = (0.1 * accuracy).clamp(LEAST_TOLERANCE, 1e-6);
    let mut tolerance = (worse / 30.0).max(LEAST_TOLERANCE);
    let mut last = run(worse)?;
    let mut cost = last.cost;
    loop {
        let next = run(tolerance)?;
        cost += next.cost;
        let pairs = last.states.iter().zip(&next.states);
        let apart = pairs.map(|(a, b)| distance(a, b)).fold(0.0, f64::max);
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
