//! Roller, sheet and spool: under dry friction every velocity is linear in time from one event to the next.

use super::super::number::Angle;
use super::super::random::Random;
use super::{Scene, Sort, line, told};
use support::double_double::Dd;

/// Forces per mass: a steady push and its moment, the table's reaction, friction when it slides and at most when it holds, and the arm of the
/// resistance to rolling; friction and resistance are there or not.
#[derive(Clone)]
struct Table {
    kappa: Dd,
    push: Dd,
    twist: Dd,
    reaction: Dd,
    friction: Option<[Dd; 2]>,
    resistance: Option<Dd>,
    sheet: Option<Sheet>,
}

#[derive(Clone)]
struct Sheet {
    friction: Dd,
    /// Times and speeds.
    speeds: Vec<[Dd; 2]>,
    margin: Dd,
}

#[derive(Clone, Copy, Default)]
struct State {
    x: Dd,
    v: Dd,
    rim: Dd,
    slip: Dd,
    turned: Dd,
    heat: Dd,
    work: Dd,
}

/// Friction f and couple m, and whether each of slip and turning is held at zero.
struct Forces {
    f: Dd,
    m: Dd,
    holds: bool,
    stands: bool,
}

impl Table {
    /// Nothing but the table's reaction.
    fn level(kappa: Dd, gravity: f64) -> Self {
        Self {
            kappa,
            push: Dd::ZERO,
            twist: Dd::ZERO,
            reaction: Dd::from(gravity),
            friction: None,
            resistance: None,
            sheet: None,
        }
    }

    /// What dry friction and resistance do: where slip or turning is nil they do what keeps it so, if they can.
    fn forces(&self, state: &State, ground: Dd, friction: Option<[Dd; 2]>) -> Forces {
        let zero = Dd::ZERO;
        let (p, q, n) = (self.push, self.twist, self.reaction);
        let sign = |x: Dd| Dd::from(x.hi.signum());
        let small = |x: Dd, most: Dd| x.abs() <= most;
        let forces = |f, m, holds, stands| Forces {
            f,
            m,
            holds,
            stands,
        };
        let moving = |f: Dd, m: Dd, holds: bool| forces(f, m, holds, false);
        let free = |f: Dd, m: Dd| moving(f, m, false);
        let standing = |f: Dd, holds: bool| forces(f, f - q, holds, true);
        let rest = self.resistance.map_or(zero, |arm| arm * n);
        let [kinetic, grip] = friction.map_or([zero; 2], |pair| pair.map(|mu| mu * n));
        // What friction must be so that the contact does not begin to slip, under this couple.
        let rolls = |m: Dd| (self.kappa * (ground - p) + q + m) / (1.0 + self.kappa);
        let slides = state.slip != zero;
        let turns = state.rim != zero;
        let couple = if turns { -sign(state.rim) * rest } else { zero };
        let rubbed = if slides {
            -sign(state.slip) * kinetic
        } else {
            zero
        };
        let (glides, spins) = (friction.is_none(), self.resistance.is_none());
        match (slides || glides, turns || spins) {
            (true, true) => free(rubbed, couple),
            (true, false) if small(rubbed - q, rest) => standing(rubbed, false),
            (true, false) => free(rubbed, sign(rubbed - q) * rest),
            (false, true) => {
                let f = rolls(couple);
                if small(f, grip) {
                    moving(f, couple, true)
                } else {
                    free(sign(f) * kinetic, couple)
                }
            }
            (false, false) => {
                let f = ground - p;
                if small(f, grip) && small(f - q, rest) {
                    return standing(f, true);
                }
                for way in [1.0, -1.0] {
                    let m = -way * rest;
                    let f = rolls(m);
                    let begins = (q + m - f).hi * way;
                    if small(f, grip) && begins > 0.0 {
                        return moving(f, m, true);
                    }
                }
                for way in [1.0, -1.0] {
                    let f = way * kinetic;
                    if small(f - q, rest) && (p + f - ground).hi * way < 0.0 {
                        return standing(f, false);
                    }
                    for other in [1.0, -1.0] {
                        let m = -other * rest;
                        let spun = (q + m - f) / self.kappa;
                        if spun.hi * other > 0.0 && (p + f - spun - ground).hi * way < 0.0 {
                            return free(f, m);
                        }
                    }
                }
                unreachable!("friction and resistance do something");
            }
        }
    }

