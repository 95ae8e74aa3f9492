//! The falling cat (tutorial 1.1).

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::{AN_INTEGRAL, Pace, Pieced, in_order, planned, with_corners};
use crate::conservation::Ledger;
use crate::error::{Error, Result, finite, positive};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::integrators::{Cost, Method};
use crate::phenomena::cat::{self, Bend, EqualHalves};
use crate::phenomena::holonomy::ShapePlane;
use crate::phenomena::quadrature::integral;
use crate::scene::{
    Absent, Budget, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced,
};

/// A path of shapes of a cat.
pub trait Bending: Effect {
    /// The shape at a time, and its rate.
    fn bend(&self, t: f64) -> Bend;

    /// Times at which the path is not smooth.
    fn corners(&self) -> Vec<f64>;

    /// # Errors
    /// What is wrong with the path.
    fn checked(&self) -> Result<()>;
}

impl Bending for Absent {
    fn bend(&self, _: f64) -> Bend {
        Bend::default()
    }

    fn corners(&self) -> Vec<f64> {
        Vec::new()
    }

    fn checked(&self) -> Result<()> {
        Ok(())
    }
}

/// Bend forward, carry the bend once round, straighten: a quarter, a half and a quarter of the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turnover {
    /// Bend γ forward, radians.
    pub forward: f64,
    /// Bend backward, half-way round, radians; a cat's back allows less.
    pub back: f64,
    /// Duration of the whole, s.
    pub duration: f64,
    /// How each part is spread over its time.
    pub pace: Pace,
}

impl Effect for Turnover {
    const PRESENT: bool = true;
    const NAME: &'static str = "turnover";
}

impl Bending for Turnover {
    fn bend(&self, t: f64) -> Bend {
        let u = t / self.duration;
        if u < 0.25 {
            let [part, rate, _] = self.pace.at(4.0 * u);
            Bend {
                angle: self.forward * part,
                angle_rate: self.forward * rate * 4.0 / self.duration,
                ..Bend::default()
            }
        } else if u < 0.75 {
            let [part, rate, _] = self.pace.at(2.0 * u - 0.5);
            let (mean, swing) = (
                0.5 * (self.forward + self.back),
                0.5 * (self.forward - self.back),
            );
            let (sin, cos) = (TAU * part).sin_cos();
            let direction_rate = TAU * rate * 2.0 / self.duration;
            Bend {
                angle: mean + swing * cos,
                direction: TAU * part,
                angle_rate: -swing * sin * direction_rate,
                direction_rate,
            }
        } else {
            let [part, rate, _] = self.pace.at(4.0 * u - 3.0);
            Bend {
                angle: self.forward * (1.0 - part),
                direction: TAU,
                angle_rate: -self.forward * rate * 4.0 / self.duration,
                direction_rate: 0.0,
            }
        }
    }

    fn corners(&self) -> Vec<f64> {
        [0.25, 0.75, 1.0].map(|u| u * self.duration).to_vec()
    }

    fn checked(&self) -> Result<()> {
        positive("the duration of the turnover", self.duration)?;
        for bend in [self.forward, self.back] {
            if !(0.0..=PI).contains(&bend) {
                return Err(Error::OutOfRange {
                    quantity: "the bend",
                    value: bend,
                    least: 0.0,
                    greatest: PI,
                });
            }
        }
        Ok(())
    }
}

/// What moves the centre of mass. Nothing here can turn the cat.
pub trait Falling: Effect {
    /// Where the centre of mass is after a time, from where it would be without this.
    fn fallen(&self, free: SpaceVector, t: f64) -> SpaceVector;
}

impl Falling for Absent {
    fn fallen(&self, free: SpaceVector, _: f64) -> SpaceVector {
        free
    }
}

/// Uniform gravity down the z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    /// g, m/s².
    pub g: f64,
}

impl Effect for Gravity {
    const PRESENT: bool = true;
    const NAME: &'static str = "gravity";
}

impl Falling for Gravity {
    fn fallen(&self, free: SpaceVector, t: f64) -> SpaceVector {
        free - SpaceVector::new(0.0, 0.0, 0.5 * self.g * t * t)
    }
}

/// A cat of two halves, let go: attitude, velocity and angular momentum at the start, a path of shapes, and gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cat<Change = Absent, Weight = Absent> {
    body: cat::Cat,
    attitude: Attitude,
    center: SpaceVector,
    velocity: SpaceVector,
    angular_momentum: SpaceVector,
    change: Change,
    gravity: Weight,
}

