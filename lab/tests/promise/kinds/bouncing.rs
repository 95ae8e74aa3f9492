//! The superball: parabolas between bounces.

use super::super::random::Random;
use super::rolling;
use super::{Scene, Sort, line, told};
use support::double_double::Dd;

#[derive(Clone, Copy)]
struct Ball {
    kappa: Dd,
    gravity: Dd,
    room: Option<Dd>,
    /// e_n and e_t.
    restitution: [Dd; 2],
    grip: Option<Dd>,
}

#[derive(Clone, Copy)]
struct State {
    x: Dd,
    height: Dd,
    climb: Dd,
    v: Dd,
    rim: Dd,
}

impl Ball {
    /// The time to the next contact, the speed there, and whether it is with the ceiling.
    fn contact(&self, state: &State) -> Option<(Dd, Dd, bool)> {
        let (c, h, g) = (state.climb, state.height, self.gravity);
        if let Some(room) = self.room
            && c.hi > 0.0
        {
            let square = c * c - 2.0 * g * (room - h);
            if square.hi > 0.0 {
                let speed = square.sqrt();
                return Some((2.0 * (room - h) / (c + speed), speed, true));
            }
        }
        if g == Dd::ZERO && c.hi >= 0.0 {
            return None;
        }
        let speed = (c * c + 2.0 * g * h).sqrt();
        let rises = c.hi > 0.0;
        let wait = if rises {
            (c + speed) / g
        } else {
            2.0 * h / (speed - c)
        };
        Some((wait, speed, false))
    }

    fn flown(&self, state: &State, t: Dd) -> State {
        State {
            x: state.x + t * state.v,
            height: state.height + t * state.climb - 0.5 * self.gravity * t * t,
            climb: state.climb - self.gravity * t,
            ..*state
        }
    }

    fn bounced(&self, state: &State, t: Dd, speed: Dd, ceiling: bool) -> State {
        let [normal, tangential] = self.restitution;
        let sense = Dd::from(if ceiling { -1.0 } else { 1.0 });
        // At the contact the rim runs against the velocity below, and with it above. An impulse J per mass changes V by J and sense·RΩ by −J/κ.
        let slip = state.v - sense * state.rim;
        let mut impulse = -(1.0 + tangential) * slip * self.kappa / (1.0 + self.kappa);
        if let Some(mu) = self.grip {
            let most = mu * (1.0 + normal) * speed;
            if impulse.abs() > most {
                impulse = if slip.hi > 0.0 { -most } else { most };
            }
        }
        State {
            x: state.x + t * state.v,
            height: self.room.filter(|_| ceiling).unwrap_or(Dd::ZERO),
            climb: sense * normal * speed,
            v: state.v + impulse,
            rim: state.rim - sense * impulse / self.kappa,
        }
    }

    fn rows(&self, mut state: State, times: &[f64]) -> Vec<State> {
        let mut rows = Vec::new();
        let mut now = Dd::ZERO;
        while rows.len() < times.len() {
            let next = self.contact(&state);
            while let Some(&t) = times.get(rows.len()) {
                let t = Dd::from(t) - now;
                if next.is_some_and(|(wait, ..)| t > wait) {
                    break;
                }
                rows.push(self.flown(&state, t));
            }
            if let Some((wait, speed, ceiling)) = next {
                state = self.bounced(&state, wait, speed, ceiling);
                now += wait;
            }
        }
        rows
    }

    /// When it has bounced so often, if it ever does.
    fn time_of(&self, mut state: State, bounces: usize) -> Option<f64> {
        let mut now = Dd::ZERO;
        for _ in 0..bounces {
            let (wait, speed, ceiling) = self.contact(&state)?;
            state = self.bounced(&state, wait, speed, ceiling);
            now += wait;
        }
        Some(now.value())
    }
}

pub fn thrown(r: &mut Random, losses: bool) -> Scene {
    let mass = r.scaled(1e-2, 1.0);
    let kappa = rolling::inertia_factor(r);
    let fast = r.scaled(0.5, 10.0);
    let gravity = r.percent(80).then(|| r.scaled(1.0, 20.0));
    let room = r.percent(60).then(|| r.scaled(0.1, 3.0));
    let height = room.unwrap_or(2.0) * r.within(0.0, 1.0);
    let [climb, v, rim] = [0; 3].map(|_| fast * r.within(-1.0, 1.0));
    let mut text = format!(
        "kind = \"superball\"\n[body]\nmass = {mass:?}\ninertia_factor = {kappa:?}\n[initial]\nheight = {height:?}\nclimb = {climb:?}\nvelocity = {v:?}\nrim_speed = {rim:?}\n[effects]\n"
    );
    line(&mut text, "gravity", gravity);
    line(&mut text, "ceiling", room);
    let mut ball = Ball {
        kappa: Dd::from(kappa),
        gravity: Dd::from(gravity.unwrap_or(0.0)),
        room: room.map(Dd::from),
        restitution: [Dd::from(1.0); 2],
        grip: None,
    };
    if losses {
        let which = r.whole(3);
        if which != 1 {
            let (normal, tangential) = (r.within(0.3, 1.0), r.within(-1.0, 1.0));
            text += &format!("restitution = {normal:?}\ntangential_restitution = {tangential:?}\n");
            ball.restitution = [normal, tangential].map(Dd::from);
        }
        if which != 0 {
            let grip = r.scaled(0.02, 1.0);
            line(&mut text, "grip", Some(grip));
            ball.grip = Some(Dd::from(grip));
        }
    }
    let begun = |start: &[Dd]| State {
        x: Dd::ZERO,
        height: start[0],
        climb: start[1],
        v: start[2],
        rim: start[3],
    };
    let state = begun(&[height, climb, v, rim].map(Dd::from));
    let bounces = 1 + r.whole(if losses { 25 } else { 300 });
    let span = ball.time_of(state, bounces).unwrap_or(1.0);
    Scene {
        text,
        span: span * r.within(0.9, 0.999),
        start: vec![(height, 1.0), (climb, fast), (v, fast), (rim, fast)],
        sizes: vec![
            (Sort::Length, room.unwrap_or(height)),
            (Sort::Speed, fast),
            (Sort::Energy, mass * fast * fast),
        ],
        columns: told("length x height, speed velocity climb rim_speed, energy energy"),
        truth: Box::new(move |start, times| {
            let row = |s: &State| {
                let speeds = s.v * s.v + s.climb * s.climb + ball.kappa * s.rim * s.rim;
                let energy = mass * (0.5 * speeds + ball.gravity * s.height);
                vec![s.x, s.height, s.v, s.climb, s.rim, energy]
            };
            ball.rows(begun(start), times).iter().map(row).collect()
        }),
    }
}
