//! A strip that falls through a fluid, broadside length into the picture (tutorial 4.10).
//!
//! | effect | slot | absent |
//! |---|---|---|
//! | weight | [`with_gravity`](Strip::with_gravity) | floats |
//! | lift by circulation | [`with_lift`](Strip::with_lift) | no force across the velocity |
//! | drag | [`with_drag`](Strip::with_drag) | no force against it |
//! | resistance to rotation | [`with_rotational_damping`](Strip::with_rotational_damping) | spins on |
//! | added mass | [`with_added_mass`](Strip::with_added_mass) | no fluid is taken along, and none turns it broadside |
//!
//! Without the last four the strip is in a vacuum, and its parabola and its uniform rotation are a closed form.

mod effects;
mod engine;
mod listed;

pub use effects::Weight;
pub use listed::Listed;

use super::effect::{Absent, Effect};
use super::motion::{Motion, Request};
use super::plan::Plan;
use super::{Scene, Tabulated};
use crate::error::{Result, finite};
use crate::falling_strip::{
    AddedMass, Coefficients, Drag, Equations, Gravity, Inertia, Lift, Plate, RotationalDamping,
    Sheet, Term,
};
use engine::{Acting, List, Setting};

/// The state of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripState {
    /// Place of the axis: to the right and up, m.
    pub position: [f64; 2],
    /// Angle of the chord above the horizontal, rad.
    pub angle: f64,
    /// Velocity: to the right and up, m/s.
    pub velocity: [f64; 2],
    /// Angular velocity, rad/s.
    pub omega: f64,
    /// Kinetic energy (the fluid's that is taken along included) and potential energy, J per metre of length.
    pub energy: f64,
    /// What drag and the resistance to rotation have turned into heat, J per metre of length.
    pub heat: f64,
}

impl Tabulated for StripState {
    const COLUMNS: &'static [&'static str] =
        &["x", "y", "angle", "vx", "vy", "omega", "energy", "heat"];

    fn row(&self) -> Vec<f64> {
        let [x, y] = self.position;
        let [vx, vy] = self.velocity;
        vec![x, y, self.angle, vx, vy, self.omega, self.energy, self.heat]
    }
}

/// How a strip starts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StripStart {
    /// Angle of the chord above the horizontal, rad.
    pub angle: f64,
    /// Velocity: to the right and up, m/s.
    pub velocity: [f64; 2],
    /// Angular velocity, rad/s.
    pub omega: f64,
}

/// A strip, how it starts, and what acts on it.
///
/// Effects fill slots of their own, so the order in which they are listed cannot matter.
///
/// ```
/// use spinning_bodies::falling_strip::{Coefficients, Sheet};
/// use spinning_bodies::scene::{Request, Scene, strip::{Strip, StripStart}};
///
/// let sheet = Sheet::of_paper(0.02)?;
/// let start = StripStart { angle: 0.2, ..StripStart::default() };
/// let strip = Strip::in_air(&sheet, start, Coefficients::PAPER)?;
/// let motion = strip.simulate(&Request::at([1.0])?.to_accuracy(1e-9)?)?;
/// assert!(motion.rows[0].1.omega.abs() > 30.0, "it tumbles");
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip<G = Absent, L = Absent, D = Absent, R = Absent, A = Absent> {
    equations: Equations<G, L, D, R, A>,
    start: StripStart,
}

impl Strip {
    /// A strip on which nothing acts.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(plate: Plate, start: StripStart) -> Result<Self> {
        for component in [start.velocity[0], start.velocity[1]] {
            finite("the velocity at the start", component)?;
        }
        finite("the angle at the start", start.angle)?;
        finite("the angular velocity at the start", start.omega)?;
        let equations = Equations {
            plate,
            gravity: Absent,
            lift: Absent,
            drag: Absent,
            damping: Absent,
            added_mass: Absent,
        };
        Ok(Self { equations, start })
    }
}

/// A strip with all the effects.
pub type StripInAir = Strip<Gravity, Lift, Drag, RotationalDamping, AddedMass>;

impl StripInAir {
    /// A sheet in its fluid with all the effects and these coefficients; μ₁ is taken per unit a/U of the sheet's own time.
    ///
    /// # Errors
    /// As [`Strip::new`] and [`Plate::new`].
    pub fn in_air(sheet: &Sheet, start: StripStart, coefficients: Coefficients) -> Result<Self> {
        let a = sheet.half_chord();
        let displaced = sheet.plate()?.displaced_mass();
        let mass = sheet.mass_ratio() * displaced;
        let density = displaced / (core::f64::consts::PI * a * a);
        let plate = Plate::new(a, mass, density, 0.0, coefficients.inertia_factor)?;
        let damping = RotationalDamping {
            linear: coefficients.damping.linear / sheet.time(),
            quadratic: coefficients.damping.quadratic,
        };
        Strip::new(plate, start)?
            .with_gravity(Gravity {
                acceleration: sheet.gravity(),
            })?
            .with_lift(coefficients.lift)?
            .with_drag(coefficients.drag)?
            .with_rotational_damping(damping)?
            .with_added_mass(AddedMass { factor: 1.0 })
    }
}

