//! Tops: a body with a fixed point under any of gravity, friction at the pivot, in the bearing and at the tip, and drag (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `equations`: the torque of each effect, and the flow that the engine follows;
//! * `closed`: the scenes with a closed form;
//! * `columns`: further columns of the states;
//! * `effects`: the top, the effects that it takes, and its state;
//! * `methods`: geometric methods and power series for tops under gravity alone;
//! * `ledger`: what is conserved, or may only decrease;
//! * this file: the plan, the motion.

mod body;
mod closed;
mod columns;
mod effects;
mod equations;
mod ledger;
mod methods;

pub use body::{Body, Start};
pub use effects::{State, Top};

pub use super::effects::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction};

use super::engine::{DOUBT, Stepper, vouched};
use super::prelude::*;
use super::{Budget, Geometric};

use closed::ClosedForm;
use equations::Turning;
use ledger::Conserved;

/// The reasons for a plan that leaves a closed form, or order 8.
const NEAR_A_DOUBLE_ROOT: &str = "near a double root, where the closed form refuses times as long";
const AMPLIFIED: &str = "a motion that amplifies what steps in doubles round: series in 106 bits";
const SHORT: &str = "a motion so short that the closed form loses digits of its rates";
const FINE: &str = "an accuracy finer than the closed form states";

/// The most requested times at which a closed form is compared with one from a displaced start.
const OF_THE_TIMES: usize = 64;

impl Top {
    /// The plan, and the closed form if it uses one: the closed form if there is one, otherwise order 8; or the requested solver.
    fn planned(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        let resisting: Vec<&str> = self.resisting().collect();
        let cannot = |condition| Err(Error::Solver { condition });
        let exact = "the solver `exact` is for scenes with a closed form, this one has none";
        let geometric = "the geometric solvers and power-series are for tops under gravity alone, and dormand-prince-8 for all";
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
            (Choice::Use(Solver::Exact), None) => return cannot(exact),
            (Choice::Use(Solver::Geometric(method)), _)
                if method != Geometric::DormandPrince8 && !resisting.is_empty() =>
            {
                return cannot(geometric);
            }
            (Choice::Use(Solver::Events), _) => {
                return cannot("the solver `events` is for scenes with contacts, a top has none");
            }
            (Choice::Use(solver), _) => Plan::new(solver, "asked for"),
        };
        Ok((plan, closed))
    }

    /// The motion along the principal axes.
    fn along_principal_axes(&self, request: &Request) -> Result<Motion<State>> {
        let conserved = Conserved::of(self)?;
        let (plan, closed) = self.planned(request)?;
        let Some(closed) = closed else {
            return self.stepped(plan, request, &conserved);
        };
        let instead = match closed {
            _ if self.pace()? * request.furthest.abs() < 1.0 => SHORT,
            ClosedForm::Kovalevskaya(..) => NEAR_A_DOUBLE_ROOT,
            _ => FINE,
        };
        match self.known(plan, &closed, request, &conserved) {
            // Where the motion amplifies rounding too much, or the solution cannot be continued as far, or rates are still very small.
            Err(
                known @ (Error::Integration { .. }
                | Error::OutOfRange { .. }
                | Error::Amplified { .. }),
            ) if request.choice == Choice::Auto => {
                let stepped = self.stepped(Plan::stepped(instead), request, &conserved);
                // Neither keeps the accuracy: what is told is the better of the two.
                stepped.map_err(|stepped| match (&known, &stepped) {
                    (Error::Amplified { reached: a, .. }, Error::Amplified { reached: b, .. })
                        if a < b =>
                    {
                        known
                    }
                    _ => stepped,
                })
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
        let growth = angle.max(doubted / DOUBT[0]);
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
        let states = &mut states.into_iter().map(told);
        let ledger = OpenLedger::of(request, plan, (Cost::default(), error), states);
        conserved.lossless(ledger)?.closed(request)
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
            let top = Self::new(self.body.beside(sense)?, start)?;
            let Some(beside) = ClosedForm::find(&top.body, self.g(), &top.start)? else {
                continue;
            };
            for ((attitude, omega), (q, w)) in here.iter().zip(beside.at(&some, &budget)?) {
                let (other, moved) = top.body.outward(q, w);
                let unit = fastest.max(omega.norm()).max(f64::MIN_POSITIVE);
                let faster = (*omega - moved).norm() / unit;
                most = greater(greater(most, attitude.angle_to(&other)), faster);
            }
        }
        Ok(most)
    }

    /// The motion by order 8, or by the method that the request names. Where a motion amplifies what order 8 rounds on the way, by power series.
    fn stepped(&self, plan: Plan, request: &Request, kept: &Conserved) -> Result<Motion<State>> {
        let turning = || Turning::new(self, kept.energy_scale);
        let here = turning()?;
        if self.resisting().next().is_some() {
            let trace = to_accuracy::<8, _>(request, plan.solver, &|_| turning())?;
            let ledger = trace.told(request, plan, |_, _, y| here.state(y, kept));
            let lost = |place: usize| here.unit * trace.samples[place].1[7];
            return kept.lossy(ledger, lost)?.closed(request);
        }
        let in_series = |request: &Request| {
            let steps = methods::power_series(self, &here, request)?;
            vouched::<7, _>(request, Stepper::Other(&steps, false), &|_| turning())
        };
        let (plan, trace) = match plan.solver {
            Solver::Geometric(Geometric::PowerSeries) => (plan, in_series(request)?),
            Solver::Geometric(method) if method != Geometric::DormandPrince8 => {
                let steps = methods::steps(&here, method, request)?;
                let stepper = Stepper::Other(&steps, true);
                (plan, vouched::<7, _>(request, stepper, &|_| turning())?)
            }
            solver => match to_accuracy::<7, _>(request, solver, &|_| turning()) {
                Err(refused @ Error::Amplified { .. }) if request.choice == Choice::Auto => {
                    let trace = in_series(&request.briefly(20)).map_err(|_| refused)?;
                    let solver = Solver::Geometric(Geometric::PowerSeries);
                    (Plan::new(solver, AMPLIFIED), trace)
                }
                trace => (plan, trace?),
            },
        };
        let ledger = trace.told(request, plan, |_, _, y| here.state(y, kept));
        kept.lossless(ledger)?.closed(request)
    }
}

impl Scene for Top {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        Ok(self.planned(request)?.0)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let mut motion = self.along_principal_axes(request)?;
        for (_, state) in &mut motion.rows {
            (state.attitude, state.omega) = self.body.outward(state.attitude, state.omega);
        }
        Ok(motion)
    }

    fn further(&self) -> Columns<State> {
        columns::columns(self)
    }
}
