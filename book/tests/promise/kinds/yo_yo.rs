//! The yo-yo, every phase by extrapolation: with air there is no closed form, and without it none is used.

use super::super::extrapolation::{Place, followed};
use super::super::number::{Angle, PI};
use super::super::random::Random;
use super::{Scene, Sort, told};
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
    fn on_string(&self, sense: f64, [depth, spin, _]: &State) -> State {
        let (sense, half) = (Dd::from(sense), Dd::from(0.5));
        let r = self.radius_squared(*depth).sqrt();
        let pull = self.mass * r * (self.gravity + half * self.thinning * *spin * *spin);
        let drag = self.air * *spin * *spin;
        [
            sense * r * *spin,
            (sense * pull - drag) / self.about(*depth),
            drag * *spin,
        ]
    }

    fn turning(&self, [angle, spin, _]: &State) -> State {
        let drag = self.air * *spin * *spin;
        let weight = self.mass * self.gravity * self.axle * angle.sine_cosine().1;
        [
            *spin,
            (weight - drag) / self.about(self.length),
            drag * *spin,
        ]
    }

    fn asleep(&self, [_, spin, _]: &State) -> State {
        let drag = self.torque + self.air * *spin * *spin;
        [*spin, -drag / self.inertia, drag * *spin]
    }

    /// Depth, velocity, spin, energy, heat, work.
    fn rows(&self, throw: Dd, times: &[f64]) -> Vec<Vec<Dd>> {
        let (zero, half, two) = (Dd::ZERO, Dd::from(0.5), Dd::from(2.0));
        let spin = throw / self.radius_squared(zero).sqrt();
        let mut energy = half * self.about(zero) * spin * spin;
        let (g, m, l, r) = (self.gravity, self.mass, self.length, self.axle);
        let bare = self.about(l);
        let bottom = -(m * g * (l + r));
        let pull = m * g * r / bare;
        let scale = (energy + m * g * l).value();
        let fastest = (two * Dd::from(scale) / bare).sqrt().value();
        let mut phase = if energy.hi > 0.0 || g.hi > 0.0 {
            Phase::Down
        } else {
            Phase::Caught
        };
        let mut here = Place {
            time: zero,
            state: [zero, spin, zero],
        };
        let (mut heat, mut work) = (zero, zero);
        let mut rows = Vec::new();
        let end = times.last().map_or(zero, |&t| Dd::from(t)) + Dd::from(1.0);
        while rows.len() < times.len() {
            let left = &times[rows.len()..];
            let turn = Dd::from(core::f64::consts::FRAC_PI_2 / fastest).value();
            let way = (l / (r * Dd::from(fastest))).value();
            let leg = match phase {
                Phase::Down => followed(
                    |_, y| self.on_string(1.0, y),
                    here,
                    &[l.value(), fastest, scale],
                    left,
                    end,
                    way,
                    |y| l - y[0],
                ),
                Phase::Up => followed(
                    |_, y| self.on_string(-1.0, y),
                    here,
                    &[l.value(), fastest, scale],
                    left,
                    end,
                    way,
                    |y| {
                        let (depth, spin) = (y[0] / l, y[1] / Dd::from(fastest));
                        if energy.hi > 0.0 && (depth - spin).value() < 0.0 {
                            depth
                        } else {
                            spin
                        }
                    },
                ),
                Phase::Turn | Phase::IntoSleep | Phase::OutOfSleep => {
                    let whole = if phase == Phase::IntoSleep {
                        PI * half
                    } else {
                        PI
                    };
                    followed(
                        |_, y| self.turning(y),
                        here,
                        &[1.0, fastest, scale],
                        left,
                        end,
                        turn,
                        |y| whole - y[0],
                    )
                }
                Phase::Asleep => {
                    let until = here.time + self.sleep.unwrap_or(zero);
                    let mut leg = followed(
                        |_, y| self.asleep(y),
                        here,
                        &[1.0, fastest, scale],
                        left,
                        until,
                        (until - here.time).value().max(1e-30),
                        |y| y[1],
                    );
                    if leg.met {
                        // Stopped, for the rest of its sleep.
                        let spent = half * self.inertia * here.state[1] * here.state[1];
                        let still = [zero, zero, spent];
                        let within = left
                            .iter()
                            .filter(|&&t| (Dd::from(t) - until).value() <= 0.0);
                        leg.samples.resize(within.count(), still);
                        leg.end = Place {
                            time: until,
                            state: still,
                        };
                    }
                    leg.met = true;
                    leg
                }
                Phase::Hanging | Phase::Caught => {
                    let depth = if phase == Phase::Hanging { l + r } else { zero };
                    rows.extend(
                        left.iter()
                            .map(|_| vec![depth, zero, zero, -(m * g * depth), heat, work]),
                    );
                    break;
                }
            };
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
                let energy = half * whole * y[1] * y[1] - m * g * depth;
                rows.push(vec![depth, velocity, y[1], energy, heat + y[2], work]);
            }
            if !leg.met {
                break;
            }
            let [place, mut spin, lost] = leg.end.state;
            heat = heat + lost;
            energy = energy - lost;
            let turns = |spin: Dd| (spin * spin - two * pull).value() > 0.0 && spin.hi > 0.0;
            let hangs = (Phase::Hanging, bottom, l, zero);
            let next = match phase {
                Phase::Down if !turns(spin) => hangs,
                Phase::Down if self.sleep.is_some() => (Phase::IntoSleep, energy, zero, spin),
                Phase::Down => (Phase::Turn, energy, zero, spin),
                Phase::IntoSleep => {
                    let lost = half * m * r * r * spin * spin;
                    (Phase::Asleep, energy - lost, zero, spin)
                }
                Phase::Asleep => {
                    let awake = spin * self.inertia / bare;
                    let level = awake * awake - two * pull;
                    if (level - two * pull).value() > 0.0 {
                        let lost = half * self.inertia * spin * spin - half * bare * awake * awake;
                        (Phase::OutOfSleep, energy - lost, PI * half, awake)
                    } else {
                        hangs
                    }
                }
                Phase::Turn | Phase::OutOfSleep => {
                    let lost = (Dd::from(1.0) - self.turn * self.turn) * half * bare * spin * spin;
                    spin = spin * self.turn;
                    work = work + self.hand;
                    energy = energy + self.hand;
                    spin = (spin * spin + two * self.hand / bare).sqrt();
                    if spin.hi > 0.0 && (energy - lost + m * g * l).value() > 0.0 {
                        (Phase::Up, energy - lost, l, spin)
                    } else {
                        hangs
                    }
                }
                _ if energy.hi > 0.0 && spin.hi > 1e-15 * fastest => {
                    work = work - energy;
                    energy = zero;
                    (Phase::Caught, zero, zero, zero)
                }
                _ => (Phase::Down, energy, place, zero),
            };
            // What an event takes becomes heat.
            heat = heat + (energy - next.1);
            (phase, energy) = (next.0, next.1);
            here = Place {
                time: leg.end.time,
                state: [next.2, next.3, zero],
            };
        }
        rows
    }
}

