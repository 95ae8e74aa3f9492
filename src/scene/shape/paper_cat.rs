//! The paper cat (tutorial 1.1): a rigid sheet that the air turns over.

use super::{in_order, planned, with_corners};
use crate::conservation::{Law, Ledger};
use crate::error::{Result, finite, positive};
use crate::integrators::{Cost, Effort, Method, Stop, refined, until};
use crate::phenomena;
use crate::scene::{
    Absent, Budget, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
};

use super::cat::Gravity;

/// Weight, or none.
pub trait Weight: Effect {
    /// The acceleration of fall, m/s², with what this adds.
    fn pulled(&self, acceleration: f64) -> f64;

    /// Energy of height, J/kg, at this fall (m), added.
    fn lifted(&self, energy: f64, fall: f64) -> f64;
}

impl Weight for Absent {
    fn pulled(&self, acceleration: f64) -> f64 {
        acceleration
    }

    fn lifted(&self, energy: f64, _: f64) -> f64 {
        energy
    }
}

impl Weight for Gravity {
    fn pulled(&self, acceleration: f64) -> f64 {
        acceleration + self.g
    }

    fn lifted(&self, energy: f64, fall: f64) -> f64 {
        energy - self.g * fall
    }
}

/// Air, or none.
pub trait Atmosphere: Effect {
    /// What the air does: deceleration of the fall (m/s²) and angular acceleration (rad/s²), applied.
    fn blown(&self, cat: &phenomena::PaperCat, rates: [f64; 2], state: [f64; 3]) -> [f64; 2];

    /// Power lost to the air, W/kg, added.
    fn lost(&self, cat: &phenomena::PaperCat, power: f64, velocity: f64) -> f64;
}

impl Atmosphere for Absent {
    fn blown(&self, _: &phenomena::PaperCat, rates: [f64; 2], _: [f64; 3]) -> [f64; 2] {
        rates
    }

    fn lost(&self, _: &phenomena::PaperCat, power: f64, _: f64) -> f64 {
        power
    }
}

/// Air at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Air {
    /// Its density, kg/m³.
    pub density: f64,
}

impl Effect for Air {
    const PRESENT: bool = true;
    const NAME: &'static str = "air";
}

impl Atmosphere for Air {
    fn blown(
        &self,
        cat: &phenomena::PaperCat,
        [fall, turn]: [f64; 2],
        [velocity, tilt, tilt_rate]: [f64; 3],
    ) -> [f64; 2] {
        [
            fall - cat.drag(self.density, velocity),
            turn + cat.righting(self.density, velocity, tilt, tilt_rate),
        ]
    }

    fn lost(&self, cat: &phenomena::PaperCat, power: f64, velocity: f64) -> f64 {
        power + cat.drag(self.density, velocity) * velocity
    }
}

/// A paper cat let go: tilt, air and weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperCat<A = Absent, W = Absent> {
    cat: phenomena::PaperCat,
    tilt: f64,
    air: A,
    gravity: W,
}

/// A paper cat at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperCatState {
    /// How far it has fallen, m.
    pub fall: f64,
    /// Velocity of fall, m/s.
    pub velocity: f64,
    /// Tilt from feet-down, radians.
    pub tilt: f64,
    /// Its rate, rad/s.
    pub tilt_rate: f64,
    /// Energy lost to the air, J/kg.
    pub lost: f64,
}

impl Tabulated for PaperCatState {
    const COLUMNS: &'static [&'static str] = &["fall", "velocity", "tilt", "tilt_rate", "lost"];

    fn row(&self) -> Vec<f64> {
        vec![
            self.fall,
            self.velocity,
            self.tilt,
            self.tilt_rate,
            self.lost,
        ]
    }
}

/// When a paper cat first points its feet down, and how far it has fallen by then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Righting {
    /// s.
    pub time: f64,
    /// m.
    pub fall: f64,
}

impl PaperCat {
    /// A cat at rest, tilted by this much (radians) from feet-down.
    ///
    /// # Errors
    /// What no cat can be like; [`Error::NotFinite`](crate::Error::NotFinite) for the tilt.
    pub fn new(cat: phenomena::PaperCat, tilt: f64) -> Result<Self> {
        Ok(Self {
            cat: cat.checked()?,
            tilt: finite("the tilt", tilt)?,
            air: Absent,
            gravity: Absent,
        })
    }
}

impl<A: Atmosphere, W: Weight> PaperCat<A, W> {
    /// The same in this air.
    pub fn with_air<B: Atmosphere>(self, air: B) -> PaperCat<B, W> {
        PaperCat {
            cat: self.cat,
            tilt: self.tilt,
            air,
            gravity: self.gravity,
        }
    }

