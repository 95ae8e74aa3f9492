//! A top: a body with a fixed point, and whatever of gravity, pivot friction, tip friction and drag acts on it (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `effects`: what can act, and its torque;
//! * `closed`: the scenes whose motion is known;
//! * `equations`, `general`: the others, by a method with error control;
//! * this file: the slots, the plan, the motion and its ledger.

mod body;
mod books;
mod closed;
mod effects;
mod equations;
mod general;

pub use body::{Body, Start};
pub use closed::{Axes, ClosedForm};
pub use effects::{
    AirDrag, BearingFriction, Gravity, PivotFriction, Resistance, TipFriction, Turning, Weight,
};

use super::{Absent, Choice, Motion, Plan, Request, Scene, Solver, Tabulated, balanced, choose};
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::{Cost, Method};

use books::Books;
use equations::{Equations, Lossless, Lossy, fastest, packed, unpacked};
use general::{Problem, Spin};

/// A top and its effects, one type parameter each: gravity, pivot friction, bearing friction, air drag, tip friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top<G = Absent, F = Absent, B = Absent, D = Absent, T = Absent> {
    body: Body,
    start: Start,
    gravity: G,
    pivot_friction: F,
    bearing_friction: B,
    air_drag: D,
    tip_friction: T,
}

/// Effects as a scene file lists them: some there, some not, known only when the program runs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Uniform gravity.
    pub gravity: Option<Gravity>,
    /// Friction at the pivot.
    pub pivot_friction: Option<PivotFriction>,
    /// Friction at the pivot that spares the spin.
    pub bearing_friction: Option<BearingFriction>,
    /// Drag of the air.
    pub air_drag: Option<AirDrag>,
    /// Dry friction at the tip.
    pub tip_friction: Option<TipFriction>,
}

impl Listed {
    /// The scene of the type that has these effects and no others: one of thirty-two, each compiled for itself.
    ///
    /// # Errors
    /// As for [`Top::new`] and [`Top::with_tip_friction`].
    pub fn on(self, body: Body, start: Start) -> Result<Box<dyn Scene<State = State>>> {
        let free = Top::new(body, start)?;
        if let Some(tip_friction) = self.tip_friction {
            free.with_tip_friction(tip_friction)?;
        }
        Ok(choose!(
            (gravity = self.gravity)
            (pivot_friction = self.pivot_friction)
            (bearing_friction = self.bearing_friction)
            (air_drag = self.air_drag)
            (tip_friction = self.tip_friction)
            => Box::new(Top { body, start, gravity, pivot_friction, bearing_friction, air_drag, tip_friction })
        ))
    }
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

impl Top {
    /// The body, left alone.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for the start.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::scene::{Request, Scene, top::{Body, Gravity, Start, Top}};
    /// let body = Body::new([2.0, 2.0, 1.0])?.with_center_of_mass(1.0, BodyVector::new(0.0, 0.0, 0.5))?;
    /// let start = Start::with_omega(BodyVector::new(0.1, 0.0, 9.0), Attitude::identity());
    /// let free = Top::new(body, start)?;
    /// let heavy = free.with_gravity(Gravity::new(9.80665)?);
    /// let request = Request::at([1.0])?;
    /// assert_eq!(free.plan(&request)?.to_string(), "exact: no torque: closed form");
    /// assert_eq!(heavy.plan(&request)?.to_string(), "exact: gravity on a symmetric top: closed form");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: Body, start: Start) -> Result<Self> {
        start.omega(body.moments)?;
        Ok(Self {
            body,
            start,
            gravity: Absent,
            pivot_friction: Absent,
            bearing_friction: Absent,
            air_drag: Absent,
            tip_friction: Absent,
        })
    }
}

impl Top {
    /// The motion of a scene without effects, which is the free top of section 6 and no more: nothing is asked when it runs.
    ///
    /// # Errors
    /// Those of [`EulerTop`].
    pub fn free_top(&self) -> Result<EulerTop> {
        let (moments, attitude) = (self.body.moments, self.start.attitude);
        match self.start.spin {
            body::Spin::Omega(omega) => EulerTop::from_omega(moments, omega, attitude),
            body::Spin::AngularMomentum(l) => EulerTop::new(moments, l, attitude),
        }
    }
}

