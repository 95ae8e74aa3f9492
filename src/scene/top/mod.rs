//! Tops: a body with a fixed point under any of gravity, friction at the pivot, in the bearing and at the tip, and drag (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `equations`: the torque of each effect, and the flow that the engine follows;
//! * `closed`: the scenes with a closed form;
//! * `columns`: further columns of the states;
//! * `methods`: geometric methods for tops under gravity alone;
//! * `ledger`: what is conserved, or may only decrease;
//! * this file: the top and its effects, its state, the plan, the motion.

mod body;
mod closed;
mod columns;
mod equations;
mod ledger;
mod methods;

pub use body::{Body, Start};

pub use super::effects::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction};

use super::columns::columns;
use super::effects::Effect;
use super::engine::{Stepper, greater, to_accuracy, vouched};
use super::motion::Books;
use super::{Budget, Choice, Columns, Geometric, Motion, Plan, Request, Scene, Solver, Tabulated};
use crate::error::{Error, Result, refused};
use crate::frame::{Attitude, BodyVector};
use crate::integrators::Cost;
use crate::precise::power_of_two_below;

use closed::ClosedForm;
use equations::Turning;
use ledger::Conserved;

/// A top and the effects on it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Written")
)]
pub struct Top {
    body: Body,
    start: Start,
    gravity: Option<Gravity>,
    pivot_friction: Option<PivotFriction>,
    bearing_friction: Option<BearingFriction>,
    air_drag: Option<AirDrag>,
    tip_friction: Option<TipFriction>,
}

/// A serialised top before its effects are checked.
#[cfg(feature = "serde")]
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    body: Body,
    start: Start,
    gravity: Option<Gravity>,
    pivot_friction: Option<PivotFriction>,
    bearing_friction: Option<BearingFriction>,
    air_drag: Option<AirDrag>,
    tip_friction: Option<TipFriction>,
}

#[cfg(feature = "serde")]
impl TryFrom<Written> for Top {
    type Error = Error;

    fn try_from(written: Written) -> Result<Self> {
        let effects = [
            written.gravity.map(Effect::from),
            written.pivot_friction.map(Effect::from),
            written.bearing_friction.map(Effect::from),
            written.air_drag.map(Effect::from),
            written.tip_friction.map(Effect::from),
        ];
        let alone = Self::of_principal_axes(written.body, written.start)?;
        effects.into_iter().flatten().try_fold(alone, Self::with)
    }
}

/// A top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// The attitude.
    pub attitude: Attitude,
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// Kinetic energy plus potential energy relative to the pivot, J.
    pub energy: f64,
}

impl Tabulated for State {
    fn columns() -> Columns<Self> {
        Columns::default()
            .attitude(|state: &Self| state.attitude)
            .omega(|state| state.omega)
            .and(columns! { |state: &Self|
                "energy", "J", "kinetic energy, and of the weight above the pivot" => state.energy;
            })
    }
}

