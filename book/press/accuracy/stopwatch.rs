//! The least time of repeated runs, and a limit to patience.

use std::cell::Cell;
use std::time::Instant;

use spinning_bodies::accuracy::{Candidate, Measurement, Problem};
use spinning_bodies::integrators::Effort;

/// Whether times are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Times {
    /// Not at all; the watch still sees when patience ends.
    None,
    /// The least of repeated runs.
    Least,
}

/// A run that would take longer is left out, s.
pub const PATIENCE: f64 = 0.6;

/// Repeated runs last at least this long together, s; and not much longer than [`LONG`].
const SHORT: f64 = 0.02;
const LONG: f64 = 0.1;
/// A call to the clock costs some 30 ns: runs are bundled into lots of this length, s.
const LOT: f64 = 2e-5;
const FEWEST: u32 = 5;

/// Times the runs of one method on one problem.
#[derive(Debug)]
pub struct Stopwatch {
    times: Times,
    last: Cell<f64>,
    gave_up: Cell<bool>,
}

impl Stopwatch {
    /// A watch at zero.
    pub const fn new(times: Times) -> Self {
        Self {
            times,
            last: Cell::new(0.0),
            gave_up: Cell::new(false),
        }
    }

    /// Runs until five lots and 0.02 s are over, or 0.1 s: the time of the fastest lot, per run.
    pub fn time(&self, run: &mut dyn FnMut()) -> Option<f64> {
        let begin = Instant::now();
        run();
        let mut least = begin.elapsed().as_secs_f64();
        self.last.set(least);
        if self.times == Times::None {
            return None;
        }
        let lot = (LOT / least).clamp(1.0, 1000.0) as u32;
        let mut lots = 1;
        loop {
            let spent = begin.elapsed().as_secs_f64();
            if spent >= LONG || lots >= FEWEST && spent >= SHORT {
                break;
            }
            let start = Instant::now();
            for _ in 0..lot {
                run();
            }
            least = least.min(start.elapsed().as_secs_f64() / f64::from(lot));
            lots += 1;
        }
        self.last.set(least);
        Some(least)
    }

    /// Whether a run at the next effort is likely to take less than [`PATIENCE`]: by the last one, or by a part of the first.
    pub fn affords(
        &self,
        problem: &Problem,
        candidate: &Candidate,
        rows: &[Measurement],
        next: Effort,
    ) -> bool {
        let expected = match (rows.last(), next) {
            (None, _) => first(problem, candidate, next),
            (Some(row), Effort::Step(step)) => self.last.get() * row.parameter / step,
            // A third of a decade of tolerance costs a method of order 5 a factor 1.2.
            (Some(_), Effort::Tolerance(_)) => self.last.get() * 1.2,
        };
        let affords = expected <= PATIENCE;
        if !affords {
            self.gave_up.set(true);
        }
        affords
    }

    /// Whether an effort has been left out.
    pub const fn gave_up(&self) -> bool {
        self.gave_up.get()
    }
}

/// The time that the first run is likely to take, from a short piece of it.
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
    begin.elapsed().as_secs_f64()
        * if candidate.name() == "exact" {
            1.0
        } else {
            parts
        }
}
