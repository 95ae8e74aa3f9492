//! The motions of the chapter, and the sweep of a method over one of them.

use lab::accuracy::{Measurement, Problem, Status, Trial, candidates, measure, named};
use spinning_bodies::Error;

use crate::prelude::*;

/// One problem over one length.
pub fn problem(name: &str) -> Result<Problem> {
    let first = named(name)?.into_iter().next();
    first.ok_or(Error::Empty {
        quantity: "the list of problems of this name",
    })
}

/// The sweep of one method, without runs that would need more than the given number of evaluations.
pub fn swept(problem: &Problem, method: &str, most: u64) -> Result<Vec<Measurement>> {
    let all = candidates(problem)?;
    let Some(candidate) = all.iter().find(|candidate| candidate.name == method) else {
        return Ok(Vec::new());
    };
    Ok(Trial::of(problem, candidate).sweep(|rows, effort| {
        // Efforts are at most a decade or a factor 1.5 apart.
        let more = rows.last().is_none_or(|row| 3 * row.evaluations < 2 * most);
        more.then(|| measure(problem, candidate, effort))
    }))
}

/// Errors against a chosen quantity, without runs that failed or diverged, and with one point at the floor of rounding.
pub fn points(rows: &[Measurement], across: impl Fn(&Measurement) -> f64) -> Vec<Point> {
    let mut floor = 0;
    let kept = rows.iter().filter(|row| {
        floor += usize::from(row.status == Status::Floor);
        matches!(row.status, Status::Ok | Status::Floor) && floor < 2
    });
    kept.map(|row| [across(row), row.error_attitude]).collect()
}
