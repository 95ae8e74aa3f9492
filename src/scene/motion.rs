//! Requests to a scene, and the motion it returns: states at the requested times, their cost, and the ledger.

use super::budget::{Budget, Progress};
use super::plan::{Choice, Plan};
use crate::conservation::{Law, Ledger, Value};
use crate::error::{Error, Result, each_finite, not_empty, within};
use crate::integrators::{Cost, Effort, GeneralMethods};
use crate::search::ascending;

/// A request to a scene: at which times, how accurately, and by which solver.
#[derive(Debug, Clone)]
pub struct Request {
    times: Vec<f64>,
    /// The time furthest from the start, s.
    pub(super) furthest: f64,
    /// The requested relative accuracy; infinite for a single run.
    pub(super) accuracy: f64,
    /// The effort of a single run; `None` where two runs are compared.
    pub(super) effort: Option<Effort>,
    /// Which solver is chosen, and by whom.
    pub(super) choice: Choice,
    most: u64,
    progress: Option<Progress>,
    methods: Option<&'static dyn GeneralMethods>,
}

impl Request {
    /// The same request at other times.
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
        let (mut other, at) = (self.clone(), Self::at(times)?);
        (other.times, other.furthest) = (at.times, at.furthest);
        Ok(other)
    }

    /// A request for states at these times (s, any order), to a relative accuracy of 1e-10, by the solver of the scene's plan.
    ///
    /// # Errors
    /// [`Error::Empty`]; [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// assert_eq!(Request::at([0.0, 1.0])?.times(), [0.0, 1.0]);
    /// assert!(Request::at([]).is_err());
    /// // Ten seconds, in a hundred equal steps.
    /// let evenly: Vec<f64> = (0..=100).map(|k| f64::from(k) / 10.0).collect();
    /// assert_eq!(Request::at(evenly)?.times().len(), 101);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(times: impl Into<Vec<f64>>) -> Result<Self> {
        let times = times.into();
        not_empty("the list of times", &times)?;
        each_finite("the time", times.iter().copied())?;
        let further = |a: f64, &b: &f64| if b.abs() > a.abs() { b } else { a };
        Ok(Self {
            furthest: times.iter().fold(0.0, further),
            times,
            accuracy: 1e-10,
            effort: None,
            choice: Choice::Auto,
            most: Self::MOST_EVALUATIONS,
            progress: None,
            methods: None,
        })
    }

    /// Asks for another relative accuracy.
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

    /// Asks for a single run at this effort, without a comparison: its error estimate is infinite, no accuracy is required and the ledger is not checked.
    /// Closed forms ignore the effort and estimate their error as usual.
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

    /// Chooses the solver.
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

    /// The default budget of a simulation, in evaluations of the equations; observed, 3 to 30 seconds of computing.
    pub const MOST_EVALUATIONS: u64 = 200_000_000;

    /// Sets another budget of evaluations.
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

    /// Reports its progress to `progress` while it runs.
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

    /// Adds general methods, which the library itself does not have, so that a request can choose one by name.
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
    /// [`Error::Solver`] if the request has none.
    pub(super) fn methods(&self) -> Result<&'static dyn GeneralMethods> {
        self.methods.ok_or(Error::Solver {
            condition: "the solver must be of the library, that is exact, events, dormand-prince-8 or, for tops, power-series or a geometric one: rk4, dopri5, dop853, verner98 and gauss come with a request that brings them",
        })
    }

    /// The budget of a simulation, with its progress.
    pub(crate) fn budget(&self) -> Budget {
        Budget::new(self.most, self.furthest, self.progress.as_ref())
    }

    /// The same request with this fraction of the budget, one over `part`, without progress.
    pub(super) fn briefly(&self, part: u64) -> Self {
        Self {
            most: self.most / part,
            progress: None,
            ..self.clone()
        }
    }

    /// The requested times, s.
    ///
    /// ```
    /// use spinning_bodies::scene::Request;
    /// assert_eq!(Request::at([1.0, -3.0])?.times(), [1.0, -3.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The error for a motion with this error estimate, a change of whose start has grown by this factor.
    pub(super) fn amplified(&self, reached: f64, growth: f64) -> Error {
        Error::Amplified {
            asked: self.accuracy,
            reached,
            growth,
        }
    }

    /// # Errors
    /// [`Error::OutOfRange`] for a time before the start, for a scene that cannot be run backward.
    pub(super) fn forward(&self) -> Result<()> {
        let first = self.times.iter().copied().fold(0.0, f64::min);
        let what = "the time of a scene that cannot be run backward";
        within(what, first, 0.0, f64::INFINITY).map(|_| ())
    }
}

