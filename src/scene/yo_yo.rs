//! The scene `yo-yo` (tutorial 4.9): let go or thrown from the hand it goes down, turns, comes up, and down again; or it goes down, sleeps, wakes, and comes up.

use core::f64::consts::{FRAC_PI_2, PI};

use super::prelude::*;
use crate::yo_yo::{Turn, Unwinding, YoYo, sleeping_spin, spin_after_waking};

/// The phases of a yo-yo's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Phase {
    /// On its way down.
    Down,
    /// Turning at the end of the string.
    Turn,
    /// On its way up.
    Up,
    /// Spinning asleep in the loop.
    Asleep,
    /// At the end of the string, with too little spin to leave it.
    Hanging,
    /// Back in the hand with energy to spare, and caught.
    Caught,
}

state! {
    /// The state of a yo-yo.
    YoYoState {
        /// Depth below the hand, m.
        depth,
        /// Velocity downward, m/s.
        velocity,
        /// Spin Ω, whose sense never changes, rad/s.
        omega,
        /// Pull of the string, without the blows on falling asleep and on waking, N.
        tension,
        /// Kinetic and potential energy, zero at rest at the hand, J.
        energy,
        /// Energy lost so far, J.
        heat,
        /// Work of the hand so far, catching counted against it, J.
        work,
    }
    /// The phase.
    phase: Phase,
}

/// A yo-yo, the speed of its throw, and the effects on it.
///
/// ```
/// use spinning_bodies::scene::effects::{AirDrag, Gravity};
/// use spinning_bodies::scene::{Phase, Play, Request, Scene};
/// use spinning_bodies::yo_yo::YoYo;
///
/// let toy = YoYo::disc(0.055, 0.029, 1.0, 0.005)?;
/// let play = Play::new(toy, 0.0)?.with(Gravity::new(9.81)?)?;
/// let motion = play.simulate(&Request::at([1.9])?)?;
/// assert!((motion.rows[0].1.depth - 0.9936).abs() < 1e-4);
/// // In honey it stops on its way round the end of the string, and hangs there.
/// let in_honey = play.with(AirDrag::new(1e-5)?)?.simulate(&Request::at([60.0])?)?;
/// assert_eq!(in_honey.rows[0].1.phase, Phase::Hanging);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// | effect | if absent |
/// |---|---|
/// | [`Gravity`](super::effects::Gravity) | only the throw unwinds it |
/// | [`TurnLoss`](super::effects::TurnLoss) | every turn keeps the spin |
/// | [`Hand`](super::effects::Hand), its work at every turn | the hand holds still |
/// | [`Sleep`](super::effects::Sleep), in a loop at the end of the string | the string is tied fast: it comes up at once |
/// | [`AxleFriction`](super::effects::AxleFriction) in the loop | it sleeps without loss |
/// | [`AirDrag`](super::effects::AirDrag) | no drag; with it there are no closed forms |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Play {
    toy: YoYo,
    throw: f64,
    gravity: f64,
    turn_loss: Option<f64>,
    hand: Option<f64>,
    sleep: Option<f64>,
    axle_friction: Option<f64>,
    air_drag: Option<f64>,
}

impl Play {
    /// A yo-yo thrown from the hand with this speed (m/s; 0: let go).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`].
    ///
    /// ```
    /// use spinning_bodies::{scene::{Play, Request, Scene}, yo_yo::YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?;
    /// // Without gravity, thrown at 1 m/s: so far in half a second.
    /// let motion = Play::new(toy, 1.0)?.simulate(&Request::at([0.5])?)?;
    /// assert!((motion.rows[0].1.depth - 0.5).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(toy: YoYo, throw: f64) -> Result<Self> {
        Ok(Self {
            toy,
            throw: not_negative("the speed of the throw", throw)?,
            gravity: 0.0,
            turn_loss: None,
            hand: None,
            sleep: None,
            axle_friction: None,
            air_drag: None,
        })
    }

    /// Adds an effect of the table at [`Play`].
    ///
    /// # Errors
    /// [`Error::Effect`] for any other; [`Error::NotPositive`] for a gravity that does not pull down.
    ///
    /// ```
    /// use spinning_bodies::{scene::{Play, Request, Scene, effects::Gravity}, yo_yo::YoYo};
    /// let toy = YoYo::new(1.0, 3e-4, 1.0, 0.01)?; // I = 3mr²
    /// let motion = Play::new(toy, 0.0)?.with(Gravity::new(8.0)?)?.simulate(&Request::at([0.5])?)?;
    /// assert!((motion.rows[0].1.depth - 0.25).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with(mut self, effect: impl Into<Effect>) -> Result<Self> {
        let takes = "gravity, turn_loss, hand, sleep, axle_friction, air_drag";
        match effect.into() {
            Effect::Gravity(gravity) => self.gravity = positive("gravity", gravity.value())?,
            Effect::TurnLoss(loss) => self.turn_loss = Some(loss.value()),
            Effect::Hand(hand) => self.hand = Some(hand.value()),
            Effect::Sleep(sleep) => self.sleep = Some(sleep.value()),
            Effect::AxleFriction(friction) => self.axle_friction = Some(friction.value()),
            Effect::AirDrag(drag) => self.air_drag = Some(drag.value()),
            other => return Err(other.refused("a yo-yo", takes)),
        }
        Ok(self)
    }
}

