//! A yo-yo, run from phase to phase: compiled once for all lists of effects, which come as [`Acting`] behind a pointer.

use super::effects::Passed;
use super::exact::ClosedForms;
use super::{Phase, YoYoState};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result};
use crate::integrators::{Cost, Method};
use crate::scene::Budget;
use crate::scene::motion::{Motion, Request, balanced};
use crate::scene::plan::{Choice, Plan, Solver};
use crate::yo_yo::{Unwinding, YoYo, spin_after_waking};

/// Most turns of a run.
const MOST_TURNS: u32 = 1_000_000;

/// What a yo-yo sets out with into a phase.
#[derive(Debug, Clone, Copy)]
pub(super) struct Departure {
    pub stage: Stage,
    /// Of the whole, J; on the way down and up it decides the way.
    pub energy: f64,
    pub omega: f64,
}

/// A phase, and the half of the turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    Down,
    Turn,
    /// The first quarter, to where it falls asleep; the last one, from where it wakes.
    IntoSleep,
    OutOfSleep,
    Up,
    Asleep,
    Hanging,
    Caught,
}

/// What the yo-yo does in a phase: samples until it ends, and with what it ends.
pub(super) struct Leg {
    pub samples: Vec<Sample>,
    /// Time, energy and spin at the end; none if the phase outlasts the last sample asked for.
    pub end: Option<Ending>,
    pub cost: Cost,
}

pub(super) struct Ending {
    /// When, s.
    pub time: f64,
    pub energy: f64,
    pub omega: f64,
    /// Lost in this phase by what acts all the time.
    pub heat: f64,
}

#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub depth: f64,
    pub velocity: f64,
    pub omega: f64,
    pub tension: f64,
    pub heat: f64,
}

/// What both engines need to know.
#[derive(Clone, Copy)]
pub(super) struct Bench {
    pub toy: YoYo,
    pub gravity: f64,
    pub torque: f64,
    pub asleep: f64,
}

/// What moves a yo-yo through a phase.
pub(super) trait Engine {
    /// Samples at those of the times (s, in order) that the phase lasts, which began at `begin`.
    fn leg(&self, departure: &Departure, begin: f64, times: &[f64]) -> Result<Leg>;
}

/// What a list of effects does, behind a pointer.
pub(super) trait Acting {
    /// g, m/s².
    fn gravity(&self) -> f64;
    /// What a turn takes and what the hand gives in it; `kinetic` tells the energy of a spin.
    fn turned(&self, passed: &mut Passed, kinetic: &dyn Fn(f64) -> f64);
    /// How long it is left asleep, s; none without a loop.
    fn sleeps(&self) -> Option<f64>;
    /// Friction of the loop, N m.
    fn torque(&self) -> f64;
    /// Resistance of the air, kg m²; none without air.
    fn air(&self) -> Option<f64>;
}

/// A yo-yo, how fast it is thrown, and what acts on it.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub toy: YoYo,
    pub throw: f64,
    pub effects: &'a dyn Acting,
}