/// A motion at the requested times.
#[derive(Debug, Clone)]
pub struct Motion<S> {
    /// The solver that ran, and why.
    pub plan: Plan,
    /// The cost.
    pub cost: Cost,
    /// Estimated error of the states: the greatest over attitude (radians) and angular velocity (relative to the fastest). Infinite for a single run
    /// without a comparison.
    pub error_estimate: f64,
    /// The quantities that the scene conserves, or may only lose or gain, and how far the states violate that.
    pub ledger: Ledger,
    /// Time (s) and state, in the order of the request.
    pub rows: Vec<(f64, S)>,
}

/// A motion with an open ledger, to which the conserved and monotone quantities are added one by one.
pub(crate) struct OpenLedger<S> {
    motion: Motion<S>,
    /// The places of the rows read for the ledger, in the order of time.
    order: Vec<usize>,
}

impl<S> OpenLedger<S> {
    /// The open ledger of a motion: the solver's cost, the error estimate, and the states at the requested times.
    pub fn of(
        request: &Request,
        plan: Plan,
        (cost, error_estimate): (Cost, f64),
        states: &mut dyn Iterator<Item = S>,
    ) -> Self {
        let times = &request.times;
        let order = ascending(Vec::from_iter(0..times.len()), times);
        let motion = Motion {
            plan,
            cost,
            error_estimate,
            ledger: Ledger::new(),
            rows: times.iter().copied().zip(states).collect(),
        };
        Self { motion, order }
    }

    /// The same, reading at most this many rows, evenly chosen, and the last.
    pub fn reading(mut self, most: usize) -> Self {
        let every = self.order.len().div_ceil(most);
        let last = self.order.pop();
        self.order = self.order.into_iter().step_by(every).chain(last).collect();
        self
    }

    /// The greatest of these numbers, each from the place of a row and its state, and of `least`.
    pub fn greatest(&self, least: f64, of: impl Fn(usize, &S) -> f64) -> f64 {
        let rows = self.motion.rows.iter().enumerate();
        let numbers = rows.map(|(place, (_, state))| of(place, state));
        numbers.fold(least, f64::max)
    }

    /// The earliest state read for the ledger.
    pub fn earliest(&self) -> &S {
        &self.motion.rows[self.order[0]].1
    }

    /// Adds a quantity: its name, its law and the scale of its drift (1 in place of 0), its value at the start, and its value for the row at a place.
    pub fn keep<V: Into<Value> + Copy>(
        &mut self,
        (name, law, scale): (&'static str, Law, f64),
        start: V,
        of: impl Fn(usize, &S) -> V,
    ) -> Result<()> {
        let Motion { rows, ledger, .. } = &mut self.motion;
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let account = ledger.push(name, law, start, scale)?;
        for &place in &self.order {
            ledger.record(account, of(place, &rows[place].1))?;
        }
        Ok(())
    }

    /// Adds a quantity that is conserved.
    pub fn conserved<V: Into<Value> + Copy>(
        &mut self,
        name: &'static str,
        scale: f64,
        start: V,
        of: impl Fn(usize, &S) -> V,
    ) -> Result<()> {
        self.keep((name, Law::Conserved, scale), start, of)
    }

    /// The motion, if its error is within the requested accuracy and the ledger balances.
    ///
    /// # Errors
    /// [`Error::Amplified`], [`Error::Ledger`].
    pub fn closed(self, request: &Request) -> Result<Motion<S>> {
        let mut motion = self.motion;
        let reached = motion.error_estimate;
        // Not `>`: an error that is not a number must not pass.
        if reached <= request.accuracy {
            motion.ledger = balanced(motion.ledger, request.accuracy)?;
            return Ok(motion);
        }
        Err(request.amplified(reached, reached / f64::EPSILON))
    }
}

/// The ledger, if every drift is within 100 times the requested accuracy, or within 1e-11 if that is more.
///
/// An error within the accuracy changes a conserved quantity by about as much; the factor leaves room for quantities that depend more steeply on
/// the state.
///
/// # Errors
/// [`Error::Ledger`] with the quantity that drifted most.
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