impl<F, B, D, T> Top<Absent, F, B, D, T> {
    /// The same under gravity.
    pub fn with_gravity(self, gravity: Gravity) -> Top<Gravity, F, B, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, B, D, T> Top<G, Absent, B, D, T> {
    /// The same with friction at the pivot.
    pub fn with_pivot_friction(
        self,
        pivot_friction: PivotFriction,
    ) -> Top<G, PivotFriction, B, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, D, T> Top<G, F, Absent, D, T> {
    /// The same with friction at the pivot that spares the spin.
    pub fn with_bearing_friction(
        self,
        bearing_friction: BearingFriction,
    ) -> Top<G, F, BearingFriction, D, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, B, T> Top<G, F, B, Absent, T> {
    /// The same with drag of the air.
    pub fn with_air_drag(self, air_drag: AirDrag) -> Top<G, F, B, AirDrag, T> {
        Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G, F, B, D> Top<G, F, B, D, Absent> {
    /// The same with dry friction at the tip.
    ///
    /// # Errors
    /// [`Error::Condition`] unless I₁ = I₂ and C lies on the third axis: of another body the spin would not stay stopped.
    pub fn with_tip_friction(
        self,
        tip_friction: TipFriction,
    ) -> Result<Top<G, F, B, D, TipFriction>> {
        if !self.body.is_symmetric_about_third() {
            return Err(Error::Condition {
                condition: "tip friction is for bodies with I1 = I2 and the centre of mass on the third axis",
                value: self.body.moments[1] / self.body.moments[0],
            });
        }
        Ok(Top {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction,
        })
    }
}

/// The method for scenes without a closed form.
const GENERAL: Solver = Solver::General(Method::Dop853);

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Top<G, F, B, D, T> {
    /// Whether anything resists; known at compile time.
    const LOSSY: bool = F::PRESENT || B::PRESENT || D::PRESENT || T::PRESENT;

    /// The motion in closed form, if this scene has one.
    ///
    /// # Errors
    /// Those of the solution.
    pub fn closed_form(&self) -> Result<Option<ClosedForm>> {
        if Self::LOSSY {
            return Ok(None);
        }
        ClosedForm::find(&self.body, self.gravity.lever(self.body.arm()), &self.start)
    }

    fn planned(&self, request: &Request) -> Result<(Plan, Option<ClosedForm>)> {
        match request.choice() {
            Choice::Auto => Ok(match self.closed_form()? {
                Some(closed) => (Plan::new(Solver::Exact, closed.reason()), Some(closed)),
                None => (Plan::new(GENERAL, self.reason()), None),
            }),
            Choice::Use(Solver::Exact) => match self.closed_form()? {
                Some(closed) => Ok((Plan::new(Solver::Exact, "asked for"), Some(closed))),
                None => Err(Error::Condition {
                    condition: "the solver `exact` is for scenes with a closed form, this one has none",
                    value: f64::NAN,
                }),
            },
            Choice::Use(solver @ Solver::General(_)) => Ok((Plan::new(solver, "asked for"), None)),
            Choice::Use(Solver::Events) => Err(Error::Condition {
                condition: "the solver `events` is for scenes with contacts, a top has none",
                value: f64::NAN,
            }),
        }
    }

    /// Why no closed form will do.
    fn reason(&self) -> String {
        let resisting = [
            (F::PRESENT, F::NAME),
            (B::PRESENT, B::NAME),
            (D::PRESENT, D::NAME),
            (T::PRESENT, T::NAME),
        ];
        let names: Vec<&str> = resisting.iter().filter(|r| r.0).map(|r| r.1).collect();
        if names.is_empty() {
            closed::NONE.to_owned()
        } else {
            format!("{}: no closed form", names.join(" and "))
        }
    }

    fn equations(&self) -> Equations<G, F, B, D, T> {
        Equations {
            moments: self.body.moments,
            arm: self.body.arm(),
            gravity: self.gravity,
            pivot_friction: self.pivot_friction,
            bearing_friction: self.bearing_friction,
            air_drag: self.air_drag,
            tip_friction: self.tip_friction,
        }
    }
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Scene
    for Top<G, F, B, D, T>
{
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        Ok(self.planned(request)?.0)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let (plan, closed) = self.planned(request)?;
        let books = Books::of(&self.body, self.gravity.lever(self.body.arm()), &self.start)?;
        match (plan.solver, closed) {
            (Solver::General(method), _) => self.followed(plan, method, request, &books),
            (_, Some(closed)) => known(plan, &closed, request, &books),
            (_, None) => Err(Error::Condition {
                condition: "a plan without a closed form must name a general method",
                value: f64::NAN,
            }),
        }
    }
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Top<G, F, B, D, T> {
    fn followed(
        &self,
        plan: Plan,
        method: Method,
        request: &Request,
        books: &Books,
    ) -> Result<Motion<State>> {
        if let Some(&moment) = self.body.moments.iter().find(|&&moment| moment == 0.0) {
            return Err(Error::NotPositive {
                quantity: "a principal moment of a body without a closed form",
                value: moment,
            });
        }
        let omega = self.start.omega(self.body.moments)?;
        let problem = Problem {
            start: packed(omega, &self.start.attitude),
            fastest: fastest(&self.body, self.gravity.lever(self.body.arm()), omega)
                .max(f64::MIN_POSITIVE),
            energy: books.energy_scale,
            times: request.times(),
            method,
            accuracy: request.accuracy(),
        };
        let equations = self.equations();
        let run = match (Self::LOSSY, T::PRESENT) {
            (false, _) => problem.lossless(&Lossless(&equations))?,
            (true, false) => problem.lossy(&Lossy(&equations), Spin::GoesOn)?,
            (true, true) => problem.lossy(&Lossy(&equations), Spin::MayStop)?,
        };
        let mut rows = Vec::with_capacity(run.states.len());
        let mut losses = Vec::with_capacity(run.states.len());
        for (&t, (y, lost)) in request.times().iter().zip(&run.states) {
            let (attitude, omega) = unpacked(y);
            let energy = books.energy(&attitude, omega);
            rows.push((
                t,
                State {
                    attitude,
                    omega,
                    energy,
                },
            ));
            losses.push(*lost);
        }
        let ledger = if Self::LOSSY {
            books.lossy(&rows, &losses)?
        } else {
            books.lossless(&rows)?
        };
        Ok(Motion {
            plan,
            cost: run.cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }
}

/// The rows of a closed form: every time on its own.
fn known(
    plan: Plan,
    closed: &ClosedForm,
    request: &Request,
    books: &Books,
) -> Result<Motion<State>> {
    let mut rows = Vec::with_capacity(request.times().len());
    for &t in request.times() {
        let (attitude, omega) = closed.at(t)?;
        let energy = books.energy(&attitude, omega);
        rows.push((
            t,
            State {
                attitude,
                omega,
                energy,
            },
        ));
    }
    Ok(Motion {
        plan,
        cost: Cost::default(),
        ledger: balanced(books.lossless(&rows)?, request.accuracy())?,
        rows,
    })
}
