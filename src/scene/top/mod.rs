//! A top: a body with a fixed point, and whatever of gravity, friction at the pivot, in the bearing and at the tip, and drag acts on it (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `equations`: the torque of each effect, and the flow that the engine follows;
//! * `closed`: the scenes whose motion is known;
//! * `methods`: tops under gravity alone by the methods for turning bodies;
//! * `ledger`: what is conserved, or may only be lost;
//! * this file: the top and its effects, the plan, the motion.

mod body;
mod closed;
mod equations;
mod ledger;
mod methods;

pub use body::{Body, Start};
pub use closed::{Axes, ClosedForm};

pub use super::effects::{AirDrag, BearingFriction, Gravity, PivotFriction, TipFriction};

use super::effects::Effect;
use super::engine::{furthest, greater, to_accuracy};
use super::{Budget, Choice, Geometric, Motion, Plan, Request, Scene, Solver, Tabulated, balanced};
use crate::error::{Error, Result};
use crate::euler_equations::Integrability;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::Cost;

use equations::Turning;
use ledger::Conserved;

/// A top and the effects at work on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top {
    body: Body,
    start: Start,
    gravity: Option<Gravity>,
    pivot_friction: Option<PivotFriction>,
    bearing_friction: Option<BearingFriction>,
    air_drag: Option<AirDrag>,
    tip_friction: Option<TipFriction>,
}

/// A top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// How the body stands in space.
    pub attitude: Attitude,
    /// Ω along the principal axes, rad/s.
    pub omega: BodyVector,
    /// Kinetic energy, plus potential energy above the pivot, J.
    pub energy: f64,
}

impl Tabulated for State {
    const COLUMNS: &'static [&'static str] = &[
        "qw", "qx", "qy", "qz", "omega1", "omega2", "omega3", "energy",
    ];

    fn row(&self) -> Vec<f64> {
        let q = self.attitude.quaternion();
        let [o1, o2, o3]: [f64; 3] = self.omega.components().into();
        vec![q.w, q.i, q.j, q.k, o1, o2, o3, self.energy]
    }
}

/// What steps where there is no closed form.
const ORDER_EIGHT: Solver = Solver::Geometric(Geometric::DormandPrince8);

/// Kovalevskaya's closed form is for times of at least so many radians of the [pace](Top::pace): preparing it takes as long as an order 8 run of that
/// length, 0.3 ms.
const KOVALEVSKAYA_FROM: f64 = 200.0;

impl Top {
    /// The body, left alone.
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

