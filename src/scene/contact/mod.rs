//! A body on a table (tutorial 4.7): tippe top, egg, hoop with clay, chiral top, rattleback.
//!
//! | slot | effects | absent |
//! |---|---|---|
//! | gravity | [`Gravity`] | a free body, in closed form |
//! | friction | [`Viscous`], [`Regularised`], [`Coulomb`], [`NoSlip`] | a table without friction |
//! | resistance | [`Resistance`] to rolling and pivoting | |
//!
//! The table only pushes. Where the reaction falls to zero the body takes off, flies in closed form, and lands with an inelastic blow.
//! Coulomb's law is the true one: a body whose slip comes to rest rolls while the force that takes lies within the cone of friction, and
//! slides again when it does not; each change is located.
//!
//! ```
//! use spinning_bodies::scene::contact::{Gravity, TableTop, Viscous};
//! use spinning_bodies::scene::{Request, Scene};
//! use spinning_bodies::tippe_top::{Start, bodies};
//!
//! let start = Start::about_third_axis(0.1, 0.0, 155.0)?;
//! let scene = TableTop::new(bodies::tippe_top()?, start)
//!     .with_gravity(Gravity::new(9.82)?)
//!     .with_friction(Viscous::new(0.3)?);
//! let motion = scene.simulate(&Request::at([8.0])?.to_accuracy(1e-8)?)?;
//! let (_, state) = motion.rows[0];
//! assert!(state.tilt() > 3.1, "it stands on its head");
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod effects;
mod listed;
mod run;
mod state;

use nalgebra::Quaternion;

pub use crate::tippe_top::{Coulomb, Regularised, Resistance, Viscous};
pub use effects::{Gravity, Grip, Holding, NoSlip, Pull, Resist};
pub use listed::{Friction, listed};
pub use run::{Phase, Support};
pub use state::{State, passage};

use self::run::{History, Place, Run, tightened};
use super::Scene;
use super::effect::Absent;
use super::motion::{Motion, Request, balanced};
use super::plan::{Choice, Plan, Solver};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, finite};
use crate::integrators::{Cost, Method, System, refined};
use crate::tippe_top::equations::{NUMBERS, Numbers, Pose, Table, numbers};
use crate::tippe_top::flight::Flight;
use crate::tippe_top::{ConvexBody, Start};

/// A body on a table, with one slot an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableTop<G = Absent, F = Absent, R = Absent> {
    body: ConvexBody,
    start: Start,
    gravity: G,
    friction: F,
    resistance: R,
}

impl TableTop {
    /// The body, touching the table, without any effect: a free body.
    pub const fn new(body: ConvexBody, start: Start) -> Self {
        Self {
            body,
            start,
            gravity: Absent,
            friction: Absent,
            resistance: Absent,
        }
    }
}

impl<G, F, R> TableTop<G, F, R> {
    /// The same under gravity.
    pub fn with_gravity<P: Pull>(self, gravity: P) -> TableTop<P, F, R> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity,
            friction: self.friction,
            resistance: self.resistance,
        }
    }

    /// The same with friction at the contact.
    pub fn with_friction<P: Grip>(self, friction: P) -> TableTop<G, P, R> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            friction,
            resistance: self.resistance,
        }
    }

    /// The same with resistance to rolling and pivoting.
    pub fn with_resistance<P: Resist>(self, resistance: P) -> TableTop<G, F, P> {
        TableTop {
            body: self.body,
            start: self.start,
            gravity: self.gravity,
            friction: self.friction,
            resistance,
        }
    }

    /// The mirror image of body and start, with the same effects.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        self.body = self.body.mirrored();
        self.start = self.start.mirrored();
        self
    }

    /// The body.
    pub const fn body(&self) -> &ConvexBody {
        &self.body
    }

    /// The start.
    pub const fn start(&self) -> &Start {
        &self.start
    }
}

impl<G: Pull, F: Grip, R: Resist> TableTop<G, F, R> {
    /// When the body slides, rolls and hops, up to the last of the times asked for.
    ///
    /// # Errors
    /// As for [`simulate`](Scene::simulate).
    pub fn phases(&self, request: &Request) -> Result<Vec<Phase>> {
        let Some(gravity) = self.gravity.pull() else {
            let support = Support::Airborne;
            return Ok(vec![Phase {
                start: 0.0,
                support,
            }]);
        };
        let method = self.method(&self.plan(request)?)?;
        let (_, times) = ascending(request)?;
        Ok(self.history(gravity, request, method, &times)?.phases)
    }