/// A yo-yo as a flow.
#[derive(Clone, Copy)]
struct Playing {
    play: Play,
    /// Energy at the start, J.
    energy: f64,
    /// Whether closed forms are used.
    closed: bool,
}

/// The phase, and the angle at which the turn ends, rad: π/2 if the yo-yo then falls asleep, π otherwise.
type Stage = (Phase, f64);

/// Depth as a fraction of the string's length, or the angle of the turn; spin; energy, heat, work of the hand; and the correction to be added to the
/// run's clock for the time at which the phase began.
type Numbers = [f64; 6];

const ENERGY: usize = 2;
const HEAT: usize = 3;
const WORK: usize = 4;
const LATER: usize = 5;

/// Relative error of the time of an event.
const OF_A_TIME: f64 = 4e-16;

/// Enters the turn at the angle `from`, to end at `to`.
fn turns(y: &mut Numbers, from: f64, to: f64) -> Stage {
    y[0] = from;
    (Phase::Turn, to)
}

/// Converts this much energy into heat.
fn lose(y: &mut Numbers, lost: f64) {
    y[ENERGY] -= lost;
    y[HEAT] += lost;
}

/// The passage of a phase of this duration, s; `at` gives the state a time after its beginning.
fn lasting(duration: f64, ahead: &Ahead<'_, 6>, at: &dyn Fn(f64) -> Result<Numbers>) -> Passed<6> {
    let (from, y) = ahead.start;
    let since = |t: f64| ((t - from) - y[LATER]).clamp(0.0, duration);
    let rest = y[LATER] + duration;
    let time = from + rest;
    let ends = (time < ahead.end).then_some(time);
    let mut passage = ahead.in_closed_form(ends, &|t| at(since(t)))?;
    if ends.is_some() {
        passage.end = at(duration)?;
        // The rounding error of adding the duration to the time.
        passage.end[LATER] = (from - time) + rest;
    }
    Ok(passage)
}

impl Playing {
    /// I + m r² about the end of the string, with r the axle's radius, kg m².
    fn inertia(&self) -> f64 {
        let toy = &self.play.toy;
        toy.inertia + toy.mass * toy.axle * toy.axle
    }

    /// The greatest energy above that of rest at the end of the string, J, and the spin that has this energy there.
    fn greatest(&self) -> (f64, f64) {
        let toy = &self.play.toy;
        let fall = toy.mass * self.play.gravity * toy.length;
        let energy = fall + self.energy + self.play.hand.unwrap_or(0.0);
        let energy = energy.max(f64::MIN_POSITIVE);
        (energy, (2.0 * energy / self.inertia()).sqrt())
    }

    /// Ends the motion at rest at the lowest point, with m g (l + r) lost.
    fn hangs(&self, y: &mut Numbers) -> Stage {
        let toy = &self.play.toy;
        let bottom = -toy.mass * self.play.gravity * (toy.length + toy.axle);
        lose(y, y[ENERGY] - bottom);
        y[1] = 0.0;
        (Phase::Hanging, 0.0)
    }

    /// Ends the turn, with its loss and the work of the hand.
    fn turned(&self, y: &mut Numbers) -> Stage {
        let toy = &self.play.toy;
        if let Some(left) = self.play.turn_loss {
            let kinetic = toy.kinetic_energy(toy.length, y[1]);
            lose(y, (1.0 - left) * (1.0 + left) * kinetic);
            y[1] *= left;
        }
        if let Some(work) = self.play.hand {
            y[ENERGY] += work;
            y[WORK] += work;
            y[1] = (y[1] * y[1] + 2.0 * work / self.inertia()).sqrt();
        }
        // The condition of `Unwinding::new`: energy enough to leave the end of the string.
        if y[1] > 0.0 && y[ENERGY] > -toy.mass * self.play.gravity * toy.length {
            y[0] = 1.0;
            (Phase::Up, 0.0)
        } else {
            self.hangs(y)
        }
    }