    fn rows(&self, mut state: State, times: &[f64]) -> Vec<State> {
        let mut rows = Vec::new();
        let mut now = Dd::ZERO;
        let (mut on_sheet, mut margin) = (self.sheet.is_some(), Dd::ZERO);
        if let Some(sheet) = &self.sheet {
            margin = sheet.margin;
            state.slip -= sheet.speeds[0][1];
        }
        let mut leg = 0;
        while rows.len() < times.len() {
            // Speed and acceleration of the sheet, and until when.
            let (mut speed, mut ground, mut ends) = (Dd::ZERO, Dd::ZERO, None);
            if let Some(sheet) = &self.sheet {
                let from = sheet.speeds[leg];
                speed = from[1];
                if let Some(to) = sheet.speeds.get(leg + 1) {
                    ground = (to[1] - from[1]) / (to[0] - from[0]);
                    speed += ground * (now - from[0]);
                    ends = Some(to[0] - now);
                }
            }
            let (cloth, pull) = (speed, ground);
            if !on_sheet {
                (speed, ground) = (Dd::ZERO, Dd::ZERO);
            }
            let law = match &self.sheet {
                Some(sheet) if on_sheet => Some([sheet.friction; 2]),
                _ => self.friction,
            };
            let does = self.forces(&state, ground, law);
            let Forces {
                f,
                m,
                holds,
                stands,
            } = does;
            let v_rate = self.push + f;
            let rim_rate = match (stands, holds) {
                (true, _) => Dd::ZERO,
                (_, true) => v_rate - ground,
                _ => (self.twist + m - f) / self.kappa,
            };
            let slip_rate = v_rate - rim_rate - ground;
            let slip_rate = if holds { Dd::ZERO } else { slip_rate };
            // What comes next.
            let mut wait: Option<(Dd, u8)> = ends.map(|t| (t, 0));
            let mut sooner = |t: Dd, what: u8| {
                if t.value() >= 0.0 && wait.is_none_or(|(w, _)| t < w) {
                    wait = Some((t, what));
                }
            };
            if law.is_some() && state.slip.hi * slip_rate.hi < 0.0 {
                sooner(-state.slip / slip_rate, 1);
            }
            if self.resistance.is_some() && state.rim.hi * rim_rate.hi < 0.0 {
                sooner(-state.rim / rim_rate, 2);
            }
            if self.sheet.is_some() {
                let (drift, bend) = (state.v - cloth, v_rate - pull);
                let sense = if on_sheet { 1.0 } else { -1.0 };
                let [a, b, c] = [margin, drift, bend].map(|x| x * sense);
                if let Some(t) = falls(a, b, c) {
                    sooner(t, 3);
                }
            }
            let at = |t: Dd| {
                let way = t * (state.v + 0.5 * t * v_rate);
                let turn = t * (state.rim + 0.5 * t * rim_rate);
                let slid = t * (state.slip + 0.5 * t * slip_rate);
                State {
                    x: state.x + way,
                    v: state.v + t * v_rate,
                    rim: state.rim + t * rim_rate,
                    slip: state.slip + t * slip_rate,
                    turned: state.turned + turn,
                    heat: state.heat - f * slid - m * turn,
                    work: state.work + self.push * way + self.twist * turn,
                }
            };
            while let Some(&t) = times.get(rows.len()) {
                let t = Dd::from(t) - now;
                if wait.is_some_and(|(w, _)| t > w) {
                    break;
                }
                rows.push(at(t));
            }
            let Some((t, what)) = wait else { continue };
            let way = t * (state.v + 0.5 * t * v_rate) - t * (cloth + 0.5 * t * pull);
            margin += way;
            let speed = speed + t * ground;
            let cloth = cloth + t * pull;
            state = at(t);
            now += t;
            if stands {
                state.rim = Dd::ZERO;
            }
            if holds {
                state.slip = Dd::ZERO;
            }
            match what {
                0 => leg += 1,
                1 => {
                    state.slip = Dd::ZERO;
                    state.rim = if stands { Dd::ZERO } else { state.v - speed };
                }
                2 => {
                    state.rim = Dd::ZERO;
                    if holds {
                        state.v = speed;
                    }
                }
                _ => {
                    (on_sheet, margin) = (!on_sheet, Dd::ZERO);
                    let ground = if on_sheet { cloth } else { Dd::ZERO };
                    state.slip = state.v - state.rim - ground;
                }
            }
        }
        rows
    }
}

/// The first time at which a + bt + ct²/2, positive or falling through zero, is below zero.
fn falls(a: Dd, b: Dd, c: Dd) -> Option<Dd> {
    if a == Dd::ZERO {
        if b.hi < 0.0 || b == Dd::ZERO && c.hi < 0.0 {
            return Some(Dd::ZERO);
        }
        return (b.hi > 0.0 && c.hi < 0.0).then(|| -2.0 * b / c);
    }
    let square = b * b - 2.0 * c * a;
    if square.hi < 0.0 {
        return None;
    }
    let root = square.sqrt();
    if b.hi < 0.0 {
        return Some(2.0 * a / (root - b));
    }
    (c.hi < 0.0).then(|| (b + root) / -c)
}

