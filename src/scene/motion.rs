//! What a scene gives back: states at the times asked for, what they have cost, and the ledger.

use super::budget::{Budget, Progress};
use super::plan::{Choice, Plan};
use crate::conservation::{Law, Ledger, Value};
use crate::error::{Error, Result, finite, within};
use crate::integrators::{Cost, Effort, GeneralMethods};

/// What is asked of a scene: when, how well, and by which solver.
#[derive(Debug, Clone)]
pub struct Request {
    times: Vec<f64>,
    /// The one furthest from the start, s.
    pub(super) furthest: f64,
    /// The relative accuracy asked for; infinite where one run is.
    pub(super) accuracy: f64,
    /// The effort of the one run that is asked for; none where runs are to vouch for each other.
    pub(super) effort: Option<Effort>,
    /// Who chooses the solver.
    pub(super) choice: Choice,
    most: u64,
    progress: Option<Progress>,
    methods: Option<&'static dyn GeneralMethods>,
}

impl Request {
    /// The same at other times.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// let request = Request::at([0.0, 1.0])?.to_accuracy(1e-6)?;
    /// assert_eq!(request.of_times(&[0.5])?.times(), [0.5]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn of_times(&self, times: &[f64]) -> Result<Self> {
        let Self {
            times, furthest, ..
        } = Self::at(times)?;
        Ok(Self {
            times,
            furthest,
            ..self.clone()
        })
    }

    /// States at these times (s, any order), to a relative accuracy of 1e-10, by the solver that the scene's plan picks.
    ///
    /// # Errors
    /// [`Error::Empty`]; [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// assert_eq!(Request::at([0.0, 1.0])?.times(), [0.0, 1.0]);
    /// assert!(Request::at([]).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(times: impl Into<Vec<f64>>) -> Result<Self> {
        let times = times.into();
        if times.is_empty() {
            return Err(Error::Empty {
                quantity: "the list of times",
            });
        }
        for &t in &times {
            finite("the time", t)?;
        }
        Ok(Self {
            furthest: furthest(&times),
            times,
            accuracy: 1e-10,
            effort: None,
            choice: Choice::Auto,
            most: Self::MOST_EVALUATIONS,
            progress: None,
            methods: None,
        })
    }

    /// The same to another relative accuracy.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside 1e-15 … 0.1.
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// assert!(Request::at([1.0])?.to_accuracy(1e-6).is_ok());
    /// assert!(Request::at([1.0])?.to_accuracy(0.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn to_accuracy(mut self, accuracy: f64) -> Result<Self> {
        within("the accuracy", accuracy, 1e-15, 0.1)?;
        (self.accuracy, self.effort) = (accuracy, None);
        Ok(self)
    }

    /// The same in one run at this effort, for which nothing vouches: its error estimate is infinite, no accuracy is asked for and no ledger judged.
    /// Closed forms have no use for the effort and tell their error as ever.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::{integrators::Effort, scene::{Request, Scene, effects::AirDrag, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let dragged = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.with(AirDrag::new(0.01)?)?;
    /// let motion = dragged.simulate(&Request::at([1.0])?.in_one_run(Effort::Tolerance(1e-8)))?;
    /// // Nothing vouches for one run.
    /// assert_eq!(motion.error_estimate, f64::INFINITY);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn in_one_run(mut self, effort: Effort) -> Self {
        (self.accuracy, self.effort) = (f64::INFINITY, Some(effort));
        self
    }

    /// The same by this solver.
    ///
    /// ```
    /// use spinning_bodies::scene::{Choice, Request};
    /// let request = Request::at([1.0])?.by(Choice::Auto);
    /// assert_eq!(request.times(), [1.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn by(mut self, choice: Choice) -> Self {
        self.choice = choice;
        self
    }

    /// The evaluations of its equations that a run is given if nothing else is said; observed, 3 to 30 seconds of computing.
    pub const MOST_EVALUATIONS: u64 = 200_000_000;

    /// The same with another budget of evaluations.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Request, Scene, effects::AirDrag, top::{Body, Start, Top}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// // Ten evaluations are too few for a second of friction.
    /// let dragged = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.with(AirDrag::new(0.01)?)?;
    /// assert!(dragged.simulate(&Request::at([1.0])?.within(10)).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn within(mut self, evaluations: u64) -> Self {
        self.most = evaluations;
        self
    }

    /// The same with someone who watches.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Progress, Request, Scene, top::{Body, Start, Top}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let progress = Progress::default();
    /// Top::new(Body::new([1.0, 2.0, 3.0])?, start)?.simulate(&Request::at([1.0, 5.0])?.within(100).watched(&progress))?;
    /// assert_eq!(progress.reached().evaluations, 2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn watched(mut self, progress: &Progress) -> Self {
        self.progress = Some(progress.clone());
        self
    }

    /// The same with general methods at hand, for those who ask for one of them by its name: the library has none.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::{AnyLeg, Effort, GeneralMethods, Method, Passage};
    /// use spinning_bodies::scene::{Choice, Request, Scene, Solver, top::{Body, Start, Top}};
    /// use spinning_bodies::{Error, Result};
    /// /// One that refuses everything.
    /// #[derive(Debug)]
    /// struct Closed;
    /// const REFUSED: Error = Error::Solver { condition: "the shop is closed" };
    /// impl GeneralMethods for Closed {
    ///     fn follow(&self, _: Method, _: &AnyLeg<'_>, _: Effort) -> Result<Passage<Vec<f64>>> {
    ///         Err(REFUSED)
    ///     }
    /// }
    /// let start = Start::with_omega(BodyVector::new(0.0, 1.0, 2.0), Attitude::identity());
    /// let top = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?;
    /// let asked = Request::at([1.0])?.by(Choice::Use(Solver::General(Method::Rk4)));
    /// assert_eq!(top.simulate(&asked.with_methods(&Closed)).err(), Some(REFUSED));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with_methods(mut self, methods: &'static dyn GeneralMethods) -> Self {
        self.methods = Some(methods);
        self
    }

    /// # Errors
    /// [`Error::Solver`] if the request brings none.
    pub(super) fn methods(&self) -> Result<&'static dyn GeneralMethods> {
        self.methods.ok_or(Error::Solver {
            condition: "the solver must be of the library, that is exact, events, dormand-prince-8 or, for tops, a geometric one: rk4, dopri5, dop853, verner98 and gauss come with a request that brings them",
        })
    }

    /// What a run of it may cost, and who watches.
    pub(crate) fn budget(&self) -> Budget {
        Budget::new(self.most, self.furthest, self.progress.as_ref())
    }

    /// A hundredth of that, which nobody watches.
    pub(crate) fn moment(&self) -> Budget {
        Budget::new(self.most / 100, self.furthest, None)
    }

    /// The times, s.
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// assert_eq!(Request::at([1.0, -3.0])?.times(), [1.0, -3.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The refusal of a motion whose error is this, and whose start has grown so many times.
    pub(super) fn amplified(&self, reached: f64, growth: f64) -> Error {
        Error::Amplified {
            asked: self.accuracy,
            reached,
            growth,
        }
    }

    /// # Errors
    /// [`Error::OutOfRange`] for a time before the start, of a scene that cannot be run backward.
    pub(super) fn forward(&self) -> Result<()> {
        let first = self.times.iter().copied().fold(0.0, f64::min);
        let what = "the time of a scene that cannot be run backward";
        within(what, first, 0.0, f64::INFINITY).map(|_| ())
    }
}

