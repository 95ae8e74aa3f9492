//! The scene `meteorite` (tutorial 4.2): a planet flies and turns freely, a meteorite strikes at time 0 and sticks, and the two fly on as one body.
//!
//! | effect | type | what it does |
//! |---|---|---|
//! | impact | [`Impact`] | the meteorite, with recoil and its own share of the inertia |
//!
//! The two are one rigid body that turns about an axis which is no principal axis of it: after the blow the planet wobbles, as
//! Euler's top does, and its centre circles the common centre of mass.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

use super::choose;
use super::{Absent, Choice, Effect, Motion, Plan, Request, Scene, Solver, Tabulated, balanced};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::impacts::{Meteorite, Planet, Strike, strike};
use crate::inertia::InertiaMatrix;
use crate::integrators::Cost;

/// A meteorite that strikes at time 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// The meteorite, velocity along the planet's axes at time 0.
    pub meteorite: Meteorite,
    /// The point of impact from the planet's centre, along the same axes, m.
    pub at: BodyVector,
}

/// A blow, or none.
pub trait Blow: Copy {
    /// What it does to the planet.
    ///
    /// # Errors
    /// As [`strike`].
    fn strike(&self, planet: &Planet) -> Result<Option<Strike>>;
}

impl Blow for Impact {
    fn strike(&self, planet: &Planet) -> Result<Option<Strike>> {
        strike(planet, &self.meteorite, self.at).map(Some)
    }
}

impl Blow for Absent {
    fn strike(&self, _: &Planet) -> Result<Option<Strike>> {
        Ok(None)
    }
}

impl Effect for Impact {
    const PRESENT: bool = true;
    const NAME: &'static str = "impact";
}

/// A planet in free flight whose axes point along those of space at time 0, when its centre is at the origin.
#[derive(Debug, Clone, Copy)]
pub struct StruckPlanet<B = Absent> {
    planet: Planet,
    blow: B,
}

impl StruckPlanet {
    /// The planet left alone.
    pub const fn new(planet: Planet) -> Self {
        Self {
            planet,
            blow: Absent,
        }
    }
}

impl<B> StruckPlanet<B> {
    /// The same with a meteorite.
    pub fn with_impact<A>(self, impact: A) -> StruckPlanet<A> {
        StruckPlanet {
            planet: self.planet,
            blow: impact,
        }
    }
}

/// A planet at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flying {
    /// Turns the planet's axes into those of space.
    pub attitude: Attitude,
    /// Angular velocity along the planet's axes, rad/s.
    pub omega: BodyVector,
    /// The planet's centre C, m.
    pub center: SpaceVector,
    /// Kinetic energy of planet and meteorite, J.
    pub energy: f64,
}

impl Tabulated for Flying {
    /// Unit quaternion; rad/s; m; J.
    const COLUMNS: &'static [&'static str] = &[
        "qw", "qx", "qy", "qz", "omega1", "omega2", "omega3", "x", "y", "z", "energy",
    ];

    fn row(&self) -> Vec<f64> {
        let q = self.attitude.quaternion();
        let (o, c) = (self.omega, self.center);
        vec![
            q.w,
            q.i,
            q.j,
            q.k,
            o.x(),
            o.y(),
            o.z(),
            c.x(),
            c.y(),
            c.z(),
            self.energy,
        ]
    }
}

/// A rigid body in free flight: its centre of mass and Euler's top about it.
struct Free {
    mass: f64,
    top: EulerTop,
    /// From the planet's axes to the principal ones.
    turn: UnitQuaternion<f64>,
    /// The common centre of mass at time 0 and its velocity.
    from: SpaceVector,
    velocity: SpaceVector,
    /// The planet's centre from there, along the planet's axes.
    offset: BodyVector,
}

fn space(v: BodyVector) -> SpaceVector {
    SpaceVector::from_components(v.components())
}

impl Free {
    fn new(
        mass: f64,
        inertia: InertiaMatrix,
        omega: BodyVector,
        velocity: SpaceVector,
        offset: BodyVector,
    ) -> Result<Self> {
        let principal = inertia.principal_axes();
        let axes: Matrix3<f64> = principal.axes();
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        let along = BodyVector::from_components(axes.transpose() * omega.components());
        let q = turn.into_inner();
        let attitude = Attitude::from_quaternion(q.w, q.i, q.j, q.k)?;
        Ok(Self {
            mass,
            top: EulerTop::from_omega(principal.moments(), along, attitude)?,
            turn,
            from: space(-offset),
            velocity,
            offset,
        })
    }

    fn at(&self, t: f64) -> Result<(Flying, SpaceVector)> {
        let state = self.top.at(t)?;
        let q = (state.attitude.quaternion() * self.turn.inverse()).into_inner();
        let attitude = Attitude::from_quaternion(q.w, q.i, q.j, q.k)?;
        let omega = BodyVector::from_components(self.turn * state.omega.components());
        let common = self.from + t * self.velocity;
        let spin = state.attitude.to_space(state.angular_momentum);
        let v = self.velocity;
        let energy = 0.5 * self.mass * v.dot(&v) + 0.5 * state.angular_momentum.dot(&state.omega);
        let flying = Flying {
            attitude,
            omega,
            center: common + attitude.to_space(self.offset),
            energy,
        };
        Ok((flying, spin + common.cross(&(self.mass * v))))
    }
}

