//! The equations of a falling plate, term by term. SI units, per metre of its length.

use core::fmt::Debug;

use crate::error::{Error, Result, not_negative, positive};
use crate::integrators::System;

/// A long plate, per metre of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    half_chord: f64,
    mass: f64,
    fluid_density: f64,
    thickness_ratio: f64,
    inertia_factor: f64,
}

impl Plate {
    /// A plate of half width a (`half_chord`, m) and `mass` (kg per metre of length) in a fluid of density ρ (kg/m³, 0 for none).
    ///
    /// `thickness_ratio` is β = b/a of the elliptical section whose added mass it has, `inertia_factor` is j: its moment of inertia about
    /// the long axis is j m a²(1 + β²), so 1/3 is a flat strip, 1/4 an elliptical cylinder.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::Negative`]; [`Error::OutOfRange`] for β outside 0…1.
    pub fn new(
        half_chord: f64,
        mass: f64,
        fluid_density: f64,
        thickness_ratio: f64,
        inertia_factor: f64,
    ) -> Result<Self> {
        not_negative("the thickness ratio", thickness_ratio)?;
        if thickness_ratio > 1.0 {
            return Err(Error::OutOfRange {
                quantity: "the thickness ratio",
                value: thickness_ratio,
                least: 0.0,
                greatest: 1.0,
            });
        }
        Ok(Self {
            half_chord: positive("half the width of the plate", half_chord)?,
            mass: positive("the mass of the plate", mass)?,
            fluid_density: not_negative("the density of the fluid", fluid_density)?,
            thickness_ratio,
            inertia_factor: positive("the inertia factor of the plate", inertia_factor)?,
        })
    }

    /// Half its width, m.
    pub const fn half_chord(&self) -> f64 {
        self.half_chord
    }

    /// Its mass, kg per metre of length.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// The mass π ρ a² of the fluid cylinder that just holds it, kg/m: what it must push aside when it moves broadside.
    pub fn displaced_mass(&self) -> f64 {
        core::f64::consts::PI * self.fluid_density * self.half_chord * self.half_chord
    }

    /// Its mass over the [displaced mass](Self::displaced_mass), I*; infinite in a vacuum.
    pub fn mass_ratio(&self) -> f64 {
        self.mass / self.displaced_mass()
    }

    /// The plate's own masses and moment: what it resists acceleration with in a vacuum.
    pub(crate) fn own(&self) -> Masses {
        let beta = self.thickness_ratio;
        let a = self.half_chord;
        Masses {
            along: self.mass,
            across: self.mass,
            moment: self.inertia_factor * self.mass * a * a * (1.0 + beta * beta),
        }
    }
}

/// What the plate resists acceleration with: along the chord and across it (kg/m), and in rotation (kg m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Masses {
    /// Along the chord.
    pub along: f64,
    /// Across it.
    pub across: f64,
    /// About the long axis.
    pub moment: f64,
}

/// How the plate moves: u along its chord, w across it (m/s), both in axes that turn with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moving {
    /// Sine and cosine of the angle θ from the horizontal to the chord.
    pub slope: (f64, f64),
    /// Velocity along the chord.
    pub u: f64,
    /// Velocity across it.
    pub w: f64,
    /// Angular velocity θ', rad/s, about the long axis.
    pub omega: f64,
    /// 1 if it turns anticlockwise, −1 if clockwise: |ω| is `sense` · ω. Within a step of an integrator that ends where the plate turns
    /// back, it is the sense before that.
    pub sense: f64,
}

impl Moving {
    /// √(u² + w²), m/s.
    pub fn speed(&self) -> f64 {
        self.u.hypot(self.w)
    }
}

/// Force along the chord and across it (N/m), torque about the long axis (N), and the power turned into heat (W/m).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Load {
    /// Along the chord.
    pub along: f64,
    /// Across it.
    pub across: f64,
    /// Anticlockwise.
    pub torque: f64,
    /// What friction takes from the motion.
    pub heating: f64,
}

/// One of the things that act on the plate.
pub trait Term: Copy + Debug {
    /// Adds its force, torque and heating to the load.
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load);

    /// Whether it has a kink where the plate turns back.
    fn has_kink(&self) -> bool {
        false
    }
}