    /// The passage of a phase in closed form.
    fn passage(&self, stage: Stage, ahead: &Ahead<'_, 6>) -> Passed<6> {
        let (toy, g, (phase, end), y) = (self.play.toy, self.play.gravity, stage, *ahead.start.1);
        let omega = y[1];
        let now = |place: f64, omega: f64| {
            let mut now = y;
            (now[0], now[1]) = (place, omega);
            now
        };
        match phase {
            Phase::Down | Phase::Up => {
                let way = Unwinding::new(toy, g, y[ENERGY])?;
                let duration = way.duration()?;
                lasting(duration, ahead, &|t| {
                    let t = if phase == Phase::Up { duration - t } else { t };
                    let [depth, omega] = way.at(t)?;
                    Ok(now(depth / toy.length, omega))
                })
            }
            Phase::Turn => {
                // The turn after a sleep begins at the lowest point, half-way.
                let (level, begun) = match y[0] > 0.0 {
                    true => ((omega * omega - 2.0 * toy.pull(g)).sqrt(), 0.5),
                    false => (omega, 0.0),
                };
                let turn = Turn::new(toy, g, level)?;
                let done = if end < PI { 0.5 } else { 1.0 };
                let [from, to] = [begun, done].map(|part| part * turn.duration);
                lasting(to - from, ahead, &|t| {
                    let state = turn.at(from + t)?;
                    Ok(now(state.angle, state.omega))
                })
            }
            Phase::Asleep => {
                let torque = self.play.axle_friction;
                let stops = torque.map_or(f64::INFINITY, |torque| toy.inertia * omega / torque);
                let duration = self.play.sleep.unwrap_or(0.0).min(stops);
                lasting(duration, ahead, &|t| {
                    let left = torque.map(|torque| sleeping_spin(&toy, omega, t, torque));
                    let left = left.unwrap_or(omega);
                    let lost = 0.5 * toy.inertia * ((omega - left) * (omega + left));
                    let mut now = now(0.0, left);
                    lose(&mut now, lost);
                    Ok(now)
                })
            }
            Phase::Hanging | Phase::Caught => lasting(f64::INFINITY, ahead, &|_| Ok(now(0.0, 0.0))),
        }
    }

    /// The numbers of a [`YoYoState`].
    fn told(&self, stage: Stage, y: &Numbers) -> [f64; 7] {
        let toy = &self.play.toy;
        let (m, g, l, r) = (toy.mass, self.play.gravity, toy.length, toy.axle);
        let ([place, omega, _, heat, work, _], [_, spin_up, ..]) = (*y, self.rate(stage, 0.0, y));
        let (depth, velocity, tension) = match stage.0 {
            Phase::Down | Phase::Up => {
                let depth = place * l;
                let radius = toy.radius(depth);
                let sense = if stage.0 == Phase::Up { -1.0 } else { 1.0 };
                let mut tension = toy.tension(depth, omega, g);
                if let Some(air) = self.play.air_drag {
                    // The drag on the spin also slows the centre, by the string: this is the centre's share of it.
                    let share = m * radius / (toy.inertia + m * radius * radius);
                    tension += sense * air * omega * omega * share;
                }
                (depth, sense * radius * omega, tension)
            }
            Phase::Turn => {
                let (sine, cosine) = place.sin_cos();
                let up = r * (omega * omega * sine - spin_up * cosine);
                (l + r * sine, r * omega * cosine, m * (g + up))
            }
            Phase::Asleep | Phase::Hanging => (l + r, 0.0, m * g),
            Phase::Caught => (0.0, 0.0, 0.0),
        };
        let kinetic = match stage.0 {
            Phase::Asleep => 0.5 * toy.inertia * omega * omega,
            _ => toy.kinetic_energy(depth, omega),
        };
        let energy = kinetic - m * g * depth;
        [depth, velocity, omega, tension, energy, heat, work]
    }
}

impl Flow<6> for Playing {
    type Phase = Stage;

