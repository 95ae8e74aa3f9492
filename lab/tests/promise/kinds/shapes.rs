//! Swivel, skater, cat, paper cat and crawler.

use super::super::door::held;
use super::super::extrapolation::pieced;
use super::super::number::{Angle, PI, Vector, root};
use super::super::random::Random;
use super::{Scene, Sort, line, told};
use support::double_double::Dd;
use support::turned;

/// A stroke from 0 to 1, at rest at both ends: u³(10 − 15u + 6u²), or the same of u²; and its rate.
fn pace(late: bool, u: Dd) -> [Dd; 2] {
    let smooth = |u: Dd| {
        let left = 1.0 - u;
        let value = u * u * u * (10.0 + u * (6.0 * u - 15.0));
        [value, 30.0 * u * u * left * left]
    };
    if u.hi <= 0.0 {
        return [Dd::ZERO; 2];
    }
    if u >= Dd::from(1.0) {
        return [Dd::from(1.0), Dd::ZERO];
    }
    if !late {
        return smooth(u);
    }
    let [value, rate] = smooth(u * u);
    [value, 2.0 * u * rate]
}

/// How a stroke is spread over its time.
fn pace_named(late: bool) -> &'static str {
    if late { "late" } else { "even" }
}

pub fn swivelling(r: &mut Random, braked: bool) -> Scene {
    let [lower, out] = [0; 2].map(|_| r.scaled(0.1, 3.0));
    let inside = out * r.within(0.1, 1.0);
    let twist = r.within(-3.0, 3.0);
    let duration = r.scaled(0.3, 5.0);
    let late = r.percent(50);
    let moves = r.percent(85) || braked && r.percent(50);
    let pushed = braked && !moves;
    let still = r.percent(50) && !pushed;
    let l = if still { 0.0 } else { r.within(-2.0, 2.0) };
    let mut text = format!(
        "kind = \"swivel\"\n[body]\nlower = {lower:?}\nupper = {out:?}\n[initial]\nangular_momentum = {l:?}\n[effects]\n"
    );
    let brake = braked.then(|| lower / duration * r.scaled(1e-3, 1.0));
    line(&mut text, "bearing_friction", brake);
    if moves {
        let pace = pace_named(late);
        text += &format!(
            "[effects.four_phases]\narms_out = {out:?}\narms_in = {inside:?}\ntwist = {twist:?}\nduration = {duration:?}\npace = \"{pace}\"\n"
        );
    }
    let [b, out, inside, twist] = [lower, out, inside, twist].map(Dd::from);
    let whole = Dd::from(duration);
    let c = Dd::from(brake.unwrap_or(0.0));
    // Upper moment, angle and rate of the waist.
    let shape = move |piece: usize, t: Dd| {
        if !moves {
            return [out, Dd::ZERO, Dd::ZERO];
        }
        let quarter = whole * 0.25;
        let [part, rate] = pace(late, (t - quarter * piece as f64) / quarter);
        let rate = rate * twist / quarter;
        let between = |from: Dd, to: Dd| from + (to - from) * part;
        match piece % 4 {
            0 => [out, twist * part, rate],
            1 => [between(out, inside), twist, Dd::ZERO],
            2 => [inside, twist * (1.0 - part), -rate],
            _ => [between(inside, out), Dd::ZERO, Dd::ZERO],
        }
    };
    let spin = move |[a, _, rate]: [Dd; 3], l: Dd| (l - a * rate) / (a + b);
    Scene {
        text,
        span: duration * r.scaled(0.05, 20.0),
        start: vec![(l, 1.0)],
        sizes: vec![
            (Sort::Rate, 1.0 / duration),
            (Sort::Momentum, lower / duration),
        ],
        columns: told("angle lower upper, rate rate, momentum angular_momentum"),
        truth: Box::new(move |start, times| {
            let last = times[times.len() - 1];
            let quarter = duration / 4.0;
            let corners = 1..=(last / quarter) as usize + 1;
            let corners: Vec<Dd> = corners.map(|k| whole * (0.25 * k as f64)).collect();
            let rate = |piece: usize, t: Dd, y: &[Dd; 2]| {
                let spin = spin(shape(piece, t), y[1]);
                [spin, -(c * spin)]
            };
            let start = [Dd::ZERO, start[0]];
            let rows = pieced(rate, start, &[1.0, 1.0], &corners, times, quarter);
            let row = |(&t, y): (&f64, &[Dd; 2])| {
                let shape = shape((t / quarter) as usize, Dd::from(t));
                vec![y[0], y[0] + shape[1], spin(shape, y[1]), y[1]]
            };
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}

pub fn skating(r: &mut Random, braked: bool) -> Scene {
    let core = r.scaled(0.1, 3.0);
    let hand = r.scaled(0.3, 5.0);
    let [reach, to] = [0; 2].map(|_| r.within(0.05, 1.0));
    let spin = r.sign() * r.scaled(0.3, 20.0);
    let begin = r.nil_or(30, |r| r.scaled(0.05, 2.0));
    let duration = r.scaled(0.1, 3.0);
    let late = r.percent(50);
    let moves = r.percent(85);
    let mut text = format!(
        "kind = \"skater\"\n[body]\ncore = {core:?}\nhand = {hand:?}\n[initial]\nreach = {reach:?}\nspin = {spin:?}\n[effects]\n"
    );
    let brake = braked.then(|| core / (begin + duration) * r.scaled(1e-3, 1.0));
    line(&mut text, "bearing_friction", brake);
    if moves {
        let pace = pace_named(late);
        text += &format!(
            "[effects.draw]\nto = {to:?}\nbegin = {begin:?}\nduration = {duration:?}\npace = \"{pace}\"\n"
        );
    }
    let [core, hand, to] = [core, hand, to].map(Dd::from);
    let c = Dd::from(brake.unwrap_or(0.0));
    let drawn = move |from: Dd, t: Dd| {
        if !moves {
            return [from, Dd::ZERO];
        }
        let [part, rate] = pace(late, (t - begin) / duration);
        [from + (to - from) * part, (to - from) * rate / duration]
    };
    let moment = move |reach: Dd| core + 2.0 * hand * reach * reach;
    Scene {
        text,
        span: (begin + duration) * r.scaled(0.05, 10.0),
        start: vec![(reach, 1.0), (spin, spin.abs())],
        sizes: Vec::new(),
        columns: told("angle angle, rate spin, length reach, energy energy work heat"),
        truth: Box::new(move |start, times| {
            let (reach, spin) = (start[0], start[1]);
            let rate = |_: usize, t: Dd, y: &[Dd; 3]| {
                let spin = y[1] / moment(drawn(reach, t)[0]);
                [spin, -(c * spin), c * spin * spin]
            };
            let first = 0.5 * moment(reach) * spin * spin;
            let scales = [1.0, (moment(reach) * spin).value().abs(), first.value()];
            let corners = [Dd::from(begin), Dd::from(begin) + duration];
            let longest = (begin + duration).min(1.0 / spin.value().abs());
            let start = [Dd::ZERO, moment(reach) * spin, Dd::ZERO];
            let rows = pieced(rate, start, &scales, &corners, times, longest);
            let row = |(&t, y): (&f64, &[Dd; 3])| {
                let [reach, rate] = drawn(reach, Dd::from(t));
                let spin = y[1] / moment(reach);
                let energy = 0.5 * y[1] * spin + hand * rate * rate;
                vec![y[0], spin, reach, energy, energy + y[2] - first, y[2]]
            };
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}

/// Mass, moments about the spine and across it, distance to the joint.
#[derive(Clone, Copy)]
struct Half {
    mass: Dd,
    axial: Dd,
    transverse: Dd,
    joint: Dd,
}

/// Bend and direction, and their rates.
#[derive(Clone, Copy, Default)]
struct Bend {
    angle: Dd,
    direction: Dd,
    angle_rate: Dd,
    direction_rate: Dd,
}

impl Bend {
    /// The second spine, and how the second half turns against the first: about the axis of the bend at γ', and as the bend is carried round
    /// neither twists.
    fn second(&self) -> [Vector; 2] {
        let (s, c) = self.angle.sine_cosine();
        let (sp, cp) = self.direction.sine_cosine();
        let spine = Vector::new(c, s * cp, s * sp);
        let rolled = (Vector::x() - spine) * self.direction_rate;
        let bent = Vector::new(Dd::ZERO, -sp, cp) * self.angle_rate;
        [spine, bent + rolled]
    }
}

#[derive(Clone, Copy)]
struct Turnover {
    forward: Dd,
    back: Dd,
    duration: Dd,
    late: bool,
}

impl Turnover {
    fn bend(&self, piece: usize, t: Dd) -> Bend {
        let (u, round) = (t / self.duration, PI * 2.0);
        let (forward, back) = (self.forward, self.back);
        match piece {
            0 => {
                let [part, rate] = pace(self.late, 4.0 * u);
                Bend {
                    angle: forward * part,
                    angle_rate: forward * rate * 4.0 / self.duration,
                    ..Bend::default()
                }
            }
            1 => {
                let [part, rate] = pace(self.late, 2.0 * u - 0.5);
                let (mean, swing) = ((forward + back) * 0.5, (forward - back) * 0.5);
                let (sine, cosine) = (round * part).sine_cosine();
                let direction_rate = round * rate * 2.0 / self.duration;
                Bend {
                    angle: mean + swing * cosine,
                    direction: round * part,
                    angle_rate: -(swing * sine * direction_rate),
                    direction_rate,
                }
            }
            2 => {
                let [part, rate] = pace(self.late, 4.0 * u - 3.0);
                Bend {
                    angle: forward * (1.0 - part),
                    angle_rate: -(forward * rate * 4.0 / self.duration),
                    direction: round,
                    ..Bend::default()
                }
            }
            _ => Bend {
                direction: round,
                ..Bend::default()
            },
        }
    }
}

/// L about the common centre, along the first half's axes, when that half turns at Ω: the halves' own, and that of their centres.
fn momentum(halves: &[Half; 2], [second, against]: [Vector; 2], omega: Vector) -> Vector {
    let [one, other] = halves;
    let rates = [omega, omega + against];
    let joints = |first: Vector, second: Vector| first * one.joint + second * other.joint;
    // From the centre of the first half to that of the second, and how fast that changes in space.
    let arm = joints(Vector::x(), second);
    let speed = joints(rates[0].cross(&Vector::x()), rates[1].cross(&second));
    let reduced = one.mass * other.mass / (one.mass + other.mass);
    let own = |half: &Half, spine: Vector, rate: Vector| {
        rate * half.transverse + spine * ((half.axial - half.transverse) * spine.dot(&rate))
    };
    let both = own(one, Vector::x(), rates[0]) + own(other, second, rates[1]);
    arm.cross(&speed) * reduced + both
}

pub fn cat(r: &mut Random, even: bool) -> Scene {
    let half = |r: &mut Random| {
        let mass = r.scaled(0.3, 3.0);
        let transverse = mass * r.scaled(1e-3, 3e-2);
        let axial = transverse * r.within(0.1, 1.9);
        [mass, axial, transverse, r.within(0.03, 0.3)]
    };
    let first = half(r);
    let second = if even { first } else { half(r) };
    let attitude = held(r.attitude());
    let gravity = r.percent(50).then(|| r.scaled(1.0, 20.0));
    let [forward, back] = [0; 2].map(|_| r.within(0.1, 2.5));
    let duration = r.scaled(0.1, 3.0);
    let late = r.percent(50);
    let [mass, axial, transverse, joint] = [0, 1, 2, 3].map(|k| [first[k], second[k]]);
    let mut text = format!(
        "kind = \"cat\"\n[body]\nmass = {mass:?}\naxial = {axial:?}\ntransverse = {transverse:?}\nto_joint = {joint:?}\n[initial]\nattitude = {attitude:?}\n[effects]\n"
    );
    line(&mut text, "gravity", gravity);
    let pace = pace_named(late);
    text += &format!(
        "[effects.turnover]\nforward = {forward:?}\nback = {back:?}\nduration = {duration:?}\npace = \"{pace}\"\n"
    );
    let halves = [first, second].map(|half| {
        let [mass, axial, transverse, joint] = half.map(Dd::from);
        Half {
            mass,
            axial,
            transverse,
            joint,
        }
    });
    let [forward, back, whole] = [forward, back, duration].map(Dd::from);
    let path = Turnover {
        forward,
        back,
        duration: whole,
        late,
    };
    let g = Dd::from(gravity.unwrap_or(0.0));
    Scene {
        text,
        span: duration * r.within(0.1, 1.3),
        start: attitude.iter().map(|&q| (q, 1.0)).collect(),
        sizes: vec![(Sort::Length, first[3])],
        columns: told("attitude qw qx qy qz, angle bend direction, length z"),
        truth: Box::new(move |start, times| {
            let rate = |piece: usize, t: Dd, q: &[Dd; 4]| {
                let bend = path.bend(piece, t).second();
                turned(*q, root(|omega| momentum(&halves, bend, omega)).into())
            };
            let quarter = whole * 0.25;
            let corners = [quarter, quarter * 3.0, whole];
            let start = [start[0], start[1], start[2], start[3]];
            let rows = pieced(rate, start, &[1.0; 4], &corners, times, duration);
            let row = |(&t, q): (&f64, &[Dd; 4])| {
                let t = Dd::from(t);
                let piece = corners.iter().filter(|c| t > **c).count();
                let bend = path.bend(piece, t);
                [&q[..], &[bend.angle, bend.direction, -(0.5 * g * t * t)]].concat()
            };
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}

pub fn paper_cat(r: &mut Random) -> Scene {
    let mass = r.scaled(3e-4, 3e-2);
    let area = r.scaled(1e-3, 1e-1);
    let lever = r.sign() * r.scaled(1e-3, 3e-2);
    let gyration = r.scaled(5e-3, 1e-1);
    let coefficient = r.within(0.5, 2.0);
    let damping = gyration * gyration * r.scaled(0.1, 5.0);
    let air = r.percent(80).then(|| r.scaled(0.1, 2.0));
    let gravity = r.percent(95).then(|| r.scaled(1.0, 20.0));
    let tilt = match r.percent(50) {
        true => r.within(-3.1, 3.1),
        false => core::f64::consts::PI - r.scaled(1e-9, 1e-1),
    };
    let mut text = format!(
        "kind = \"paper-cat\"\n[body]\nmass = {mass:?}\narea = {area:?}\nlever = {lever:?}\ngyration = {gyration:?}\ncoefficient = {coefficient:?}\ndamping = {damping:?}\n[initial]\ntilt = {tilt:?}\n[effects]\n"
    );
    line(&mut text, "gravity", gravity);
    line(&mut text, "air", air);
    let g = gravity.unwrap_or(0.1);
    let terminal = (2.0 * mass * g / (air.unwrap_or(1.0) * area * coefficient)).sqrt();
    let swing = gyration / (g * lever.abs()).sqrt();
    let [m, s, d, k, c, b] = [mass, area, lever, gyration, coefficient, damping].map(Dd::from);
    let grip = 0.5 * Dd::from(air.unwrap_or(0.0)) * s * c;
    let weight = Dd::from(gravity.unwrap_or(0.0));
    let fast = terminal / g;
    Scene {
        text,
        span: (fast + swing) * r.scaled(0.05, 20.0),
        start: vec![(tilt, 1.0)],
        sizes: vec![
            (Sort::Length, gyration),
            (Sort::Speed, gyration / swing),
            (Sort::Rate, 1.0 / swing),
            (Sort::Energy, (gyration / swing).powi(2)),
        ],
        columns: told("length fall, speed velocity, angle tilt, rate tilt_rate, energy lost"),
        truth: Box::new(move |start, times| {
            // It falls and never rises: |v| is v.
            let rate = |_: usize, _: Dd, y: &[Dd; 5]| {
                let [_, v, tilt, rate, _] = *y;
                let drag = grip * v * v / m;
                let sine = tilt.sine_cosine().0;
                let turn = -(grip * v * (d * v * sine + b * rate)) / (m * k * k);
                [v, weight - drag, rate, turn, drag * v]
            };
            let energy = terminal * terminal;
            let scales = [fast * terminal, terminal, 1.0, 1.0 / swing, energy];
            let start = [Dd::ZERO, Dd::ZERO, start[0], Dd::ZERO, Dd::ZERO];
            let rows = pieced(rate, start, &scales, &[], times, fast + swing);
            rows.iter().map(|y| y.to_vec()).collect()
        }),
    }
}

/// Two feet that a muscle pushes apart and pulls together, evenly sped up and slowed down.
pub fn crawler(r: &mut Random) -> Scene {
    let [rear, front] = [0; 2].map(|_| r.scaled(0.3, 5.0));
    let [gap, length] = [0; 2].map(|_| r.within(0.05, 0.5));
    let [push, pull] = [0; 2].map(|_| r.scaled(0.1, 2.0));
    let mut text = format!(
        "kind = \"crawler\"\n[body]\nmasses = [{rear:?}, {front:?}]\ngap = {gap:?}\nlength = {length:?}\npush = {push:?}\npull = {pull:?}\n"
    );
    let fastest = 4.0 * length / (push.min(pull) * push.min(pull));
    let ground = r.percent(90).then(|| {
        let g = r.scaled(1.0, 20.0);
        (fastest / g * r.scaled(1e-2, 3.0), g)
    });
    text += "[effects]\n";
    if let Some((mu, g)) = ground {
        text += &format!("[effects.ground_friction]\ncoefficient = {mu:?}\ngravity = {g:?}\n");
    }
    let grip = ground.map_or(Dd::ZERO, |(mu, g)| Dd::from(mu) * g);
    let walk = Walk {
        masses: [rear, front].map(Dd::from),
        gap: Dd::from(gap),
        length: Dd::from(length),
        strokes: [push, pull].map(Dd::from),
        grip,
    };
    Scene {
        text,
        span: (push + pull) * r.scaled(0.05, 300.0),
        start: vec![(length, length), (gap, gap)],
        sizes: vec![
            (Sort::Length, gap),
            (Sort::Speed, length / push.min(pull)),
            (Sort::Energy, (rear + front) * fastest * length),
        ],
        columns: told("length rear front center, speed velocity, energy work heat"),
        truth: Box::new(move |start, times| {
            let (length, gap) = (start[0], start[1]);
            Walk {
                length,
                gap,
                ..walk
            }
            .rows(times)
        }),
    }
}

#[derive(Clone, Copy)]
struct Walk {
    masses: [Dd; 2],
    gap: Dd,
    length: Dd,
    strokes: [Dd; 2],
    /// μg.
    grip: Dd,
}

impl Walk {
    /// Velocities of the feet: 0 where a foot holds. Forces on the feet: the muscle's, and the ground's.
    fn rows(&self, times: &[f64]) -> Vec<Vec<Dd>> {
        let zero = Dd::ZERO;
        let [rear, front] = self.masses;
        let whole = rear + front;
        let mut rows: Vec<Vec<Dd>> = Vec::new();
        let mut v = [zero; 2];
        let mut x = [-(front * self.gap / whole), rear * self.gap / whole];
        let (mut work, mut heat, mut now) = (zero, zero, zero);
        // Which way each foot slips, 0 for one that holds.
        let mut slips = [0.0_f64; 2];
        let mut begin = zero;
        for piece in 0.. {
            if rows.len() == times.len() {
                break;
            }
            let duration = self.strokes[piece % 4 / 2];
            let size = 4.0 * self.length / (duration * duration);
            let alpha = if matches!(piece % 4, 0 | 3) {
                size
            } else {
                -size
            };
            let end = begin + duration * 0.5;
            if piece % 2 == 0 {
                // The gap is at rest: feet that one of them holds are both at rest.
                if slips.contains(&0.0) || self.grip == zero && piece == 0 {
                    (slips, v) = ([0.0; 2], [zero; 2]);
                }
            }
            while end > now {
                let most = self.masses.map(|mass| mass * self.grip);
                let toward = |force: Dd| if force.hi > 0.0 { 1.0 } else { -1.0 };
                let outward = [-toward(alpha), toward(alpha)];
                let sliding = |k: usize, way: f64| -(way * most[k]);
                // What the ground must do to a foot so that it holds while the other slips.
                let needed = |k: usize, way: f64| {
                    let other = 1 - k;
                    let pushed = if other == 1 { alpha } else { -alpha };
                    self.masses[other] * pushed - sliding(other, way)
                };
                let can = |k: usize, way: f64| needed(k, way).abs() <= most[k];
                match slips {
                    [0.0, 0.0] => {
                        slips = outward;
                        for k in [1, 0] {
                            if can(k, outward[1 - k]) {
                                slips = outward;
                                slips[k] = 0.0;
                            }
                        }
                    }
                    [0.0, way] if !can(0, way) => slips[0] = -toward(needed(0, way)),
                    [way, 0.0] if !can(1, way) => slips[1] = -toward(needed(1, way)),
                    _ => {}
                }
                if self.grip == zero {
                    slips = outward;
                }
                let ground = match slips {
                    [0.0, way] => [needed(0, way), sliding(1, way)],
                    [way, 0.0] => [sliding(0, way), needed(1, way)],
                    [a, b] => [sliding(0, a), sliding(1, b)],
                };
                // Centre and gap accelerate; so do the feet.
                let centre = (ground[0] + ground[1]) / whole;
                let rates = [
                    centre - front / whole * alpha,
                    centre + rear / whole * alpha,
                ];
                let rates = [0, 1].map(|k| if slips[k] == 0.0 { zero } else { rates[k] });
                let muscle = front * rates[1] - ground[1];
                let mut wait = end - now;
                let mut stops = None;
                if !slips.contains(&0.0) && self.grip != zero {
                    for k in 0..2 {
                        if rates[k].hi * slips[k] < 0.0 {
                            let t = -v[k] / rates[k];
                            let t = if t.hi < 0.0 { zero } else { t };
                            if t < wait {
                                (wait, stops) = (t, Some(k));
                            }
                        }
                    }
                }
                let at = |t: Dd| {
                    let moved = [0, 1].map(|k| t * (v[k] + 0.5 * t * rates[k]));
                    let rubs = |&k: &usize| slips[k] != 0.0;
                    let heats = (0..2).filter(rubs).map(|k| -(ground[k] * moved[k]));
                    let place = [x[0] + moved[0], x[1] + moved[1]];
                    let fast = [0, 1].map(|k| v[k] + t * rates[k]);
                    let work = work + muscle * (moved[1] - moved[0]);
                    (place, fast, work, heat + heats.sum::<Dd>())
                };
                while let Some(&t) = times.get(rows.len()) {
                    let t = Dd::from(t) - now;
                    if t > wait {
                        break;
                    }
                    let (place, fast, work, heat) = at(t);
                    let mean = |of: [Dd; 2]| (rear * of[0] + front * of[1]) / whole;
                    rows.push(vec![
                        place[0],
                        place[1],
                        mean(place),
                        mean(fast),
                        work,
                        heat,
                    ]);
                }
                (x, v, work, heat) = at(wait);
                now += wait;
                if let Some(k) = stops {
                    (v[k], slips[k]) = (zero, 0.0);
                }
            }
            now = end;
            begin = end;
        }
        rows
    }
}