/// A cat at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CatState {
    /// Attitude of the first half, its spine along x.
    pub attitude: Attitude,
    /// Angular velocity of the first half, rad/s.
    pub omega: BodyVector,
    /// The shape.
    pub bend: Bend,
    /// Centre of mass, m.
    pub center: SpaceVector,
    /// Angular momentum about it, summed over the halves, kg m²/s.
    pub angular_momentum: SpaceVector,
}

impl Tabulated for CatState {
    const COLUMNS: &'static [&'static str] = &[
        "qw",
        "qx",
        "qy",
        "qz",
        "bend",
        "direction",
        "x",
        "y",
        "z",
        "angular_momentum",
    ];

    fn row(&self) -> Vec<f64> {
        let q = self.attitude.quaternion();
        let [c, l] = [self.center, self.angular_momentum];
        vec![
            q.w,
            q.i,
            q.j,
            q.k,
            self.bend.angle,
            self.bend.direction,
            c.x(),
            c.y(),
            c.z(),
            l.norm(),
        ]
    }
}

impl Cat {
    /// A straight cat let go from rest, its centre at the origin, that does nothing.
    pub fn new(body: cat::Cat, attitude: Attitude) -> Self {
        Self {
            body,
            attitude,
            center: SpaceVector::zero(),
            velocity: SpaceVector::zero(),
            angular_momentum: SpaceVector::zero(),
            change: Absent,
            gravity: Absent,
        }
    }
}

impl<C: Bending, G: Falling> Cat<C, G> {
    /// The same with this path of shapes.
    ///
    /// # Errors
    /// What is wrong with the path.
    pub fn with_change<D: Bending>(self, change: D) -> Result<Cat<D, G>> {
        change.checked()?;
        Ok(Cat {
            body: self.body,
            attitude: self.attitude,
            center: self.center,
            velocity: self.velocity,
            angular_momentum: self.angular_momentum,
            change,
            gravity: self.gravity,
        })
    }

    /// The same with gravity.
    pub fn with_gravity<W: Falling>(self, gravity: W) -> Cat<C, W> {
        Cat {
            body: self.body,
            attitude: self.attitude,
            center: self.center,
            velocity: self.velocity,
            angular_momentum: self.angular_momentum,
            change: self.change,
            gravity,
        }
    }

    /// The same let go from this place (m) with this velocity (m/s).
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn thrown(mut self, center: SpaceVector, velocity: SpaceVector) -> Result<Self> {
        self.center = all_finite("the centre of mass", center)?;
        self.velocity = all_finite("the velocity", velocity)?;
        Ok(self)
    }