/// A motion, at the times asked for.
#[derive(Debug, Clone)]
pub struct Motion<S> {
    /// The solver that ran, and why.
    pub plan: Plan,
    /// What it has cost.
    pub cost: Cost,
    /// By how much the states may be off: the most over attitude (radians) and angular velocity (relative to the fastest). Infinite where nothing vouches
    /// for them.
    pub error_estimate: f64,
    /// What the scene conserves, or may only lose or gain, and by how much it failed to.
    pub ledger: Ledger,
    /// Time (s) and state, in the order asked for.
    pub rows: Vec<(f64, S)>,
}

/// A motion whose books are open: one after the other it is told what it conserves, or may only lose or gain.
pub(crate) struct Books<S> {
    motion: Motion<S>,
    /// So many rows are read at most.
    most: usize,
    /// Those, in the order of time, once the first is read.
    order: Vec<usize>,
}

impl<S> Books<S> {
    /// What the solver of a plan has cost, by how much its states may be off, and these, at the times of a request.
    pub fn of(
        request: &Request,
        plan: Plan,
        (cost, error_estimate): (Cost, f64),
        states: impl IntoIterator<Item = S>,
    ) -> Self {
        let motion = Motion {
            plan,
            cost,
            error_estimate,
            ledger: Ledger::new(),
            rows: request.times.iter().copied().zip(states).collect(),
        };
        Self {
            motion,
            most: usize::MAX,
            order: Vec::new(),
        }
    }

