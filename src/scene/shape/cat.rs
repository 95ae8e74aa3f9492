//! The falling cat (tutorial 1.1).

use core::f64::consts::FRAC_PI_2;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::euler_equations::quaternion_rate;
use crate::frame::finite_vector;
use crate::phenomena::quadrature::integral;
use crate::phenomena::{self, Bend, EqualHalves, ShapePlane};
use crate::scene::path::{Turnover, next_of};
use crate::scene::prelude::*;

/// A cat of two halves in free fall: attitude and angular momentum at the start, a path of shapes, and gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cat {
    body: phenomena::Cat,
    attitude: Attitude,
    angular_momentum: SpaceVector,
    turnover: Option<Turnover>,
    gravity: Option<f64>,
}

/// A cat at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CatState {
    /// Attitude of the first half, whose spine is along x.
    pub attitude: Attitude,
    /// Angular velocity of the first half, rad/s.
    pub omega: BodyVector,
    /// The shape.
    pub bend: Bend,
    /// Centre of mass, m.
    pub center: SpaceVector,
    /// Angular momentum about the centre of mass, summed over the halves, kg m²/s.
    pub angular_momentum: SpaceVector,
}

impl Tabulated for CatState {
    fn columns() -> Columns<Self> {
        Columns::default()
            .attitude(|state: &Self| state.attitude)
            .and(columns! { |state: &Self|
                "bend", "rad", "angle between the spines of the halves" => state.bend.angle;
                "direction", "rad", "direction of the bend about the spine" => state.bend.direction;
            })
            .vector(["x", "y", "z"], ["m", "centre of mass"], |state| state.center)
            .and(columns! { |state: &Self|
                "angular_momentum", "kg m²/s", "size of the angular momentum" => state.angular_momentum.norm();
            })
    }
}

impl Cat {
    /// A straight cat released at rest, its centre at the origin, without effects.
    ///
    /// ```
    /// use spinning_bodies::{frame::Attitude, phenomena::{self, Half}, scene::{Request, Scene, shape::Cat}};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let cat = Cat::new(phenomena::Cat::new([half; 2])?, Attitude::identity());
    /// let motion = cat.simulate(&Request::at([5.0])?)?;
    /// assert_eq!(motion.rows[0].1.center.norm(), 0.0); // nothing acts, nothing happens
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: phenomena::Cat, attitude: Attitude) -> Self {
        Self {
            body,
            attitude,
            angular_momentum: SpaceVector::zero(),
            turnover: None,
            gravity: None,
        }
    }

    /// The attitude of a cat held by the paws, back down: the spine along the x axis of space, the belly, +y of its own axes, up.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, scene::shape::Cat};
    /// let belly = Cat::on_its_back().to_space(BodyVector::new(0.0, 1.0, 0.0));
    /// assert!((belly.z() - 1.0).abs() < 1e-15);
    /// ```
    pub fn on_its_back() -> Attitude {
        turn_x(FRAC_PI_2).into()
    }

    /// Adds a path of shapes, [`Turnover`], or [`Gravity`](crate::scene::effects::Gravity), which cannot turn it.
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other effect; the errors of an invalid path.
    ///
    /// ```
    /// use spinning_bodies::{frame::Attitude, phenomena::{self, Half}, scene::{Request, Scene, effects::Gravity, shape::Cat}};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let cat = Cat::new(phenomena::Cat::new([half; 2])?, Attitude::identity()).with(Gravity::new(9.81)?)?;
    /// let motion = cat.simulate(&Request::at([1.0])?)?;
    /// assert!((motion.rows[0].1.center.z() + 9.81 / 2.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Turnover(path) => self.turnover = Some(path.checked()?),
            Effect::Gravity(gravity) => self.gravity = Some(gravity.value()),
            other => return Err(other.refused("a cat", "turnover, gravity")),
        }
        Ok(self)
    }

    /// Sets the angular momentum (kg m²/s) about the centre of mass.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, SpaceVector}, phenomena::{self, Half}, scene::{Request, Scene, shape::Cat}};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let cat = Cat::new(phenomena::Cat::new([half; 2])?, Attitude::identity());
    /// // Straight, it has 0.02 kg m² about the spine.
    /// let cat = cat.with_angular_momentum(SpaceVector::new(0.04, 0.0, 0.0))?;
    /// let motion = cat.simulate(&Request::at([5.0])?)?;
    /// assert!((motion.rows[0].1.omega.x() - 2.0).abs() < 1e-9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with_angular_momentum(mut self, l: SpaceVector) -> Result<Self> {
        self.angular_momentum = finite_vector("the angular momentum", l)?;
        Ok(self)
    }

    fn bend(&self, t: f64) -> Bend {
        self.turnover.map_or(Bend::default(), |path| path.bend(t))
    }

    /// The cat of the closed form: with equal halves and without angular momentum, if it is that.
    fn equal_halves(&self) -> Option<EqualHalves> {
        let still = self.angular_momentum == SpaceVector::zero();
        self.body.equal_halves().filter(|_| still)
    }

    /// The turn from the frame of the bend, which turns about the bisector of the spines, to the first half, which turns back in that frame.
    fn to_half(bend: &Bend) -> UnitQuaternion<f64> {
        let bent = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -0.5 * bend.angle);
        bent * turn_x(-bend.direction)
    }

    /// The attitude in closed form: χ = ψ − ∫(1 − f) dψ while the bend goes round.
    fn known(&self, equal: &EqualHalves, t: f64) -> Result<[f64; 4]> {
        let back = |t: f64| {
            let bend = self.bend(t);
            equal.turn_back(bend.angle) * bend.direction_rate
        };
        let turned = match self.turnover.map(|path| path.corners()) {
            None => 0.0,
            Some([from, to, _]) => integral(back, from, t.clamp(from, to))?,
        };
        let bend = self.bend(t);
        let attitude = self.attitude.quaternion() * turn_x(bend.direction - turned);
        Ok(Attitude::from(attitude * Self::to_half(&bend)).into())
    }

    /// The angular velocity in closed form.
    fn omega_known(&self, equal: &EqualHalves, bend: &Bend) -> BodyVector {
        let (s, c) = (0.5 * bend.angle).sin_cos();
        let (turn, rate) = (equal.frame_turn(bend.angle), bend.direction_rate);
        let in_frame = Vector3::new(turn * rate - c * rate, s * rate, -0.5 * bend.angle_rate);
        BodyVector::from_components(Self::to_half(bend).inverse() * in_frame)
    }

    /// The angular velocity from the angular momentum.
    fn omega(&self, t: f64, attitude: &Attitude) -> Result<BodyVector> {
        let l = attitude.to_body(self.angular_momentum);
        self.body.angular_velocity(&self.bend(t), l)
    }

    fn state(&self, t: f64, y: &[f64; 4], equal: Option<&EqualHalves>) -> Result<CatState> {
        let (attitude, bend) = (unit(y), self.bend(t));
        let omega = match equal {
            Some(equal) => self.omega_known(equal, &bend),
            None => self.omega(t, &attitude)?,
        };
        let fallen = self.gravity.map_or(0.0, |g| 0.5 * g * t * t);
        let center = SpaceVector::new(0.0, 0.0, -finite("the height fallen", fallen)?);
        let l = self.body.angular_momentum(&bend, omega);
        Ok(CatState {
            attitude,
            omega,
            bend,
            center,
            angular_momentum: attitude.to_space(l),
        })
    }
}