    fn method(&self, plan: &Plan) -> Result<Method> {
        match plan.solver {
            Solver::General(method) => Ok(method),
            _ => Err(Error::Condition {
                condition: "a body on a table must be run by a general method",
                value: self.gravity.pull().unwrap_or(0.0),
            }),
        }
    }

    fn table(&self, gravity: f64) -> Table<F, R> {
        Table {
            body: self.body,
            gravity,
            friction: self.friction,
            resistance: self.resistance,
        }
    }

    /// The numbers at the start, and the size below which each counts as small.
    fn opening(&self, gravity: f64) -> Result<(Numbers, Numbers)> {
        let y = numbers(&self.start);
        for component in y {
            finite("the start of a body on a table", component)?;
        }
        let size = self.body.surface().size();
        let turn = self.start.omega.norm() + (gravity / size).sqrt();
        let energy = self.body.mass() * size * size * turn * turn;
        let (v, w) = (size * turn, turn);
        let scales = [1.0, 1.0, 1.0, 1.0, w, w, w, v, v, size, size, energy];
        Ok((y, scales))
    }

    fn history(
        &self,
        gravity: f64,
        request: &Request,
        method: Method,
        times: &[f64],
    ) -> Result<History> {
        let table = self.table(gravity);
        let (y, scales) = self.opening(gravity)?;
        let accuracy = request.accuracy();
        let run = |tolerance: f64| {
            Run {
                table: &table,
                scales: &scales,
                method,
                tolerance,
                // Steps of this tolerance overshoot rest by about as much: nothing finer can be seen as rest.
                still: 10.0 * tolerance * scales[7],
            }
            .follow(&y, times)
        };
        tightened(accuracy, run, |a: &Place, b: &Place| {
            apart(&a.numbers, &b.numbers, &scales)
        })
    }

    /// Without gravity nothing presses: the free body.
    fn free(&self, request: &Request, plan: Plan) -> Result<Motion<State>> {
        let (y, scales) = self.opening(0.0)?;
        let table = self.table(0.0);
        let (height, climb) = table.height(&Pose::of(&y));
        let mut cost = Cost::default();
        let places: Vec<Place> = match plan.solver {
            Solver::General(method) => {
                let rates = |_: f64, y: &Numbers| free_rates(&table, y);
                let rates: &dyn System<NUMBERS> = &rates;
                let times = request.times();
                let run = refined(
                    rates,
                    &y,
                    &scales,
                    times,
                    method,
                    request.accuracy(),
                    |a, b| apart(a, b, &scales),
                )?;
                cost = run.cost;
                let rising = times.iter().map(|t| height + climb * t);
                let rows = run.states.into_iter().zip(rising);
                rows.map(|(numbers, height)| aloft(numbers, height, climb))
                    .collect()
            }
            _ => {
                let flight = Flight::from(&self.body, 0.0, &y, height, climb)?;
                let place = |&t: &f64| {
                    let place = flight.at(t)?;
                    Ok(aloft(place.numbers, place.height, place.climb))
                };
                request.times().iter().map(place).collect::<Result<_>>()?
            }
        };
        let states = places.iter().map(|place| State::of(&table, place));
        let rows: Vec<_> = request.times().iter().copied().zip(states).collect();
        let ledger = self.ledger(&table, &aloft(y, height, climb), &rows)?;
        Ok(Motion {
            plan,
            cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }

    fn ledger(&self, table: &Table<F, R>, start: &Place, rows: &[(f64, State)]) -> Result<Ledger> {
        let first = State::of(table, start);
        let mut ledger = Ledger::new();
        let energy = ledger.open("energy", Law::NonIncreasing, first.energy)?;
        let balance = ledger.open(
            "energy and what contact has taken",
            Law::Conserved,
            first.energy,
        )?;
        let unbraked = G::PRESENT && !R::PRESENT;
        let size = self.body.surface().size();
        let spin = self.body.inertia().matrix().amax() * first.omega.norm();
        let jellett = if unbraked && spin > 0.0 && self.body.has_jellett_integral() {
            Some(ledger.open_scaled(
                "Jellett's integral",
                Law::Conserved,
                first.jellett,
                spin * size,
            )?)
        } else {
            None
        };
        let vertical = if !F::PRESENT && !R::PRESENT && spin > 0.0 {
            Some(ledger.open_scaled(
                "vertical angular momentum",
                Law::Conserved,
                first.vertical_angular_momentum,
                spin,
            )?)
        } else {
            None
        };
        let mut order: Vec<&(f64, State)> = rows.iter().collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, state) in order {
            ledger.record(energy, state.energy)?;
            ledger.record(balance, state.energy + state.dissipated)?;
            if let Some(jellett) = jellett {
                ledger.record(jellett, state.jellett)?;
            }
            if let Some(vertical) = vertical {
                ledger.record(vertical, state.vertical_angular_momentum)?;
            }
        }
        Ok(ledger)
    }
}

impl<G: Pull, F: Grip, R: Resist> Scene for TableTop<G, F, R> {
    type State = State;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let reason = match (G::PRESENT, self.friction.hold(), F::PRESENT) {
            (false, _, _) => "no gravity, so no contact: closed form",
            (_, Holding::Grips, _) => "pure rolling: dop853 with take-off as an event",
            (_, Holding::Cone { .. }, _) => {
                "Coulomb friction: dop853 with slip, roll and take-off as events"
            }
            (_, Holding::Slides, true) => "sliding friction: dop853 with take-off as an event",
            (_, Holding::Slides, false) => {
                "a table without friction: dop853 with take-off as an event"
            }
        };
        let best = if G::PRESENT {
            Solver::General(Method::Dop853)
        } else {
            Solver::Exact
        };
        match request.choice() {
            Choice::Auto => Ok(Plan::new(best, reason)),
            Choice::Use(solver) if solver == best => Ok(Plan::new(solver, reason)),
            Choice::Use(solver @ Solver::General(method)) if method.is_adaptive() => {
                Ok(Plan::new(solver, "asked for"))
            }
            Choice::Use(solver) => Err(Error::Condition {
                condition: match solver {
                    Solver::Exact => "the solver exact must be given a body without gravity",
                    Solver::Events => {
                        "the solver events must be given a scene with closed forms between events"
                    }
                    _ => {
                        "a body on a table must be run by a method that chooses its own steps, not by rk4"
                    }
                },
                value: self.gravity.pull().unwrap_or(0.0),
            }),
        }
    }