    /// The same with one effect more, or with another value of one that it has.
    ///
    /// # Errors
    /// [`Error::Effect`] for one that has no meaning for a top. [`Error::Condition`] for tip friction unless I₁ = I₂ and C lies on the third axis: of
    /// another body the spin would not stay stopped.
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Gravity(gravity) => self.gravity = Some(gravity),
            Effect::PivotFriction(friction) => self.pivot_friction = Some(friction),
            Effect::BearingFriction(friction) => self.bearing_friction = Some(friction),
            Effect::AirDrag(drag) => self.air_drag = Some(drag),
            Effect::TipFriction(friction) if self.body.is_symmetric_about_third() => {
                self.tip_friction = Some(friction);
            }
            Effect::TipFriction(_) => {
                return Err(Error::Condition {
                    condition: "tip friction is for bodies with I1 = I2 and the centre of mass on the third axis",
                    value: self.body.moments[1] / self.body.moments[0],
                });
            }
            other => {
                let takes = "gravity, pivot_friction, bearing_friction, air_drag and tip_friction";
                return Err(other.refused("a top", takes));
            }
        }
        Ok(self)
    }

    /// The motion in closed form, if this scene has one.
    ///
    /// # Errors
    /// Those of the solution.
    pub fn closed_form(&self) -> Result<Option<ClosedForm>> {
        if self.resisting().next().is_some() {
            return Ok(None);
        }
        ClosedForm::find(&self.body, self.g(), &self.start)
    }

    /// MgC, N m: with the upward unit vector z the torque about the pivot is z∧MgC (8.1).
    fn lever(&self) -> [f64; 3] {
        let g = self.g();
        self.body.arm().map(|component| component * g)
    }

    fn g(&self) -> f64 {
        self.gravity.map_or(0.0, Gravity::value)
    }

    /// The names of what resists.
    fn resisting(&self) -> impl Iterator<Item = &'static str> {
        let effects: [Option<Effect>; 4] = [
            self.pivot_friction.map(Effect::from),
            self.bearing_friction.map(Effect::from),
            self.air_drag.map(Effect::from),
            self.tip_friction.map(Effect::from),
        ];
        effects.into_iter().flatten().map(|effect| effect.name())
    }

    /// The rate that this top turns at, or would if its weight made it fall, rad/s.
    fn pace(&self) -> Result<f64> {
        let moments = self.body.moments;
        let omega = self.start.omega(moments)?.norm();
        let [x, y, z] = self.lever();
        let arms = [y.hypot(z), z.hypot(x), x.hypot(y)];
        let square: f64 = (0..3)
            .filter(|&k| moments[k] > 0.0)
            .map(|k| (arms[k] / moments[k]).powi(2))
            .sum();
        let falling = (2.0 * square.sqrt()).sqrt();
        Ok(omega.hypot(falling).max(f64::MIN_POSITIVE))
    }

    /// The plan: the closed form wherever there is one, Kovalevskaya's only for long runs; otherwise order 8. Or what was asked for by name.
    fn planned(
        &self,
        request: &Request,
        kind: Integrability,
    ) -> Result<(Plan, Option<ClosedForm>)> {
        let resisting: Vec<&str> = self.resisting().collect();
        let stepped = |reason: String| Ok((Plan::new(ORDER_EIGHT, reason), None));
        match request.choice() {
            Choice::Auto if !resisting.is_empty() => {
                stepped(format!("{}: no closed form", resisting.join(" and ")))
            }
            Choice::Auto if matches!(kind, Integrability::Kovalevskaya(_)) => {
                if self.pace()? * furthest(request.times()).abs() < KOVALEVSKAYA_FROM {
                    let reason = "a run so short that it costs less than preparing the closed form";
                    return stepped(reason.to_owned());
                }
                match self.closed_form() {
                    Ok(Some(closed)) => {
                        Ok((Plan::new(Solver::Exact, closed.reason()), Some(closed)))
                    }
                    _ => stepped(NEAR_A_DOUBLE_ROOT.to_owned()),
                }
            }
            Choice::Auto => match self.closed_form()? {
                Some(closed) => Ok((Plan::new(Solver::Exact, closed.reason()), Some(closed))),
                None => stepped(closed::NONE.to_owned()),
            },
            Choice::Use(Solver::Exact) => match self.closed_form()? {
                Some(closed) => Ok((Plan::new(Solver::Exact, "asked for"), Some(closed))),
                None => Err(Error::Solver {
                    condition: "the solver `exact` is for scenes with a closed form, this one has none",
                }),
            },
            Choice::Use(Solver::Geometric(method))
                if method != Geometric::DormandPrince8 && !resisting.is_empty() =>
            {
                Err(Error::Solver {
                    condition: "the geometric solvers are for tops under gravity alone, and dormand-prince-8 for all",
                })
            }
            Choice::Use(Solver::Events) => Err(Error::Solver {
                condition: "the solver `events` is for scenes with contacts, a top has none",
            }),
            Choice::Use(solver) => Ok((Plan::new(solver, "asked for"), None)),
        }
    }
}

const NEAR_A_DOUBLE_ROOT: &str = "near a double root, where the closed form refuses times as long";

