//! How wrong a method is, and what that has cost.

use super::candidate::Candidate;
use super::problem::Problem;
use super::sample::Apart;
use crate::integrators::Effort;
use crate::integrators::geometric::Course;

/// Where the errors are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judged {
    /// At the end of the run alone.
    AtTheEnd,
    /// Also at every sample, by a second run: the end of the first is not disturbed by steps to the samples.
    AlongTheRun,
}

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

/// One run of one method on one problem.
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
    /// The largest of the first at all samples, if they were asked for.
    pub largest_attitude: Option<f64>,
    /// The largest of the second.
    pub largest_omega: Option<f64>,
    /// Evaluations of the right-hand side, or of what the method lives by, on the way to the end.
    pub evaluations: u64,
    /// Steps on the way to the end.
    pub steps: u64,
    /// Time to the end, if there was a clock.
    pub seconds: Option<f64>,
    /// What became of it.
    pub status: Status,
}

/// Measures how long it takes to call what it is given, by calling it as often as it likes; `None` if it does not care to.
pub type Clock<'a> = dyn FnMut(&mut dyn FnMut()) -> Option<f64> + 'a;

/// One run of a method at one effort: errors against the truth, cost, and time by the clock.
///
/// Errors at the end, cost and time belong to a run that is asked for the end alone. A run that fails has no time.
pub fn measure(
    problem: &Problem,
    candidate: &Candidate,
    effort: Effort,
    judged: Judged,
    clock: &mut Clock<'_>,
) -> Measurement {
    let method = candidate.method();
    let end = [problem.end()];
    let parameter = match effort {
        Effort::Step(x) | Effort::Tolerance(x) => x,
    };
    let mut found = Measurement {
        problem: problem.name().to_owned(),
        method: candidate.name().to_owned(),
        parameter,
        error_attitude: f64::INFINITY,
        error_omega: f64::INFINITY,
        largest_attitude: None,
        largest_omega: None,
        evaluations: 0,
        steps: 0,
        seconds: None,
        status: Status::Failed,
    };
    let follow = || method.follow(problem.start(), &end, effort);
    let mut last = None;
    let seconds = clock(&mut || last = Some(follow()));
    let Ok(course) = last.unwrap_or_else(follow) else {
        return found;
    };
    found.seconds = seconds;
    let [apart] = errors(problem, &course, problem.truth().len() - 1)[..] else {
        return found;
    };
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
    if judged == Judged::AlongTheRun
        && let Ok(course) = method.follow(problem.start(), &problem.times(), effort)
    {
        let all = errors(problem, &course, 0);
        let most = |of: fn(&Apart) -> f64| all.iter().map(of).fold(0.0, f64::max);
        found.largest_attitude = Some(most(|a| a.attitude));
        found.largest_omega = Some(most(|a| a.omega));
    }
    found
}

/// Errors of the phases of a run, of which the first belongs to sample number `first`.
fn errors(problem: &Problem, course: &Course, first: usize) -> Vec<Apart> {
    let samples = problem.truth().iter().skip(first);
    let pairs = samples.zip(&course.phases);
    pairs
        .map(|(sample, phase)| sample.apart(phase, problem.moments()))
        .collect()
}

/// A method from coarse to fine, until rounding stops it or `more` says no to the next effort.
///
/// `more` sees what has been measured so far. Runs that gained nothing on a coarser one are marked as [`Status::Floor`].
pub fn sweep(
    problem: &Problem,
    candidate: &Candidate,
    judged: Judged,
    clock: &mut Clock<'_>,
    more: &mut dyn FnMut(&[Measurement], Effort) -> bool,
) -> Vec<Measurement> {
    let mut rows = Vec::new();
    for &effort in candidate.efforts() {
        if !more(&rows, effort) {
            break;
        }
        rows.push(measure(problem, candidate, effort, judged, clock));
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
