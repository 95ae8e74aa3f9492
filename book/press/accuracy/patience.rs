//! The sweep of a method, as far as it does not take too long.

use std::time::Instant;

use lab::accuracy::{Candidate, Measurement, Problem, Trial};
use spinning_bodies::Error;
use spinning_bodies::integrators::Effort;

/// One method on one problem.
#[derive(Debug)]
pub struct Swept {
    /// Its measurements, from coarse to fine.
    pub rows: Vec<Measurement>,
    /// Its name.
    pub method: String,
    /// Number of finer efforts left out because they would have taken too long.
    pub left_out: usize,
}

/// A run that would take longer is left out, s.
pub const PATIENCE: f64 = 0.6;

/// The sweep of one method on a motion, without runs of more seconds than `patience`; `first` estimates the time of the first run. A debug build measures no times.
pub fn swept<E>(trial: &Trial<'_, E>, patience: f64, first: impl Fn(Effort) -> f64) -> Swept {
    let (mut last, mut gave_up) = (0.0, false);
    let rows = trial.sweep(|rows, effort| {
        let before = rows.last();
        let failure = before.and_then(|row| row.failure.as_ref());
        // Such a method fails at every effort.
        if let Some(Error::Solver { .. } | Error::Condition { .. }) = failure {
            return None;
        }
        let expected = before.map_or_else(|| first(effort), |row| next(row, effort, last));
        gave_up = expected > patience;
        if gave_up {
            return None;
        }
        let begin = Instant::now();
        let row = match cfg!(debug_assertions) {
            true => trial.measure(effort),
            false => trial.timed(effort),
        };
        last = row.seconds.unwrap_or(begin.elapsed().as_secs_f64());
        gave_up = matches!(row.failure, Some(Error::Budget { .. }));
        (!gave_up).then_some(row)
    });
    let left = trial.efforts.len() - rows.len();
    Swept {
        left_out: if gave_up { left } else { 0 },
        rows,
        method: trial.names[1].to_owned(),
    }
}

/// The time that the next run is likely to take, s, after one that took `last`.
fn next(row: &Measurement, effort: Effort, last: f64) -> f64 {
    match effort {
        Effort::Step(step) => last * row.parameter / step,
        // A third of a decade of tolerance costs a method of order 5 a factor 1.2.
        Effort::Tolerance(_) => last * 1.2,
    }
}

/// The time that the first run on a problem is likely to take, s, from a short piece of it.
pub fn first(problem: &Problem, candidate: &Candidate, effort: Effort) -> f64 {
    let parts = problem.turns();
    // A closed form is asked for the end alone.
    if parts < 100.0 || candidate.name == "exact" {
        return 0.0;
    }
    // Only the time matters; a failure is reported by the run that counts. The least of several, because the first one includes warming up.
    let piece = || {
        let begin = Instant::now();
        let _ = candidate
            .method
            .follow(problem.start(), &[problem.end() / parts], effort);
        begin.elapsed().as_secs_f64()
    };
    parts * (0..5).map(|_| piece()).fold(f64::INFINITY, f64::min)
}