impl<B: Effect + Blow> Scene for StruckPlanet<B> {
    type State = Flying;

    fn plan(&self, request: &Request) -> Result<Plan> {
        match request.choice() {
            Choice::Auto | Choice::Use(Solver::Exact) if B::PRESENT => Ok(Plan::new(
                Solver::Exact,
                "an impact that sticks: six linear equations between two free motions in closed form",
            )),
            Choice::Auto | Choice::Use(Solver::Exact) => {
                Ok(Plan::new(Solver::Exact, "no torque: closed form"))
            }
            Choice::Use(_) => Err(Error::Solver {
                condition: "a struck planet is solved in closed form only; ask for exact",
            }),
        }
    }

    fn simulate(&self, request: &Request) -> Result<Motion<Flying>> {
        let plan = self.plan(request)?;
        let planet = &self.planet;
        let free = |planet: &Planet| {
            Free::new(
                planet.mass(),
                planet.inertia(),
                planet.omega(),
                space(planet.velocity()),
                BodyVector::zero(),
            )
        };
        let before = free(planet)?;
        let hit = self.blow.strike(planet)?;
        let after = match &hit {
            None => None,
            Some(hit) => {
                let (small, mass) = (hit.meteorite().mass(), planet.mass());
                let whole = mass + small;
                let center = (small / whole) * hit.at();
                let ball = planet.inertia().shifted_from_center(mass, center)?.matrix();
                let point = InertiaMatrix::of_particle(small, hit.at() - center)?.matrix();
                let inertia = InertiaMatrix::from_matrix(ball + point)?;
                let velocity = hit.velocity_after() + hit.omega_after().cross(&center);
                let omega = hit.omega_after();
                Some(Free::new(whole, inertia, omega, space(velocity), -center)?)
            }
        };
        // The meteorite on its way brings its own.
        let incoming = hit.as_ref().map(|hit| {
            let (m, v) = (hit.meteorite().mass(), space(hit.meteorite().velocity()));
            (m * v, space(hit.at()).cross(&(m * v)), 0.5 * m * v.dot(&v))
        });
        let mut times: Vec<f64> = request.times().to_vec();
        times.sort_by(f64::total_cmp);
        let look = |t: f64| -> Result<(Flying, SpaceVector, SpaceVector)> {
            match (&after, t >= 0.0, &incoming) {
                (Some(after), true, _) => {
                    let (state, momentum) = after.at(t)?;
                    Ok((state, after.mass * after.velocity, momentum))
                }
                (_, _, Some((p, l, e))) => {
                    let (mut state, momentum) = before.at(t)?;
                    state.energy += e;
                    Ok((state, before.mass * before.velocity + *p, momentum + *l))
                }
                _ => {
                    let (state, momentum) = before.at(t)?;
                    Ok((state, before.mass * before.velocity, momentum))
                }
            }
        };
        let ledger = books(&times, look, B::PRESENT)?;
        let rows = request
            .times()
            .iter()
            .map(|&t| Ok((t, look(t)?.0)))
            .collect::<Result<Vec<_>>>()?;
        Ok(Motion {
            error_estimate: None,
            plan,
            cost: Cost::default(),
            ledger: balanced(ledger, request.accuracy())?,
            rows,
        })
    }
}

/// Momentum, angular momentum about the origin, energy; from just before time 0 if that is where the blow falls.
fn books(
    times: &[f64],
    look: impl Fn(f64) -> Result<(Flying, SpaceVector, SpaceVector)>,
    struck: bool,
) -> Result<Ledger> {
    let first = times.first().copied().unwrap_or(0.0);
    let opening = if struck {
        first.min(-f64::MIN_POSITIVE)
    } else {
        first
    };
    let (state, p, l) = look(opening)?;
    let mut ledger = Ledger::new();
    let size = |v: SpaceVector| if v.norm() > 0.0 { v.norm() } else { 1.0 };
    let momentum = ledger.open_vector_scaled("momentum", p, size(p))?;
    let name = "angular momentum about the origin";
    let angular = ledger.open_vector_scaled(name, l, size(l))?;
    let law = if struck {
        Law::NonIncreasing
    } else {
        Law::Conserved
    };
    let scale = if state.energy > 0.0 {
        state.energy
    } else {
        1.0
    };
    let energy = ledger.open_scaled("kinetic energy", law, state.energy, scale)?;
    for &t in times {
        let (state, p, l) = look(t)?;
        ledger.record_vector(momentum, p)?;
        ledger.record_vector(angular, l)?;
        ledger.record(energy, state.energy)?;
    }
    Ok(ledger)
}

/// Simulates `planet` with the impact if it is listed.
///
/// # Errors
/// As for [`Scene::simulate`].
pub fn listed(
    planet: StruckPlanet,
    impact: Option<Impact>,
    request: &Request,
) -> Result<Motion<Flying>> {
    choose!((impact = impact) => planet.with_impact(impact).simulate(request))
}
