//! A yo-yo let go or thrown from the hand (tutorial 4.9): down, turn, up, and down again; or down, asleep, awake, and up.
//!
//! | effect | slot | absent |
//! |---|---|---|
//! | weight | [`with_gravity`](Play::with_gravity) | it unwinds by its throw alone |
//! | loss at the turn | [`with_turn_loss`](Play::with_turn_loss) | every turn gives the spin back |
//! | work of the hand | [`with_hand`](Play::with_hand) | the hand holds still |
//! | a loop at the end of the string | [`with_sleep`](Play::with_sleep) | a knot: it comes up at once |
//! | friction in the loop | [`with_axle_friction`](Play::with_axle_friction) | it sleeps without loss |
//! | resistance of the air | [`with_air_drag`](Play::with_air_drag) | none; with it the closed forms end |

mod effects;
mod exact;
mod general;

pub use effects::{AirDrag, AxleFriction, Gravity, Hand, Sleep, TurnLoss};

use super::effect::Absent;
use super::motion::{Motion, Request, balanced};
use super::plan::{Choice, Plan, Solver};
use super::{Scene, Tabulated, choose};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, not_negative};
use crate::integrators::{Cost, Method};
use crate::yo_yo::{Unwinding, YoYo, spin_after_waking};
use effects::{AirTerm, AxleTerm, HandTerm, SleepTerm, TurnTerm, Weight};

/// What the yo-yo is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// On its way down.
    Down,
    /// In the turn at the end of the string.
    Turn,
    /// On its way up.
    Up,
    /// Spinning in the loop.
    Asleep,
    /// At the end of the string, without spin enough to leave it.
    Hanging,
    /// Back in the hand with speed to spare, and caught.
    Caught,
}

/// The state of a yo-yo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YoYoState {
    /// What it is at.
    pub phase: Phase,
    /// Depth below the hand, m.
    pub depth: f64,
    /// Velocity downward, m/s.
    pub velocity: f64,
    /// Spin, rad/s; its sense never changes.
    pub omega: f64,
    /// Pull of the string, N; the blows on falling asleep and on waking are not in it.
    pub tension: f64,
    /// Kinetic and potential energy, J; zero at rest at the hand.
    pub energy: f64,
    /// Energy lost so far, J.
    pub heat: f64,
    /// Work that the hand has done so far, J; catching counts against it.
    pub work: f64,
}

impl Tabulated for YoYoState {
    const COLUMNS: &'static [&'static str] = &[
        "depth", "velocity", "omega", "tension", "energy", "heat", "work",
    ];

    fn row(&self) -> Vec<f64> {
        vec![
            self.depth,
            self.velocity,
            self.omega,
            self.tension,
            self.energy,
            self.heat,
            self.work,
        ]
    }
}

/// A yo-yo, how fast it is thrown, and what acts on it.
///
/// Effects fill slots of their own, so the order in which they are listed cannot matter.
///
/// ```
/// use spinning_bodies::scene::{Request, Scene, yo_yo::{Gravity, Play}};
/// use spinning_bodies::yo_yo::YoYo;
///
/// let toy = YoYo::disc(0.055, 0.029, 1.0, 0.005)?;
/// let play = Play::new(toy, 0.0)?.with_gravity(Gravity { acceleration: 9.81 })?;
/// let motion = play.simulate(&Request::at([1.9])?)?;
/// assert!((motion.rows[0].1.depth - 0.9936).abs() < 1e-4);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Play<G = Absent, T = Absent, H = Absent, S = Absent, X = Absent, W = Absent> {
    toy: YoYo,
    throw: f64,
    gravity: G,
    turn_loss: T,
    hand: H,
    sleep: S,
    axle_friction: X,
    air_drag: W,
}

impl Play {
    /// This yo-yo, thrown from the hand with this speed (m/s; 0: let go).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    pub fn new(toy: YoYo, throw: f64) -> Result<Self> {
        Ok(Self {
            toy,
            throw: not_negative("the speed of the throw", throw)?,
            gravity: Absent,
            turn_loss: Absent,
            hand: Absent,
            sleep: Absent,
            axle_friction: Absent,
            air_drag: Absent,
        })
    }
}