/// The cat's state is the quaternion of the first half.
impl Flow<4> for Cat {
    type Phase = ();
    const KEPT: Kept = Kept::UnitQuaternion(0);

    fn start(&self) -> Result<((), [f64; 4])> {
        Ok(((), self.attitude.into()))
    }

    fn scales(&self) -> [f64; 4] {
        [1.0; 4]
    }

    fn pace(&self) -> f64 {
        let least = (self.body.halves.iter()).map(|half| half.axial.min(half.transverse));
        let turning = self.angular_momentum.norm() / least.sum::<f64>();
        turning + self.turnover.map_or(0.0, |path| path.greatest_rate())
    }

    fn rate(&self, (): (), t: f64, y: &[f64; 4]) -> [f64; 4] {
        let unknown = BodyVector::from([f64::NAN; 3]);
        quaternion_rate(*y, self.omega(t, &unit(y)).unwrap_or(unknown))
    }

    fn lasts_until(&self, (): (), t: f64) -> f64 {
        next_of(self.turnover.map(|path| path.corners()), t)
    }

    /// The closed form is that of a cat without angular momentum, which stands still once it has turned over.
    fn rounding(&self, angle: f64, _: usize) -> f64 {
        let whole = |path: Turnover| path.greatest_rate() * path.duration;
        OF_CLOSED_FORMS * (1.0 + angle.min(self.turnover.map_or(0.0, whole)))
    }

    /// Ω is a function of the attitude, and its error, relative to the fastest rate, is no greater.
    fn distance(&self, ((), a): &((), [f64; 4]), ((), b): &((), [f64; 4])) -> f64 {
        unit(a).angle_to(&unit(b))
    }
}

impl Scene for Cat {
    type State = CatState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let equal = "equal halves without angular momentum: one integral along the path of shapes";
        let plan = match self.equal_halves() {
            Some(_) => Plan::exact(equal),
            None => Plan::stepped("unequal halves or angular momentum: no closed form"),
        };
        let solvers = "the solver of a cat is `exact`, if it has equal halves and no angular momentum, or one that steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<CatState>> {
        let plan = self.plan(request)?;
        let exact = |_: &_| plan.solver == Solver::Exact;
        let equal = self.equal_halves().filter(exact);
        let trace = solved((self, &plan, request), AN_INTEGRAL, &|t| match &equal {
            Some(equal) => self.known(equal, t),
            None => self.start().map(|((), y)| y),
        })?;
        let rows = request.times().iter().zip(&trace.samples);
        let states = rows.map(|(&t, ((), y))| self.state(t, y, equal.as_ref()));
        let states: Vec<CatState> = states.collect::<Result<_>>()?;
        // Drifts are relative to the angular momenta of the fastest parts, whose sum is the whole.
        let pace =
            |s: &CatState| s.omega.norm() + s.bend.angle_rate.abs() + s.bend.direction_rate.abs();
        let fastest = states.iter().map(pace).fold(0.0, f64::max);
        let moments: f64 = self.body.halves.iter().map(|half| half.transverse).sum();
        let l = self.angular_momentum;
        let scale = (moments * fastest).max(l.norm());
        let done = (trace.cost, trace.error);
        let mut ledger = OpenLedger::of(request, plan, done, &mut states.into_iter());
        ledger.conserved("angular momentum", scale, l, |_, s| s.angular_momentum)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<CatState> {
        let turning = "angular velocity of the first half, along its axes";
        let (names, omega) = (["omega1", "omega2", "omega3"], ["rad/s", turning]);
        let l = ["kg m²/s", "angular momentum, along the axes of space"];
        Columns::default()
            .vector(names, omega, |state: &CatState| state.omega)
            .vector(["lx", "ly", "lz"], l, |state| state.angular_momentum)
            .angles(|state| state.attitude)
    }
}

fn unit(y: &[f64; 4]) -> Attitude {
    Attitude::from_unit(Quaternion::new(y[0], y[1], y[2], y[3]).normalize())
}

fn turn_x(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}