    fn start(&self) -> Result<(Stage, Numbers)> {
        let spin = self.play.throw / self.play.toy.radius(0.0);
        let moves = self.energy > 0.0 || self.play.gravity > 0.0;
        // Without throw and gravity it stays in the hand.
        let phase = if moves { Phase::Down } else { Phase::Caught };
        Ok(((phase, 0.0), [0.0, spin, self.energy, 0.0, 0.0, 0.0]))
    }

    fn scales(&self) -> Numbers {
        let (energy, fastest) = self.greatest();
        [1.0, fastest, energy, energy, energy, 1.0]
    }

    /// The pace at which the way down, at half the greatest speed, counts as an angle of π; the spin is faster but steady.
    fn pace(&self) -> f64 {
        let toy = &self.play.toy;
        FRAC_PI_2 * self.greatest().1 * toy.radius(0.0) / toy.length
    }

    fn rate(&self, (phase, _): Stage, _: f64, y: &Numbers) -> Numbers {
        let toy = &self.play.toy;
        let ([place, omega, ..], m, g, r) = (*y, toy.mass, self.play.gravity, toy.axle);
        let (along, torque, inertia) = match phase {
            Phase::Down | Phase::Up => {
                let sense = if phase == Phase::Up { -1.0 } else { 1.0 };
                let square = toy.radius_squared(place * toy.length);
                let radius = square.sqrt();
                let pull = g + 0.5 * toy.slope * omega * omega;
                let along = sense * radius * omega / toy.length;
                let inertia = toy.inertia + m * square;
                (along, sense * m * radius * pull, inertia)
            }
            Phase::Turn => (omega, m * g * r * place.cos(), self.inertia()),
            Phase::Asleep => (0.0, 0.0, toy.inertia),
            Phase::Hanging | Phase::Caught => return [0.0; 6],
        };
        // ω is not negative. Its sign is not taken, for a kink at zero, where phases end, would spoil the steps that try beyond.
        let mut brake = 0.0;
        if let Some(air) = self.play.air_drag {
            brake += air * omega * omega;
        }
        if let (Phase::Asleep, Some(friction)) = (phase, self.play.axle_friction) {
            brake += friction;
        }
        let heating = brake * omega;
        let spin_up = (torque - brake) / inertia;
        [along, spin_up, -heating, heating, 0.0, 0.0]
    }

    fn margin(&self, (phase, end): Stage, _: f64, y: &Numbers) -> Option<f64> {
        let spin = y[1] / self.greatest().1;
        match phase {
            Phase::Down => Some(1.0 - y[0]),
            // Without energy to spare the spin ends the way up; the depth would only graze zero.
            Phase::Up if y[ENERGY] > 0.0 => Some(y[0].min(spin)),
            Phase::Up | Phase::Asleep => Some(spin),
            // In air the spin may not carry the axle round.
            Phase::Turn => Some(spin.min(end - y[0])),
            Phase::Hanging | Phase::Caught => None,
        }
    }

    fn lasts_until(&self, (phase, _): Stage, t: f64) -> f64 {
        match (phase, self.play.sleep) {
            // With closed forms the margin ends the sleep, more exactly than the clock.
            (Phase::Asleep, Some(sleep)) if !self.closed => t + sleep,
            _ => f64::INFINITY,
        }
    }

    fn next(&self, (phase, end): Stage, _: Stop, _: f64, y: &mut Numbers) -> Result<Stage> {
        let toy = &self.play.toy;
        let twice = 2.0 * toy.pull(self.play.gravity);
        y[1] = y[1].max(0.0);
        Ok(match phase {
            // Too slow to carry the axle round the end of the string.
            Phase::Down if y[1] * y[1] <= twice => self.hangs(y),
            Phase::Down if self.play.sleep.is_some() => turns(y, 0.0, FRAC_PI_2),
            Phase::Down => turns(y, 0.0, PI),
            Phase::Turn if y[1] < self.greatest().1 * (end - y[0]) => self.hangs(y),
            Phase::Turn if end < PI => {
                // The loop slips on the axle, and the string takes the kinetic energy of the centre.
                let velocity = toy.axle * y[1];
                lose(y, 0.5 * toy.mass * velocity * velocity);
                y[0] = 0.0;
                (Phase::Asleep, 0.0)
            }
            Phase::Turn => self.turned(y),
            Phase::Asleep => {
                let awake = spin_after_waking(toy, y[1]);
                if awake * awake - twice > twice {
                    let before = 0.5 * toy.inertia * y[1] * y[1];
                    lose(y, before - 0.5 * self.inertia() * awake * awake);
                    y[1] = awake;
                    turns(y, FRAC_PI_2, PI)
                } else {
                    self.hangs(y)
                }
            }
            Phase::Up if y[ENERGY] > 0.0 => {
                y[WORK] -= y[ENERGY];
                (y[ENERGY], y[1]) = (0.0, 0.0);
                (Phase::Caught, 0.0)
            }
            Phase::Up => {
                // At rest at the depth that its energy allows.
                let depth = -y[ENERGY] / (toy.mass * self.play.gravity);
                (y[0], y[1]) = (depth / toy.length, 0.0);
                (Phase::Down, 0.0)
            }
            Phase::Hanging | Phase::Caught => (phase, 0.0),
        })
    }

