//! The scene `meteorite` (tutorial 4.2): a planet flies and turns freely; at time 0 a meteorite strikes it and sticks, and the two fly on as one body.

use super::columns::{Columns, columns};
use super::effects::{Effect, Impact};
use super::motion::Books;
use super::{Choice, Motion, Plan, Request, Scene, Solver, Tabulated};
use crate::conservation::Law;
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::impacts::{Planet, Strike, strike};
use crate::inertia::MassProperties;
use crate::integrators::Cost;

/// A planet in free flight, whose axes point along those of space at time 0, when its centre is at the origin.
///
/// It takes one effect, an [`Impact`], with recoil and the meteorite's own moment of inertia. After it the two are one rigid body that turns about an
/// axis that is not principal: the planet wobbles like Euler's top, and its centre circles the common centre of mass.
#[derive(Debug, Clone, Copy)]
pub struct StruckPlanet {
    planet: Planet,
    impact: Option<Impact>,
}

impl StruckPlanet {
    /// The planet without an impact.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::Planet, scene::{Request, Scene, StruckPlanet}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::new(0.0, 0.0, 1.0))?;
    /// let motion = StruckPlanet::new(planet).simulate(&Request::at([5.0])?)?;
    /// assert_eq!(motion.rows[0].1.omega.z(), 1.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn new(planet: Planet) -> Self {
        Self {
            planet,
            impact: None,
        }
    }

    /// Adds an [`Impact`], at time 0.
    ///
    /// # Errors
    /// [`Error::Effect`] for any other effect.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, impacts::{Impact, Meteorite, Planet}, scene::{Request, Scene, StruckPlanet}};
    /// let planet = Planet::spherical(10.0, 4.0, BodyVector::zero(), BodyVector::new(0.0, 0.0, 1.0))?;
    /// let meteorite = Meteorite::new(10.0, BodyVector::new(0.0, 3.0, 0.0))?;
    /// let impact = Impact { meteorite, at: BodyVector::new(1.0, 0.0, 0.0) };
    /// let motion = StruckPlanet::new(planet).with(impact)?.simulate(&Request::at([5.0])?)?;
    /// // 9 ΔΩ = 5·(3 − 1).
    /// assert!((motion.rows[0].1.omega.z() - (1.0 + 10.0 / 9.0)).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        match effect.into() {
            Effect::Impact(impact) => self.impact = Some(impact),
            other => return Err(other.refused("a struck planet", "impact")),
        }
        Ok(self)
    }
}

/// A planet at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Flying {
    /// Attitude: turns the planet's axes into those of space.
    pub attitude: Attitude,
    /// Angular velocity along the planet's axes, rad/s.
    pub omega: BodyVector,
    /// The planet's centre C, m.
    pub center: SpaceVector,
    /// Kinetic energy of planet and meteorite, J.
    pub energy: f64,
    /// Angular momentum about the centre of mass, kg m²/s: of the planet before the impact, of both bodies after it.
    pub angular_momentum: SpaceVector,
}

impl Tabulated for Flying {
    fn columns() -> Columns<Self> {
        Columns::default()
            .attitude(|state: &Self| state.attitude)
            .omega(|state| state.omega)
            .vector(["x", "y", "z"], ["m", "centre of the planet"], |state| {
                state.center
            })
            .and(columns! { |state: &Self|
                "energy", "J", "kinetic energy, before the blow of both bodies" => state.energy;
            })
    }
}

/// Momentum, and angular momentum about the origin: what is conserved.
type Kept = [SpaceVector; 2];

/// A rigid body in free flight: the motion of its centre of mass, and Euler's top about it.
struct Free {
    mass: f64,
    top: EulerTop,
    /// The same top with moments and rates changed by about [`MOVED`].
    twin: EulerTop,
    /// The turn from the planet's axes to the principal ones.
    turn: Attitude,
    /// The common centre of mass at time 0, relative to the planet's centre, along the planet's axes.
    common: BodyVector,
    /// Its velocity, m/s.
    velocity: SpaceVector,
    omega: BodyVector,
}

/// Relative change of a twin, which shows how the motion amplifies rounding.
const MOVED: f64 = 1e-13;
/// Relative rounding error of moments, axes and rates: four times the observed one.
const ROUNDING: f64 = 1.2e-15;
/// Number of times, up to the last, at which a top and its twin are compared.
const CHECKS: u32 = 4;

fn space(v: BodyVector) -> SpaceVector {
    SpaceVector::from_components(v.components())
}

impl Free {
    /// This body in free flight; `body` has its centre of mass relative to the planet's centre, whose velocity is `velocity`.
    fn new(body: &MassProperties, omega: BodyVector, velocity: BodyVector) -> Result<Self> {
        let principal = body.inertia().principal_axes();
        let [a, b, c] = principal.moments;
        let (axes, attitude) = (principal.axes, Attitude::from(principal.turn()));
        let along = BodyVector::from_components(axes.transpose() * omega.components());
        // The triangle inequality must hold for the changed moments too: for the greatest, and for the middle one of a needle.
        let (a_moved, c_moved) = (a * (1.0 + MOVED), c * (1.0 - 0.6 * MOVED));
        let b_moved = (b * (1.0 + 0.7 * MOVED)).min(a_moved + c_moved);
        let moved = [a_moved, b_moved, c_moved];
        let aside = MOVED * omega.norm() * BodyVector::new(0.6, -0.5, 0.6);
        Ok(Self {
            mass: body.mass(),
            top: EulerTop::from_omega([a, b, c], along, attitude)?,
            twin: EulerTop::from_omega(moved, along + aside, attitude)?,
            turn: attitude,
            common: body.center(),
            velocity: space(velocity + omega.cross(&body.center())),
            omega,
        })
    }

