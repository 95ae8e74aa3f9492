//! The sweep of a method, as far as patience goes.

use std::time::Instant;

use lab::accuracy::{Candidate, Measurement, Problem, measure, sweep, timed};
use spinning_bodies::integrators::Effort;

use super::Swept;

/// A run that would take longer is left out, s.
pub const PATIENCE: f64 = 0.6;

/// One method on a problem; a debug build tells no times.
pub fn swept(problem: &Problem, candidate: &Candidate) -> Swept {
    let (mut last, mut gave_up) = (0.0, false);
    let rows = sweep(candidate, |rows, effort| {
        let expected = match rows.last() {
            None => first(problem, candidate, effort),
            Some(row) => next(row, effort, last),
        };
        gave_up = expected > PATIENCE;
        if gave_up {
            return None;
        }
        let begin = Instant::now();
        let row = if cfg!(debug_assertions) {
            measure(problem, candidate, effort)
        } else {
            timed(problem, candidate, effort)
        };
        last = row.seconds.unwrap_or(begin.elapsed().as_secs_f64());
        Some(row)
    });
    let left = candidate.efforts().len() - rows.len();
    Swept {
        left_out: if gave_up { left } else { 0 },
        rows,
        method: candidate.name().to_owned(),
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

/// The time that the first run is likely to take, s, from a short piece of it.
fn first(problem: &Problem, candidate: &Candidate, effort: Effort) -> f64 {
    if problem.turns() < 100.0 {
        return 0.0;
    }
    let parts = problem.turns();
    let begin = Instant::now();
    // What the run returns is of no interest; a failure is told by the run that counts.
    let _ = candidate
        .method()
        .follow(problem.start(), &[problem.end() / parts], effort);
    let whole = if candidate.name() == "exact" {
        1.0
    } else {
        parts
    };
    begin.elapsed().as_secs_f64() * whole
}
