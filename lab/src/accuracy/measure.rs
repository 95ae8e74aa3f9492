//! The error of a method, and its cost.

use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::integrators::{Cost, Effort, Solution};
use spinning_bodies::{Error, Result};

use super::candidate::Candidate;
use super::problem::Problem;
use super::sample::Apart;
use crate::stopwatch;

/// The outcome of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// The error would decrease with more effort.
    Ok,
    /// Rounding: more effort than a coarser run without gain, or an error no greater than that of the truth. Only [`Trial::sweep`] can recognise it.
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
    /// Angle between the attitudes at the end, rad; infinite if the run failed, NaN if there is no attitude.
    pub error_attitude: f64,
    /// |ΔΩ|/|Ω| at the end, or for motions other than tops as [`Apart`] defines it; infinite if the run failed.
    pub error_omega: f64,
    /// Evaluations of the right-hand side, or of what the method evaluates instead.
    pub evaluations: u64,
    /// Steps.
    pub steps: u64,
    /// Time, s, if it was measured.
    pub seconds: Option<f64>,
    /// The outcome.
    pub status: Status,
    /// The error, if it failed.
    pub failure: Option<Error>,
}

impl Measurement {
    /// The error of the attitude or, without an attitude, that of the rates.
    pub const fn error(&self) -> f64 {
        if self.error_attitude.is_nan() {
            self.error_omega
        } else {
            self.error_attitude
        }
    }
}

/// One method on one motion, of any kind: how it is run, and how its error is found.
pub struct Trial<'a, E> {
    /// The names of motion and method.
    pub names: [&'a str; 2],
    /// The efforts at which the method is run, from coarse to fine.
    pub efforts: &'a [Effort],
    /// Errors below this cannot be distinguished from the error of the truth.
    pub floor: f64,
    /// The errors of a run that failed.
    pub lost: Apart,
    /// The end of the motion at one effort, and its cost.
    pub run: Box<dyn Fn(Effort) -> Result<(E, Cost)> + 'a>,
    /// The distance of such an end from the truth.
    pub apart: Box<dyn Fn(&E) -> Apart + 'a>,
}

impl<E> core::fmt::Debug for Trial<'_, E> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Trial")
            .field("names", &self.names)
            .finish_non_exhaustive()
    }
}

impl<'a> Trial<'a, Solution<Phase>> {
    /// The trial of this method on this problem.
    pub fn of(problem: &'a Problem, candidate: &'a Candidate) -> Self {
        Self {
            names: [problem.name(), &candidate.name],
            efforts: &candidate.efforts,
            floor: 0.0,
            lost: Apart {
                attitude: f64::INFINITY,
                omega: f64::INFINITY,
            },
            run: Box::new(|effort| {
                let times = [problem.end()];
                let course = candidate.method.follow(problem.start(), &times, effort)?;
                let cost = course.cost;
                Ok((course, cost))
            }),
            apart: Box::new(|course| problem.last().apart(&course.states[0], problem.moments())),
        }
    }
}