impl<G: Copy, T: Copy, H: Copy, S: Copy, X: Copy, W: Copy> Play<G, T, H, S, X, W> {
    /// Adds weight.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_gravity(self, effect: Gravity) -> Result<Play<Gravity, T, H, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: effect.checked()?,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the loss of every turn.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_turn_loss(self, effect: TurnLoss) -> Result<Play<G, TurnLoss, H, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: effect.checked()?,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the work of the hand at every turn.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_hand(self, effect: Hand) -> Result<Play<G, T, Hand, S, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: effect.checked()?,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Ties the string in a loop, so that the yo-yo sleeps at the end of it.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_sleep(self, effect: Sleep) -> Result<Play<G, T, H, Sleep, X, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: effect.checked()?,
            axle_friction: self.axle_friction,
            air_drag: self.air_drag,
        })
    }

    /// Adds the friction of the loop on the axle while the yo-yo sleeps.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_axle_friction(
        self,
        effect: AxleFriction,
    ) -> Result<Play<G, T, H, S, AxleFriction, W>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: effect.checked()?,
            air_drag: self.air_drag,
        })
    }

    /// Adds the resistance of the air to the spin.
    ///
    /// # Errors
    /// As the fields of the effect say.
    pub fn with_air_drag(self, effect: AirDrag) -> Result<Play<G, T, H, S, X, AirDrag>> {
        Ok(Play {
            toy: self.toy,
            throw: self.throw,
            gravity: self.gravity,
            turn_loss: self.turn_loss,
            hand: self.hand,
            sleep: self.sleep,
            axle_friction: self.axle_friction,
            air_drag: effect.checked()?,
        })
    }
}

/// Most turns of a run.
const MOST_TURNS: u32 = 1_000_000;

/// What a yo-yo sets out with into a phase.
#[derive(Debug, Clone, Copy)]
struct Departure {
    stage: Stage,
    /// Of the whole, J; on the way down and up it decides the way.
    energy: f64,
    omega: f64,
}

/// A phase, and the half of the turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
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
struct Leg {
    samples: Vec<Sample>,
    /// Duration, energy and spin at the end; none if the phase outlasts the last sample asked for.
    end: Option<Ending>,
    cost: Cost,
}

struct Ending {
    duration: f64,
    energy: f64,
    omega: f64,
    /// Lost in this phase by what acts all the time.
    heat: f64,
}

#[derive(Clone, Copy)]
struct Sample {
    depth: f64,
    velocity: f64,
    omega: f64,
    tension: f64,
    heat: f64,
}

/// What both engines need to know.
#[derive(Clone, Copy)]
struct Bench {
    toy: YoYo,
    gravity: f64,
    torque: f64,
    asleep: f64,
}

/// What moves a yo-yo through a phase.
trait Engine {
    /// Samples at these times (s after the phase began, in order).
    fn leg(&self, departure: &Departure, times: &[f64]) -> Result<Leg>;
}

