//! The yo-yo, every phase by extrapolation: with air there is no closed form, and without it none is used.

use super::super::extrapolation::{Place, followed};
use super::super::number::{Angle, PI};
use super::super::random::Random;
use super::{Scene, Sort, line, told};
use support::double_double::Dd;

#[derive(Clone, Copy)]
struct Toy {
    mass: Dd,
    inertia: Dd,
    length: Dd,
    axle: Dd,
    /// −d(r²)/dx.
    thinning: Dd,
    gravity: Dd,
    air: Dd,
    turn: Dd,
    hand: Dd,
    sleep: Option<Dd>,
    torque: Dd,
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Down,
    Up,
    Turn,
    IntoSleep,
    OutOfSleep,
    Asleep,
    Hanging,
    Caught,
}

/// Depth or angle, spin, and what has become heat in this phase.
type State = [Dd; 3];

impl Toy {
    fn radius_squared(&self, depth: Dd) -> Dd {
        self.axle * self.axle + self.thinning * (self.length - depth)
    }

    /// I + m r².
    fn about(&self, depth: Dd) -> Dd {
        self.inertia + self.mass * self.radius_squared(depth)
    }

    /// With the spin and the heat as they go on the string, down (1) or up (−1).
    fn on_string(&self, sense: f64, &[depth, spin, _]: &State) -> State {
        let r = self.radius_squared(depth).sqrt();
        let pull = self.mass * r * (self.gravity + 0.5 * self.thinning * spin * spin);
        let drag = self.air * spin * spin;
        let spun = (sense * pull - drag) / self.about(depth);
        [sense * r * spin, spun, drag * spin]
    }

    fn turning(&self, &[angle, spin, _]: &State) -> State {
        let drag = self.air * spin * spin;
        let weight = self.mass * self.gravity * self.axle * angle.sine_cosine().1;
        let spun = (weight - drag) / self.about(self.length);
        [spin, spun, drag * spin]
    }

    fn asleep(&self, &[_, spin, _]: &State) -> State {
        let drag = self.torque + self.air * spin * spin;
        [spin, -drag / self.inertia, drag * spin]
    }

