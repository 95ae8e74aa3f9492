//! A top: a body with a fixed point, and whatever of gravity, pivot friction, tip friction and drag acts on it (6, 7, 8).
//!
//! * `body`: moments, mass, centre of mass; attitude and Ω, or L, at the start;
//! * `effects`: what can act, and its torque;
//! * `closed`: the scenes whose motion is known;
//! * `equations`, `general`: the others, by a method with error control;
//! * `methods`: tops under gravity alone by the methods for turning bodies, `steered` and `foreseen`: the error of such a run, `prices`: what to choose;
//! * `with`: an effect into its slot; `choice`: who runs a scene, and why;
//! * this file: the slots, the plan, the motion and its ledger.

mod body;
mod books;
mod choice;
mod closed;
mod effects;
mod equations;
mod foreseen;
mod general;
mod methods;
mod prices;
mod steered;
mod with;

pub use body::{Body, Start};
pub use closed::{Axes, ClosedForm};
pub use effects::{
    AirDrag, BearingFriction, Gravity, PivotFriction, Resistance, TipFriction, Turning, Weight,
};

use super::{
    Absent, Budget, Choice, Geometric, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
    choose,
};
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::{Cost, Method};

use books::Books;
use choice::Way;
use equations::{Lossless, Lossy, unpacked};
use general::{Problem, Spin};
use methods::{Heavy, longest};

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

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Scene
    for Top<G, F, B, D, T>
{
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        Ok(self.planned(request, &self.books()?)?.0)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let (books, budget) = (self.books()?, Budget::asked(request));
        let (mut plan, mut way) = self.planned(request, &books)?;
        loop {
            let method = match (plan.solver, &way) {
                (_, Way::Closed(closed)) => match known(plan, closed, request, &books, &budget) {
                    // Where the motion amplifies too much, or would be walked too far.
                    Err(Error::Integration { .. } | Error::OutOfRange { .. })
                        if request.choice() == Choice::Auto
                            && matches!(closed, ClosedForm::Kovalevskaya(..)) =>
                    {
                        let reason =
                            "near a double root, where the closed form refuses times as long";
                        let plan = Plan::new(choice::LEAN, reason);
                        let method = Geometric::DormandPrince8;
                        return self.turned(&plan, method, &Way::Named, request, &books, &budget);
                    }
                    done => return done,
                },
                (Solver::General(method), _) => {
                    return self.followed(plan, Some(method), request, &books, &budget);
                }
                _ if Self::LOSSY => return self.followed(plan, None, request, &books, &budget),
                (Solver::Geometric(method), _) => method,
                _ => {
                    return Err(Error::Solver {
                        condition: "a plan without a closed form must name a method",
                    });
                }
            };
            match self.turned(&plan, method, &way, request, &books, &budget) {
                Err(refusal @ Error::Accuracy { .. }) if request.choice() == Choice::Auto => {
                    (plan, way) = self.instead(&plan)?.ok_or(refusal)?;
                }
                done => return done,
            }
        }
    }
}

impl<G: Weight, F: Resistance, B: Resistance, D: Resistance, T: Resistance> Top<G, F, B, D, T> {
    fn books(&self) -> Result<Books> {
        Books::of(&self.body, self.gravity.lever(self.body.arm()), &self.start)
    }

    /// Under gravity alone by a method for turning bodies.
    fn turned(
        &self,
        plan: &Plan,
        method: Geometric,
        way: &Way,
        request: &Request,
        books: &Books,
        budget: &Budget,
    ) -> Result<Motion<State>> {
        self.needs_moments()?;
        let heavy = self.heavy(request.times(), books, budget)?;
        let run = match way {
            Way::Foreseen(foreseen) => heavy.foreseen(foreseen, request.accuracy())?,
            _ => heavy.to_accuracy(method, request.accuracy())?,
        };
        let rows = heavy.rows(&run.states, books)?;
        Ok(Motion {
            plan: plan.clone(),
            cost: run.cost,
            error_estimate: Some(run.error),
            ledger: balanced(books.lossless(&rows)?, request.accuracy())?,
            rows,
        })
    }

    /// By a general method, or where something resists by the one of order 8 without a name.
    fn followed(
        &self,
        plan: Plan,
        method: Option<Method>,
        request: &Request,
        books: &Books,
        budget: &Budget,
    ) -> Result<Motion<State>> {
        let Heavy {
            moments,
            lever,
            start,
            fastest,
            ..
        } = self.heavy(request.times(), books, budget)?;
        let problem = Problem {
            moments,
            lever,
            start,
            fastest,
            energy: books.energy_scale,
            times: request.times(),
            accuracy: request.accuracy(),
        };
        let equations = self.equations().divided();
        let run = match (method, Self::LOSSY, T::PRESENT) {
            (None, ..) => problem.steered(&budget.counted(&Lossy(equations)))?,
            (Some(method), false, _) => {
                problem.lossless(&budget.counted(&Lossless(equations)), method)?
            }
            (Some(method), true, false) => {
                problem.lossy(&budget.counted(&Lossy(equations)), method, Spin::GoesOn)?
            }
            (Some(method), true, true) => {
                problem.lossy(&budget.counted(&Lossy(equations)), method, Spin::MayStop)?
            }
        };
        let mut rows = Vec::with_capacity(run.states.len());
        let mut losses = Vec::with_capacity(run.states.len());
        for (&t, (y, lost)) in request.times().iter().zip(&run.states) {
            let (attitude, omega) = unpacked(moments, y);
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
            error_estimate: run.error,
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
    budget: &Budget,
) -> Result<Motion<State>> {
    let times = request.times();
    let mut rows = Vec::with_capacity(times.len());
    for (&t, (attitude, omega)) in times.iter().zip(closed.states(times, budget)?) {
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
        error_estimate: Some(closed.rounding(longest(times))),
        ledger: balanced(books.lossless(&rows)?, request.accuracy())?,
        rows,
    })
}
