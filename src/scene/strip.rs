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

use super::effect::{Absent, Effect};
use super::motion::{Motion, Request, balanced};
use super::plan::{Choice, Plan, Solver};
use super::{Scene, Tabulated, choose};
use crate::conservation::{Law, Ledger};
use crate::error::{Error, Result, finite};
use crate::falling_strip::{
    AddedMass, Coefficients, Drag, Equations, Gravity, Inertia, Lift, Load, Masses, Moving, Plate,
    RotationalDamping, Sheet, Term,
};
use crate::integrators::{Cost, Effort, Method, System, refined, solve};

impl Term for Absent {
    fn add(&self, _: &Plate, _: &Moving, _: &mut Load) {}
}

impl Inertia for Absent {
    fn masses(&self, plate: &Plate) -> Masses {
        plate.own()
    }
}

/// Weight in a slot: it has a potential energy as well.
pub trait Weight: Term + Effect {
    /// Energy at this height, J/m.
    fn potential(&self, plate: &Plate, height: f64) -> f64;
    /// g, m/s².
    fn acceleration(&self) -> f64;
}

impl Weight for Absent {
    fn potential(&self, _: &Plate, _: f64) -> f64 {
        0.0
    }
    fn acceleration(&self) -> f64 {
        0.0
    }
}

impl Weight for Gravity {
    fn potential(&self, plate: &Plate, height: f64) -> f64 {
        plate.mass() * self.acceleration * height
    }
    fn acceleration(&self) -> f64 {
        self.acceleration
    }
}

macro_rules! effects {
    ($($effect:ty: $name:literal,)*) => {
        $(impl Effect for $effect {
            const PRESENT: bool = true;
            const NAME: &'static str = $name;
        })*
    };
}

effects! {
    Gravity: "gravity",
    Lift: "lift",
    Drag: "drag",
    RotationalDamping: "rotational_damping",
    AddedMass: "added_mass",
}

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
    /// [`Error::NotFinite`].
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
    /// [`Error::NotFinite`]; [`Error::Negative`] for what should brake and would drive.
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
    /// [`Error::NotFinite`]; [`Error::Negative`] for what should brake and would drive.
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
    /// [`Error::NotFinite`]; [`Error::Negative`] for what should brake and would drive.
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
    /// [`Error::NotFinite`]; [`Error::Negative`] for what should brake and would drive.
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
    /// [`Error::NotFinite`]; [`Error::Negative`] for what should brake and would drive.
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
    /// Nothing of the fluid is at work.
    const VACUUM: bool = !(L::PRESENT || D::PRESENT || R::PRESENT || A::PRESENT);

    fn first(&self) -> [f64; 7] {
        let StripStart {
            angle,
            velocity: [vx, vy],
            omega,
        } = self.start;
        let (sine, cosine) = angle.sin_cos();
        let along = vx * cosine + vy * sine;
        let across = vy * cosine - vx * sine;
        [0.0, 0.0, angle, along, across, omega, 0.0]
    }

    /// The parabola.
    fn in_vacuum(&self, t: f64) -> [f64; 7] {
        let StripStart {
            angle,
            velocity: [vx, vy],
            omega,
        } = self.start;
        let g = self.equations.gravity.acceleration();
        let theta = angle + omega * t;
        let (sine, cosine) = theta.sin_cos();
        let now = vy - g * t;
        let (along, across) = (vx * cosine + now * sine, now * cosine - vx * sine);
        let height = t * (vy - 0.5 * g * t);
        [vx * t, height, theta, along, across, omega, 0.0]
    }

    fn state(&self, y: &[f64; 7]) -> StripState {
        let (sine, cosine) = y[2].sin_cos();
        let potential = self
            .equations
            .gravity
            .potential(&self.equations.plate, y[1]);
        StripState {
            position: [y[0], y[1]],
            angle: y[2],
            velocity: [y[3] * cosine - y[4] * sine, y[3] * sine + y[4] * cosine],
            omega: y[5],
            energy: self.equations.kinetic_energy(y) + potential,
            heat: y[6],
        }
    }

    /// Sizes of the state: a, 1, a speed, a rate, an energy.
    fn scales(&self) -> [f64; 7] {
        let plate = &self.equations.plate;
        let a = plate.half_chord();
        let g = self.equations.gravity.acceleration().abs();
        let [vx, vy] = self.start.velocity;
        let speed = (g * a).sqrt() + vx.hypot(vy) + a * self.start.omega.abs();
        // A strip that nothing moves has no speed; any will do.
        let speed = if speed > 0.0 { speed } else { 1.0 };
        let energy = plate.mass() * speed * speed;
        [a, a, 1.0, speed, speed, speed / a, energy]
    }

    fn ledger(&self, times: &[f64], rows: &[[f64; 7]], accuracy: f64) -> Result<Ledger> {
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
        let first = self.first();
        let start = self.state(&first);
        let [px, py] = self.equations.impulse(&first);
        let mut energy_scale = self.scales()[6];
        let mut impulse_scale = energy_scale / self.scales()[3];
        let weight = self.equations.plate.mass() * self.equations.gravity.acceleration();
        for (y, t) in rows.iter().zip(times) {
            energy_scale = energy_scale.max(self.equations.kinetic_energy(y) + y[6]);
            impulse_scale = impulse_scale.max((weight * t).abs());
        }
        let mut ledger = Ledger::new();
        let balance = ledger.open_scaled(
            "energy and heat",
            Law::Conserved,
            start.energy,
            energy_scale,
        )?;
        let heat = if D::PRESENT || R::PRESENT {
            let name = "heat";
            Some(ledger.open_scaled(name, Law::NonDecreasing, 0.0, energy_scale)?)
        } else {
            None
        };
        // Without lift and drag only the weight changes the impulse of plate and fluid.
        let impulse = if L::PRESENT || D::PRESENT {
            None
        } else {
            let name = "horizontal impulse";
            let horizontal = ledger.open_scaled(name, Law::Conserved, px, impulse_scale)?;
            let name = "vertical impulse and that of the weight";
            let vertical = ledger.open_scaled(name, Law::Conserved, py, impulse_scale)?;
            Some((horizontal, vertical))
        };
        for i in order {
            let state = self.state(&rows[i]);
            ledger.record(balance, state.energy + state.heat)?;
            if let Some(heat) = heat {
                ledger.record(heat, state.heat)?;
            }
            if let Some((horizontal, vertical)) = impulse {
                let [x, y] = self.equations.impulse(&rows[i]);
                ledger.record(horizontal, x)?;
                ledger.record(vertical, y + weight * times[i])?;
            }
        }
        balanced(ledger, accuracy)
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
        let solver = match request.choice() {
            Choice::Use(solver) => solver,
            Choice::Auto if Self::VACUUM => Solver::Exact,
            Choice::Auto => Solver::General(Method::Dop853),
        };
        let reason = match solver {
            Solver::Exact if Self::VACUUM => "a vacuum: closed form",
            Solver::Exact | Solver::Events | Solver::Geometric(_) => {
                return Err(Error::Condition {
                    condition: "the solver must be a general one for a strip in a fluid, which has no closed form",
                    value: f64::NAN,
                });
            }
            Solver::General(_) if Self::VACUUM => "asked for, though a vacuum has a closed form",
            Solver::General(_) => "forces of a fluid: general integration",
        };
        let damped = !D::PRESENT;
        if request.times().iter().any(|&t| t < 0.0) && !damped {
            return Err(Error::OutOfRange {
                quantity: "a time of a scene with drag",
                value: request.times().iter().copied().fold(0.0, f64::min),
                least: 0.0,
                greatest: f64::INFINITY,
            });
        }
        Ok(Plan::new(solver, reason))
    }

    fn simulate(&self, request: &Request) -> Result<Motion<StripState>> {
        let plan = self.plan(request)?;
        let times = request.times();
        let scales = self.scales();
        let (rows, cost) = match plan.solver {
            Solver::General(method) => {
                let (system, first) = (&self.equations as &dyn System<7>, self.first());
                integrated(system, &first, &scales, times, method, request.accuracy())?
            }
            _ => {
                let rows = times.iter().map(|&t| self.in_vacuum(t)).collect();
                (rows, Cost::default())
            }
        };
        for y in &rows {
            for &component in y {
                finite("the state of the strip", component)?;
            }
        }
        let ledger = self.ledger(times, &rows, request.accuracy())?;
        let states = rows.iter().map(|y| self.state(y));
        Ok(Motion {
            error_estimate: None,
            plan,
            cost,
            ledger,
            rows: times.iter().copied().zip(states).collect(),
        })
    }
}