impl<E> Trial<'_, E> {
    /// One run at one effort: errors against the truth, and cost.
    pub fn measure(&self, effort: Effort) -> Measurement {
        let (Effort::Step(parameter) | Effort::Tolerance(parameter)) = effort;
        let [problem, method] = self.names.map(str::to_owned);
        let mut found = Measurement {
            problem,
            method,
            parameter,
            error_attitude: self.lost.attitude,
            error_omega: self.lost.omega,
            evaluations: 0,
            steps: 0,
            seconds: None,
            status: Status::Failed,
            failure: None,
        };
        match (self.run)(effort) {
            Ok((end, cost)) => {
                let Apart { attitude, omega } = (self.apart)(&end);
                (found.error_attitude, found.error_omega) = (attitude, omega);
                (found.evaluations, found.steps) = (cost.evaluations, cost.steps);
                // An error of a radian, or of the whole angular velocity, is not a result.
                found.status = if attitude > 1.0 || omega > 1.0 {
                    Status::Diverged
                } else {
                    Status::Ok
                };
            }
            Err(error) => found.failure = Some(error),
        }
        found
    }

    /// As [`measure`](Self::measure), with the least time of repeated runs, unless the run fails.
    pub fn timed(&self, effort: Effort) -> Measurement {
        let mut found = self.measure(effort);
        if found.status != Status::Failed {
            // The result was judged above.
            found.seconds = Some(stopwatch::least(|| drop((self.run)(effort))));
        }
        found
    }

    /// Measures the method from coarse to fine, until rounding stops it or `run` ends the sweep.
    ///
    /// `run` gets the measurements so far and the next effort, and measures it, or returns `None` to end the sweep. Runs that gained nothing
    /// over a coarser one, or whose error is no greater than that of the truth, are marked as [`Status::Floor`].
    pub fn sweep(
        &self,
        mut run: impl FnMut(&[Measurement], Effort) -> Option<Measurement>,
    ) -> Vec<Measurement> {
        let mut rows = Vec::new();
        for &effort in self.efforts {
            let Some(row) = run(&rows, effort) else {
                break;
            };
            rows.push(row);
            let places = (0..rows.len()).rev();
            let in_vain = places.take_while(|&place| self.no_gain(&rows, place));
            if in_vain.count() >= vain_runs(effort) {
                break;
            }
        }
        for place in 0..rows.len() {
            let never = || (place..rows.len()).all(|later| self.no_gain(&rows, later));
            if rows[place].status == Status::Ok && (rows[place].error() <= self.floor || never()) {
                rows[place].status = Status::Floor;
            }
        }
        rows
    }

    /// Whether the run at `place` is at the floor: its error is not distinguishable from that of the truth, or it is not smaller by a fifth than those of all coarser
    /// runs, one of which is within the reach of rounding.
    ///
    /// Each effort is finer by at least a quarter, by which the error of a method of order 2 falls to 0.57: a fall to more than 0.8 is no gain.
    /// Errors above 1e-6, or far above the floor, may belong to steps too long for the order to show, and may be small by chance.
    fn no_gain(&self, rows: &[Measurement], place: usize) -> bool {
        let errors = rows[..place].iter().map(Measurement::error);
        let best = errors.fold(f64::INFINITY, f64::min);
        let reach = if self.floor > 0.0 {
            (FAR * self.floor).min(REACH)
        } else {
            REACH
        };
        best <= self.floor || best < reach && rows[place].error() > 0.8 * best
    }
}

/// Greatest error that rounding may cause, and greatest multiple of the floor.
const REACH: f64 = 1e-6;
const FAR: f64 = 1e5;

/// One run of a method at one effort: errors against the truth, and cost.
pub fn measure(problem: &Problem, candidate: &Candidate, effort: Effort) -> Measurement {
    Trial::of(problem, candidate).measure(effort)
}

/// The largest errors over all samples of a run that returns them all.
///
/// # Errors
/// Those of the method.
pub fn along_the_run(problem: &Problem, candidate: &Candidate, effort: Effort) -> Result<Apart> {
    let course = candidate
        .method
        .follow(problem.start(), &problem.times(), effort)?;
    let none = Apart {
        attitude: 0.0,
        omega: 0.0,
    };
    let pairs = problem.truth().iter().zip(&course.states);
    Ok(pairs.fold(none, |worst, (sample, phase)| {
        let apart = sample.apart(phase, problem.moments());
        Apart {
            attitude: worst.attitude.max(apart.attitude),
            omega: worst.omega.max(apart.omega),
        }
    }))
}

/// Number of successive runs without a gain that ends a sweep: a short run may take the same few steps for tolerances two decades apart.
const fn vain_runs(effort: Effort) -> usize {
    match effort {
        Effort::Step(_) => 2,
        Effort::Tolerance(_) => 5,
    }
}