impl Top {
    /// The body without effects.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the start.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Request, Scene, top::{AirDrag, Body, Gravity, Start, Top}};
    /// let body = Body::new([2.0, 2.0, 1.0])?.with_center_of_mass(1.0, BodyVector::new(0.0, 0.0, 0.5))?;
    /// let start = Start::with_omega(BodyVector::new(0.1, 0.0, 9.0), Attitude::identity());
    /// let free = Top::new(body, start)?;
    /// let heavy = free.with(Gravity::new(9.80665)?)?;
    /// let rubbed = heavy.with(AirDrag::new(1e-3)?)?;
    /// let request = Request::at([1.0])?;
    /// assert_eq!(free.plan(&request)?.to_string(), "exact: no torque: closed form");
    /// assert_eq!(heavy.plan(&request)?.to_string(), "exact: gravity on a symmetric top: closed form");
    /// assert_eq!(rubbed.plan(&request)?.to_string(), "dormand-prince-8: air_drag: no closed form");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: Body, start: Start) -> Result<Self> {
        Self::of_principal_axes(body, start.inward(&body))
    }

    /// A top whose start is along the principal axes.
    fn of_principal_axes(body: Body, start: Start) -> Result<Self> {
        start.omega(body.moments)?;
        Ok(Self {
            body,
            start,
            gravity: None,
            pivot_friction: None,
            bearing_friction: None,
            air_drag: None,
            tip_friction: None,
        })
    }

    /// Adds an effect, or replaces its value.
    ///
    /// # Errors
    /// [`Error::Effect`] for one that has no meaning for a top. [`Error::Condition`] for tip friction unless I₁ = I₂ and C lies on the third axis, because
    /// the spin of any other body would not stay at rest; for bearing friction of a body whose own axes are not principal.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, scene::{effects::{AirDrag, TurnLoss}, top::{Body, Start, Top}}};
    /// let start = Start::with_omega(BodyVector::new(0.0, 0.0, 2.0), Attitude::identity());
    /// let free = Top::new(Body::new([1.0, 2.0, 3.0])?, start)?;
    /// assert!(free.with(AirDrag::new(1e-6)?).is_ok());
    /// assert!(free.with(TurnLoss::new(0.9)?).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Gravity(gravity) => self.gravity = Some(gravity),
            Effect::PivotFriction(friction) => self.pivot_friction = Some(friction),
            Effect::BearingFriction(_) if self.body.own.is_some() => {
                let condition = "bearing friction is for bodies whose own axes are principal axes, all three products of inertia zero";
                let angle = self.body.own.map_or(0.0, |own| own.quaternion().angle());
                return refused(condition, angle);
            }
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction),
            Effect::AirDrag(drag) => self.air_drag = Some(drag),
            Effect::TipFriction(friction) if self.body.is_symmetric_about_third() => {
                self.tip_friction = Some(friction);
            }
            Effect::TipFriction(_) => {
                let condition = "tip friction is for bodies with I1 = I2 and the centre of mass on the third axis";
                return refused(condition, self.body.moments[1] / self.body.moments[0]);
            }
            other => {
                let takes = "gravity, pivot_friction, bearing_friction, air_drag and tip_friction";
                return Err(other.refused("a top", takes));
            }
        }
        Ok(self)
    }

    /// MgC, N m: with the upward unit vector z the torque about the pivot is z∧MgC (8.1).
    fn lever(&self) -> [f64; 3] {
        let g = self.g();
        self.body.arm().map(|component| component * g)
    }

    fn g(&self) -> f64 {
        self.gravity.map_or(0.0, Gravity::value)
    }

    /// Succeeds if every axis has a moment or nothing resists: resistance excludes the closed forms, and steps need all moments.
    ///
    /// # Errors
    /// [`Error::NotPositive`].
    #[cfg(feature = "scene-files")]
    pub(super) fn can_be_resisted(&self) -> Result<()> {
        let mut resisting = self.resisting();
        resisting.try_for_each(|_| self.body.has_every_moment())
    }

    /// The names of the resistances.
    fn resisting(&self) -> impl Iterator<Item = &'static str> {
        let effects: [Option<Effect>; 4] = [
            self.pivot_friction.map(Effect::from),
            self.bearing_friction.map(Effect::from),
            self.air_drag.map(Effect::from),
            self.tip_friction.map(Effect::from),
        ];
        effects.into_iter().flatten().map(|effect| effect.name())
    }

    /// The pace, rad/s: the rate at which this top turns, or its weight would make it fall.
    fn pace(&self) -> Result<f64> {
        let omega = self.start.omega(self.body.moments)?.norm();
        Ok(omega.hypot(self.falling()).max(f64::MIN_POSITIVE))
    }

    /// The rate at which its weight would make it fall, rad/s; 0 without weight.
    fn falling(&self) -> f64 {
        let moments = self.body.moments;
        let [x, y, z] = self.lever();
        let arms = [y.hypot(z), z.hypot(x), x.hypot(y)];
        let ratio = |k: usize| {
            if moments[k] > 0.0 {
                arms[k] / moments[k]
            } else {
                0.0
            }
        };
        let ratios = [0, 1, 2].map(ratio);
        // In units of their size: their squares may leave the range of doubles.
        let unit = power_of_two_below(ratios.into_iter().fold(0.0, f64::max));
        let sum: f64 = ratios.map(|ratio| (ratio / unit).powi(2)).iter().sum();
        (2.0 * (unit * sum.sqrt())).sqrt()
    }
}

/// The most requested times at which a closed form is compared with one from a displaced start.
const OF_THE_TIMES: usize = 64;

impl Top {
    /// The plan, and the closed form if it uses one: the closed form if there is one, otherwise order 8; or the requested solver.
    fn planned(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        let resisting: Vec<&str> = self.resisting().collect();
        let cannot = |condition| Err(Error::Solver { condition });
        let closed = match request.choice {
            Choice::Auto | Choice::Use(Solver::Exact) if resisting.is_empty() => {
                ClosedForm::find(&self.body, self.g(), &self.start)?
            }
            _ => None,
        };
        let plan = match (request.choice, &closed) {
            (Choice::Auto, Some(closed)) => Plan::exact(closed.reason()),
            (Choice::Auto, None) if resisting.is_empty() => Plan::stepped(closed::NONE),
            (Choice::Auto, None) => {
                Plan::stepped(format!("{}: no closed form", resisting.join(" and ")))
            }
            (Choice::Use(Solver::Exact), None) => {
                return cannot(
                    "the solver `exact` is for scenes with a closed form, this one has none",
                );
            }
            (Choice::Use(Solver::Geometric(method)), _)
                if method != Geometric::DormandPrince8 && !resisting.is_empty() =>
            {
                return cannot(
                    "the geometric solvers are for tops under gravity alone, and dormand-prince-8 for all",
                );
            }
            (Choice::Use(Solver::Events), _) => {
                return cannot("the solver `events` is for scenes with contacts, a top has none");
            }
            (Choice::Use(solver), _) => Plan::new(solver, "asked for"),
        };
        Ok((plan, closed))
    }
}

const NEAR_A_DOUBLE_ROOT: &str = "near a double root, where the closed form refuses times as long";

