//! The evaluations that a run may take, and how far it has come.

use core::cell::Cell;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::error::{Error, Result};

/// How far a run has come. The run writes it; other threads may read it.
///
/// The library has no clock: whoever wants to know how long a run will take reads twice. Most solvers follow a motion at least twice to estimate
/// their error, and the time falls back to 0 whenever they begin again.
#[derive(Debug, Clone, Default)]
pub struct Progress(Arc<Mutex<Reached>>);

/// The progress of a run at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reached {
    /// Evaluations of the equations so far; each state given by a closed form counts as one.
    pub evaluations: u64,
    /// The greatest number of evaluations allowed.
    pub most: u64,
    /// The time that the motion has reached, s.
    pub time: f64,
    /// The last time of the motion, s.
    pub until: f64,
}

impl Progress {
    /// The present progress of the run.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Progress, Request, Scene, top::{Body, Start, Top}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let progress = Progress::default();
    /// Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.simulate(&Request::at([1.0, 5.0])?.within(100).watched(&progress))?;
    /// let reached = progress.reached();
    /// // A state of a closed form counts as one.
    /// assert_eq!((reached.evaluations, reached.most), (2, 100));
    /// assert_eq!((reached.time, reached.until), (5.0, 5.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn reached(&self) -> Reached {
        *self.locked()
    }

    /// The numbers, for reading or writing: they are valid even where a thread that wrote them has panicked.
    fn locked(&self) -> MutexGuard<'_, Reached> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The evaluations of a simulation, counted over all of its runs.
pub(crate) struct Budget {
    spent: Cell<u64>,
    most: u64,
    /// Of the present run: the evaluations spent before it began, and its end time, s.
    run: Cell<(u64, f64)>,
    /// At the last check: the evaluations of the run, and the time, s, that it had reached.
    seen: Cell<(u64, f64)>,
    progress: Option<Progress>,
}

/// The first check comes after twice as many evaluations, which take only a moment.
const A_MOMENT: u64 = 500_000;

impl Budget {
    /// A budget of `most` evaluations, none of them spent, for a first run to the time `until`.
    pub fn new(most: u64, until: f64, progress: Option<&Progress>) -> Self {
        if let Some(progress) = progress {
            let mut reached = progress.locked();
            (reached.most, reached.until) = (most, until);
        }
        Self {
            spent: Cell::new(0),
            most,
            run: Cell::new((0, until)),
            seen: Cell::new((A_MOMENT, 0.0)),
            progress: progress.cloned(),
        }
    }

    /// Begins a run to the time `until`.
    pub fn begin(&self, until: f64) {
        self.run.set((self.spent.get(), until));
        self.seen.set((A_MOMENT, 0.0));
    }

    /// Counts these evaluations, with which the motion has reached this time.
    ///
    /// # Errors
    /// [`Error::Budget`] if the budget is exceeded, or will be by far.
    #[inline]
    pub fn spend(&self, evaluations: u64, time: f64) -> Result<()> {
        self.count(evaluations);
        self.reached(time)
    }

    /// Counts these evaluations.
    #[inline]
    pub fn count(&self, evaluations: u64) {
        self.spent.set(self.spent.get() + evaluations);
    }

    /// Notes that the motion has reached this time.
    ///
    /// Whenever the run has doubled its evaluations, its total cost at this pace is extrapolated. The run ends with an error if that exceeds the
    /// budget by the factor by which the budget exceeds what was spent: a hundredfold after a hundredth of it. It must also be so steady that neither
    /// friction nor bounces that pile up, both of which change the pace long before, could bring it to its end within the budget.
    ///
    /// # Errors
    /// As for [`spend`](Self::spend).
    #[inline]
    pub fn reached(&self, time: f64) -> Result<()> {
        let evaluations = self.spent.get();
        if let Some(progress) = &self.progress {
            let mut reached = progress.locked();
            (reached.evaluations, reached.time) = (evaluations, time);
        }
        let (begun, until) = self.run.get();
        let (spent, (before, then)) = (evaluations - begun, self.seen.get());
        if evaluations <= self.most && spent < 2 * before {
            return Ok(());
        }
        self.seen.set((spent, time));
        let [now, most, earlier] = [spent, self.most, before].map(|count| count as f64);
        let whole = now * (until / time);
        let uneven = (time * earlier - then * now).abs() * most;
        let steady = uneven <= STEADY * earlier * (time * earlier).abs();
        if evaluations <= self.most && !(steady && whole * now > most * most) {
            return Ok(());
        }
        Err(Error::Budget {
            spent: evaluations.min(self.most),
            most: self.most,
            time,
            whole: begun as f64 + whole,
        })
    }
}

/// The greatest relative change of the pace between two checks, as a multiple of the fraction of the budget spent at the earlier one. Exponential decay and
/// rates that fall in proportion to the time change the pace by once and by half that fraction, and would end after twice the budget or more.
const STEADY: f64 = 0.25;
