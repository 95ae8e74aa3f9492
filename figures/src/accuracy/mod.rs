//! What accuracy costs (chapter "What accuracy costs"): orders, long runs, three kinds of numbers, and the price of a digit.
//!
//! Everything here but `map` and `seconds`, which are measured, is computed when it is drawn.

mod drift;
mod growth;
mod map;
mod numbers;
mod orders;
mod seconds;

use lab::accuracy::{Measurement, Problem, Status, Trial, candidates, measure, named};
use spinning_bodies::Error;

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of("accuracy-map", &[], map::map),
    of("accuracy-seconds", &[], seconds::seconds),
    of("accuracy-orders", &[], orders::orders),
    of("accuracy-numbers", &[], numbers::three_numbers),
    of("accuracy-growth", &[], growth::growth),
    of("accuracy-drift", &[], drift::energy_drift),
];

/// One problem over one length.
fn problem(name: &str) -> Result<Problem> {
    let first = named(name)?.into_iter().next();
    first.ok_or(Error::Empty {
        quantity: "the list of problems of this name",
    })
}

/// The sweep of one method, without runs that would need more than the given number of evaluations.
fn swept(problem: &Problem, method: &str, most: u64) -> Result<Vec<Measurement>> {
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
fn points(rows: &[Measurement], across: impl Fn(&Measurement) -> f64) -> Vec<Point> {
    let mut floor = 0;
    let kept = rows.iter().filter(|row| {
        floor += usize::from(row.status == Status::Floor);
        matches!(row.status, Status::Ok | Status::Floor) && floor < 2
    });
    kept.map(|row| [across(row), row.error_attitude]).collect()
}
