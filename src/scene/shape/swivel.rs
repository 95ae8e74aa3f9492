//! The swivel on ice (tutorial 1.1, picture b).

use core::f64::consts::TAU;

use super::{AN_INTEGRAL, Bearing, Pace, Pieced, in_order, planned, repeated, with_corners};
use crate::conservation::{Law, Ledger};
use crate::error::{Result, finite, positive};
use crate::integrators::{Cost, Method};
use crate::phenomena::quadrature::integral;
use crate::phenomena::{self, Waist};
use crate::scene::{
    Absent, Budget, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
};

/// The shape of a body of two parts on one axis, and how it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist {
    /// Moment of the upper part, kg m².
    pub upper: f64,
    /// Angle of the upper part against the lower, radians.
    pub angle: f64,
    /// Its rate, rad/s.
    pub rate: f64,
}

/// A path of shapes: the effect that makes a swivel.
pub trait Twisting: Effect {
    /// The shape at a time; `still` is the upper moment of a body that does nothing.
    fn shape(&self, still: f64, t: f64) -> Twist;

    /// Times up to `until` at which the path is not smooth.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if there are too many.
    fn corners(&self, until: f64) -> Result<Vec<f64>>;

    /// # Errors
    /// What is wrong with the path.
    fn checked(&self) -> Result<()>;
}

impl Twisting for Absent {
    fn shape(&self, still: f64, _: f64) -> Twist {
        Twist {
            upper: still,
            angle: 0.0,
            rate: 0.0,
        }
    }

    fn corners(&self, _: f64) -> Result<Vec<f64>> {
        Ok(Vec::new())
    }

    fn checked(&self) -> Result<()> {
        Ok(())
    }
}

/// Twist with the arms out, arms in, untwist, arms out: over and over again, each phase a quarter of the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourPhases {
    /// Upper moment with the arms out, kg m².
    pub arms_out: f64,
    /// Upper moment with the arms in, kg m².
    pub arms_in: f64,
    /// How far the upper part twists, radians.
    pub twist: f64,
    /// Duration of a cycle, s.
    pub duration: f64,
    /// How each phase is spread over its time.
    pub pace: Pace,
}

impl FourPhases {
    /// The same body for the closed form.
    pub fn waist(&self, lower: f64) -> Waist {
        Waist {
            upper_arms_out: self.arms_out,
            upper_arms_in: self.arms_in,
            lower,
        }
    }
}

impl Effect for FourPhases {
    const PRESENT: bool = true;
    const NAME: &'static str = "four_phases";
}

impl Twisting for FourPhases {
    fn shape(&self, _: f64, t: f64) -> Twist {
        let phase = 4.0 * (t / self.duration).rem_euclid(1.0);
        let [part, rate, _] = self.pace.at(phase.fract());
        let rate = rate * self.twist * 4.0 / self.duration;
        let between = |from: f64, to: f64| from + (to - from) * part;
        let (upper, angle, rate) = match phase as u8 {
            0 => (self.arms_out, self.twist * part, rate),
            1 => (between(self.arms_out, self.arms_in), self.twist, 0.0),
            2 => (self.arms_in, self.twist * (1.0 - part), -rate),
            _ => (between(self.arms_in, self.arms_out), 0.0, 0.0),
        };
        Twist { upper, angle, rate }
    }

    fn corners(&self, until: f64) -> Result<Vec<f64>> {
        repeated(self.duration, &[0.25, 0.5, 0.75, 1.0], until)
    }

    fn checked(&self) -> Result<()> {
        positive("the duration of a cycle", self.duration)?;
        self.waist(0.0).swivel_angle(self.twist).map(|_| ())
    }
}

/// Once round an ellipse of the shape plane, over and over again: A = mean + swing cos s, ψ = twist sin s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundTrip {
    /// Mean upper moment, kg m².
    pub mean: f64,
    /// By how much it goes up and down, kg m².
    pub swing: f64,
    /// Largest twist, radians.
    pub twist: f64,
    /// Duration, s.
    pub duration: f64,
    /// How s = 0…2π is spread over it.
    pub pace: Pace,
}

impl Effect for RoundTrip {
    const PRESENT: bool = true;
    const NAME: &'static str = "round_trip";
}

impl Twisting for RoundTrip {
    fn shape(&self, _: f64, t: f64) -> Twist {
        let [part, rate, _] = self.pace.at((t / self.duration).rem_euclid(1.0));
        let (sin, cos) = (TAU * part).sin_cos();
        Twist {
            upper: self.mean + self.swing * cos,
            angle: self.twist * sin,
            rate: self.twist * cos * TAU * rate / self.duration,
        }
    }

    fn corners(&self, until: f64) -> Result<Vec<f64>> {
        repeated(self.duration, &[1.0], until)
    }

    fn checked(&self) -> Result<()> {
        positive("the duration of a cycle", self.duration)?;
        finite("the twist", self.twist)?;
        finite("the swing of the upper moment", self.swing)?;
        positive("the least upper moment", self.mean - self.swing.abs()).map(|_| ())
    }
}

/// Two parts on one vertical axis, the lower one free to turn on the ice: angular momentum L, a path of shapes, and what the bearing does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swivel<Change = Absent, Friction = Absent> {
    lower: f64,
    upper: f64,
    angular_momentum: f64,
    change: Change,
    friction: Friction,
}

/// A swivel at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwivelState {
    /// How far the lower part has turned, radians.
    pub lower: f64,
    /// How far the upper part has turned, radians.
    pub upper: f64,
    /// Moment of the upper part, kg m².
    pub upper_moment: f64,
    /// Rate of the lower part, rad/s.
    pub rate: f64,
    /// L, kg m²/s.
    pub angular_momentum: f64,
}

