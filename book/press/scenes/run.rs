//! The section `[run]`: when, how well, and by which solver.

use lab::general::DifferentialEquations;
use spinning_bodies::scene::{Choice, Request, Solver};

use super::reader::Section;
use crate::Result;

/// Most rows of a run: some gigabytes of output.
const MOST: usize = 10_000_000;

/// What `[run]` asks for: `times`, or `until` and `samples`; `accuracy`; `solver`.
///
/// # Errors
/// [`crate::Error::Input`].
pub fn read(section: &Section<'_>) -> Result<Request> {
    let times = times(section)?;
    let mut request = Request::at(times).map_err(section.about("times"))?;
    if let Some(accuracy) = section.optional("accuracy", "a relative accuracy such as 1e-10")? {
        request = request
            .to_accuracy(accuracy)
            .map_err(section.about("accuracy"))?;
    }
    let mut solvers = vec![("auto", Choice::Auto)];
    solvers.extend(Solver::all().map(|solver| (solver.name(), Choice::Use(solver))));
    let request = request.by(section.word("solver", &solvers)?);
    Ok(request.with_methods(&DifferentialEquations))
}

fn times(section: &Section<'_>) -> Result<Vec<f64>> {
    let what = "a list of times in s";
    let times = section.optional_numbers("times", what)?;
    let until = section.optional("until", "the last time in s")?;
    let samples = section.optional_count("samples", 2, MOST)?;
    match (times, until, samples) {
        (Some(times), None, None) if (1..=MOST).contains(&times.len()) => Ok(times),
        (Some(times), None, None) => {
            let told = format!(
                "must be a list of 1 to {MOST} times in s, got {}",
                times.len()
            );
            Err(section.refused("times", told))
        }
        (None, Some(0.0), _) => {
            let told = "must be the last time in s, not 0: all rows would be the same";
            Err(section.refused("until", told))
        }
        (None, Some(until), samples) => {
            let samples = samples.unwrap_or(101);
            let last = (samples - 1) as f64;
            // Product first: 49 of 52 seconds in 520 parts is 4.9 then, not one ulp less.
            let unit = if (until * last).is_finite() {
                1.0
            } else {
                last
            };
            let at = |i: usize| (until / unit) * i as f64 / (last / unit);
            Ok((0..samples).map(at).collect())
        }
        (Some(_), ..) => {
            Err(section.refused("times", "and `until` or `samples` exclude each other"))
        }
        (None, None, _) => Err(section.refused(
            "times",
            "is missing: `times`, or `until` and `samples`, is expected",
        )),
    }
}