    /// Depth, velocity, spin, energy, heat, work.
    fn rows(&self, throw: Dd, times: &[f64]) -> Vec<Vec<Dd>> {
        let zero = Dd::ZERO;
        let spin = throw / self.radius_squared(zero).sqrt();
        let mut energy = 0.5 * self.about(zero) * spin * spin;
        let (g, m, l, r) = (self.gravity, self.mass, self.length, self.axle);
        let bare = self.about(l);
        let bottom = -(m * g * (l + r));
        let pull = m * g * r / bare;
        let scale = (energy + m * g * l).value();
        let fastest = (2.0 * Dd::from(scale) / bare).sqrt().value();
        let moves = energy.hi > 0.0 || g.hi > 0.0;
        let mut phase = if moves { Phase::Down } else { Phase::Caught };
        let (time, state) = (zero, [zero, spin, zero]);
        let mut here = Place { time, state };
        let (mut heat, mut work) = (zero, zero);
        let mut rows = Vec::new();
        let end = times.last().map_or(zero, |&t| Dd::from(t)) + 1.0;
        while rows.len() < times.len() {
            let left = &times[rows.len()..];
            if matches!(phase, Phase::Hanging | Phase::Caught) {
                let depth = if phase == Phase::Hanging { l + r } else { zero };
                let row = vec![depth, zero, zero, -(m * g * depth), heat, work];
                rows.resize(times.len(), row);
                break;
            }
            let sleeps = here.time + self.sleep.unwrap_or(zero);
            let until = if phase == Phase::Asleep { sleeps } else { end };
            let (size, longest) = match phase {
                Phase::Down | Phase::Up => (l.value(), (l / (r * fastest)).value()),
                Phase::Asleep => (1.0, (until - here.time).value().max(1e-30)),
                _ => (1.0, core::f64::consts::FRAC_PI_2 / fastest),
            };
            let rate = |_, y: &State| match phase {
                Phase::Down => self.on_string(1.0, y),
                Phase::Up => self.on_string(-1.0, y),
                Phase::Asleep => self.asleep(y),
                _ => self.turning(y),
            };
            let event = |y: &State| match phase {
                Phase::Down => l - y[0],
                Phase::Up => {
                    let (depth, spin) = (y[0] / l, y[1] / fastest);
                    if energy.hi > 0.0 && depth < spin {
                        depth
                    } else {
                        spin
                    }
                }
                Phase::Asleep => y[1],
                _ => {
                    let end = if phase == Phase::IntoSleep { 0.5 } else { 1.0 };
                    let (left, spin) = (PI * end - y[0], y[1] / fastest);
                    if left < spin { left } else { spin }
                }
            };
            let scales = [size, fastest, scale];
            let mut leg = followed(rate, here, &scales, left, until, longest, event);
            if phase == Phase::Asleep {
                if leg.met {
                    // Stopped, for the rest of its sleep.
                    let spent = 0.5 * self.inertia * here.state[1] * here.state[1];
                    let (time, state) = (until, [zero, zero, spent]);
                    let within = left.iter().filter(|&&t| Dd::from(t) <= until);
                    leg.samples.resize(within.count(), state);
                    leg.end = Place { time, state };
                }
                leg.met = true;
            }
            for y in &leg.samples {
                let (depth, velocity, whole) = match phase {
                    Phase::Down | Phase::Up => {
                        let sense = if phase == Phase::Down { 1.0 } else { -1.0 };
                        (y[0], self.on_string(sense, y)[0], self.about(y[0]))
                    }
                    Phase::Asleep => (l + r, zero, self.inertia),
                    _ => {
                        let (sine, cosine) = y[0].sine_cosine();
                        (l + r * sine, r * y[1] * cosine, bare)
                    }
                };
                let energy = 0.5 * whole * y[1] * y[1] - m * g * depth;
                rows.push(vec![depth, velocity, y[1], energy, heat + y[2], work]);
            }
            if !leg.met {
                break;
            }
            let [place, mut spin, lost] = leg.end.state;
            heat += lost;
            energy -= lost;
            let turns = |spin: Dd| spin * spin > 2.0 * pull && spin.hi > 0.0;
            let hangs = (Phase::Hanging, bottom, l, zero);
            let next = match phase {
                Phase::Down if !turns(spin) => hangs,
                Phase::Down if self.sleep.is_some() => (Phase::IntoSleep, energy, zero, spin),
                Phase::Down => (Phase::Turn, energy, zero, spin),
                // Stopped on its way round.
                Phase::Turn | Phase::OutOfSleep if (PI - place).hi > 1e-15 => hangs,
                Phase::IntoSleep => {
                    let lost = 0.5 * m * r * r * spin * spin;
                    (Phase::Asleep, energy - lost, zero, spin)
                }
                Phase::Asleep => {
                    let awake = spin * self.inertia / bare;
                    let level = awake * awake - 2.0 * pull;
                    if level > 2.0 * pull {
                        let lost = 0.5 * self.inertia * spin * spin - 0.5 * bare * awake * awake;
                        (Phase::OutOfSleep, energy - lost, PI * 0.5, awake)
                    } else {
                        hangs
                    }
                }
                Phase::Turn | Phase::OutOfSleep => {
                    let lost = (1.0 - self.turn * self.turn) * 0.5 * bare * spin * spin;
                    spin *= self.turn;
                    work += self.hand;
                    energy += self.hand;
                    spin = (spin * spin + 2.0 * self.hand / bare).sqrt();
                    if spin.hi > 0.0 && (energy - lost + m * g * l).value() > 0.0 {
                        (Phase::Up, energy - lost, l, spin)
                    } else {
                        hangs
                    }
                }
                _ if energy.hi > 0.0 && spin.hi > 1e-15 * fastest => {
                    work -= energy;
                    energy = zero;
                    (Phase::Caught, zero, zero, zero)
                }
                _ => (Phase::Down, energy, place, zero),
            };
            // What an event takes becomes heat.
            heat += energy - next.1;
            (phase, energy) = (next.0, next.1);
            let (time, state) = (leg.end.time, [next.2, next.3, zero]);
            here = Place { time, state };
        }
        rows
    }
}