/// What the plate resists acceleration with.
pub trait Inertia: Term {
    /// With the fluid that it takes along, if any.
    fn masses(&self, plate: &Plate) -> Masses;
}

/// Weight m g, downward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity {
    /// g, m/s².
    pub acceleration: f64,
}

impl Term for Gravity {
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load) {
        let weight = plate.mass * self.acceleration;
        let (sine, cosine) = moving.slope;
        load.along -= weight * sine;
        load.across -= weight * cosine;
    }
}

/// Lift ρΓ at right angles to the velocity, with Γ = 2a(−C_T u w/V + C_R a ω).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lift {
    /// C_T, of the angle of attack.
    pub translational: f64,
    /// C_R, of the rotation.
    pub rotational: f64,
}

impl Lift {
    /// Γ, m²/s. At rest the first part is zero, its limit.
    pub fn circulation(&self, plate: &Plate, moving: &Moving) -> f64 {
        let a = plate.half_chord;
        let speed = moving.speed();
        let mut circulation = self.rotational * a * moving.omega;
        if speed > 0.0 {
            circulation -= self.translational * moving.u * (moving.w / speed);
        }
        2.0 * a * circulation
    }
}

impl Term for Lift {
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load) {
        let per_speed = plate.fluid_density * self.circulation(plate, moving);
        load.along -= per_speed * moving.w;
        load.across += per_speed * moving.u;
    }
}

/// Drag ρ a V²(A − B(u² − w²)/V²) against the velocity: A − B edgewise, A + B broadside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    /// A.
    pub mean: f64,
    /// B, not more than A in size.
    pub contrast: f64,
}

impl Term for Drag {
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load) {
        let speed = moving.speed();
        if speed > 0.0 {
            let (u, w) = (moving.u / speed, moving.w / speed);
            let aspect = self.mean - self.contrast * (u * u - w * w);
            let per_speed = plate.fluid_density * plate.half_chord * speed * aspect;
            load.along -= per_speed * moving.u;
            load.across -= per_speed * moving.w;
            load.heating += per_speed * speed * speed;
        }
    }
}

/// A torque −π ρ a⁴(c + μ₂|ω|)ω against the rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationalDamping {
    /// c, 1/s. In the units of the theory it is μ₁.
    pub linear: f64,
    /// μ₂, dimensionless.
    pub quadratic: f64,
}

impl Term for RotationalDamping {
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load) {
        let moment = plate.displaced_mass() * plate.half_chord * plate.half_chord;
        let size = moving.sense * moving.omega;
        let torque = moment * (self.linear + self.quadratic * size) * moving.omega;
        load.torque -= torque;
        load.heating += torque * moving.omega;
    }

    fn has_kink(&self) -> bool {
        self.quadratic != 0.0
    }
}

/// The fluid that an accelerated plate takes along: π ρ a² broadside, β² of it edgewise, π ρ a⁴(1 − β²)²/8 in rotation, each times a factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedMass {
    /// 1 for an ideal fluid.
    pub factor: f64,
}

impl AddedMass {
    /// Broadside added mass less the edgewise one, kg/m.
    fn difference(&self, plate: &Plate) -> f64 {
        let beta = plate.thickness_ratio;
        self.factor * plate.displaced_mass() * (1.0 - beta) * (1.0 + beta)
    }
}

impl Term for AddedMass {
    /// The torque that turns a plate broadside to its way: it is what the two added masses differ by that does it.
    fn add(&self, plate: &Plate, moving: &Moving, load: &mut Load) {
        load.torque -= self.difference(plate) * moving.u * moving.w;
    }
}

impl Inertia for AddedMass {
    fn masses(&self, plate: &Plate) -> Masses {
        let own = plate.own();
        let fluid = self.factor * plate.displaced_mass();
        let (a, beta) = (plate.half_chord, plate.thickness_ratio);
        let flat = (1.0 - beta) * (1.0 + beta);
        Masses {
            along: own.along + beta * beta * fluid,
            across: own.across + fluid,
            moment: own.moment + fluid * a * a * flat * flat / 8.0,
        }
    }
}

