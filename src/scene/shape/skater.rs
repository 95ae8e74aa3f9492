//! The skater who pulls in the arms (tutorial 1.1).

use super::{AN_INTEGRAL, Bearing, Pace, Pieced, in_order, planned, with_corners};
use crate::conservation::{Law, Ledger};
use crate::error::{Result, finite, not_negative, positive};
use crate::integrators::{Cost, Method};
use crate::phenomena::quadrature::integral;
use crate::phenomena::skater;
use crate::scene::{
    Absent, Budget, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
};

/// A path of the hands along the arms.
pub trait Drawing: Effect {
    /// Distance of the hands from the axis (m), its rate and its acceleration; `still` is where they are if nothing is done.
    fn reach(&self, still: f64, t: f64) -> [f64; 3];

    /// Times at which the path is not smooth.
    fn corners(&self) -> Vec<f64>;

    /// # Errors
    /// What is wrong with the path.
    fn checked(&self) -> Result<()>;
}

impl Drawing for Absent {
    fn reach(&self, still: f64, _: f64) -> [f64; 3] {
        [still, 0.0, 0.0]
    }

    fn corners(&self) -> Vec<f64> {
        Vec::new()
    }

    fn checked(&self) -> Result<()> {
        Ok(())
    }
}

/// Hands that move to another distance, and stay there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draw {
    /// Where they end, m.
    pub to: f64,
    /// When they begin, s.
    pub begin: f64,
    /// How long they take, s.
    pub duration: f64,
    /// How the stroke is spread over its time.
    pub pace: Pace,
}

impl Effect for Draw {
    const PRESENT: bool = true;
    const NAME: &'static str = "draw";
}

impl Drawing for Draw {
    fn reach(&self, still: f64, t: f64) -> [f64; 3] {
        let [part, rate, acceleration] = self.pace.at((t - self.begin) / self.duration);
        let way = self.to - still;
        [
            still + way * part,
            way * rate / self.duration,
            way * acceleration / (self.duration * self.duration),
        ]
    }

    fn corners(&self) -> Vec<f64> {
        vec![self.begin, self.begin + self.duration]
    }

    fn checked(&self) -> Result<()> {
        not_negative("the distance of the hands", self.to)?;
        not_negative("the time at which the hands begin", self.begin)?;
        positive("the time that the hands take", self.duration).map(|_| ())
    }
}

/// A skater who spins: a core, two hands, a path for them, and what the ice does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Skater<Change = Absent, Friction = Absent> {
    body: skater::Skater,
    reach: f64,
    spin: f64,
    change: Change,
    friction: Friction,
}

/// A skater at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkaterState {
    /// Angle turned, radians.
    pub angle: f64,
    /// Ω, rad/s.
    pub spin: f64,
    /// Distance of the hands from the axis, m.
    pub reach: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Budget done by the arms, J.
    pub work: f64,
    /// Heat, J.
    pub heat: f64,
}

impl Tabulated for SkaterState {
    const COLUMNS: &'static [&'static str] = &["angle", "spin", "reach", "energy", "work", "heat"];

    fn row(&self) -> Vec<f64> {
        vec![
            self.angle,
            self.spin,
            self.reach,
            self.energy,
            self.work,
            self.heat,
        ]
    }
}

impl Skater {
    /// A skater with the hands at rest at a distance (m) from the axis, spinning at `spin` (rad/s).
    ///
    /// # Errors
    /// [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(body: skater::Skater, reach: f64, spin: f64) -> Result<Self> {
        Ok(Self {
            body,
            reach: not_negative("the distance of the hands", reach)?,
            spin: finite("the spin", spin)?,
            change: Absent,
            friction: Absent,
        })
    }
}

impl<C: Drawing, F: Bearing> Skater<C, F> {
    /// The same with this path of the hands.
    ///
    /// # Errors
    /// What is wrong with the path.
    pub fn with_change<D: Drawing>(self, change: D) -> Result<Skater<D, F>> {
        change.checked()?;
        Ok(Skater {
            body: self.body,
            reach: self.reach,
            spin: self.spin,
            change,
            friction: self.friction,
        })
    }

    /// The same with friction of the ice.
    pub fn with_friction<G: Bearing>(self, friction: G) -> Skater<C, G> {
        Skater {
            body: self.body,
            reach: self.reach,
            spin: self.spin,
            change: self.change,
            friction,
        }
    }

    fn angular_momentum(&self) -> f64 {
        self.body.moment(self.reach) * self.spin
    }

