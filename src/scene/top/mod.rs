//! A top: a body with a fixed point, and whatever of gravity, friction at the pivot, in the bearing and at the tip, and drag acts on it (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `held`: the top and its effects, and its state;
//! * `equations`: the torque of each effect, and the flow that the engine follows;
//! * `closed`: the scenes whose motion is known;
//! * `columns`: what else can be told of its states;
//! * `methods`: tops under gravity alone by the methods for turning bodies;
//! * `ledger`: what is conserved, or may only be lost;
//! * this file: the plan, the motion.

mod body;
mod closed;
mod columns;
mod equations;
mod held;
mod ledger;
mod methods;

pub use body::{Body, Start};
pub use held::{State, Top};

pub use super::effects::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction};

use super::engine::{Answer, Stepper, greater, to_accuracy, vouched};
use super::{Budget, Choice, Columns, Geometric, Motion, Plan, Request, Scene, Solver};
use crate::error::{Error, Result};
use crate::integrators::Cost;

use closed::ClosedForm;
use equations::Turning;
use ledger::Conserved;

/// At so many of the times asked for a closed form is compared with that from a start beside.
const OF_THE_TIMES: usize = 64;

impl Top {
    /// The plan: the closed form wherever there is one, otherwise order 8; or what was asked for by name.
    fn planned(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        let resisting: Vec<&str> = self.resisting().collect();
        let refused = |condition| Err(Error::Solver { condition });
        let closed = match request.choice {
            Choice::Auto | Choice::Use(Solver::Exact) => self.closed_form()?,
            Choice::Use(_) => None,
        };
        let plan = match (request.choice, &closed) {
            (Choice::Auto, Some(closed)) => Plan::exact(closed.reason()),
            (Choice::Auto, None) if resisting.is_empty() => Plan::stepped(closed::NONE),
            (Choice::Auto, None) => {
                Plan::stepped(format!("{}: no closed form", resisting.join(" and ")))
            }
            (Choice::Use(Solver::Exact), None) => {
                return refused(
                    "the solver `exact` is for scenes with a closed form, this one has none",
                );
            }
            (Choice::Use(Solver::Geometric(method)), _)
                if method != Geometric::DormandPrince8 && !resisting.is_empty() =>
            {
                return refused(
                    "the geometric solvers are for tops under gravity alone, and dormand-prince-8 for all",
                );
            }
            (Choice::Use(Solver::Events), _) => {
                return refused("the solver `events` is for scenes with contacts, a top has none");
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
        if self.body.own.is_some() {
            for (_, state) in &mut motion.rows {
                let State {
                    attitude, omega, ..
                } = state;
                self.body.turn_outward(attitude, omega);
            }
        }
        Ok(motion)
    }

    fn further(&self) -> Columns<State> {
        columns::columns(self)
    }
}

impl Top {
    /// The motion as the principal axes see it.
    fn along_principal_axes(&self, request: &Request) -> Result<Motion<State>> {
        let conserved = Conserved::of(self)?;
        let (plan, closed) = self.planned(request)?;
        let Some(closed) = closed else {
            return self.stepped(plan, request, &conserved);
        };
        match self.known(plan, &closed, request, &conserved) {
            // Where the motion amplifies too much, or would be walked too far.
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

    /// By a closed form: every time on its own.
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
        let within = |error: f64| match error <= request.accuracy {
            true => Ok(error),
            false => Err(Error::Amplified {
                asked: request.accuracy,
                reached: error,
                growth: doubted / body::DOUBT[0],
            }),
        };
        within(told)?;
        let mut states = Vec::with_capacity(request.times().len());
        let mut fastest = self.start.omega(self.body.moments)?.norm();
        closed.each(request.times(), &request.budget(), |_, attitude, omega| {
            fastest = fastest.max(omega.norm());
            states.push(conserved.state(attitude, omega));
        })?;
        let error = within(told + closed.hardly_moving(self.pace()?, fastest))?;
        let accounts = conserved.lossless(request, &states)?;
        Motion::of(request, plan, Cost::default(), error, accounts, states)
    }

    /// How far a start that rounding cannot tell from this one gets from it by the last of the times, or by some of the others. Closed forms that take what is
    /// given before anything is rounded have no such doubt; what has been turned to the principal axes is rounded.
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
        let mut here = Vec::with_capacity(some.len());
        closed.each(&some, &budget, |_, attitude, omega| {
            here.push((attitude, omega))
        })?;
        let mut most = 0.0_f64;
        // In one of them what the changes do may cancel.
        for sense in [1.0, -1.0] {
            let start = self.start.beside(self.body.moments, sense)?;
            let Some(beside) = ClosedForm::find(&self.body, self.g(), &start)? else {
                continue;
            };
            let mut here = here.iter();
            beside.each(&some, &budget, |_, other, moved| {
                if let Some(&(attitude, omega)) = here.next() {
                    let unit = fastest.max(omega.norm()).max(f64::MIN_POSITIVE);
                    let faster = (omega - moved).norm() / unit;
                    most = greater(greater(most, attitude.angle_to(&other)), faster);
                }
            })?;
        }
        Ok(most)
    }

    /// By order 8, or a method asked for by its name.
    fn stepped(
        &self,
        plan: Plan,
        request: &Request,
        conserved: &Conserved,
    ) -> Result<Motion<State>> {
        let turning = || Turning::new(self, conserved.energy_scale);
        let here = turning()?;
        if self.resisting().next().is_some() {
            let Answer { trace, error } = to_accuracy::<8, _>(request, plan.solver, |_| turning())?;
            let states = here.states(&trace, conserved);
            let losses: Vec<f64> = trace.samples.iter().map(|(_, y)| y[7]).collect();
            let accounts = conserved.lossy(request, &states, &losses)?;
            return Motion::of(request, plan, trace.cost, error, accounts, states);
        }
        let Answer { trace, error } = match plan.solver {
            Solver::Geometric(method) if method != Geometric::DormandPrince8 => {
                let steps = methods::steps(self, &here, method, request)?;
                vouched::<7, _>(request, Stepper::Even(&steps), |_| turning())?
            }
            solver => to_accuracy::<7, _>(request, solver, |_| turning())?,
        };
        let states = here.states(&trace, conserved);
        let accounts = conserved.lossless(request, &states)?;
        Motion::of(request, plan, trace.cost, error, accounts, states)
    }
}
