//! The scene `strip` (tutorial 4.10): a strip that falls through a fluid, seen along its length.

use nalgebra::{Rotation2, Vector2};

use super::engine::ROUNDING;
use super::path::MOST_TURNED;
use super::prelude::*;
use crate::falling_strip::{Equations, Plate, RotationalDamping};

state! {
    /// The state of a strip; energies per metre of its length.
    StripState {
        /// place, to the right, m
        x,
        /// place, up, m
        y,
        /// angle of the chord above the horizontal, rad
        angle,
        /// velocity, to the right, m/s
        vx,
        /// velocity, up, m/s
        vy,
        /// angular velocity, rad/s
        omega,
        /// kinetic energy, of the fluid taken along too, and potential energy, J/m
        energy,
        /// what drag and damping have taken so far, J/m
        heat,
    }
}

/// The start of a strip.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StripStart {
    /// Angle of the chord above the horizontal, rad.
    pub angle: f64,
    /// Velocity: to the right and up, m/s.
    pub velocity: [f64; 2],
    /// Angular velocity, rad/s.
    pub omega: f64,
}

/// A strip, its start, and the effects on it.
///
/// ```
/// use spinning_bodies::falling_strip::{AddedMass, Coefficients, RotationalDamping, Sheet};
/// use spinning_bodies::scene::{Request, Scene, Strip, StripStart, effects::Gravity};
///
/// let start = StripStart { angle: 0.2, ..StripStart::default() };
/// let strip = Strip::new(Sheet::of_paper(0.02)?.plate()?, start)?.with(Gravity::new(9.81)?)?;
/// let Coefficients { lift, drag, .. } = Coefficients::PAPER;
/// let damping = RotationalDamping { linear: 3.2263, quadratic: 0.04 };
/// let in_air = strip.with(lift)?.with(drag)?.with(damping)?.with(AddedMass { factor: 1.0 })?;
/// let motion = in_air.simulate(&Request::at([1.0])?.to_accuracy(1e-9)?)?;
/// assert!(motion.rows[0].1.omega.abs() > 30.0, "it tumbles");
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// | effect | if absent |
/// |---|---|
/// | [`Gravity`](super::effects::Gravity) | it floats |
/// | [`Lift`](super::effects::Lift) by circulation | no force across the velocity |
/// | [`Drag`](super::effects::Drag) | no force against the velocity |
/// | [`RotationalDamping`](super::effects::RotationalDamping) | its rotation is not braked |
/// | [`AddedMass`](super::effects::AddedMass) | it moves no fluid along, and no torque of the fluid turns it broadside |
///
/// Without the last four the strip is in a vacuum, and its parabola and uniform rotation are a closed form. A scene with drag or damping cannot be run
/// backward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    equations: Equations,
    start: StripStart,
}

