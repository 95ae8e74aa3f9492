//! A run that knows its own error.

use super::general::{Effort, Method, Solution, System, solve};
use crate::error::{Error, Result};

/// The solution with a global error, by `distance` at every sample, below `accuracy`: solved twice with tolerances a factor 30 apart, and both
/// tightened until the two agree to half of it.
///
/// The first of each pair is the less exact by that factor or more, so their distance bounds the error of the second with a wide
/// margin. Cost: both runs, about 2.5 times that of the last one, counted together.
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
        let effort = Effort::Tolerance(tolerance.max(LEAST_TOLERANCE));
        solve(system, 0.0, start, scales, times, method, effort)
    };
    let mut tolerance = 0.3 * accuracy;
    let mut coarse = run(tolerance)?;
    let mut cost = coarse.cost;
    loop {
        tolerance /= FACTOR;
        let fine = run(tolerance)?;
        cost += fine.cost;
        let pairs = coarse.states.iter().zip(&fine.states);
        let apart = pairs.map(|(a, b)| distance(a, b)).fold(0.0, f64::max);
        if apart <= 0.5 * accuracy {
            return Ok(Solution { cost, ..fine });
        }
        if tolerance < LEAST_TOLERANCE {
            return Err(Error::Accuracy {
                asked: accuracy,
                reached: 2.0 * apart,
            });
        }
        // Error in proportion to the tolerance, at the least; no more than three more digits at once.
        tolerance *= (0.25 * accuracy / apart).clamp(1e-3, 1.0);
        coarse = fine;
    }
}

const FACTOR: f64 = 30.0;

/// Below this the error estimate of a step is rounding.
const LEAST_TOLERANCE: f64 = 1e-16;
