//! The scene `meteorite` (tutorial 4.2): a planet flies and turns freely; at time 0 a meteorite strikes it and sticks, and the two fly on as one body.

use nalgebra::Matrix3;

use super::effects::Impact;
use super::prelude::*;
use super::top::{Body, Start, State, Top};
use crate::impacts::{Meteorite, Planet, strike};
use crate::inertia::MassProperties;
use crate::integrators::both_ways;

/// A planet in free flight, whose axes point along those of space at time 0, when its centre is at the origin.
///
/// It takes one effect, an [`Impact`], with recoil and the meteorite's own moment of inertia. After it the two are one rigid body that turns about an
/// axis that is not principal: the planet wobbles like Euler's top, and its centre circles the common centre of mass.
///
/// ```
/// use spinning_bodies::frame::BodyVector as V;
/// use spinning_bodies::impacts::{Impact, Meteorite, Planet};
/// use spinning_bodies::scene::{Request, Scene, StruckPlanet};
///
/// // The Earth runs into a small moon at rest: without momentum, each pulls the other round.
/// let earth = Planet::spherical(6e24, 8e37, V::zero(), V::new(0.0, 1e-5, 7.3e-5))?;
/// let moon = Impact { meteorite: Meteorite::new(1e20, V::zero())?, at: V::new(3.7e6, 1e6, 5.1e6) };
/// let motion = StruckPlanet::new(earth).with(moon)?.simulate(&Request::at([1e3, 1e5])?)?;
/// let moved = (motion.rows[1].1.center - motion.rows[0].1.center).norm();
/// assert!(moved > 10.0 && moved < 2.0 * 6.4e6 * 1e20 / 6e24);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
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

state! {
    /// A planet at one time.
    Flying(Columns::default()
        .attitude(|state: &Self| state.attitude)
        .omega(|state| state.omega)
        .vector(["x", "y", "z"], ["m", "centre of the planet"], |s| s.center)) {
        /// kinetic energy, before the blow of both bodies, J
        energy,
    }
    /// Attitude: turns the planet's axes into those of space.
    attitude: Attitude,
    /// Angular velocity along the planet's axes, rad/s.
    omega: BodyVector,
    /// The planet's centre C, m.
    center: SpaceVector,
    /// Angular momentum about the centre of mass, kg m²/s: of the planet before the impact, of both bodies after it.
    angular_momentum: SpaceVector,
}

/// Momentum, and angular momentum about the origin: what is conserved.
type Kept = [SpaceVector; 2];

/// A rigid body in free flight: its centre of mass moves uniformly, and about it the body turns as a free top.
struct Free {
    /// The body, with its centre of mass at time 0 relative to the planet's centre, along the planet's axes.
    body: MassProperties,
    top: Top,
    /// Velocity of the centre of mass, m/s.
    velocity: SpaceVector,
    /// What else is in flight: its momentum and angular momentum, and its kinetic energy.
    beside: (Kept, f64),
}

fn space(v: BodyVector) -> SpaceVector {
    SpaceVector::from_components(v.components())
}

impl Free {
    /// This body with the planet's velocity and angular velocity.
    fn new(
        body: MassProperties,
        turning: Body,
        omega: BodyVector,
        velocity: BodyVector,
        beside: (Kept, f64),
    ) -> Result<Self> {
        let start = Start::with_omega(omega, Attitude::identity());
        Ok(Self {
            top: Top::new(turning, start)?,
            velocity: space(velocity + omega.cross(&body.center())),
            body,
            beside,
        })
    }

    /// The flight at a time, at which the body turns like this.
    fn at(&self, t: f64, turning: &State) -> (Flying, Kept) {
        let (attitude, omega) = (turning.attitude, turning.omega);
        let common = space(self.body.center()) + t * self.velocity;
        let spin = attitude.to_space(self.body.inertia().angular_momentum(omega));
        let momentum = self.body.mass() * self.velocity;
        // The centre of mass moves along the momentum, so its angular momentum about the origin is that at time 0.
        let orbit = space(self.body.center()).cross(&momentum);
        let ([p, l], energy) = self.beside;
        let center = common - attitude.to_space(self.body.center());
        let energy = 0.5 * momentum.dot(&self.velocity) + turning.energy + energy;
        let flying = Flying::of([energy], attitude, omega, center, spin);
        (flying, [momentum + p, spin + orbit + l])
    }
}

