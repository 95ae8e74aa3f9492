//! The scene `superball` (tutorial 4.6): a bouncing ball, under the open sky or under a table.
//!
//! | effect | type | what it does |
//! |---|---|---|
//! | gravity | [`Weight`] | bends the flights; without it they are straight |
//! | restitution | [`Restitution`] | loses a part of both contact speeds; without it nothing is lost |
//! | grip | [`Slipping`] | limits the tangential impulse; without it the contact never slips |

use super::choose;
use super::roller::{effort, in_order};
use super::{Absent, Choice, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result};
use crate::integrators::Cost;
use crate::superball::Restitution;
use crate::superball::flight::{Flight, Gravity, Grip, InFlight, Losses, Slipping, Weight};

impl Effect for Weight {
    const PRESENT: bool = true;
    const NAME: &'static str = "gravity";
}

impl Effect for Restitution {
    const PRESENT: bool = true;
    const NAME: &'static str = "restitution";
}

impl Effect for Slipping {
    const PRESENT: bool = true;
    const NAME: &'static str = "grip";
}

impl Gravity for Absent {
    const ACTS: bool = false;
    fn strength(&self) -> f64 {
        0.0
    }
}

impl Losses for Absent {
    const ACTS: bool = false;
    fn restitution(&self) -> [f64; 2] {
        [1.0; 2]
    }
}

impl Grip for Absent {
    const ACTS: bool = false;
    fn friction(&self) -> f64 {
        f64::INFINITY
    }
}

/// A ball that bounces between a floor and, perhaps, a ceiling.
#[derive(Debug, Clone, Copy)]
pub struct Superball<G = Absent, L = Absent, P = Absent> {
    mass: f64,
    kappa: f64,
    room: f64,
    start: InFlight,
    gravity: G,
    restitution: L,
    grip: P,
}

impl Superball {
    /// A ball of this mass (kg) and inertia factor under the open sky.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::NotFinite`] for the mass; the rest is examined when it runs.
    pub fn new(mass: f64, kappa: f64, start: InFlight) -> Result<Self> {
        Ok(Self {
            mass: crate::error::positive("the mass", mass)?,
            kappa,
            room: f64::INFINITY,
            start,
            gravity: Absent,
            restitution: Absent,
            grip: Absent,
        })
    }
}

impl<G, L, P> Superball<G, L, P> {
    /// The same under a ceiling: `room` (m) from floor to ceiling less the ball's diameter.
    pub fn under(mut self, room: f64) -> Self {
        self.room = room;
        self
    }

    /// The same with gravity.
    pub fn with_gravity<H>(self, gravity: H) -> Superball<H, L, P> {
        let Self {
            mass,
            kappa,
            room,
            start,
            restitution,
            grip,
            ..
        } = self;
        Superball {
            mass,
            kappa,
            room,
            start,
            gravity,
            restitution,
            grip,
        }
    }

    /// The same with restitution.
    pub fn with_restitution<M>(self, restitution: M) -> Superball<G, M, P> {
        let Self {
            mass,
            kappa,
            room,
            start,
            gravity,
            grip,
            ..
        } = self;
        Superball {
            mass,
            kappa,
            room,
            start,
            gravity,
            restitution,
            grip,
        }
    }

    /// The same with a limit to its grip.
    pub fn with_grip<Q>(self, grip: Q) -> Superball<G, L, Q> {
        let Self {
            mass,
            kappa,
            room,
            start,
            gravity,
            restitution,
            ..
        } = self;
        Superball {
            mass,
            kappa,
            room,
            start,
            gravity,
            restitution,
            grip,
        }
    }
}

impl<G: Gravity, L: Losses, P: Grip> Superball<G, L, P> {
    /// The flight itself.
    ///
    /// # Errors
    /// As [`Flight::new`].
    pub fn flight(&self) -> Result<Flight<G, L, P>> {
        let effects = (self.gravity, self.restitution, self.grip);
        Flight::new(self.kappa, self.room, effects, self.start)
    }
}

/// A ball at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bouncing {
    /// Where it is and how it moves.
    pub ball: InFlight,
    /// Kinetic energy plus weight times height, J.
    pub energy: f64,
}