/// A coefficient that must not drive what it should brake.
fn braking(quantity: &'static str, value: f64) -> Result<f64> {
    crate::error::not_negative(quantity, value)
}

impl<G: Copy, L: Copy, D: Copy, R: Copy, A: Copy> Strip<G, L, D, R, A> {
    /// Adds weight.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for what should brake and would drive.
    pub fn with_gravity(self, effect: Gravity) -> Result<Strip<Gravity, L, D, R, A>> {
        finite("gravity", effect.acceleration)?;
        let equations = Equations {
            plate: self.equations.plate,
            gravity: effect,
            lift: self.equations.lift,
            drag: self.equations.drag,
            damping: self.equations.damping,
            added_mass: self.equations.added_mass,
        };
        let start = self.start;
        Ok(Strip { equations, start })
    }

    /// Adds lift.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for what should brake and would drive.
    pub fn with_lift(self, effect: Lift) -> Result<Strip<G, Lift, D, R, A>> {
        finite("the lift of the angle of attack", effect.translational)?;
        finite("the lift of the rotation", effect.rotational)?;
        let equations = Equations {
            plate: self.equations.plate,
            gravity: self.equations.gravity,
            lift: effect,
            drag: self.equations.drag,
            damping: self.equations.damping,
            added_mass: self.equations.added_mass,
        };
        let start = self.start;
        Ok(Strip { equations, start })
    }

    /// Adds drag.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for what should brake and would drive.
    pub fn with_drag(self, effect: Drag) -> Result<Strip<G, L, Drag, R, A>> {
        finite("the contrast of the drag", effect.contrast)?;
        braking(
            "the least drag",
            finite("the mean drag", effect.mean)? - effect.contrast.abs(),
        )?;
        let equations = Equations {
            plate: self.equations.plate,
            gravity: self.equations.gravity,
            lift: self.equations.lift,
            drag: effect,
            damping: self.equations.damping,
            added_mass: self.equations.added_mass,
        };
        let start = self.start;
        Ok(Strip { equations, start })
    }

    /// Adds resistance to rotation.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for what should brake and would drive.
    pub fn with_rotational_damping(
        self,
        effect: RotationalDamping,
    ) -> Result<Strip<G, L, D, RotationalDamping, A>> {
        braking("the linear resistance to rotation", effect.linear)?;
        braking("the quadratic resistance to rotation", effect.quadratic)?;
        let equations = Equations {
            plate: self.equations.plate,
            gravity: self.equations.gravity,
            lift: self.equations.lift,
            drag: self.equations.drag,
            damping: effect,
            added_mass: self.equations.added_mass,
        };
        let start = self.start;
        Ok(Strip { equations, start })
    }

    /// Adds the mass of the fluid that is taken along.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative) for what should brake and would drive.
    pub fn with_added_mass(self, effect: AddedMass) -> Result<Strip<G, L, D, R, AddedMass>> {
        braking("the added mass", effect.factor)?;
        let equations = Equations {
            plate: self.equations.plate,
            gravity: self.equations.gravity,
            lift: self.equations.lift,
            drag: self.equations.drag,
            damping: self.equations.damping,
            added_mass: effect,
        };
        let start = self.start;
        Ok(Strip { equations, start })
    }

    /// The equations.
    pub fn equations(&self) -> &Equations<G, L, D, R, A> {
        &self.equations
    }
}

impl<G, L, D, R, A> Strip<G, L, D, R, A>
where
    G: Weight,
    L: Term + Effect,
    D: Term + Effect,
    R: Term + Effect,
    A: Inertia + Effect,
{
    /// The scene for the engine, which is compiled once for all lists of effects.
    fn setting(&self) -> Setting<'_> {
        Setting {
            equations: &self.equations,
            start: self.start,
        }
    }
}

impl<G, L, D, R, A> Acting for Equations<G, L, D, R, A>
where
    G: Weight,
    L: Term + Effect,
    D: Term + Effect,
    R: Term + Effect,
    A: Inertia + Effect,
{
    fn plate(&self) -> &Plate {
        &self.plate
    }

    fn gravity(&self) -> f64 {
        self.gravity.acceleration()
    }

    fn kinetic_energy(&self, y: &[f64; 7]) -> f64 {
        Equations::kinetic_energy(self, y)
    }

    fn potential(&self, height: f64) -> f64 {
        self.gravity.potential(&self.plate, height)
    }

    fn impulse(&self, y: &[f64; 7]) -> [f64; 2] {
        Equations::impulse(self, y)
    }

    fn acting(&self) -> List {
        List {
            lift: L::PRESENT,
            drag: D::PRESENT,
            damping: R::PRESENT,
            added_mass: A::PRESENT,
        }
    }
}

impl<G, L, D, R, A> Scene for Strip<G, L, D, R, A>
where
    G: Weight,
    L: Term + Effect,
    D: Term + Effect,
    R: Term + Effect,
    A: Inertia + Effect,
{
    type State = StripState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        self.setting().plan(request)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<StripState>> {
        self.setting().motion(request)
    }
}