impl Scene for Top {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        Ok(self.planned(request)?.0)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let mut motion = self.along_principal_axes(request)?;
        if let Some(own) = self.body.own {
            for (_, state) in &mut motion.rows {
                state.attitude = state.attitude * own.inverse();
                let outward = own.quaternion() * state.omega.components();
                state.omega = BodyVector::from_components(outward);
            }
        }
        Ok(motion)
    }

    fn further(&self) -> Columns<State> {
        columns::columns(self)
    }
}

impl Top {
    /// The motion along the principal axes.
    fn along_principal_axes(&self, request: &Request) -> Result<Motion<State>> {
        let conserved = Conserved::of(self)?;
        let (plan, closed) = self.planned(request)?;
        let Some(closed) = closed else {
            return self.stepped(plan, request, &conserved);
        };
        match self.known(plan, &closed, request, &conserved) {
            // Where the motion amplifies rounding too much, or the solution cannot be continued as far.
            Err(Error::Integration { .. } | Error::OutOfRange { .. } | Error::Amplified { .. })
                if request.choice == Choice::Auto
                    && matches!(closed, ClosedForm::Kovalevskaya(..)) =>
            {
                let plan = Plan::stepped(NEAR_A_DOUBLE_ROOT);
                self.stepped(plan, request, &conserved)
            }
            done => done,
        }
    }

    /// The motion in closed form.
    fn known(
        &self,
        plan: Plan,
        closed: &ClosedForm,
        request: &Request,
        conserved: &Conserved,
    ) -> Result<Motion<State>> {
        let angle = self.pace()? * request.furthest.abs();
        let doubted = self.doubted(closed, request)?;
        let told = closed.rounding(request.furthest, angle) + body::DOUBTED * doubted;
        // A change of the rates grows by the angle.
        let growth = angle.max(doubted / body::DOUBT[0]);
        let within = |error: f64| match error <= request.accuracy {
            true => Ok(error),
            false => Err(request.amplified(error, growth)),
        };
        within(told)?;
        let states = closed.at(request.times(), &request.budget())?;
        let start = self.start.omega(self.body.moments)?.norm();
        let rates = || states.iter().map(|(_, omega)| omega.norm());
        let fastest = || rates().fold(start, f64::max);
        let error = within(told + closed.hardly_moving(self.pace()?, fastest))?;
        let told = |(q, omega)| ledger::state(&conserved.heavy, q, omega);
        let states = states.into_iter().map(told);
        let books = Books::of(request, plan, (Cost::default(), error), states);
        conserved.lossless(books)?.closed(request)
    }

    /// The greatest effect of a displaced start at the last and some of the other requested times. It is zero for closed forms that receive the start without
    /// rounding, unless the start had to be turned to the principal axes.
    fn doubted(&self, closed: &ClosedForm, request: &Request) -> Result<f64> {
        if closed.is_exact() && self.body.own.is_none() {
            return Ok(0.0);
        }
        let fastest = self.start.omega(self.body.moments)?.norm();
        let times = request.times();
        let every = times.len().div_ceil(OF_THE_TIMES).max(1);
        let others = times.iter().copied().step_by(every);
        let some: Vec<f64> = others.chain([request.furthest]).collect();
        let budget = Budget::new(u64::MAX, 0.0, None);
        let (here, mut most) = (closed.at(&some, &budget)?, 0.0);
        // In one of the two directions the effects of the changes may cancel.
        for sense in [1.0, -1.0] {
            let start = self.start.beside(self.body.moments, sense)?;
            let Some(beside) = ClosedForm::find(&self.body, self.g(), &start)? else {
                continue;
            };
            for ((attitude, omega), (other, moved)) in here.iter().zip(beside.at(&some, &budget)?) {
                let unit = fastest.max(omega.norm()).max(f64::MIN_POSITIVE);
                let faster = (*omega - moved).norm() / unit;
                most = greater(greater(most, attitude.angle_to(&other)), faster);
            }
        }
        Ok(most)
    }

    /// The motion by order 8, or by the method that the request names.
    fn stepped(
        &self,
        plan: Plan,
        request: &Request,
        conserved: &Conserved,
    ) -> Result<Motion<State>> {
        let turning = || Turning::new(self, conserved.energy_scale);
        let here = turning()?;
        if self.resisting().next().is_some() {
            let trace = to_accuracy::<8, _>(request, plan.solver, |_| turning())?;
            let books = trace.told(request, plan, |_, _, y| here.state(y, conserved));
            let lost = |place: usize| here.unit * trace.samples[place].1[7];
            return conserved.lossy(books, lost)?.closed(request);
        }
        let trace = match plan.solver {
            Solver::Geometric(method) if method != Geometric::DormandPrince8 => {
                let steps = methods::steps(&here, method, request)?;
                vouched::<7, _>(request, Stepper::Other(&steps, true), |_| turning())?
            }
            solver => to_accuracy::<7, _>(request, solver, |_| turning())?,
        };
        let books = trace.told(request, plan, |_, _, y| here.state(y, conserved));
        conserved.lossless(books)?.closed(request)
    }
}