    fn simulate(&self, request: &Request) -> Result<Motion<State>> {
        let plan = self.plan(request)?;
        let Some(gravity) = self.gravity.pull() else {
            return self.free(request, plan);
        };
        let method = self.method(&plan)?;
        let (order, times) = ascending(request)?;
        let history = self.history(gravity, request, method, &times)?;
        let table = self.table(gravity);
        let mut rows: Vec<Option<(f64, State)>> = vec![None; times.len()];
        for (&i, place) in order.iter().zip(&history.places) {
            rows[i] = Some((request.times()[i], State::of(&table, place)));
        }
        let rows: Vec<(f64, State)> = rows.into_iter().flatten().collect();
        let (y, _) = self.opening(gravity)?;
        let (y, support) = match self.friction.hold() {
            Holding::Grips => (table.rolled(&y), Support::Rolling),
            _ => (y, Support::Sliding),
        };
        let (height, climb) = table.height(&Pose::of(&y));
        let start = Place {
            numbers: y,
            height,
            climb,
            support,
        };
        let ledger = self.ledger(&table, &start, &rows)?;
        Ok(Motion {
            plan,
            cost: history.cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }
}

/// The places of the times in ascending order, and the times in it; the contact cannot be run backwards.
fn ascending(request: &Request) -> Result<(Vec<usize>, Vec<f64>)> {
    let times = request.times();
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let sorted: Vec<f64> = order.iter().map(|&i| times[i]).collect();
    match sorted.first() {
        Some(&first) if first < 0.0 => Err(Error::OutOfRange {
            quantity: "the time of a body on a table",
            value: first,
            least: 0.0,
            greatest: f64::INFINITY,
        }),
        _ => Ok((order, sorted)),
    }
}

/// Relative distance of two states: angle between the attitudes, Ω and level velocity over their scales.
fn apart(a: &Numbers, b: &Numbers, scales: &Numbers) -> f64 {
    let of = |y: &Numbers| crate::tippe_top::equations::attitude(&Pose::of(y));
    let angle = of(a).angle_to(&of(b));
    (4..9)
        .map(|i| (a[i] - b[i]).abs() / scales[i])
        .fold(angle, f64::max)
}

const fn aloft(numbers: Numbers, height: f64, climb: f64) -> Place {
    Place {
        numbers,
        height,
        climb,
        support: Support::Airborne,
    }
}

/// Euler's equations without torque, and C on a straight line.
fn free_rates<F, R>(table: &Table<F, R>, y: &Numbers) -> Numbers {
    let pose = Pose::of(y);
    let omega = pose.omega;
    let q = Quaternion::new(y[0], y[1], y[2], y[3]) * Quaternion::from_imag(omega) * 0.5;
    let r = table.body.unforced(&omega);
    [q.w, q.i, q.j, q.k, r.x, r.y, r.z, 0.0, 0.0, y[7], y[8], 0.0]
}