struct Body {
    mass: f64,
    radius: f64,
    kappa: f64,
    gravity: f64,
}

/// I/MR²: a ball's, or any.
pub fn inertia_factor(r: &mut Random) -> f64 {
    if r.percent(40) {
        0.4
    } else {
        r.within(0.05, 1.0)
    }
}

fn body(r: &mut Random) -> Body {
    Body {
        mass: r.scaled(1e-2, 10.0),
        radius: r.scaled(1e-2, 1.0),
        kappa: inertia_factor(r),
        gravity: r.scaled(1.0, 20.0),
    }
}

/// The radius, the speed, and the energy that goes with it.
fn sizes(body: &Body, fast: f64) -> Vec<(Sort, f64)> {
    vec![
        (Sort::Length, body.radius),
        (Sort::Speed, fast),
        (Sort::Energy, body.mass * fast * fast),
    ]
}

fn head(kind: &str, body: &Body) -> String {
    let (mass, radius, kappa) = (body.mass, body.radius, body.kappa);
    format!(
        "kind = \"{kind}\"\n[body]\nmass = {mass:?}\nradius = {radius:?}\ninertia_factor = {kappa:?}\n"
    )
}

/// Friction, perhaps with more of it at rest, and resistance: lines of the file, and numbers.
fn rubbing(r: &mut Random, text: &mut String, always: bool) -> (Option<[Dd; 2]>, Option<Dd>) {
    let friction = (always || r.percent(85)).then(|| {
        let kinetic = r.scaled(0.02, 0.8);
        line(text, "friction", Some(kinetic));
        let grip = r.percent(40).then(|| kinetic * r.within(1.0, 1.6));
        line(text, "static_friction", grip);
        [kinetic, grip.unwrap_or(kinetic)].map(Dd::from)
    });
    let resistance = r.percent(50).then(|| r.scaled(1e-3, 5e-2));
    line(text, "rolling_resistance", resistance);
    (friction, resistance.map(Dd::from))
}

const COLUMNS: &str = "length x, speed velocity rim_speed slip, energy energy heat";

fn row(state: &State, mass: f64, kappa: Dd) -> Vec<Dd> {
    let State {
        x, v, rim, slip, ..
    } = *state;
    let energy = (v * v + kappa * rim * rim) * mass * 0.5;
    vec![x, v, rim, slip, energy, mass * state.heat]
}

fn starting(v: Dd, rim: Dd) -> State {
    let slip = v - rim;
    State {
        v,
        rim,
        slip,
        ..State::default()
    }
}

pub fn roller(r: &mut Random) -> Scene {
    let body = body(r);
    let mut text = head("roller", &body);
    let gravity = body.gravity;
    let speed = r.scaled(0.1, 10.0);
    let cue = r.percent(40);
    let (key, other) = match cue {
        true => ("cue_height", r.within(0.0, 2.0)),
        false => ("rim_speed", speed * r.within(-2.0, 2.0)),
    };
    text += &format!(
        "[initial]\nvelocity = {speed:?}\n{key} = {other:?}\n[effects]\ngravity = {gravity:?}\n"
    );
    let (friction, resistance) = rubbing(r, &mut text, false);
    let kappa = Dd::from(body.kappa);
    let table = Table {
        friction,
        resistance,
        ..Table::level(kappa, gravity)
    };
    let mass = body.mass;
    Scene {
        text,
        span: speed / gravity * r.scaled(0.1, 100.0),
        start: vec![(speed, speed), (other, if cue { 1.0 } else { speed })],
        sizes: sizes(&body, speed),
        columns: told(COLUMNS),
        truth: Box::new(move |start, times| {
            let (v, rim) = (start[0], start[1]);
            let rim = if cue { (rim - 1.0) / kappa * v } else { rim };
            let rows = table.rows(starting(v, rim), times);
            rows.iter().map(|state| row(state, mass, kappa)).collect()
        }),
    }
}