/// The equations of motion, one slot a term; what a slot holds is part of the type.
///
/// State: x, y (m), θ (rad), u, w (m/s), ω (rad/s), heat (J/m). With the masses of [`Inertia`] and the [`Load`] of the terms,
/// m_u u' = m_w ω w + F_u, m_w w' = −m_u ω u + F_w, J ω' = N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equations<G, L, D, R, A> {
    /// The plate.
    pub plate: Plate,
    /// Weight.
    pub gravity: G,
    /// Lift.
    pub lift: L,
    /// Drag.
    pub drag: D,
    /// Resistance to rotation.
    pub damping: R,
    /// The fluid it takes along.
    pub added_mass: A,
}

/// How a state moves.
pub(crate) fn moving(state: &[f64; 7]) -> Moving {
    Moving {
        slope: state[2].sin_cos(),
        u: state[3],
        w: state[4],
        omega: state[5],
        sense: 1.0_f64.copysign(state[5]),
    }
}

/// Equations that are smooth as long as the plate does not turn back.
pub(crate) trait Pieces {
    /// The rates with |ω| read as `sense` · ω.
    fn rate_in(&self, sense: f64, state: &[f64; 7]) -> [f64; 7];
    /// Whether turning back is a kink.
    fn has_kink(&self) -> bool;
    /// The same equations with |ω| itself.
    fn whole(&self) -> &dyn System<7>;
}

impl<G: Term, L: Term, D: Term, R: Term, A: Inertia> Equations<G, L, D, R, A> {
    /// Force, torque and heating at one moment.
    pub fn load(&self, moving: &Moving) -> Load {
        let mut load = Load::default();
        self.gravity.add(&self.plate, moving, &mut load);
        self.lift.add(&self.plate, moving, &mut load);
        self.drag.add(&self.plate, moving, &mut load);
        self.damping.add(&self.plate, moving, &mut load);
        self.added_mass.add(&self.plate, moving, &mut load);
        load
    }

    /// Kinetic energy, the fluid's included, J/m.
    pub fn kinetic_energy(&self, state: &[f64; 7]) -> f64 {
        let masses = self.added_mass.masses(&self.plate);
        let [.., u, w, omega, _] = *state;
        0.5 * (masses.along * u * u + masses.across * w * w + masses.moment * omega * omega)
    }

    /// Momentum of plate and fluid in the axes of space (right, up), kg/s.
    pub fn impulse(&self, state: &[f64; 7]) -> [f64; 2] {
        let masses = self.added_mass.masses(&self.plate);
        let (sine, cosine) = state[2].sin_cos();
        let (along, across) = (masses.along * state[3], masses.across * state[4]);
        [
            along * cosine - across * sine,
            along * sine + across * cosine,
        ]
    }
}

impl<G: Term, L: Term, D: Term, R: Term, A: Inertia> Equations<G, L, D, R, A> {
    // ANCHOR: rate
    fn rates(&self, moving: &Moving) -> [f64; 7] {
        let (sine, cosine) = moving.slope;
        let Moving { u, w, omega, .. } = *moving;
        let load = self.load(moving);
        let masses = self.added_mass.masses(&self.plate);
        [
            u * cosine - w * sine,
            u * sine + w * cosine,
            omega,
            (masses.across * omega * w + load.along) / masses.along,
            (load.across - masses.along * omega * u) / masses.across,
            load.torque / masses.moment,
            load.heating,
        ]
    }
    // ANCHOR_END: rate
}

impl<G: Term, L: Term, D: Term, R: Term, A: Inertia> System<7> for Equations<G, L, D, R, A> {
    fn rate(&self, _: f64, state: &[f64; 7]) -> [f64; 7] {
        self.rates(&moving(state))
    }
}

impl<G: Term, L: Term, D: Term, R: Term, A: Inertia> Pieces for Equations<G, L, D, R, A> {
    fn rate_in(&self, sense: f64, state: &[f64; 7]) -> [f64; 7] {
        let moving = moving(state);
        self.rates(&Moving { sense, ..moving })
    }

    fn has_kink(&self) -> bool {
        self.damping.has_kink()
    }

    fn whole(&self) -> &dyn System<7> {
        self
    }
}