    /// The same with weight.
    pub fn with_gravity<V: Weight>(self, gravity: V) -> PaperCat<A, V> {
        PaperCat {
            cat: self.cat,
            tilt: self.tilt,
            air: self.air,
            gravity,
        }
    }

    /// Fall, velocity, tilt, its rate, loss.
    fn rate(&self, y: &[f64; 5]) -> [f64; 5] {
        let [_, velocity, tilt, tilt_rate, _] = *y;
        let own = [self.gravity.pulled(0.0), 0.0];
        let [fall, turn] = self.air.blown(&self.cat, own, [velocity, tilt, tilt_rate]);
        [
            velocity,
            fall,
            tilt_rate,
            turn,
            self.air.lost(&self.cat, 0.0, velocity),
        ]
    }

    fn start(&self) -> [f64; 5] {
        [0.0, 0.0, self.tilt, 0.0, 0.0]
    }

    fn scales(&self) -> [f64; 5] {
        // A tilt near π is a small distance from π: the error of a nearly upside-down cat is what counts.
        let near = (core::f64::consts::PI - self.tilt.abs()).abs();
        let small = near.clamp(1e-8, 1.0);
        [0.1, 0.1, small, small, 0.1]
    }

    /// Where the cat first points its feet down, if it does within `time` (s).
    ///
    /// # Errors
    /// Those of [`until`].
    pub fn rights_itself(&self, time: f64) -> Result<Option<Righting>> {
        let time = positive("the time to wait", time)?;
        let side = self.tilt.signum();
        let upright = move |_: f64, y: &[f64; 5]| side * y[2];
        let rate = |_: f64, y: &[f64; 5]| self.rate(y);
        let run = until(
            &rate,
            0.0,
            &self.start(),
            &self.scales(),
            &[],
            time,
            &upright,
            Method::Dop853,
            Effort::Tolerance(1e-13),
        )?;
        Ok((run.stopped == Stop::AtTheEvent).then_some(Righting {
            time: run.time,
            fall: run.end[0],
        }))
    }

    fn known(&self, t: f64) -> [f64; 5] {
        let g = self.gravity.pulled(0.0);
        [0.5 * g * t * t, g * t, self.tilt, 0.0, 0.0]
    }

    fn ledger(&self, states: &[[f64; 5]]) -> Result<Ledger> {
        let energy = |y: &[f64; 5]| self.gravity.lifted(0.5 * y[1] * y[1], y[0]);
        let largest = states.iter().map(|y| y[1] * y[1]).fold(0.0, f64::max);
        let mut ledger = Ledger::new();
        let scale = if largest > 0.0 { largest } else { 1.0 };
        let balance = ledger.open_scaled(
            "energy of fall with what the air took",
            Law::Conserved,
            0.0,
            scale,
        )?;
        let mechanical = ledger.open_scaled("energy of fall", Law::NonIncreasing, 0.0, scale)?;
        for y in states {
            ledger.record(balance, energy(y) + y[4])?;
            ledger.record(mechanical, energy(y))?;
        }
        Ok(ledger)
    }
}

impl<A: Atmosphere, W: Weight> Scene for PaperCat<A, W> {
    type State = PaperCatState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let closed = if A::PRESENT {
            Err("air: no closed form")
        } else {
            Ok((Solver::Exact, "no air: a rigid body at rest does not turn"))
        };
        planned(
            request,
            closed,
            "the solver of a paper cat is `exact`, if there is no air, or by a method with error control",
        )
    }

    fn simulate(&self, request: &Request) -> Result<Motion<PaperCatState>> {
        let plan = self.plan(request)?;
        let (order, _) = request.forward()?;
        let stops = with_corners(request, &order, &[]);
        let (states, cost) = match plan.solver {
            Solver::General(method) => {
                let system = |_: f64, y: &[f64; 5]| self.rate(y);
                let distance = |a: &[f64; 5], b: &[f64; 5]| {
                    (0..5).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max)
                };
                let budget = Budget::asked(request);
                let run = refined(
                    &budget.counted(&system),
                    &self.start(),
                    &self.scales(),
                    &stops,
                    method,
                    request.accuracy(),
                    distance,
                )?;
                (run.states, run.cost)
            }
            _ => (
                stops.iter().map(|&t| self.known(t)).collect(),
                Cost::default(),
            ),
        };
        let ledger = balanced(self.ledger(&states)?, request.accuracy())?;
        let rows = in_order(request, &stops, &states);
        let row = |(t, [fall, velocity, tilt, tilt_rate, lost]): (f64, [f64; 5])| {
            let state = PaperCatState {
                fall,
                velocity,
                tilt,
                tilt_rate,
                lost,
            };
            (t, state)
        };
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows: rows.into_iter().map(row).collect(),
        })
    }
}