    /// The same with this angular momentum (kg m²/s) about the centre of mass.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn with_angular_momentum(mut self, l: SpaceVector) -> Result<Self> {
        self.angular_momentum = all_finite("the angular momentum", l)?;
        Ok(self)
    }

    /// The closed form, if there is one.
    fn equal_halves(&self) -> Option<EqualHalves> {
        let still = self.angular_momentum == SpaceVector::zero();
        self.body.equal_halves().filter(|_| still)
    }

    fn state(&self, t: f64, attitude: Attitude, omega: BodyVector) -> CatState {
        let bend = self.change.bend(t);
        let l = self.body.angular_momentum(&bend, omega);
        CatState {
            attitude,
            omega,
            bend,
            center: self.gravity.fallen(self.center + self.velocity * t, t),
            angular_momentum: attitude.to_space(l),
        }
    }

    /// The frame of the bend turns about the bisector of the spines, and each half turns back in it.
    fn summed(&self, equal: &EqualHalves, stops: &[f64], budget: &Budget) -> Result<Vec<CatState>> {
        let frame =
            turn_x(self.change.bend(0.0).direction) * turn_z(0.5 * self.change.bend(0.0).angle);
        let start = self.attitude.quaternion() * frame;
        let (mut turned, mut from) = (0.0, 0.0);
        let mut states = Vec::with_capacity(stops.len());
        for &t in stops {
            let back = |t: f64| {
                let bend = self.change.bend(t);
                equal.turn_back(bend.angle) * bend.direction_rate
            };
            turned += integral(back, from, t, 0.0)?;
            budget.spend(AN_INTEGRAL, t)?;
            from = t;
            let bend = self.change.bend(t);
            let since = bend.direction - self.change.bend(0.0).direction;
            // χ = ψ − ∫(1 − f) dψ.
            let to_half = turn_z(-0.5 * bend.angle) * turn_x(-bend.direction);
            let attitude = start * turn_x(since - turned) * to_half;
            let (s, c) = (0.5 * bend.angle).sin_cos();
            let in_frame = Vector3::new(
                equal.frame_turn(bend.angle) * bend.direction_rate - c * bend.direction_rate,
                s * bend.direction_rate,
                -0.5 * bend.angle_rate,
            );
            let omega = BodyVector::from_components(to_half.inverse() * in_frame);
            states.push(self.state(t, Attitude::from_unit(*attitude.quaternion()), omega));
        }
        Ok(states)
    }

    fn omega(&self, t: f64, attitude: &Attitude) -> Result<BodyVector> {
        let l = attitude.to_body(self.angular_momentum);
        self.body.angular_velocity(&self.change.bend(t), l)
    }

    fn followed(
        &self,
        stops: &[f64],
        corners: &[f64],
        method: Method,
        request: &Request,
    ) -> Result<(Vec<CatState>, Cost)> {
        let unit =
            |y: &[f64; 4]| Attitude::from_unit(Quaternion::new(y[0], y[1], y[2], y[3]).normalize());
        let system = |t: f64, y: &[f64; 4]| {
            let omega = self
                .omega(t, &unit(y))
                .map_or(Vector3::repeat(f64::NAN), |o| o.components());
            let rate = Quaternion::new(y[0], y[1], y[2], y[3]) * Quaternion::from_imag(omega) * 0.5;
            [rate.w, rate.i, rate.j, rate.k]
        };
        let q = self.attitude.quaternion();
        let distance = |a: &[f64; 4], b: &[f64; 4]| unit(a).angle_to(&unit(b));
        let start = [q.w, q.i, q.j, q.k];
        let run = Pieced {
            start,
            scales: [1.0; 4],
            stops,
            corners,
            method,
            request,
        }
        .follow(&system, &distance)?;
        let mut states = Vec::with_capacity(stops.len());
        for (&t, y) in stops.iter().zip(&run.states) {
            let attitude = unit(y);
            states.push(self.state(t, attitude, self.omega(t, &attitude)?));
        }
        Ok((states, run.cost))
    }

    fn ledger(&self, states: &[CatState]) -> Result<Ledger> {
        let pace =
            |s: &CatState| s.omega.norm() + s.bend.angle_rate.abs() + s.bend.direction_rate.abs();
        let fastest = states.iter().map(pace).fold(0.0, f64::max);
        let moments: f64 = self.body.halves().iter().map(|half| half.transverse).sum();
        let scale = (moments * fastest).max(self.angular_momentum.norm());
        let mut ledger = Ledger::new();
        let account = ledger.open_vector_scaled(
            "angular momentum",
            self.angular_momentum,
            if scale > 0.0 { scale } else { 1.0 },
        )?;
        for state in states {
            ledger.record_vector(account, state.angular_momentum)?;
        }
        Ok(ledger)
    }
}

impl<C: Bending, G: Falling> Scene for Cat<C, G> {
    type State = CatState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let closed = match self.equal_halves() {
            Some(_) => Ok((
                Solver::Exact,
                "equal halves without angular momentum: one integral along the path of shapes",
            )),
            None => Err("unequal halves or angular momentum: no closed form"),
        };
        planned(
            request,
            closed,
            "the solver of a cat is `exact`, if it has equal halves and no angular momentum, or by a method with error control",
        )
    }

    fn simulate(&self, request: &Request) -> Result<Motion<CatState>> {
        let plan = self.plan(request)?;
        let (order, _) = request.forward()?;
        let corners = self.change.corners();
        let stops = with_corners(request, &order, &corners);
        let (states, cost) = match (plan.solver, self.equal_halves()) {
            (Solver::General(method), _) => self.followed(&stops, &corners, method, request)?,
            (_, Some(equal)) => (
                self.summed(&equal, &stops, &Budget::asked(request))?,
                Cost::default(),
            ),
            (_, None) => self.followed(&stops, &corners, Method::Dop853, request)?,
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

/// A cat held by the paws, back down: spine along the x axis of space, the belly, which is +y of its axes, up.
impl Cat {
    /// The attitude of a cat that lies on its back.
    pub fn on_its_back() -> Attitude {
        Attitude::from_unit(*turn_x(FRAC_PI_2).quaternion())
    }
}

fn turn_x(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}

fn turn_z(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle)
}

fn all_finite(quantity: &'static str, vector: SpaceVector) -> Result<SpaceVector> {
    for component in vector.components().iter() {
        finite(quantity, *component)?;
    }
    Ok(vector)
}