impl<G, T, H, S, X, W> Play<G, T, H, S, X, W>
where
    G: Weight,
    T: TurnTerm,
    H: HandTerm,
    S: SleepTerm,
    X: AxleTerm,
    W: AirTerm,
{
    fn bench(&self) -> Bench {
        Bench {
            toy: self.toy,
            gravity: self.gravity.acceleration(),
            torque: self.axle_friction.torque(),
            asleep: self.sleep.duration(),
        }
    }

    fn first(&self) -> Result<Departure> {
        let gravity = self.gravity.acceleration();
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
        let gravity = self.gravity.acceleration();
        let pull = gravity * r / (r * r + self.toy.gyration_squared());
        // Whether a spin at the end of the string carries the axle round it.
        let turns = |omega: f64| omega * omega > 2.0 * pull && omega > 0.0;
        let bottom = -self.toy.mass() * gravity * (self.toy.length() + r);
        match from {
            Stage::Down if !turns(omega) => (go(Stage::Hanging, bottom, 0.0), energy - bottom, 0.0),
            Stage::Down if S::PRESENT => (go(Stage::IntoSleep, energy, omega), 0.0, 0.0),
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
                let (mut energy, mut omega, mut heat, mut work) = (energy, omega, 0.0, 0.0);
                self.turn_loss
                    .pass(&mut omega, &mut energy, &mut heat, |spin| {
                        self.kinetic(spin)
                    });
                self.hand
                    .pass(&mut omega, &mut energy, &mut work, 2.0 * self.kinetic(1.0));
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
    fn run(&self, engine: &dyn Engine, times: &[f64]) -> Result<(Vec<YoYoState>, Cost)> {
        let mut states = Vec::with_capacity(times.len());
        let mut departure = self.first()?;
        let (mut clock, mut heat, mut work) = (0.0, 0.0, 0.0);
        let mut cost = Cost::default();
        let mut turns = 0_u32;
        while states.len() < times.len() {
            let left = &times[states.len()..];
            let since: Vec<f64> = left.iter().map(|t| (t - clock).max(0.0)).collect();
            let leg = engine.leg(&departure, &since)?;
            cost += leg.cost;
            for sample in leg.samples {
                states.push(self.state(departure.stage, &sample, heat, work));
            }
            let Some(end) = leg.end else { break };
            clock += end.duration;
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
            energy: kinetic - self.toy.mass() * self.gravity.acceleration() * depth,
            heat: heat + sample.heat,
            work,
        }
    }

    fn ledger(&self, states: &[YoYoState], accuracy: f64) -> Result<Ledger> {
        let start = self.first()?.energy;
        let weight = self.toy.mass() * self.gravity.acceleration();
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

impl<G, T, H, S, X, W> Scene for Play<G, T, H, S, X, W>
where
    G: Weight,
    T: TurnTerm,
    H: HandTerm,
    S: SleepTerm,
    X: AxleTerm,
    W: AirTerm,
{
    type State = YoYoState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let least = request.times().iter().copied().fold(0.0, f64::min);
        if least < 0.0 {
            return Err(Error::OutOfRange {
                quantity: "the time of a yo-yo",
                value: least,
                least: 0.0,
                greatest: f64::INFINITY,
            });
        }
        let solver = match request.choice() {
            Choice::Use(solver) => solver,
            Choice::Auto if W::PRESENT => Solver::General(Method::Dop853),
            Choice::Auto => Solver::Events,
        };
        let reason = match solver {
            Solver::Events if !W::PRESENT => "no air: closed forms from event to event",
            Solver::General(method) if !method.is_adaptive() => {
                return Err(Error::Condition {
                    condition: "the solver must choose its steps: a yo-yo falls for seconds and turns in milliseconds",
                    value: f64::NAN,
                });
            }
            Solver::General(_) if W::PRESENT => {
                "resistance of the air: general integration with events"
            }
            Solver::General(_) => "asked for, though there are closed forms from event to event",
            Solver::Exact | Solver::Events | Solver::Geometric(_) => {
                return Err(Error::Condition {
                    condition: "the solver must be events for a yo-yo without air, a general one with it",
                    value: f64::NAN,
                });
            }
        };
        Ok(Plan::new(solver, reason))
    }

    fn simulate(&self, request: &Request) -> Result<Motion<YoYoState>> {
        let plan = self.plan(request)?;
        let asked = request.times();
        let mut order: Vec<usize> = (0..asked.len()).collect();
        order.sort_by(|&i, &j| asked[i].total_cmp(&asked[j]));
        let times: Vec<f64> = order.iter().map(|&i| asked[i]).collect();
        let (states, cost) = match plan.solver {
            Solver::General(method) => self.refined(&times, method, request.accuracy())?,
            _ => self.run(&exact::ClosedForms(self.bench()), &times)?,
        };
        let ledger = self.ledger(&states, request.accuracy())?;
        let mut rows: Vec<(f64, YoYoState)> = asked.iter().map(|&t| (t, states[0])).collect();
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
}

/// Effects of a yo-yo that are known at run time only, as from a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Weight.
    pub gravity: Option<Gravity>,
    /// Loss of every turn.
    pub turn_loss: Option<TurnLoss>,
    /// Work of the hand.
    pub hand: Option<Hand>,
    /// The loop.
    pub sleep: Option<Sleep>,
    /// Friction in the loop.
    pub axle_friction: Option<AxleFriction>,
    /// Resistance of the air.
    pub air_drag: Option<AirDrag>,
}

impl Listed {
    /// The scene of a yo-yo, thrown with this speed (m/s), with just these effects.
    ///
    /// # Errors
    /// As [`Play::new`], and the builder method of each effect.
    pub fn on(&self, toy: YoYo, throw: f64) -> Result<Box<dyn Scene<State = YoYoState>>> {
        Play::new(toy, throw)?;
        let gravity = self.gravity.map(Gravity::checked).transpose()?;
        let turn_loss = self.turn_loss.map(TurnLoss::checked).transpose()?;
        let hand = self.hand.map(Hand::checked).transpose()?;
        let sleep = self.sleep.map(Sleep::checked).transpose()?;
        let axle_friction = self.axle_friction.map(AxleFriction::checked).transpose()?;
        let air_drag = self.air_drag.map(AirDrag::checked).transpose()?;
        Ok(
            choose!((gravity = gravity) (turn_loss = turn_loss) (hand = hand) (sleep = sleep) (axle_friction = axle_friction)
            (air_drag = air_drag) => {
                Box::new(Play { toy, throw, gravity, turn_loss, hand, sleep, axle_friction, air_drag })
            }),
        )
    }
}