impl StruckPlanet {
    /// The flights before and after time 0.
    fn flights(&self) -> Result<[Free; 2]> {
        let planet = &self.planet;
        let ball = MassProperties::new(planet.mass, BodyVector::zero(), planet.inertia)?;
        let alone = Body::along_own_axes(&planet.inertia)?;
        let before = |beside| Free::new(ball, alone, planet.omega, planet.velocity, beside);
        let nothing = ([SpaceVector::zero(); 2], 0.0);
        let Some(Impact { meteorite, at }) = self.impact else {
            return Ok([before(nothing)?, before(nothing)?]);
        };
        let hit = strike(planet, &meteorite, at)?;
        let velocity = space(meteorite.velocity);
        let momentum = meteorite.mass * velocity;
        let energy = 0.5 * momentum.dot(&velocity);
        let stone = MassProperties::particle(meteorite.mass, at)?;
        let both = MassProperties::compose(&[ball, stone])?;
        let matrix = planet.inertia.matrix();
        let round = matrix.m11;
        let turning = if matrix == Matrix3::from_diagonal_element(round) {
            // Two of the common moments are equal, to the last bit only if they are one number.
            Body::symmetric_about(at, round, round + self.added(&meteorite, at))?
        } else {
            Body::along_own_axes(&both.inertia())?
        };
        Ok([
            before(([momentum, space(at).cross(&momentum)], energy))?,
            Free::new(both, turning, hit.omega_after, hit.velocity_after, nothing)?,
        ])
    }

    /// The moment, kg m², that a stone there adds about lines across its arm: that of the reduced mass.
    fn added(&self, stone: &Meteorite, at: BodyVector) -> f64 {
        at.dot(&at) / (1.0 / stone.mass + 1.0 / self.planet.mass)
    }
}

impl Scene for StruckPlanet {
    type State = Flying;

    fn plan(&self, request: &Request) -> Result<Plan> {
        let sticks =
            "an impact that sticks: six linear equations between two free motions in closed form";
        let reason = self.impact.map_or("no torque: closed form", |_| sticks);
        match request.choice {
            Choice::Auto | Choice::Use(Solver::Exact) => Ok(Plan::new(Solver::Exact, reason)),
            Choice::Use(_) => Err(Error::Solver {
                condition: "a struck planet is solved in closed form only; ask for exact",
            }),
        }
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Flying>> {
        let plan = self.plan(request)?;
        let ([before, after], mut error) = (self.flights()?, 0.0);
        let mut flown = |times: &[f64]| {
            let free = if times[0] < 0.0 { &before } else { &after };
            let turning = free.top.simulate(&request.of_times(times)?)?;
            error = turning.error_estimate.max(error);
            let states = turning.rows.iter().map(|(t, state)| free.at(*t, state));
            Ok(states.collect::<Vec<_>>())
        };
        let rows = both_ways(request.times(), &mut flown)?;
        // A state before the impact, for what is conserved: at the earliest time, or else just before time 0.
        let first = request.times().iter().copied();
        let (opening, [p, l]) = flown(&[first.fold(-f64::MIN_POSITIVE, f64::min)])?[0];
        // Drifts are compared with the terms, whose sum may be zero.
        let (planet, mut law) = (&self.planet, Law::Conserved);
        let mut moves = planet.mass * planet.velocity.norm();
        let mut turns = opening.angular_momentum.norm();
        if let Some(Impact { meteorite, at }) = self.impact {
            law = Law::NonIncreasing;
            // The planet's surface moves, too.
            let speed = meteorite.velocity.norm() + at.norm() * planet.omega.norm();
            moves += meteorite.mass * speed;
            turns += meteorite.mass * at.norm() * (speed + planet.velocity.norm());
            // Beside the moments of a stone far out those of the planet lose digits.
            let [least, ..] = planet.inertia.principal_axes().moments;
            error *= (self.added(&meteorite, at) / least).max(1.0);
        }
        let turning = "angular momentum about the origin";
        let states = &mut rows.iter().map(|(state, _)| *state);
        let mut ledger = OpenLedger::of(request, plan, (Cost::default(), error), states);
        ledger.conserved("momentum", moves, p, |k, _| rows[k].1[0])?;
        ledger.conserved(turning, turns, l, |k, _| rows[k].1[1])?;
        let kinetic = ("kinetic energy", law, opening.energy);
        ledger.keep(kinetic, opening.energy, |_, s| s.energy)?;
        ledger.closed(request)
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