impl Strip {
    /// A strip without effects.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// use spinning_bodies::scene::{Request, Scene, Strip, StripStart};
    /// // Without an effect it flies straight on.
    /// let start = StripStart { velocity: [1.0, 0.5], ..StripStart::default() };
    /// let motion = Strip::new(Sheet::of_paper(0.02)?.plate()?, start)?.simulate(&Request::at([2.0])?)?;
    /// assert!((motion.rows[0].1.vx - 1.0).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(plate: Plate, start: StripStart) -> Result<Self> {
        each_finite("the velocity at the start", start.velocity)?;
        let what = "the angle at the start";
        within(what, start.angle, -MOST_TURNED, MOST_TURNED)?;
        finite("the angular velocity at the start", start.omega)?;
        let equations = Equations::new(plate);
        Ok(Self { equations, start })
    }

    /// Adds an effect of the table at [`Strip`].
    ///
    /// # Errors
    /// [`Error::Effect`](crate::Error::Effect) for any other; [`Error::NotFinite`](crate::Error::NotFinite);
    /// [`Error::Negative`](crate::Error::Negative) for a resistance that would drive.
    ///
    /// ```
    /// use spinning_bodies::falling_strip::Sheet;
    /// use spinning_bodies::scene::{Request, Scene, Strip, StripStart, effects::Gravity};
    /// let strip = Strip::new(Sheet::of_paper(0.02)?.plate()?, StripStart::default())?.with(Gravity::new(10.0)?)?;
    /// let motion = strip.simulate(&Request::at([0.5])?)?;
    /// assert!((motion.rows[0].1.vy + 5.0).abs() < 1e-9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        let equations = &mut self.equations;
        let takes = "gravity, lift, drag, rotational_damping, added_mass";
        match effect.into() {
            Effect::Gravity(gravity) => equations.gravity = Some(gravity.value()),
            Effect::Lift(lift) => equations.lift = Some(lift),
            Effect::Drag(drag) => equations.drag = Some(drag),
            Effect::RotationalDamping(damping) => equations.damping = Some(damping),
            Effect::AddedMass(added) => equations.added_mass = Some(added),
            other => return Err(other.refused("a strip", takes)),
        }
        self.equations = self.equations.checked()?;
        Ok(self)
    }

    fn brakes(&self) -> bool {
        self.equations.drag.is_some() || self.equations.damping.is_some()
    }

    /// The state in the equations for this position, angle and velocity, with the spin of the start.
    fn numbers(&self, place: [f64; 2], angle: f64, velocity: [f64; 2]) -> [f64; 7] {
        let ([x, y], turn) = (place, Rotation2::new(-angle));
        let [along, across] = (turn * Vector2::from(velocity)).into();
        [x, y, angle, along, across, self.start.omega, 0.0]
    }

    /// The state in free fall.
    fn in_free_fall(&self, t: f64) -> [f64; 7] {
        let (start, g) = (&self.start, self.equations.gravity.unwrap_or(0.0));
        let [vx, vy] = start.velocity;
        let place = [vx * t, t * (vy - 0.5 * g * t)];
        self.numbers(place, start.angle + start.omega * t, [vx, vy - g * t])
    }

    fn state(&self, y: &[f64; 7]) -> StripState {
        let &[x, height, angle, u, w, omega, heat] = y;
        let [vx, vy] = (Rotation2::new(angle) * Vector2::new(u, w)).into();
        let equations = &self.equations;
        let mut energy = equations.kinetic_energy(y);
        if let Some(g) = equations.gravity {
            energy += equations.plate.mass * g * height;
        }
        StripState::of([x, height, angle, vx, vy, omega, energy, heat])
    }
}

/// The second derivative of |ω|ω jumps where the rotation reverses. The error of a step across that is the jump times the cube of the step, whatever
/// the method's order; so a phase has one sense of rotation, 1 or −1, in which |ω|ω is smooth. A phase lasts until the strip turns the other way by more
/// than the rounding error at rest: with the wrong sense kept for good, the resistance would drive.
impl Flow<7> for Strip {
    type Phase = f64;

    fn start(&self) -> Result<(f64, [f64; 7])> {
        let y = self.numbers([0.0; 2], self.start.angle, self.start.velocity);
        // A strip at rest is turned by −u w, the only torque on it; where u or w is zero, by what it becomes first.
        let [.., u, w, omega, _] = y;
        let [.., du, dw, _, _] = self.equations.rate_in(1.0, &y);
        let soon = |now: f64, rate: f64| if now == 0.0 { rate } else { now };
        let sense = soon(omega, -soon(u, du) * soon(w, dw));
        Ok((1.0_f64.copysign(sense), y))
    }

    /// Half chord a, 1 rad, a speed, a rate, an energy.
    fn scales(&self) -> [f64; 7] {
        let a = self.equations.plate.half_chord;
        let g = self.equations.gravity.unwrap_or(0.0).abs();
        let [vx, vy] = self.start.velocity;
        let speed = (g * a).sqrt() + vx.hypot(vy) + a * self.start.omega.abs();
        // A strip that nothing moves stays where it is: its scale is a speed so low that no time makes a distance of it.
        let speed = speed.max(1e-100 * a);
        let energy = (self.equations.plate.mass * speed * speed).max(f64::MIN_POSITIVE);
        [a, a, 1.0, speed, speed, speed / a, energy]
    }

    fn pace(&self) -> f64 {
        self.scales()[5]
    }

    fn rate(&self, sense: f64, _: f64, y: &[f64; 7]) -> [f64; 7] {
        self.equations.rate_in(sense, y)
    }

    fn margin(&self, sense: f64, _: f64, y: &[f64; 7]) -> Option<f64> {
        let kink = |damping: RotationalDamping| damping.quadratic != 0.0;
        let bends = self.equations.damping.is_some_and(kink);
        bends.then(|| sense * y[5] + AT_REST * self.scales()[5])
    }