    fn known(&self, stage: Stage, ahead: &Ahead<'_, 6>) -> Option<Passed<6>> {
        let rests = matches!(stage.0, Phase::Hanging | Phase::Caught);
        (!ahead.stepped || rests).then(|| self.passage(stage, ahead))
    }

    /// Every phase has an error in proportion to its own duration.
    fn rounding(&self, _: f64, phases: usize) -> f64 {
        OF_CLOSED_FORMS * (1.0 + phases as f64)
    }

    fn distance(&self, a: &(Stage, Numbers), b: &(Stage, Numbers)) -> f64 {
        let (energy, fastest) = self.greatest();
        let toy = &self.play.toy;
        let speed = toy.axle * fastest;
        let force = toy.mass * (self.play.gravity + speed * fastest);
        let scales = [toy.length, speed, fastest, force, energy, energy, energy];
        let [a, b] = [a, b].map(|(stage, y)| self.told(*stage, y));
        apart(&a, &b, &scales)
    }
}

impl Scene for Play {
    type State = YoYoState;

    fn plan(&self, request: &Request) -> Result<Plan> {
        if let Choice::Use(Solver::General(method)) = request.choice
            && !method.is_adaptive()
        {
            let condition = "the solver must choose its steps: a yo-yo falls for seconds and turns in milliseconds";
            return Err(Error::Solver { condition });
        }
        let plan = match self.air_drag {
            None => Plan::events("no air: closed forms from event to event"),
            Some(_) => Plan::stepped("resistance of the air: order 8 with events"),
        };
        let solvers =
            "the solver of a yo-yo is `events` without air, or one that chooses its steps";
        planned_forward(request, plan, solvers)
    }

    fn simulate(&self, request: &Request) -> Result<Motion<YoYoState>> {
        let plan = self.plan(request)?;
        let playing = Playing {
            play: *self,
            energy: Unwinding::energy_at(&self.toy, self.gravity, 0.0, self.throw)?,
            closed: plan.solver == Solver::Events,
        };
        let start = playing.start()?.1;
        let mut trace = solved((&playing, &plan, request), 1, &|_| Ok(start))?;
        let (scale, fastest) = playing.greatest();
        let mut stages = trace.samples.iter().map(|(stage, _)| stage);
        if playing.closed && stages.any(|stage| stage.0 == Phase::Turn) {
            // In the turn the angle changes as fast as the spin, and the time itself is rounded.
            trace.error += fastest * OF_A_TIME * request.furthest;
        }
        let state = |_, stage: &Stage, y: &_| YoYoState::of(playing.told(*stage, y), stage.0);
        let mut ledger = trace.told(request, plan, state);
        let balance = |_: usize, s: &YoYoState| s.energy + s.heat - s.work;
        let name = "energy and heat less the work of the hand";
        ledger.conserved(name, scale, playing.energy, balance)?;
        ledger.keep(("heat", Law::NonDecreasing, scale), 0.0, |_, s| s.heat)?;
        ledger.closed(request)
    }

    fn further(&self) -> Columns<YoYoState> {
        let (toy, weight) = (self.toy, self.toy.mass * self.gravity);
        let inertia = toy.inertia;
        columns! { |state: &YoYoState|
            "potential", "J", "energy of the weight below the hand" => -weight * state.depth;
            "rotation", "J", "kinetic energy about the axle" => 0.5 * inertia * state.omega.powi(2);
            "phase", "1", "0 down, 1 turning, 2 up, 3 asleep, 4 hanging, 5 caught" => f64::from(state.phase as u8);
            "l", "kg m²/s", "angular momentum about the axle" => inertia * state.omega;
        }
    }
}
