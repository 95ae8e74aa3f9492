//! What a run may cost, and how far it has come.

use core::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::{Error, Result};

/// How far a run has come: the run writes, others may look, from another thread as well.
///
/// The library has no clock. Who wants to know how long a run will take looks twice. Most solvers follow a motion at least twice to know
/// their error, so the time falls back to 0 whenever they begin again.
#[derive(Debug, Clone, Default)]
pub struct Progress(Arc<Numbers>);

#[derive(Debug, Default)]
struct Numbers {
    evaluations: AtomicU64,
    most: AtomicU64,
    /// Bits of the times, s.
    time: AtomicU64,
    until: AtomicU64,
}

/// Where a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reached {
    /// Evaluations of the equations so far; a state that a closed form gives counts as one.
    pub evaluations: u64,
    /// How many there may be.
    pub most: u64,
    /// The time that the motion has reached, s.
    pub time: f64,
    /// The time that it is to reach, s.
    pub until: f64,
}

impl Progress {
    /// Where the run is now.
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
        let number = |of: &AtomicU64| of.load(Ordering::Relaxed);
        Reached {
            evaluations: number(&self.0.evaluations),
            most: number(&self.0.most),
            time: f64::from_bits(number(&self.0.time)),
            until: f64::from_bits(number(&self.0.until)),
        }
    }
}

/// The evaluations of an answer, counted over all of its runs.
pub(crate) struct Budget {
    spent: Cell<u64>,
    most: u64,
    /// Of the run that goes on: what had been spent when it began, and when it ends, s.
    run: Cell<(u64, f64)>,
    /// At the last look what the run had spent, and the time, s, that it had come to.
    seen: Cell<(u64, f64)>,
    progress: Option<Progress>,
}

/// No look before twice as many evaluations: they are a moment's work.
const A_MOMENT: u64 = 500_000;

impl Budget {
    /// Nothing done yet of a run up to this time, which may do so much.
    pub fn new(most: u64, until: f64, progress: Option<&Progress>) -> Self {
        if let Some(Progress(numbers)) = progress {
            numbers.until.store(until.to_bits(), Ordering::Relaxed);
            numbers.most.store(most, Ordering::Relaxed);
        }
        Self {
            spent: Cell::new(0),
            most,
            run: Cell::new((0, until)),
            seen: Cell::new((A_MOMENT, 0.0)),
            progress: progress.cloned(),
        }
    }

    /// A run up to this time begins.
    pub fn begin(&self, until: f64) {
        self.run.set((self.spent.get(), until));
        self.seen.set((A_MOMENT, 0.0));
    }

    /// So many evaluations more have brought the motion to this time.
    ///
    /// # Errors
    /// [`Error::Budget`] if they are too many.
    #[inline]
    pub fn spend(&self, evaluations: u64, time: f64) -> Result<()> {
        self.count(evaluations);
        self.reached(time)
    }

    #[inline]
    pub fn count(&self, evaluations: u64) {
        self.spent.set(self.spent.get() + evaluations);
    }

    /// The motion has come to this time.
    ///
    /// Whenever the run has doubled its evaluations, it is asked what the whole will take at this pace. It ends if that is as far beyond the budget
    /// as the budget is beyond what was spent: a hundredfold after a hundredth of it. The pace must be so steady that neither friction nor bounces that
    /// pile up, both of which show long before, could bring the run to its end within the budget.
    ///
    /// # Errors
    /// As for [`spend`](Self::spend).
    #[inline]
    pub fn reached(&self, time: f64) -> Result<()> {
        let evaluations = self.spent.get();
        if let Some(Progress(numbers)) = &self.progress {
            numbers.evaluations.store(evaluations, Ordering::Relaxed);
            numbers.time.store(time.to_bits(), Ordering::Relaxed);
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
            whole,
        })
    }
}

/// By which part of what is spent of the budget the pace may change between two looks. Exponential decay and rates that fall in proportion to the
/// time change it by one and by half of their own part: they would end after twice the budget or more.
const STEADY: f64 = 0.25;