/// All rows by a general method: with a verified error where the method chooses its steps. Compiled once for all lists of effects.
fn integrated(
    system: &dyn System<7>,
    first: &[f64; 7],
    scales: &[f64; 7],
    times: &[f64],
    method: Method,
    accuracy: f64,
) -> Result<(Vec<[f64; 7]>, Cost)> {
    // Everything but the heat, which the energy vouches for.
    let distance = |a: &[f64; 7], b: &[f64; 7]| {
        (0..6)
            .map(|i| (a[i] - b[i]).abs() / (scales[i] + a[i].abs()))
            .fold(0.0, f64::max)
    };
    let run = if method.is_adaptive() {
        refined(system, first, scales, times, method, accuracy, distance)?
    } else {
        // An error of order step⁴, with the fastest motion of the scales as its unit of time.
        let step = 0.1 * accuracy.powf(0.25) * scales[0] / scales[3];
        let effort = Effort::Step(step);
        solve(system, 0.0, first, scales, times, method, effort)?
    };
    Ok((run.states, run.cost))
}

/// Effects of a strip that are known at run time only, as from a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Listed {
    /// Weight.
    pub gravity: Option<Gravity>,
    /// Lift.
    pub lift: Option<Lift>,
    /// Drag.
    pub drag: Option<Drag>,
    /// Resistance to rotation.
    pub rotational_damping: Option<RotationalDamping>,
    /// Added mass.
    pub added_mass: Option<AddedMass>,
}

impl Listed {
    /// The scene of a strip with just these effects.
    ///
    /// # Errors
    /// As [`Strip::new`], and the builder method of each effect.
    pub fn on(
        &self,
        plate: Plate,
        start: StripStart,
    ) -> Result<Box<dyn Scene<State = StripState>>> {
        let bare = Strip::new(plate, start)?;
        if let Some(effect) = self.gravity {
            bare.with_gravity(effect)?;
        }
        if let Some(effect) = self.lift {
            bare.with_lift(effect)?;
        }
        if let Some(effect) = self.drag {
            bare.with_drag(effect)?;
        }
        if let Some(effect) = self.rotational_damping {
            bare.with_rotational_damping(effect)?;
        }
        if let Some(effect) = self.added_mass {
            bare.with_added_mass(effect)?;
        }
        Ok(
            choose!((gravity = self.gravity) (lift = self.lift) (drag = self.drag) (damping = self.rotational_damping)
            (added_mass = self.added_mass) => {
                let equations = Equations { plate, gravity, lift, drag, damping, added_mass };
                Box::new(Strip { equations, start })
            }),
        )
    }
}