/// `air` is the part of the spin that drag would take on the way down.
pub fn play(r: &mut Random, air: Option<[f64; 2]>) -> Scene {
    let mass = r.scaled(0.01, 1.0);
    let radius = r.scaled(0.02, 0.1);
    let inertia = mass * radius * radius * r.within(0.3, 1.0);
    let length = r.within(0.4, 1.5);
    let axle = radius * r.within(0.05, 0.5);
    let thick = r.percent(40).then(|| axle * r.within(1.05, 2.0));
    let gravity = r.percent(92).then(|| r.scaled(1.0, 20.0));
    let thrown = gravity.is_none() || r.percent(60);
    let throw = if thrown { r.scaled(0.1, 5.0) } else { 0.0 };
    let mut text = format!(
        "kind = \"yo-yo\"\n[body]\nmass = {mass:?}\ninertia = {inertia:?}\nlength = {length:?}\naxle = {axle:?}\n"
    );
    line(&mut text, "wound", thick);
    text += &format!("[initial]\nthrow = {throw:?}\n[effects]\n");
    line(&mut text, "gravity", gravity);
    let gravity = gravity.unwrap_or(0.0);
    let mut listed = |r: &mut Random, name: &str, often: u64, [least, greatest]: [f64; 2]| {
        let value = r.percent(often).then(|| r.scaled(least, greatest));
        line(&mut text, name, value);
        value
    };
    let down = (2.0 * length * (1.0 + inertia / (mass * axle * axle)) / gravity.max(0.1)).sqrt();
    let fall = mass * gravity * length + 0.5 * mass * throw * throw;
    let spin = (2.0 * fall / inertia).sqrt();
    let turn = listed(r, "turn_loss", 50, [0.5, 1.0]);
    let hand = listed(r, "hand", 30, [1e-2, 0.3].map(|x| x * fall));
    let sleep = listed(r, "sleep", 30, [0.1, 3.0].map(|x| x * down));
    let braking = [1e-3, 0.5].map(|x| x * inertia * spin / down);
    let torque = listed(r, "axle_friction", 50, braking);
    let braking = |part: [f64; 2]| part.map(|x| x * inertia / (spin * down));
    let drag = air.map(|part| listed(r, "air_drag", 100, braking(part)));
    let zero = Dd::ZERO;
    let given = |value: Option<f64>| value.map_or(zero, Dd::from);
    let thinning = thick.map_or(zero, |wound| {
        let [wound, axle] = [wound, axle].map(Dd::from);
        (wound * wound - axle * axle) / length
    });
    let toy = Toy {
        mass: Dd::from(mass),
        inertia: Dd::from(inertia),
        length: Dd::from(length),
        axle: Dd::from(axle),
        thinning,
        gravity: Dd::from(gravity),
        air: given(drag.flatten()),
        turn: turn.map_or(Dd::from(1.0), Dd::from),
        hand: given(hand),
        sleep: sleep.map(Dd::from),
        torque: given(torque),
    };
    Scene {
        text,
        span: down * r.scaled(0.05, 8.0),
        start: vec![(throw, 1.0)],
        sizes: vec![
            (Sort::Length, length),
            (Sort::Speed, axle * spin),
            (Sort::Rate, spin),
            (Sort::Energy, fall),
        ],
        columns: told("length depth, speed velocity, rate omega, energy energy heat work"),
        truth: Box::new(move |start, times| toy.rows(start[0], times)),
    }
}
