//! A body on a table, run: compiled once for all lists of effects, which come as a [`Ground`] behind a pointer.

use nalgebra::Quaternion;

use super::run::{History, Place, Run, Support, tightened};
use super::state::State;
use super::{Holding, Phase};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, finite};
use crate::integrators::{Cost, Method, System, refined};
use crate::scene::Budget;
use crate::scene::motion::{Motion, Request, balanced};
use crate::scene::plan::{Choice, Plan, Solver};
use crate::tippe_top::Start;
use crate::tippe_top::equations::{Ground, NUMBERS, Numbers, Pose, attitude, numbers};
use crate::tippe_top::flight::Flight;

/// A scene, its effects behind a pointer, and which of them are there.
pub(super) struct Setting<'a> {
    pub(super) ground: &'a dyn Ground,
    pub(super) start: &'a Start,
    pub(super) gravity: bool,
    pub(super) friction: bool,
    pub(super) resistance: bool,
}

impl Setting<'_> {
    pub(super) fn plan(&self, request: &Request) -> Result<Plan> {
        let reason = match (self.gravity, self.ground.holding(), self.friction) {
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
        let best = if self.gravity {
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
            Choice::Use(solver) => Err(Error::Solver {
                condition: match solver {
                    Solver::Exact => "the solver exact must be given a body without gravity",
                    Solver::Events => {
                        "the solver events must be given a scene with closed forms between events"
                    }
                    _ => {
                        "a body on a table must be run by a method that chooses its own steps, not by rk4"
                    }
                },
            }),
        }
    }

    pub(super) fn phases(&self, request: &Request) -> Result<Vec<Phase>> {
        let plan = self.plan(request)?;
        if !self.gravity {
            let support = Support::Airborne;
            return Ok(vec![Phase {
                start: 0.0,
                support,
            }]);
        }
        let (_, times) = request.forward()?;
        Ok(self.history(request, self.method(&plan)?, &times)?.phases)
    }

    pub(super) fn motion(&self, request: &Request) -> Result<Motion<State>> {
        let plan = self.plan(request)?;
        if !self.gravity {
            return self.free(request, plan);
        }
        let (order, times) = request.forward()?;
        let history = self.history(request, self.method(&plan)?, &times)?;
        let mut places = vec![0; times.len()];
        for (place, &i) in order.iter().enumerate() {
            places[i] = place;
        }
        let rows = request.times().iter().zip(&places);
        let rows: Vec<(f64, State)> = rows
            .map(|(&t, &place)| (t, State::of(self.ground, &history.places[place])))
            .collect();
        let (y, _) = self.opening()?;
        let body = self.ground.body();
        let (numbers, support) = match self.ground.holding() {
            Holding::Grips => (body.rolled(&y), Support::Rolling),
            _ => (y, Support::Sliding),
        };
        let (height, climb) = body.height(&Pose::of(&numbers));
        let start = Place {
            numbers,
            height,
            climb,
            support,
        };
        let ledger = self.ledger(&start, &rows)?;
        Ok(Motion {
            error_estimate: None,
            plan,
            cost: history.cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }

    fn method(&self, plan: &Plan) -> Result<Method> {
        match plan.solver {
            Solver::General(method) => Ok(method),
            _ => Err(Error::Solver {
                condition: "a body on a table must be run by a general method",
            }),
        }
    }

    /// The numbers at the start, and the size below which each counts as small.
    fn opening(&self) -> Result<(Numbers, Numbers)> {
        let y = numbers(self.start);
        for component in y {
            finite("the start of a body on a table", component)?;
        }
        let body = self.ground.body();
        let size = body.surface().size();
        let turn = self.start.omega.norm() + (self.ground.gravity() / size).sqrt();
        let energy = body.mass() * size * size * turn * turn;
        let (v, w) = (size * turn, turn);
        let scales = [1.0, 1.0, 1.0, 1.0, w, w, w, v, v, size, size, energy];
        Ok((y, scales))
    }

    fn history(&self, request: &Request, method: Method, times: &[f64]) -> Result<History> {
        let (y, scales) = self.opening()?;
        let budget = &Budget::asked(request);
        let run = |tolerance: f64| {
            Run {
                budget,
                ground: self.ground,
                scales: &scales,
                method,
                tolerance,
            }
            .follow(&y, times)
        };
        tightened(request.accuracy(), run, |a: &Place, b: &Place| {
            apart(&a.numbers, &b.numbers, &scales)
        })
    }

    /// Without gravity nothing presses: the free body.
    fn free(&self, request: &Request, plan: Plan) -> Result<Motion<State>> {
        let (y, scales) = self.opening()?;
        let body = self.ground.body();
        let (height, climb) = body.height(&Pose::of(&y));
        let times = request.times();
        let mut cost = Cost::default();
        let places: Vec<Place> = match plan.solver {
            Solver::General(method) => {
                let rates = |_: f64, y: &Numbers| self.free_rates(y);
                let budget = Budget::asked(request);
                let rates: &dyn System<NUMBERS> = &budget.counted(&rates);
                let distance = |a: &Numbers, b: &Numbers| apart(a, b, &scales);
                let accuracy = request.accuracy();
                let run = refined(rates, &y, &scales, times, method, accuracy, distance)?;
                cost = run.cost;
                let rising = times.iter().map(|t| height + climb * t);
                let rows = run.states.into_iter().zip(rising);
                rows.map(|(numbers, height)| Place::aloft(numbers, height, climb))
                    .collect()
            }
            _ => {
                let flight = Flight::from(body, 0.0, &y, height, climb)?;
                let place = |&t: &f64| {
                    let place = flight.at(t)?;
                    Ok(Place::aloft(place.numbers, place.height, place.climb))
                };
                times.iter().map(place).collect::<Result<_>>()?
            }
        };
        let states = places.iter().map(|place| State::of(self.ground, place));
        let rows: Vec<_> = times.iter().copied().zip(states).collect();
        let ledger = self.ledger(&Place::aloft(y, height, climb), &rows)?;
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }

    /// Euler's equations without torque, and C on a straight line.
    fn free_rates(&self, y: &Numbers) -> Numbers {
        let omega = Pose::of(y).omega;
        let q = Quaternion::new(y[0], y[1], y[2], y[3]) * Quaternion::from_imag(omega) * 0.5;
        let r = self.ground.body().unforced(&omega);
        [q.w, q.i, q.j, q.k, r.x, r.y, r.z, 0.0, 0.0, y[7], y[8], 0.0]
    }

    fn ledger(&self, start: &Place, rows: &[(f64, State)]) -> Result<Ledger> {
        let body = self.ground.body();
        let first = State::of(self.ground, start);
        let mut ledger = Ledger::new();
        let energy = ledger.open("energy", Law::NonIncreasing, first.energy)?;
        let name = "energy and what contact has taken";
        let balance = ledger.open(name, Law::Conserved, first.energy)?;
        let spin = body.inertia().matrix().amax() * first.omega.norm();
        let jellett = self.gravity && !self.resistance && body.has_jellett_integral();
        let jellett = if jellett && spin > 0.0 {
            let (name, scale) = ("Jellett's integral", spin * body.surface().size());
            Some(ledger.open_scaled(name, Law::Conserved, first.jellett, scale)?)
        } else {
            None
        };
        let vertical = if !self.friction && !self.resistance && spin > 0.0 {
            let name = "vertical angular momentum";
            let value = first.vertical_angular_momentum;
            Some(ledger.open_scaled(name, Law::Conserved, value, spin)?)
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

/// Relative distance of two states: angle between the attitudes, Ω and level velocity over their scales.
fn apart(a: &Numbers, b: &Numbers, scales: &Numbers) -> f64 {
    let of = |y: &Numbers| attitude(&Pose::of(y));
    let angle = of(a).angle_to(&of(b));
    (4..9)
        .map(|i| (a[i] - b[i]).abs() / scales[i])
        .fold(angle, f64::max)
}