/// A speed, and a start with such speeds so many times in a hundred, otherwise at rest: lines of the file, and numbers.
fn rolled(
    r: &mut Random,
    moving: u64,
    [least, greatest]: [f64; 2],
    part: f64,
    (gravity, text): (f64, &mut String),
) -> (f64, [f64; 2]) {
    let moves = r.percent(moving);
    let fast = r.scaled(least, greatest);
    let speeds = [0; 2].map(|_| {
        if moves {
            fast * r.within(-part, part)
        } else {
            0.0
        }
    });
    let [v, rim] = speeds;
    *text += &format!(
        "[initial]\nvelocity = {v:?}\nrim_speed = {rim:?}\n[effects]\ngravity = {gravity:?}\n"
    );
    (fast, speeds)
}

pub fn sheet(r: &mut Random) -> Scene {
    let body = body(r);
    let mut text = head("roller", &body);
    let gravity = body.gravity;
    let speeds = [0.3, 5.0];
    let (fast, [v, rim]) = rolled(r, 30, speeds, 0.5, (gravity, &mut text));
    let (friction, resistance) = rubbing(r, &mut text, true);
    let mu = r.scaled(0.05, 0.8);
    let count = 2 + r.whole(3);
    let moves = [v, rim] != [0.0; 2];
    let first = if moves {
        fast * r.within(-1.0, 1.0)
    } else {
        0.0
    };
    let (mut times, mut speeds) = (vec![0.0], vec![first]);
    for _ in 1..count {
        let last = times[times.len() - 1];
        times.push(last + fast / gravity * r.scaled(0.05, 3.0));
        speeds.push(fast * r.within(-1.0, 2.0));
    }
    let margin = fast * fast / gravity * r.scaled(0.01, 10.0);
    text += &format!(
        "sheet_friction = {mu:?}\nsheet_times = {times:?}\nsheet_speeds = {speeds:?}\nsheet_margin = {margin:?}\n"
    );
    let kappa = Dd::from(body.kappa);
    let speeds = times
        .iter()
        .zip(&speeds)
        .map(|(&t, &v)| [t, v].map(Dd::from));
    let sheet = Sheet {
        friction: Dd::from(mu),
        speeds: speeds.collect(),
        margin: Dd::from(margin),
    };
    let table = Table {
        friction,
        resistance,
        sheet: Some(sheet),
        ..Table::level(kappa, gravity)
    };
    let mass = body.mass;
    Scene {
        text,
        span: fast / gravity * r.scaled(0.1, 30.0),
        start: vec![(v, fast), (rim, fast)],
        sizes: sizes(&body, fast),
        columns: told(COLUMNS),
        truth: Box::new(move |start, times| {
            let rows = table.rows(starting(start[0], start[1]), times);
            rows.iter().map(|state| row(state, mass, kappa)).collect()
        }),
    }
}

pub fn spool(r: &mut Random) -> Scene {
    let body = body(r);
    let mut text = head("spool", &body);
    let gravity = body.gravity;
    let ratio = r.within(0.05, 1.0);
    let axle = body.radius * ratio;
    text += &format!("axle = {axle:?}\n");
    let speeds = [0.1, 5.0];
    let (fast, [v, rim]) = rolled(r, 50, speeds, 1.0, (gravity, &mut text));
    let (friction, resistance) = rubbing(r, &mut text, false);
    let tug = r.percent(85).then(|| {
        let angle = r.within(0.0, core::f64::consts::PI);
        let tension = body.mass * gravity * r.scaled(1e-2, 0.9);
        text += &format!("tension = {tension:?}\ntug_angle = {angle:?}\n");
        (tension, angle)
    });
    let (kappa, mass) = (Dd::from(body.kappa), Dd::from(body.mass));
    let ratio = Dd::from(axle) / Dd::from(body.radius);
    let (mut push, mut twist, mut reaction) = (Dd::ZERO, Dd::ZERO, Dd::from(gravity));
    if let Some((tension, angle)) = tug {
        let (sine, cosine) = Dd::from(angle).sine_cosine();
        let pull = Dd::from(tension) / mass;
        (push, twist) = (pull * cosine, -(pull * ratio));
        reaction -= pull * sine;
    }
    let table = Table {
        push,
        twist,
        reaction,
        friction,
        resistance,
        ..Table::level(kappa, gravity)
    };
    let whole = body.mass;
    Scene {
        text,
        span: fast / gravity * r.scaled(0.1, 100.0),
        start: vec![(v, fast), (rim, fast)],
        sizes: sizes(&body, fast),
        columns: [told(COLUMNS), told("length wound, energy work")].concat(),
        truth: Box::new(move |start, times| {
            let rows = table.rows(starting(start[0], start[1]), times);
            let full = |state: &State| {
                let mut row = row(state, whole, kappa);
                row.extend([ratio * state.turned, mass * state.work]);
                row
            };
            rows.iter().map(full).collect()
        }),
    }
}