    fn next(&self, _: f64, _: Stop, _: f64, y: &mut [f64; 7]) -> Result<f64> {
        Ok(1.0_f64.copysign(y[5]))
    }

    /// Position and energies grow with the square of the time; the total energy, a difference of two of them, does not.
    fn rounding(&self, angle: f64, _: usize) -> f64 {
        OF_CLOSED_FORMS * (1.0 + angle) + ROUNDING * angle * angle
    }

    fn distance(&self, (_, a): &(f64, [f64; 7]), (_, b): &(f64, [f64; 7])) -> f64 {
        let [length, _, _, speed, _, rate, energy] = self.scales();
        let [a, b] = [a, b].map(|y| self.state(y));
        let apart = |a: [f64; 2], b: [f64; 2], scale: f64| {
            (a[0] - b[0]).hypot(a[1] - b[1]) / scale.max(b[0].hypot(b[1]))
        };
        let alone = |a: f64, b: f64, scale: f64| (a - b).abs() / scale.max(b.abs());
        // Three times the distance: a tumbling strip amplifies, and two runs may err together. Of 2000 motions in air, five are off by more than the estimate.
        3.0 * [
            apart([a.x, a.y], [b.x, b.y], length),
            (a.angle - b.angle).abs(),
            apart([a.vx, a.vy], [b.vx, b.vy], speed),
            alone(a.omega, b.omega, rate),
            alone(a.energy, b.energy, energy),
            alone(a.heat, b.heat, energy),
        ]
        .into_iter()
        .fold(0.0, greater)
    }
}

/// Rates below this, in units of the scale, may have either sign: their square is less than rounding. Compared starts differ by less.
const AT_REST: f64 = 1e-9;

impl Scene for Strip {
    type State = StripState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        if self.brakes() {
            request.forward()?;
        }
        let equations = &self.equations;
        let plan = match (self.brakes(), equations.lift, equations.added_mass) {
            (false, None, None) => Plan::exact("a vacuum: closed form"),
            _ => Plan::stepped("forces of a fluid: order 8"),
        };
        let solvers = "the solver of a strip is `exact` in a vacuum, or one that steps";
        planned(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<StripState>> {
        let plan = self.plan(request)?;
        let known = |t| Ok(self.in_free_fall(t));
        let trace = solved((self, &plan, request), 1, &known)?;
        let (equations, times) = (&self.equations, request.times());
        let [.., speed, _, _, scale] = self.scales();
        let first = self.start()?.1;
        let [px, py] = equations.impulse(&first);
        let weight = equations.plate.mass * equations.gravity.unwrap_or(0.0);
        let impulse = (weight * request.furthest).abs().max(scale / speed);
        let opening = self.state(&first).energy;
        let numbers = |k: usize| &trace.samples[k].1;
        let across = |k: usize, _: &_| equations.impulse(numbers(k))[0];
        let up = |k: usize, _: &_| equations.impulse(numbers(k))[1] + weight * times[k];
        let mut ledger = trace.told(request, plan, |_, _, y| self.state(y));
        let energy = ledger.greatest(scale, |k, s| equations.kinetic_energy(numbers(k)) + s.heat);
        ledger.conserved("energy and heat", energy, opening, |_, s| s.energy + s.heat)?;
        if self.brakes() {
            ledger.keep(("heat", Law::NonDecreasing, energy), 0.0, |_, s| s.heat)?;
        }
        // Without lift and drag only the weight changes the momentum of plate and fluid.
        if equations.lift.is_none() && equations.drag.is_none() {
            let vertical = "vertical impulse and that of the weight";
            ledger.conserved("horizontal impulse", impulse, px, across)?;
            ledger.conserved(vertical, impulse, py, up)?;
        }
        ledger.closed(request)
    }

    fn further(&self) -> Columns<StripState> {
        let equations = &self.equations;
        let weight = equations.plate.mass * equations.gravity.unwrap_or(0.0);
        let moment = equations.plate.moment();
        columns! { |state: &StripState|
            "speed", "m/s", "size of the velocity" => state.vx.hypot(state.vy);
            "descent", "rad", "direction of the velocity, downward from the right, −π … π" => (-state.vy).atan2(state.vx);
            "potential", "J/m", "energy of the weight above the start" => weight * state.y;
            "l", "kg m/s", "angular momentum of the strip alone about its axis, a metre of its length" => moment * state.omega;
        }
    }
}