    fn state(&self, t: f64, [angle, spin, work, heat]: [f64; 4]) -> SkaterState {
        let [reach, rate, _] = self.change.reach(self.reach, t);
        SkaterState {
            angle,
            spin,
            reach,
            energy: self.body.energy(spin, reach, rate),
            work,
            heat,
        }
    }

    fn known(&self, stops: &[f64], budget: &Budget) -> Result<Vec<SkaterState>> {
        let l = self.angular_momentum();
        let spin = |t: f64| self.body.spin(l, self.change.reach(self.reach, t)[0]);
        let (mut angle, mut from) = (0.0, 0.0);
        let mut states = Vec::with_capacity(stops.len());
        for &t in stops {
            angle += integral(spin, from, t, 0.0)?;
            budget.spend(AN_INTEGRAL, t)?;
            from = t;
            let [reach, rate, _] = self.change.reach(self.reach, t);
            let work = self.body.work(l, self.reach, reach)? + self.body.hand() * rate * rate;
            states.push(self.state(t, [angle, spin(t), work, 0.0]));
        }
        Ok(states)
    }

    fn followed(
        &self,
        stops: &[f64],
        corners: &[f64],
        method: Method,
        request: &Request,
    ) -> Result<(Vec<SkaterState>, Cost)> {
        let system = |t: f64, y: &[f64; 4]| {
            let [reach, rate, acceleration] = self.change.reach(self.reach, t);
            let spin = y[1];
            let torque = self.friction.resisted(0.0, spin);
            [
                spin,
                self.body.acceleration(spin, reach, rate) + torque / self.body.moment(reach),
                self.body.power(spin, reach, rate, acceleration),
                self.friction.heated(0.0, spin),
            ]
        };
        let energy = self
            .body
            .energy(self.spin, self.reach, 0.0)
            .max(f64::MIN_POSITIVE);
        let scales = [1.0, self.spin.abs().max(f64::MIN_POSITIVE), energy, energy];
        let distance = |a: &[f64; 4], b: &[f64; 4]| {
            let parts = (0..4).map(|k| (a[k] - b[k]).abs() / scales[k].max(b[k].abs()));
            parts.fold(0.0, f64::max)
        };
        let start = [0.0, self.spin, 0.0, 0.0];
        let run = Pieced {
            start,
            scales,
            stops,
            corners,
            method,
            request,
        }
        .follow(&system, &distance)?;
        let pairs = stops.iter().zip(&run.states);
        Ok((pairs.map(|(&t, &y)| self.state(t, y)).collect(), run.cost))
    }

    fn ledger(&self, states: &[SkaterState]) -> Result<Ledger> {
        let (l, energy) = (
            self.angular_momentum(),
            self.body.energy(self.spin, self.reach, 0.0),
        );
        let or_one = |scale: f64| if scale > 0.0 { scale } else { 1.0 };
        // What the hands do with the energy and what the energy does with the rounding: relative to the largest that occurs.
        let largest = states.iter().map(|s| s.energy).fold(energy, f64::max);
        let mut ledger = Ledger::new();
        let momentum =
            ledger.open_scaled("angular momentum", Law::Conserved, l, or_one(l.abs()))?;
        let balance = ledger.open_scaled(
            "energy less the work of the arms",
            Law::Conserved,
            energy,
            or_one(largest),
        )?;
        for state in states {
            let now = self.body.moment(state.reach) * state.spin;
            ledger.record(momentum, self.friction.restored(now, state.angle))?;
            ledger.record(balance, state.energy + state.heat - state.work)?;
        }
        Ok(ledger)
    }
}

impl<C: Drawing, F: Bearing> Scene for Skater<C, F> {
    type State = SkaterState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let closed = if F::PRESENT {
            Err("bearing friction: no closed form")
        } else {
            Ok((
                Solver::Exact,
                "no torque: spin and moment have a fixed product",
            ))
        };
        planned(
            request,
            closed,
            "the solver of a skater is `exact`, if nothing resists, or by a method with error control",
        )
    }

    fn simulate(&self, request: &Request) -> Result<Motion<SkaterState>> {
        let plan = self.plan(request)?;
        let (order, _) = request.forward()?;
        let corners = self.change.corners();
        let stops = with_corners(request, &order, &corners);
        let (states, cost) = match plan.solver {
            Solver::General(method) => self.followed(&stops, &corners, method, request)?,
            _ => (
                self.known(&stops, &Budget::asked(request))?,
                Cost::default(),
            ),
        };
        let ledger = balanced(self.ledger(&states)?, request.accuracy())?;
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows: in_order(request, &stops, &states),
        })
    }
}