impl Tabulated for SwivelState {
    const COLUMNS: &'static [&'static str] =
        &["lower", "upper", "upper_moment", "rate", "angular_momentum"];

    fn row(&self) -> Vec<f64> {
        vec![
            self.lower,
            self.upper,
            self.upper_moment,
            self.rate,
            self.angular_momentum,
        ]
    }
}

impl Swivel {
    /// A body at rest, its parts of these moments (kg m²), that does nothing.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(lower: f64, upper: f64) -> Result<Self> {
        Ok(Self {
            lower: positive("the lower moment", lower)?,
            upper: positive("the upper moment", upper)?,
            angular_momentum: 0.0,
            change: Absent,
            friction: Absent,
        })
    }
}

impl<C: Twisting, F: Bearing> Swivel<C, F> {
    /// The same with this path of shapes.
    ///
    /// # Errors
    /// What is wrong with the path.
    pub fn with_change<D: Twisting>(self, change: D) -> Result<Swivel<D, F>> {
        change.checked()?;
        Ok(Swivel {
            lower: self.lower,
            upper: self.upper,
            angular_momentum: self.angular_momentum,
            change,
            friction: self.friction,
        })
    }

    /// The same with friction of the bearing.
    pub fn with_friction<G: Bearing>(self, friction: G) -> Swivel<C, G> {
        Swivel {
            lower: self.lower,
            upper: self.upper,
            angular_momentum: self.angular_momentum,
            change: self.change,
            friction,
        }
    }

    /// The same with this angular momentum at the start, kg m²/s.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn with_angular_momentum(mut self, l: f64) -> Result<Self> {
        self.angular_momentum = finite("the angular momentum", l)?;
        Ok(self)
    }

    fn rate(&self, l: f64, t: f64) -> f64 {
        let shape = self.change.shape(self.upper, t);
        phenomena::Swivel { lower: self.lower }.rate(l, shape.upper, shape.rate)
    }

    fn state(&self, t: f64, lower: f64, l: f64) -> SwivelState {
        let shape = self.change.shape(self.upper, t);
        SwivelState {
            lower,
            upper: lower + shape.angle,
            upper_moment: shape.upper,
            rate: self.rate(l, t),
            angular_momentum: l,
        }
    }

    /// One integral from stop to stop.
    fn summed(&self, stops: &[f64], budget: &Budget) -> Result<Vec<SwivelState>> {
        let l = self.angular_momentum;
        let (mut lower, mut from) = (0.0, 0.0);
        let mut states = Vec::with_capacity(stops.len());
        for &t in stops {
            lower += integral(|t| self.rate(l, t), from, t, 0.0)?;
            budget.spend(AN_INTEGRAL, t)?;
            from = t;
            states.push(self.state(t, lower, l));
        }
        Ok(states)
    }

    fn followed(
        &self,
        stops: &[f64],
        corners: &[f64],
        method: Method,
        request: &Request,
    ) -> Result<(Vec<SwivelState>, Cost)> {
        let system = |t: f64, y: &[f64; 2]| {
            let rate = self.rate(y[1], t);
            [rate, self.friction.resisted(0.0, rate)]
        };
        let start = [0.0, self.angular_momentum];
        let pace = self.angular_momentum.abs().max(self.lower);
        let distance = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs();
        let run = Pieced {
            start,
            scales: [1.0, pace],
            stops,
            corners,
            method,
            request,
        }
        .follow(&system, &distance)?;
        let pairs = stops.iter().zip(&run.states);
        let states = pairs.map(|(&t, y)| self.state(t, y[0], y[1])).collect();
        Ok((states, run.cost))
    }

    /// L with what the bearing took of it, summed over the two parts from their rates.
    fn ledger(&self, stops: &[f64], states: &[SwivelState]) -> Result<Ledger> {
        let rate = |t: f64| self.change.shape(self.upper, t).rate;
        let whole = |t: f64, state: &SwivelState| {
            let upper_rate = state.rate + rate(t);
            let l = state.upper_moment * upper_rate + self.lower * state.rate;
            self.friction.restored(l, state.lower)
        };
        let pairs = || stops.iter().zip(states);
        let largest = pairs().map(|(&t, s)| s.upper_moment * (s.rate + rate(t)).abs());
        let scale = largest.fold(self.angular_momentum.abs(), f64::max);
        let mut ledger = Ledger::new();
        let account = ledger.open_scaled(
            "angular momentum",
            Law::Conserved,
            self.angular_momentum,
            if scale > 0.0 { scale } else { 1.0 },
        )?;
        for (&t, state) in pairs() {
            ledger.record(account, whole(t, state))?;
        }
        Ok(ledger)
    }
}

impl<C: Twisting, F: Bearing> Scene for Swivel<C, F> {
    type State = SwivelState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let closed = if F::PRESENT {
            Err("bearing friction: no closed form")
        } else {
            Ok((
                Solver::Exact,
                "no torque: one integral along the path of shapes",
            ))
        };
        planned(
            request,
            closed,
            "the solver of a swivel is `exact`, if nothing resists, or by a method with error control",
        )
    }

    fn simulate(&self, request: &Request) -> Result<Motion<SwivelState>> {
        let plan = self.plan(request)?;
        let (order, _) = request.forward()?;
        let until = order.last().map_or(0.0, |&i| request.times()[i]);
        let corners = self.change.corners(until)?;
        let stops = with_corners(request, &order, &corners);
        let (states, cost) = match plan.solver {
            Solver::General(method) => self.followed(&stops, &corners, method, request)?,
            _ => (
                self.summed(&stops, &Budget::asked(request))?,
                Cost::default(),
            ),
        };
        let ledger = self.ledger(&stops, &states)?;
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger: balanced(ledger, request.accuracy())?,
            rows: in_order(request, &stops, &states),
        })
    }
}