    fn at(&self, t: f64) -> Result<(Flying, Kept)> {
        let state = self.top.at(t)?;
        let attitude = state.attitude * self.turn.inverse();
        let common = space(self.common) + t * self.velocity;
        let spin = state.attitude.to_space(state.angular_momentum);
        let momentum = self.mass * self.velocity;
        let rotation = 0.5 * state.angular_momentum.dot(&state.omega);
        let energy = 0.5 * momentum.dot(&self.velocity) + rotation;
        let flying = Flying {
            attitude,
            omega: BodyVector::from_components(self.turn.quaternion() * state.omega.components()),
            center: common - attitude.to_space(self.common),
            energy,
            angular_momentum: spin,
        };
        Ok((flying, [momentum, spin + common.cross(&momentum)]))
    }

    /// The error that rounding may cause up to a time: in proportion to the distance from the twin, whose change is greater.
    fn error(&self, until: f64) -> Result<f64> {
        let fastest = self.omega.norm().max(f64::MIN_POSITIVE);
        let mut apart: f64 = MOVED;
        for n in 1..=CHECKS {
            let t = until * f64::from(n) / f64::from(CHECKS);
            let (a, b) = (self.top.at(t)?, self.twin.at(t)?);
            let rates = (a.omega - b.omega).norm() / fastest;
            apart = apart.max(a.attitude.angle_to(&b.attitude)).max(rates);
        }
        Ok(ROUNDING * (1.0 + apart / MOVED))
    }
}

impl StruckPlanet {
    /// The body after the impact, and the momentum, angular momentum and energy that the meteorite brought.
    fn struck(&self, hit: &Strike) -> Result<(Free, Kept, f64)> {
        let (planet, meteorite) = (&self.planet, hit.meteorite);
        let ball = MassProperties::new(planet.mass, BodyVector::zero(), planet.inertia)?;
        let stone = MassProperties::particle(meteorite.mass, hit.at)?;
        let body = MassProperties::compose(&[ball, stone])?;
        let after = Free::new(&body, hit.omega_after, hit.velocity_after)?;
        let velocity = space(meteorite.velocity);
        let momentum = meteorite.mass * velocity;
        let brought = [momentum, space(hit.at).cross(&momentum)];
        Ok((after, brought, 0.5 * momentum.dot(&velocity)))
    }
}

impl Scene for StruckPlanet {
    type State = Flying;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let reason = match self.impact {
            Some(_) => {
                "an impact that sticks: six linear equations between two free motions in closed form"
            }
            None => "no torque: closed form",
        };
        match request.choice {
            Choice::Auto | Choice::Use(Solver::Exact) => Ok(Plan::new(Solver::Exact, reason)),
            Choice::Use(_) => Err(Error::Solver {
                condition: "a struck planet is solved in closed form only; ask for exact",
            }),
        }
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Flying>> {
        let plan = self.plan(request)?;
        let (planet, times) = (&self.planet, request.times());
        let ball = MassProperties::new(planet.mass, BodyVector::zero(), planet.inertia)?;
        let before = Free::new(&ball, planet.omega, planet.velocity)?;
        let hit = self.impact.map(|it| strike(planet, &it.meteorite, it.at));
        let struck = hit.transpose()?.map(|hit| self.struck(&hit)).transpose()?;
        let at = |t: f64| match &struck {
            Some((after, ..)) if t >= 0.0 => after.at(t),
            None => before.at(t),
            Some((_, [p, l], energy)) => {
                let (mut state, [p_before, l_before]) = before.at(t)?;
                state.energy += energy;
                Ok((state, [p_before + *p, l_before + *l]))
            }
        };
        let rows: Vec<(Flying, Kept)> = times.iter().map(|&t| at(t)).collect::<Result<_>>()?;
        let first = times.iter().copied().fold(0.0, f64::min);
        let last = times.iter().copied().fold(0.0, f64::max);
        let after = struck.as_ref().map_or(&before, |(after, ..)| after);
        let error = before.error(first)?.max(after.error(last)?);
        // The state just before the impact.
        let (opening, [p, l]) = at(first.min(-f64::MIN_POSITIVE))?;
        let law = match self.impact {
            Some(_) => Law::NonIncreasing,
            None => Law::Conserved,
        };
        let turning = "angular momentum about the origin";
        let states = rows.iter().map(|(state, _)| *state);
        let mut books = Books::of(request, plan, (Cost::default(), error), states);
        books.conserved("momentum", p.norm(), p, |k, _| rows[k].1[0])?;
        books.conserved(turning, l.norm(), l, |k, _| rows[k].1[1])?;
        let kinetic = ("kinetic energy", law, opening.energy);
        books.keep(kinetic, opening.energy, |_, s| s.energy)?;
        books.closed(request)
    }

    fn further(&self) -> Columns<Flying> {
        Columns::default()
            .angles(|state: &Flying| state.attitude)
            .and(columns! { |state: &Flying|
                "omega", "rad/s", "size of the angular velocity" => state.omega.norm();
            })
            .angular_momentum(|state| state.attitude, |state| state.angular_momentum)
    }
}
