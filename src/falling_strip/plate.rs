//! The equations of a falling plate, term by term. SI units, per metre of the plate's length.

use core::f64::consts::PI;

use nalgebra::{Rotation2, Vector2};

use crate::error::{Result, finite, not_negative, positive, within};
use crate::integrators::System;

/// A long plate, per metre of its length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Half its width, m.
    pub(crate) half_chord: f64,
    /// Its mass, kg per metre of length.
    pub(crate) mass: f64,
    fluid_density: f64,
    thickness_ratio: f64,
    inertia_factor: f64,
}

impl Plate {
    /// A plate of half width a (`half_chord`, m) and `mass` (kg per metre of length) in a fluid of density ρ (kg/m³, 0 for none).
    ///
    /// `thickness_ratio` is β = b/a of the elliptical section from which its added mass is taken, `inertia_factor` is j in its moment of inertia
    /// j m a²(1 + β²) about the long axis: 1/3 for a flat strip, 1/4 for an elliptical cylinder.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::Negative`](crate::Error::Negative); [`Error::OutOfRange`](crate::Error::OutOfRange) for β outside 0…1.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Plate;
    /// assert!(Plate::new(0.02, 3.2e-3, 1.2, 0.0, 1.0 / 3.0).is_ok());
    /// // Thicker than wide.
    /// assert!(Plate::new(0.02, 3.2e-3, 1.2, 2.0, 1.0 / 3.0).is_err());
    /// ```
    pub fn new(
        half_chord: f64,
        mass: f64,
        fluid_density: f64,
        thickness_ratio: f64,
        inertia_factor: f64,
    ) -> Result<Self> {
        Ok(Self {
            half_chord: positive("half the width of the plate", half_chord)?,
            mass: positive("the mass of the plate", mass)?,
            fluid_density: not_negative("the density of the fluid", fluid_density)?,
            thickness_ratio: within("the thickness ratio", thickness_ratio, 0.0, 1.0)?,
            inertia_factor: positive("the inertia factor of the plate", inertia_factor)?,
        })
    }

    /// Its moment of inertia j m a²(1 + β²) about the long axis, kg m² per metre of length.
    pub(crate) fn moment(&self) -> f64 {
        let [a, beta] = [self.half_chord, self.thickness_ratio];
        self.inertia_factor * self.mass * a * a * (1.0 + beta * beta)
    }

    /// The mass π ρ a² of the fluid in the cylinder around the plate, kg/m: its added mass in broadside motion.
    pub(crate) fn displaced_mass(&self) -> f64 {
        PI * self.fluid_density * self.half_chord * self.half_chord
    }
}

/// Lift ρΓV at right angles to the velocity, with the circulation Γ = 2a(−C_T u w/V + C_R a ω), m²/s. At rest the first part of Γ is zero, its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lift {
    /// C_T, for the lift due to the angle of attack.
    pub translational: f64,
    /// C_R, for the lift due to rotation.
    pub rotational: f64,
}

/// Drag ρ a V²(A − B(u² − w²)/V²) against the velocity: A − B edgewise, A + B broadside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    /// A.
    pub mean: f64,
    /// B, at most A in magnitude.
    pub contrast: f64,
}

/// A torque −π ρ a⁴(c + μ₂|ω|)ω against the rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationalDamping {
    /// c, 1/s; in units of a and U it is μ₁.
    pub linear: f64,
    /// μ₂, dimensionless.
    pub quadratic: f64,
}

/// The added mass, of the fluid that an accelerated plate carries along: π ρ a² broadside, β² times that edgewise, π ρ a⁴(1 − β²)²/8 in rotation, each times a factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedMass {
    /// 1 for an ideal fluid.
    pub factor: f64,
}

/// The inertia of plate and added mass: along the chord and across it (kg/m), and in rotation (kg m).
struct Masses {
    along: f64,
    across: f64,
    moment: f64,
    /// Broadside added mass less the edgewise one.
    difference: f64,
}

/// Force along the chord and across it (N/m), torque about the long axis (N), and the power turned into heat (W/m).
#[derive(Default)]
struct Load {
    force: Vector2<f64>,
    torque: f64,
    heating: f64,
}

/// The equations of motion of a plate under the effects that are present.
///
/// State: x, y (m), θ (rad), u, w (m/s), ω (rad/s), heat (J/m); u is the velocity along the chord, w across it, in axes that turn with the plate. With
/// masses that include the added mass, m_u u' = m_w ω w + F_u, m_w w' = −m_u ω u + F_w, J ω' = N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equations {
    /// The plate.
    pub plate: Plate,
    /// Weight: g, m/s².
    pub gravity: Option<f64>,
    /// Lift.
    pub lift: Option<Lift>,
    /// Drag.
    pub drag: Option<Drag>,
    /// Resistance to rotation.
    pub damping: Option<RotationalDamping>,
    /// Added mass.
    pub added_mass: Option<AddedMass>,
}