impl Setting<'_> {
    pub fn plan(&self, request: &Request) -> Result<Plan> {
        request.forward()?;
        let air = self.effects.air().is_some();
        let solver = match request.choice() {
            Choice::Use(solver) => solver,
            Choice::Auto if air => Solver::General(Method::Dop853),
            Choice::Auto => Solver::Events,
        };
        let reason = match solver {
            Solver::Events if !air => "no air: closed forms from event to event",
            Solver::General(method) if !method.is_adaptive() => {
                return Err(Error::Solver {
                    condition: "the solver must choose its steps: a yo-yo falls for seconds and turns in milliseconds",
                });
            }
            Solver::General(_) if air => "resistance of the air: general integration with events",
            Solver::General(_) => "asked for, though there are closed forms from event to event",
            Solver::Exact | Solver::Events | Solver::Geometric(_) => {
                return Err(Error::Solver {
                    condition: "the solver must be events for a yo-yo without air, a general one with it",
                });
            }
        };
        Ok(Plan::new(solver, reason))
    }

    pub fn motion(&self, request: &Request) -> Result<Motion<YoYoState>> {
        let plan = self.plan(request)?;
        let (order, times) = request.forward()?;
        let (states, cost) = match plan.solver {
            Solver::General(method) => self.refined(&times, method, request)?,
            _ => self.run(&ClosedForms(self.bench()), &times, &Budget::asked(request))?,
        };
        let ledger = self.ledger(&states, request.accuracy())?;
        let asked = request.times().iter();
        let mut rows: Vec<(f64, YoYoState)> = asked.map(|&t| (t, states[0])).collect();
        for (&place, state) in order.iter().zip(states) {
            rows[place].1 = state;
        }
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows,
        })
    }

    pub fn bench(&self) -> Bench {
        Bench {
            toy: self.toy,
            gravity: self.effects.gravity(),
            torque: self.effects.torque(),
            asleep: self.effects.sleeps().unwrap_or(0.0),
        }
    }

    fn first(&self) -> Result<Departure> {
        let gravity = self.effects.gravity();
        let energy = Unwinding::energy_at(&self.toy, gravity, 0.0, self.throw)?;
        let stage = if energy > 0.0 || gravity > 0.0 {
            Stage::Down
        } else {
            // Nothing moves it: it stays in the hand.
            Stage::Caught
        };
        let omega = self.throw / self.toy.radius(0.0);
        Ok(Departure {
            stage,
            energy,
            omega,
        })
    }

    /// What is ½(I + m r²)ω² with the radius of the bare axle.
    fn kinetic(&self, omega: f64) -> f64 {
        self.toy.kinetic_energy(self.toy.length(), omega)
    }

    /// Where a phase leads: the next departure, and the heat and the work of the event between.
    fn next(&self, from: Stage, end: &Ending) -> (Departure, f64, f64) {
        let (energy, omega) = (end.energy, end.omega);
        let go = |stage, energy, omega| Departure {
            stage,
            energy,
            omega,
        };
        let r = self.toy.axle();
        let gravity = self.effects.gravity();
        let pull = gravity * r / (r * r + self.toy.gyration_squared());
        // Whether a spin at the end of the string carries the axle round it.
        let turns = |omega: f64| omega * omega > 2.0 * pull && omega > 0.0;
        let bottom = -self.toy.mass() * gravity * (self.toy.length() + r);
        match from {
            Stage::Down if !turns(omega) => (go(Stage::Hanging, bottom, 0.0), energy - bottom, 0.0),
            Stage::Down if self.effects.sleeps().is_some() => {
                (go(Stage::IntoSleep, energy, omega), 0.0, 0.0)
            }
            Stage::Down => (go(Stage::Turn, energy, omega), 0.0, 0.0),
            Stage::IntoSleep => {
                // The loop slips, and the string takes up what the centre had.
                let lost = 0.5 * self.toy.mass() * (r * omega) * (r * omega);
                (go(Stage::Asleep, energy - lost, omega), lost, 0.0)
            }
            Stage::Asleep => {
                let awake = spin_after_waking(&self.toy, omega);
                let square = awake * awake - 2.0 * pull;
                if square > 2.0 * pull {
                    let lost = 0.5 * self.toy.inertia() * omega * omega - self.kinetic(awake);
                    let omega = square.sqrt();
                    (go(Stage::OutOfSleep, energy - lost, omega), lost, 0.0)
                } else {
                    (go(Stage::Hanging, bottom, 0.0), energy - bottom, 0.0)
                }
            }
            Stage::Turn | Stage::OutOfSleep => {
                let mut passed = Passed {
                    omega,
                    energy,
                    heat: 0.0,
                    work: 0.0,
                };
                self.effects.turned(&mut passed, &|spin| self.kinetic(spin));
                let Passed {
                    omega,
                    energy,
                    heat,
                    work,
                } = passed;
                // Unwinding::new asks the same: energy enough to leave the end of the string.
                if omega > 0.0 && energy > -self.toy.mass() * gravity * self.toy.length() {
                    (go(Stage::Up, energy, omega), heat, work)
                } else {
                    (
                        go(Stage::Hanging, bottom, 0.0),
                        heat + energy - bottom,
                        work,
                    )
                }
            }
            Stage::Up if energy > 0.0 => (go(Stage::Caught, 0.0, 0.0), 0.0, -energy),
            Stage::Up => (go(Stage::Down, energy, 0.0), 0.0, 0.0),
            Stage::Hanging | Stage::Caught => (go(from, energy, omega), 0.0, 0.0),
        }
    }

    /// The states at `times`, in ascending order.
    pub fn run(
        &self,
        engine: &dyn Engine,
        times: &[f64],
        budget: &Budget,
    ) -> Result<(Vec<YoYoState>, Cost)> {
        let mut states = Vec::with_capacity(times.len());
        let mut departure = self.first()?;
        let (mut clock, mut heat, mut work) = (0.0, 0.0, 0.0);
        let mut cost = Cost::default();
        let mut turns = 0_u32;
        while states.len() < times.len() {
            let leg = engine.leg(&departure, clock, &times[states.len()..])?;
            cost += leg.cost;
            budget.spend(1 + leg.samples.len() as u64, clock)?;
            for sample in leg.samples {
                states.push(self.state(departure.stage, &sample, heat, work));
            }
            let Some(end) = leg.end else { break };
            clock = end.time;
            heat += end.heat;
            let (next, lost, done) = self.next(departure.stage, &end);
            heat += lost;
            work += done;
            turns += u32::from(departure.stage == Stage::Down);
            if turns > MOST_TURNS {
                return Err(Error::Condition {
                    condition: "a yo-yo may be followed for a million turns at most; it had not come to the last time",
                    value: clock,
                });
            }
            departure = next;
        }
        Ok((states, cost))
    }

    fn state(&self, stage: Stage, sample: &Sample, heat: f64, work: f64) -> YoYoState {
        let Sample {
            depth,
            velocity,
            omega,
            tension,
            ..
        } = *sample;
        let phase = match stage {
            Stage::Down => Phase::Down,
            Stage::Turn | Stage::IntoSleep | Stage::OutOfSleep => Phase::Turn,
            Stage::Up => Phase::Up,
            Stage::Asleep => Phase::Asleep,
            Stage::Hanging => Phase::Hanging,
            Stage::Caught => Phase::Caught,
        };
        let kinetic = match phase {
            Phase::Down | Phase::Up | Phase::Turn => self.toy.kinetic_energy(depth, omega),
            _ => 0.5 * self.toy.inertia() * omega * omega,
        };
        YoYoState {
            phase,
            depth,
            velocity,
            omega,
            tension,
            energy: kinetic - self.toy.mass() * self.effects.gravity() * depth,
            heat: heat + sample.heat,
            work,
        }
    }

    fn ledger(&self, states: &[YoYoState], accuracy: f64) -> Result<Ledger> {
        let start = self.first()?.energy;
        let weight = self.toy.mass() * self.effects.gravity();
        let hand = states.iter().map(|s| s.work).fold(0.0, f64::max);
        let scale = start.abs() + weight * self.toy.length() + hand;
        let mut ledger = Ledger::new();
        if scale == 0.0 {
            return Ok(ledger);
        }
        let balance = "energy and heat less the work of the hand";
        let balance = ledger.open_scaled(balance, Law::Conserved, start, scale)?;
        let heat = ledger.open_scaled("heat", Law::NonDecreasing, 0.0, scale)?;
        for state in states {
            ledger.record(balance, state.energy + state.heat - state.work)?;
            ledger.record(heat, state.heat)?;
        }
        balanced(ledger, accuracy)
    }
}