fn play(r: &mut Random, air: bool) -> Scene {
    let mass = r.scaled(0.01, 1.0);
    let radius = r.scaled(0.02, 0.1);
    let inertia = mass * radius * radius * r.within(0.3, 1.0);
    let length = r.within(0.4, 1.5);
    let axle = radius * r.within(0.05, 0.5);
    let thick = r.percent(40).then(|| axle * r.within(1.05, 2.0));
    let gravity = if r.percent(92) {
        r.scaled(1.0, 20.0)
    } else {
        0.0
    };
    let throw = if gravity == 0.0 || r.percent(60) {
        r.scaled(0.1, 5.0)
    } else {
        0.0
    };
    let mut text = format!(
        "kind = \"yo-yo\"\n[body]\nmass = {mass:?}\ninertia = {inertia:?}\nlength = {length:?}\naxle = {axle:?}\n"
    );
    if let Some(wound) = thick {
        text += &format!("wound = {wound:?}\n");
    }
    text += &format!("[initial]\nthrow = {throw:?}\n[effects]\n");
    if gravity > 0.0 {
        text += &format!("gravity = {gravity:?}\n");
    }
    let mut listed = |r: &mut Random, name: &str, often: u64, least: f64, greatest: f64| {
        let value = r.percent(often).then(|| r.scaled(least, greatest));
        if let Some(value) = value {
            text += &format!("{name} = {value:?}\n");
        }
        value
    };
    let down = (2.0 * length * (1.0 + inertia / (mass * axle * axle)) / gravity.max(0.1)).sqrt();
    let fall = mass * gravity * length + 0.5 * mass * throw * throw;
    let spin = (2.0 * fall / inertia).sqrt();
    let turn = listed(r, "turn_loss", 50, 0.5, 1.0);
    let hand = listed(r, "hand", 30, 1e-2 * fall, 0.3 * fall);
    let sleep = listed(r, "sleep", 30, 0.1 * down, 3.0 * down);
    let torque = listed(
        r,
        "axle_friction",
        50,
        1e-3 * inertia * spin / down,
        0.5 * inertia * spin / down,
    );
    let drag = if air {
        listed(
            r,
            "air_drag",
            100,
            1e-5 * inertia / (spin * down),
            0.1 * inertia / (spin * down),
        )
    } else {
        None
    };
    let zero = Dd::ZERO;
    let given = |value: Option<f64>| value.map_or(zero, Dd::from);
    let thinning = thick.map_or(zero, |wound| {
        let (wound, axle) = (Dd::from(wound), Dd::from(axle));
        (wound * wound - axle * axle) / Dd::from(length)
    });
    let toy = Toy {
        mass: Dd::from(mass),
        inertia: Dd::from(inertia),
        length: Dd::from(length),
        axle: Dd::from(axle),
        thinning,
        gravity: Dd::from(gravity),
        air: given(drag),
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
        columns: told(&[
            (Sort::Length, "depth"),
            (Sort::Speed, "velocity"),
            (Sort::Rate, "omega"),
            (Sort::Energy, "energy heat work"),
        ]),
        truth: Box::new(move |start, times| toy.rows(start[0], times)),
    }
}

pub fn dry(r: &mut Random) -> Scene {
    play(r, false)
}

pub fn in_air(r: &mut Random) -> Scene {
    play(r, true)
}