    /// The same of at most so many of its rows, evenly chosen, and the last.
    pub fn reading(mut self, most: usize) -> Self {
        self.most = most;
        self
    }

    fn order(&mut self) -> &[usize] {
        if self.order.is_empty() {
            let rows = &self.motion.rows;
            let last = rows.len() - 1;
            let chosen = (0..last).step_by(rows.len().div_ceil(self.most));
            self.order.extend(chosen.chain([last]));
            let times = |&i: &usize, &j: &usize| rows[i].0.total_cmp(&rows[j].0);
            self.order.sort_by(times);
        }
        &self.order
    }

    /// Its states.
    pub fn states(&self) -> impl Iterator<Item = &S> {
        self.motion.rows.iter().map(|(_, state)| state)
    }

    /// The earliest state that is read.
    pub fn earliest(&mut self) -> &S {
        let earliest = self.order()[0];
        &self.motion.rows[earliest].1
    }

    /// A quantity by its name and law and the scale of its drift (0: any will do), its value at the start, and that of a state by its place.
    pub fn keep<V: Into<Value>>(
        &mut self,
        account: (&'static str, Law, f64),
        start: V,
        of: impl Fn(usize, &S) -> V,
    ) -> Result<()> {
        self.order();
        let Motion { rows, ledger, .. } = &mut self.motion;
        let read = self.order.iter().map(|&place| of(place, &rows[place].1));
        ledger.keep(account, start, read)
    }

    /// One that keeps its value.
    pub fn conserved<V: Into<Value>>(
        &mut self,
        name: &'static str,
        scale: f64,
        start: V,
        of: impl Fn(usize, &S) -> V,
    ) -> Result<()> {
        self.keep((name, Law::Conserved, scale), start, of)
    }

    /// The motion, if its error is within the accuracy asked for and the books balance.
    ///
    /// # Errors
    /// [`Error::Amplified`], [`Error::Ledger`].
    pub fn closed(self, request: &Request) -> Result<Motion<S>> {
        let mut motion = self.motion;
        let reached = motion.error_estimate;
        // An error that is not a number must not pass for a small one.
        if reached <= request.accuracy {
            motion.ledger = balanced(motion.ledger, request.accuracy)?;
            return Ok(motion);
        }
        Err(request.amplified(reached, reached / f64::EPSILON))
    }
}

/// The time furthest from the start.
pub(crate) fn furthest(times: &[f64]) -> f64 {
    let further = |a: f64, &b: &f64| if b.abs() > a.abs() { b } else { a };
    times.iter().fold(0.0, further)
}

/// The ledger, if every drift in it is within what the accuracy asked for allows: 100 times the accuracy, and never less than 1e-11.
///
/// An error that a solver makes within its accuracy drives a conserved quantity off by about as much; the factor leaves room for
/// quantities that depend on the state more steeply than in proportion.
///
/// # Errors
/// [`Error::Ledger`] names the quantity that drifted most.
///
/// ```
/// use spinning_bodies::{conservation::{Law, Ledger}, scene::balanced};
/// let mut ledger = Ledger::new();
/// let energy = ledger.open("energy", Law::Conserved, 1.0)?;
/// ledger.record(energy, 1.0 + 1e-9)?;
/// assert!(balanced(ledger.clone(), 1e-10).is_ok() && balanced(ledger, 1e-12).is_err());
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn balanced(ledger: Ledger, accuracy: f64) -> Result<Ledger> {
    let allowed = (100.0 * accuracy).max(1e-11);
    let worst = ledger
        .entries()
        .iter()
        .max_by(|a, b| a.relative_drift().total_cmp(&b.relative_drift()));
    match worst {
        Some(entry) if entry.relative_drift() > allowed => Err(Error::Ledger {
            quantity: entry.name,
            drift: entry.relative_drift(),
            allowed,
        }),
        _ => Ok(ledger),
    }
}
