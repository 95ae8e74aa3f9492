//! How wrong a method is, and what that has cost.

use spinning_bodies::Result;
use spinning_bodies::integrators::Effort;

use super::candidate::Candidate;
use super::problem::Problem;
use super::sample::Apart;
use crate::stopwatch;

/// What became of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// An error that more effort would make smaller.
    Ok,
    /// Rounding: more effort than a coarser run, and no gain. Only [`sweep`] can tell.
    Floor,
    /// The attitude is off by more than a radian, Ω by more than itself, or either not finite.
    Diverged,
    /// The method returned an error.
    Failed,
}

impl Status {
    /// The word in the tables.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Floor => "floor",
            Self::Diverged => "diverged",
            Self::Failed => "failed",
        }
    }
}

/// One run of one method on one problem, asked for its end alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The problem's name.
    pub problem: String,
    /// The method's name.
    pub method: String,
    /// Step (s) or tolerance; 0 for the closed form, which has neither.
    pub parameter: f64,
    /// Angle between the attitudes at the end, rad; infinite where the run failed.
    pub error_attitude: f64,
    /// |ΔΩ|/|Ω| at the end; infinite likewise.
    pub error_omega: f64,
    /// Evaluations of the right-hand side, or of what the method lives by.
    pub evaluations: u64,
    /// Steps.
    pub steps: u64,
    /// Time, s, if it was taken.
    pub seconds: Option<f64>,
    /// What became of it.
    pub status: Status,
}

/// One run of a method at one effort: errors against the truth, and cost.
pub fn measure(problem: &Problem, candidate: &Candidate, effort: Effort) -> Measurement {
    let (Effort::Step(parameter) | Effort::Tolerance(parameter)) = effort;
    let mut found = Measurement {
        problem: problem.name().to_owned(),
        method: candidate.name().to_owned(),
        parameter,
        error_attitude: f64::INFINITY,
        error_omega: f64::INFINITY,
        evaluations: 0,
        steps: 0,
        seconds: None,
        status: Status::Failed,
    };
    let course = candidate
        .method()
        .follow(problem.start(), &[problem.end()], effort);
    if let Ok(course) = course
        && let [end] = course.phases[..]
    {
        let apart = problem.last().apart(&end, problem.moments());
        found.error_attitude = apart.attitude;
        found.error_omega = apart.omega;
        found.evaluations = course.cost.evaluations;
        found.steps = course.cost.steps;
        // A radian off is no answer, nor is all of the angular velocity.
        found.status = if apart.attitude <= 1.0 && apart.omega <= 1.0 {
            Status::Ok
        } else {
            Status::Diverged
        };
    }
    found
}

/// [`measure`], and the least time of repeated runs; one that fails has none.
pub fn timed(problem: &Problem, candidate: &Candidate, effort: Effort) -> Measurement {
    let mut found = measure(problem, candidate, effort);
    if found.status != Status::Failed {
        let (method, end) = (candidate.method(), [problem.end()]);
        // What it returns has been judged.
        let time = stopwatch::least(|| drop(method.follow(problem.start(), &end, effort)));
        found.seconds = Some(time);
    }
    found
}

/// The largest errors at all samples of a run that is asked for them all.
///
/// # Errors
/// Those of the method.
pub fn along_the_run(problem: &Problem, candidate: &Candidate, effort: Effort) -> Result<Apart> {
    let course = candidate
        .method()
        .follow(problem.start(), &problem.times(), effort)?;
    let none = Apart {
        attitude: 0.0,
        omega: 0.0,
    };
    let pairs = problem.truth().iter().zip(&course.phases);
    Ok(pairs.fold(none, |worst, (sample, phase)| {
        let apart = sample.apart(phase, problem.moments());
        Apart {
            attitude: worst.attitude.max(apart.attitude),
            omega: worst.omega.max(apart.omega),
        }
    }))
}

/// A method from coarse to fine, until rounding stops it or `run` has enough.
///
/// `run` sees what has been measured so far and the next effort, and measures it, or gives nothing and ends the sweep. Runs that gained nothing
/// on a coarser one are marked as [`Status::Floor`].
pub fn sweep(
    candidate: &Candidate,
    mut run: impl FnMut(&[Measurement], Effort) -> Option<Measurement>,
) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for &effort in candidate.efforts() {
        let Some(row) = run(&rows, effort) else {
            break;
        };
        rows.push(row);
        let in_vain = (0..rows.len()).rev().take_while(|&n| no_gain(&rows, n));
        if in_vain.count() >= vain_runs(effort) {
            break;
        }
    }
    for place in 1..rows.len() {
        let never = (place..rows.len()).all(|later| no_gain(&rows, later));
        if never && rows[place].status != Status::Failed {
            rows[place].status = Status::Floor;
        }
    }
    rows
}

/// How many runs without a gain in a row end a sweep: a short run may take the same few steps for tolerances two decades apart.
const fn vain_runs(effort: Effort) -> usize {
    match effort {
        Effort::Step(_) => 2,
        Effort::Tolerance(_) => 5,
    }
}

/// Whether the run at `place` is not better than all coarser ones by a fifth, one of which is within the reach of rounding.
///
/// A finer effort is one by a quarter at least, so that the error of a method of order 2 falls to 0.57 of what it was: less gain than that
/// to 0.8 is none. Errors above 1e-6 may be those of steps too long for the method to be of any order, and happen to be small.
fn no_gain(rows: &[Measurement], place: usize) -> bool {
    let best = rows[..place]
        .iter()
        .map(|row| row.error_attitude)
        .fold(f64::INFINITY, f64::min);
    let row = &rows[place];
    best < 1e-6 && row.error_attitude > 0.8 * best
}