impl Equations {
    /// The equations of a plate on which nothing acts.
    pub(crate) const fn new(plate: Plate) -> Self {
        Self {
            plate,
            gravity: None,
            lift: None,
            drag: None,
            damping: None,
            added_mass: None,
        }
    }

    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) where drag would push the plate, or damping speed up its rotation.
    pub(crate) fn checked(self) -> Result<Self> {
        if let Some(lift) = self.lift {
            finite("the lift of the angle of attack", lift.translational)?;
            finite("the lift of the rotation", lift.rotational)?;
        }
        if let Some(drag) = self.drag {
            not_negative("the least drag", drag.mean - drag.contrast.abs())?;
        }
        if let Some(damping) = self.damping {
            not_negative("the linear resistance to rotation", damping.linear)?;
            not_negative("the quadratic resistance to rotation", damping.quadratic)?;
        }
        if let Some(added) = self.added_mass {
            not_negative("the added mass", added.factor)?;
        }
        Ok(self)
    }

    fn masses(&self) -> Masses {
        let (a, mass) = (self.plate.half_chord, self.plate.mass);
        let beta = self.plate.thickness_ratio;
        let carried = |added: AddedMass| added.factor * self.plate.displaced_mass();
        let fluid = self.added_mass.map_or(0.0, carried);
        let flat = (1.0 - beta) * (1.0 + beta);
        Masses {
            along: mass + beta * beta * fluid,
            across: mass + fluid,
            moment: self.plate.moment() + fluid * a * a * flat * flat / 8.0,
            difference: fluid * flat,
        }
    }

    /// Force and torque on the plate, given sine and cosine of its angle and the sign of its spin.
    fn load(&self, slope: Vector2<f64>, sense: f64, state: &[f64; 7], masses: &Masses) -> Load {
        let [.., u, w, omega, _] = *state;
        let (plate, a, density) = (&self.plate, self.plate.half_chord, self.plate.fluid_density);
        let (velocity, speed) = (Vector2::new(u, w), u.hypot(w));
        let mut load = Load::default();
        if let Some(g) = self.gravity {
            load.force -= plate.mass * g * slope;
        }
        if let Some(lift) = self.lift {
            let mut circulation = lift.rotational * a * omega;
            if speed > 0.0 {
                circulation -= lift.translational * u * (w / speed);
            }
            load.force += density * (2.0 * a * circulation) * Vector2::new(-w, u);
        }
        if let Some(drag) = self.drag
            && speed > 0.0
        {
            let (edgewise, broadside) = (u / speed, w / speed);
            let aspect = drag.mean - drag.contrast * (edgewise * edgewise - broadside * broadside);
            let per_speed = density * a * speed * aspect;
            load.force -= per_speed * velocity;
            load.heating += per_speed * speed * speed;
        }
        if let Some(damping) = self.damping {
            let moment = plate.displaced_mass() * a * a;
            let torque = moment * (damping.linear + damping.quadratic * (sense * omega)) * omega;
            load.torque -= torque;
            load.heating += torque * omega;
        }
        // The difference of the two added masses turns a plate broadside to its motion.
        load.torque -= masses.difference * u * w;
        load
    }

    /// The rates of the state, with |ω| written as `sense` · ω: smooth as long as ω does not change sign.
    // ANCHOR: rate
    pub(crate) fn rate_in(&self, sense: f64, state: &[f64; 7]) -> [f64; 7] {
        let [_, _, theta, u, w, omega, _] = *state;
        let (sine, cosine) = theta.sin_cos();
        let masses = self.masses();
        let load = self.load(Vector2::new(sine, cosine), sense, state, &masses);
        [
            u * cosine - w * sine,
            u * sine + w * cosine,
            omega,
            (masses.across * omega * w + load.force.x) / masses.along,
            (load.force.y - masses.along * omega * u) / masses.across,
            load.torque / masses.moment,
            load.heating,
        ]
    }
    // ANCHOR_END: rate

    /// Kinetic energy, the fluid's included, J/m.
    pub(crate) fn kinetic_energy(&self, state: &[f64; 7]) -> f64 {
        let masses = self.masses();
        let [.., u, w, omega, _] = *state;
        0.5 * (masses.along * u * u + masses.across * w * w + masses.moment * omega * omega)
    }

    /// Momentum of plate and fluid in the axes of space (right, up), kg/s.
    pub(crate) fn impulse(&self, state: &[f64; 7]) -> [f64; 2] {
        let masses = self.masses();
        let [_, _, angle, u, w, ..] = *state;
        let momentum = Vector2::new(masses.along * u, masses.across * w);
        (Rotation2::new(angle) * momentum).into()
    }
}

impl System<7> for Equations {
    fn rate(&self, _: f64, state: &[f64; 7]) -> [f64; 7] {
        self.rate_in(1.0_f64.copysign(state[5]), state)
    }
}