impl Tabulated for Bouncing {
    /// m (the ball's lowest point above the floor); m/s; bounces so far; J.
    const COLUMNS: &'static [&'static str] = &[
        "x",
        "height",
        "velocity",
        "climb",
        "rim_speed",
        "bounces",
        "energy",
    ];

    fn row(&self) -> Vec<f64> {
        let b = &self.ball;
        let motion = b.motion;
        vec![
            b.position,
            b.height,
            motion.velocity,
            b.climb,
            motion.rim_speed,
            b.bounces as f64,
            self.energy,
        ]
    }
}

impl<G, L, P> Scene for Superball<G, L, P>
where
    G: Effect + Gravity,
    L: Effect + Losses,
    P: Effect + Grip,
{
    type State = Bouncing;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let elastic = !L::PRESENT && !P::PRESENT;
        match request.choice() {
            Choice::Auto if elastic => Ok(Plan::new(
                Solver::Exact,
                "elastic and non-slipping: a rotation a bounce, closed form",
            )),
            Choice::Auto => Ok(Plan::new(
                Solver::Events,
                "losses in the bounces: closed form from bounce to bounce",
            )),
            Choice::Use(Solver::Exact) if !elastic => Err(Error::Solver {
                condition: "the solver exact needs a superball without restitution and grip; ask for events",
            }),
            Choice::Use(Solver::General(method)) => Ok(Plan::new(
                Solver::General(method),
                format!("flights: {} with events, as asked for", method.name()),
            )),
            Choice::Use(Solver::Geometric(_)) => Err(super::only_for_tops()),
            Choice::Use(solver) => Ok(Plan::new(solver, "as asked for")),
        }
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Bouncing>> {
        let plan = self.plan(request)?;
        let (order, times) = request.forward()?;
        let flight = self.flight()?;
        let bounces = |balls: &[InFlight]| Cost {
            evaluations: 0,
            steps: balls.last().map_or(0, |b| b.bounces - self.start.bounces),
        };
        let (balls, cost) = match plan.solver {
            Solver::Exact => {
                let balls = times.iter().map(|&t| flight.exact(t));
                (balls.collect::<Result<Vec<_>>>()?, Cost::default())
            }
            Solver::General(method) => {
                flight.integrated(&times, (method, effort(method, request, &times)))?
            }
            Solver::Events | Solver::Geometric(_) => {
                let balls = flight.followed(&times)?;
                let cost = bounces(&balls);
                (balls, cost)
            }
        };
        let energy = |ball: &InFlight| self.mass * ball.energy(self.kappa, flight.gravity());
        let mut ledger = Ledger::new();
        let law = if L::PRESENT || P::PRESENT {
            Law::NonIncreasing
        } else {
            Law::Conserved
        };
        let first = energy(&self.start);
        let scale = if first > 0.0 { first } else { 1.0 };
        let account = ledger.open_scaled("energy", law, first, scale)?;
        // A flight that goes on through the floor keeps its energy too.
        let depth = |ball: &InFlight| (-ball.height).max(ball.height - self.room).max(0.0);
        let highest = balls
            .iter()
            .map(|b| b.height.abs())
            .fold(self.start.height, f64::max);
        let room = if highest > 0.0 {
            highest.min(self.room)
        } else {
            1.0
        };
        let name = "depth in floor or ceiling";
        let inside = ledger.open_scaled(name, Law::Conserved, depth(&self.start), room)?;
        for ball in &balls {
            ledger.record(account, energy(ball))?;
            ledger.record(inside, depth(ball))?;
        }
        let states = balls.iter().map(|ball| Bouncing {
            ball: *ball,
            energy: energy(ball),
        });
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows: in_order(request, &order, states),
        })
    }
}

/// Simulates `ball` with those of the effects that are listed: one compiled scene a combination.
///
/// # Errors
/// As for [`Scene::simulate`].
pub fn listed(
    ball: Superball,
    gravity: Option<Weight>,
    restitution: Option<Restitution>,
    grip: Option<Slipping>,
    request: &Request,
) -> Result<Motion<Bouncing>> {
    choose!((gravity = gravity) (restitution = restitution) (grip = grip) => ball
        .with_gravity(gravity)
        .with_restitution(restitution)
        .with_grip(grip)
        .simulate(request))
}