impl Scene for Top {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let conserved = Conserved::of(&self.body, self.lever(), &self.start)?;
        Ok(self.planned(request, conserved.kind)?.0)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let conserved = Conserved::of(&self.body, self.lever(), &self.start)?;
        let (plan, closed) = self.planned(request, conserved.kind)?;
        let Some(closed) = closed else {
            return self.stepped(plan, request, &conserved);
        };
        match self.known(plan, &closed, request, &conserved) {
            // Where the motion amplifies too much, or would be walked too far.
            Err(Error::Integration { .. } | Error::OutOfRange { .. } | Error::Amplified { .. })
                if request.choice() == Choice::Auto
                    && matches!(closed, ClosedForm::Kovalevskaya(..)) =>
            {
                let plan = Plan::new(ORDER_EIGHT, NEAR_A_DOUBLE_ROOT);
                self.stepped(plan, request, &conserved)
            }
            done => done,
        }
    }
}

impl Top {
    /// By a closed form: every time on its own.
    fn known(
        &self,
        plan: Plan,
        closed: &ClosedForm,
        request: &Request,
        conserved: &Conserved,
    ) -> Result<Motion<State>> {
        let times = request.times();
        let angle = self.pace()? * furthest(times).abs();
        let doubted = self.doubted(closed, times)?;
        let error = closed.rounding(furthest(times), angle) + body::DOUBTED * doubted;
        if error > request.accuracy() {
            return Err(Error::Amplified {
                asked: request.accuracy(),
                reached: error,
                growth: doubted / body::DOUBT[0],
            });
        }
        let states = closed.states(times, &Budget::asked(request))?;
        let rows = conserved.rows(times, states);
        Ok(Motion {
            plan,
            cost: Cost::default(),
            error_estimate: Some(error),
            ledger: balanced(conserved.lossless(&rows)?, request.accuracy())?,
            rows,
        })
    }

    /// How far a start that rounding cannot tell from this one gets from it by the last of the times, or one of those before. Closed forms that take what is
    /// given before anything is rounded have no such doubt.
    fn doubted(&self, closed: &ClosedForm, times: &[f64]) -> Result<f64> {
        if closed.is_exact() {
            return Ok(0.0);
        }
        let start = self.start.beside(self.body.moments)?;
        let Some(beside) = ClosedForm::find(&self.body, self.g(), &start)? else {
            return Ok(0.0);
        };
        let fastest = self.start.omega(self.body.moments)?.norm();
        let last = furthest(times);
        let some = [0.25, 0.55, 0.8, 1.0].map(|part| part * last);
        let budget = Budget::unlimited();
        let (here, there) = (
            closed.states(&some, &budget)?,
            beside.states(&some, &budget)?,
        );
        let mut most = 0.0_f64;
        for ((attitude, omega), (other, moved)) in here.iter().zip(&there) {
            let unit = fastest.max(omega.norm()).max(f64::MIN_POSITIVE);
            let faster = (*omega - *moved).norm() / unit;
            most = greater(greater(most, attitude.angle_to(other)), faster);
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
        let times = request.times();
        if self.resisting().next().is_some() {
            let answer = to_accuracy::<8, _>(request, plan.solver, |_| turning())?;
            let states = answer.trace.samples.iter();
            let rows = conserved.rows(times, states.clone().map(|(_, y)| here.unpacked(y)));
            let losses: Vec<f64> = states.map(|(_, y)| y[7]).collect();
            return Ok(Motion {
                plan,
                cost: answer.trace.cost,
                error_estimate: Some(answer.error),
                ledger: balanced(conserved.lossy(&rows, &losses)?, request.accuracy())?,
                rows,
            });
        }
        let (rows, cost, error) = match plan.solver {
            Solver::Geometric(method) if method != Geometric::DormandPrince8 => {
                let run = methods::halved(self, &here, method, request)?;
                let states = run.phases.iter().map(|phase| here.state(phase));
                (conserved.rows(times, states), run.cost, run.error)
            }
            solver => {
                let answer = to_accuracy::<7, _>(request, solver, |_| turning())?;
                let samples = answer.trace.samples.iter();
                let rows = conserved.rows(times, samples.map(|(_, y)| here.unpacked(y)));
                (rows, answer.trace.cost, answer.error)
            }
        };
        Ok(Motion {
            plan,
            cost,
            error_estimate: Some(error),
            ledger: balanced(conserved.lossless(&rows)?, request.accuracy())?,
            rows,
        })
    }
}
