//! Random tops of every kind, the truth about each, and the verdict on what a scene gives back.

use core::f64::consts::PI;

use super::door::{self, Answer};
use super::kinds::line;
use super::random::Random;
use super::top_series::{AIR, BEARING, Frictions, Motion, PIVOT, TIP, Top, Whole, vertical};
use super::verdict::{self, Given, Outcome};
use support::double_double::Dd;
use support::{greatest, multiplied, turned};

/// How a top starts to turn.
#[derive(Debug, Clone, Copy)]
pub enum Spin {
    Omega([f64; 3]),
    AngularMomentum([f64; 3]),
}

#[derive(Debug, Clone)]
pub struct Case {
    pub top: Top,
    pub spin: Spin,
    pub attitude: [f64; 4],
    pub times: Vec<f64>,
    pub accuracy: f64,
}

/// A top that is not yet scaled: moments and rates are of the order of 1.
pub struct Draft {
    moments: [f64; 3],
    /// MgC.
    weight: [f64; 3],
    omega: [f64; 3],
    attitude: [f64; 4],
    /// Parts of the rotation that each takes over the whole time.
    frictions: Frictions,
}

type Kind = fn(&mut Random) -> Draft;

const NEAR_THE_THRESHOLD: &str = "Lagrange, nearly upright near the threshold";
const NEAR_ITS_SEPARATRIX: &str = "Lagrange, pendulum near its separatrix";

/// The strata and how many tops there are of each: 5,000.
pub const STRATA: [(&str, usize, Kind); 32] = [
    ("free, asymmetric", 200, |r| free(r, asymmetric)),
    ("free, near the separatrix", 300, near_separatrix),
    ("free, nearly along an axis", 100, near_axis),
    ("free, symmetric", 150, |r| free(r, symmetric)),
    ("free, nearly symmetric", 150, |r| free(r, nearly_symmetric)),
    ("free, spherical", 40, |r| free(r, spherical)),
    ("free, rod", 80, |r| free(r, rod)),
    ("free, lamina", 80, |r| free(r, lamina)),
    ("free, moments far apart", 100, |r| free(r, far_apart)),
    ("Lagrange", 300, lagrange),
    ("Lagrange, fast", 120, lagrange_fast),
    (NEAR_THE_THRESHOLD, 250, near_threshold),
    ("Lagrange, asleep upright", 120, asleep),
    ("Lagrange, waking", 120, waking),
    ("Lagrange, hanging", 80, hanging),
    ("Lagrange, without spin", 120, pendulum),
    (NEAR_ITS_SEPARATRIX, 120, pendulum_near_separatrix),
    ("Lagrange, spherical inertia", 100, heavy_sphere),
    ("Kovalevskaya", 250, kovalevskaya),
    ("Kovalevskaya, nearly upright", 150, kovalevskaya_upright),
    ("Goryachev", 120, goryachev),
    ("heavy", 300, heavy),
    ("heavy, fast", 150, heavy_fast),
    ("heavy, slow", 150, heavy_slow),
    ("heavy, nearly a known top", 150, nearly_known),
    ("heavy, upright or hanging", 150, heavy_vertical),
    ("pivot friction", 200, |r| braked(r, PIVOT)),
    ("bearing friction", 200, |r| braked(r, BEARING)),
    ("air drag", 200, |r| braked(r, AIR)),
    ("tip friction", 200, dry),
    ("frictions mixed", 200, mixed),
    ("frictions mixed with a dry tip", 50, mixed_and_dry),
];

/// One case of one stratum.
pub fn case(stratum: usize, number: usize) -> Case {
    let mut random = Random::of(stratum, number);
    let draft = STRATA[stratum].2(&mut random);
    draft.scaled(&mut random)
}

fn asymmetric(r: &mut Random) -> [f64; 3] {
    loop {
        let m: [f64; 3] = core::array::from_fn(|_| r.scaled(0.1, 3.0));
        if (0..3).all(|k| m[k] < 0.99 * (m[(k + 1) % 3] + m[(k + 2) % 3])) {
            return m;
        }
    }
}

fn rotated(r: &mut Random, mut moments: [f64; 3]) -> [f64; 3] {
    moments.rotate_left(r.whole(3));
    moments
}

fn symmetric(r: &mut Random) -> [f64; 3] {
    let m = r.scaled(0.3, 3.0);
    let moments = [m, m, m * r.within(0.02, 1.98)];
    rotated(r, moments)
}

fn nearly_symmetric(r: &mut Random) -> [f64; 3] {
    let m = r.scaled(0.3, 3.0);
    let off = r.sign() * r.scaled(1e-15, 1e-2);
    let moments = [m, m * (1.0 + off), m * r.within(0.05, 1.95)];
    rotated(r, moments)
}

fn spherical(r: &mut Random) -> [f64; 3] {
    [r.scaled(0.1, 3.0); 3]
}

fn rod(r: &mut Random) -> [f64; 3] {
    let m = r.scaled(0.3, 3.0);
    let thin = m * r.scaled(1e-12, 1e-2);
    let off = r.nil_or(50, |r| thin * r.within(0.0, 0.9));
    rotated(r, [m, m - off, thin])
}

fn lamina(r: &mut Random) -> [f64; 3] {
    let (a, b) = (r.scaled(0.1, 3.0), r.scaled(0.1, 3.0));
    rotated(r, [a, b, a + b])
}

fn far_apart(r: &mut Random) -> [f64; 3] {
    let (a, b) = (1.0, r.scaled(1e-6, 1.0));
    let moments = [a, b, a + b * r.within(-0.99, 0.99)];
    rotated(r, moments)
}

fn free(r: &mut Random, moments: fn(&mut Random) -> [f64; 3]) -> Draft {
    let moments = moments(r);
    // Half of them with L in any direction, half with Ω.
    let direction = r.direction();
    let omega = if r.percent(50) {
        core::array::from_fn(|k| direction[k] / moments[k])
    } else {
        direction
    };
    Draft {
        moments,
        weight: [0.0; 3],
        omega,
        attitude: r.attitude(),
        frictions: [None; 4],
    }
}

fn near_separatrix(r: &mut Random) -> Draft {
    let mut moments = asymmetric(r);
    moments.sort_by(f64::total_cmp);
    let [a, b, c] = moments;
    let off = r.nil_or(5, |r| r.sign() * r.scaled(1e-15, 1e-1));
    // On the separatrix L1²(1/I1 - 1/I2) = L3²(1/I2 - 1/I3); in half of the cases next to the middle axis.
    let far = r.percent(50);
    let l1 = r.sign() * if far { 1.0 } else { r.scaled(1e-12, 1.0) };
    let l3 = r.sign() * l1 * ((1.0 / a - 1.0 / b) / (1.0 / b - 1.0 / c)).sqrt() * (1.0 + off);
    let l2 = r.sign() * r.scaled(0.1, 10.0);
    let turn = r.whole(3);
    let mut omega = [l1 / a, l2 / b, l3 / c];
    moments.rotate_left(turn);
    omega.rotate_left(turn);
    Draft {
        moments,
        omega,
        ..free(r, spherical)
    }
}

fn near_axis(r: &mut Random) -> Draft {
    let moments = asymmetric(r);
    let mut omega = [0.0; 3];
    let axis = r.whole(3);
    omega[axis] = r.sign();
    for k in 1..3 {
        if r.percent(80) {
            omega[(axis + k) % 3] = r.sign() * r.scaled(1e-15, 1e-3);
        }
    }
    Draft {
        moments,
        omega,
        ..free(r, spherical)
    }
}

/// Turns axis 3 by `tilt` from the vertical, the rest at random.
fn tilted(r: &mut Random, tilt: f64) -> [f64; 4] {
    let (first, second) = (r.within(0.0, PI), r.within(0.0, PI));
    let (s, c) = (0.5 * tilt).sin_cos();
    [
        c * (first + second).cos(),
        s * (first - second).cos(),
        s * (first - second).sin(),
        c * (first + second).sin(),
    ]
}

/// A symmetric body with its centre of mass on axis 3.
fn on_axis(r: &mut Random, omega: [f64; 3], weight: f64, tilt: f64) -> Draft {
    let m = r.scaled(0.5, 2.0);
    let moments = [m, m, m * r.within(0.05, 1.95)];
    Draft {
        moments,
        weight: [0.0, 0.0, weight],
        omega,
        attitude: tilted(r, tilt),
        frictions: [None; 4],
    }
}

fn lagrange(r: &mut Random) -> Draft {
    let (weight, tilt) = (r.sign() * r.scaled(1e-2, 5.0), r.within(0.0, PI));
    let omega = r.direction();
    let draft = on_axis(r, omega, weight, tilt);
    on_any_axis(r, draft)
}

/// The axis of symmetry is any of the three.
fn on_any_axis(r: &mut Random, mut draft: Draft) -> Draft {
    let turn = r.whole(3);
    draft.moments.rotate_left(turn);
    draft.weight.rotate_left(turn);
    draft.omega.rotate_left(turn);
    draft
}

fn lagrange_fast(r: &mut Random) -> Draft {
    let (weight, tilt) = (r.sign() * r.scaled(1e-6, 1e-1), r.within(0.0, PI));
    let slow = r.scaled(1e-3, 1.0);
    let [x, y] = [0; 2].map(|_| slow * r.within(-1.0, 1.0));
    let omega = [x, y, r.sign()];
    let draft = on_axis(r, omega, weight, tilt);
    on_any_axis(r, draft)
}

/// (I₃Ω₃)² as a multiple of 4 I₁Mgl, which it must be for the upright top to be stable.
fn spun(draft: &mut Draft, multiple: f64) {
    let [m, _, axial] = draft.moments;
    draft.omega[2] = (4.0 * multiple * m * draft.weight[2].abs()).sqrt() / axial;
}

fn near_threshold(r: &mut Random) -> Draft {
    let tilt = r.scaled(1e-12, 1e-1);
    let mut draft = on_axis(r, [0.0; 3], 1.0, tilt);
    let off = r.sign() * r.scaled(1e-15, 1e-1);
    spun(&mut draft, 1.0 + off);
    if r.percent(50) {
        let nudge = tilt * r.scaled(1e-2, 10.0);
        let [x, y, _] = r.direction();
        (draft.omega[0], draft.omega[1]) = (x * nudge, y * nudge);
    }
    draft
}

/// On its axis, exactly upright so many times in a hundred, otherwise tilted within this range.
fn nearly_upright(r: &mut Random, exactly: u64, [least, greatest]: [f64; 2]) -> Draft {
    let tilt = r.nil_or(exactly, |r| r.scaled(least, greatest));
    on_axis(r, [0.0; 3], 1.0, tilt)
}

fn asleep(r: &mut Random) -> Draft {
    let mut draft = nearly_upright(r, 40, [1e-16, 1e-3]);
    let multiple = r.scaled(1.0, 100.0);
    spun(&mut draft, multiple);
    draft
}

fn waking(r: &mut Random) -> Draft {
    let mut draft = nearly_upright(r, 10, [1e-15, 1e-1]);
    let multiple = r.within(0.0, 1.0);
    spun(&mut draft, multiple);
    if r.percent(50) {
        let nudge = r.scaled(1e-15, 1e-1);
        let [x, y, _] = r.direction();
        (draft.omega[0], draft.omega[1]) = (x * nudge, y * nudge);
    }
    draft
}

fn hanging(r: &mut Random) -> Draft {
    let tilt = PI - r.scaled(1e-12, 1.0);
    let omega = r.direction().map(|x| x * 0.3);
    on_axis(r, omega, 1.0, tilt)
}

fn pendulum(r: &mut Random) -> Draft {
    let tilt = r.within(0.0, PI);
    let [x, y, _] = r.direction();
    let size = r.nil_or(30, |r| r.scaled(1e-3, 3.0));
    on_axis(r, [x * size, y * size, 0.0], 1.0, tilt)
}

/// Nearly enough energy to stand upright, in one plane or nearly.
fn pendulum_near_separatrix(r: &mut Random) -> Draft {
    let tilt = r.within(0.1, PI);
    let mut draft = on_axis(r, [0.0; 3], 1.0, tilt);
    let half = 0.5 * tilt;
    draft.attitude = [half.cos(), half.sin(), 0.0, 0.0];
    let off = r.sign() * r.scaled(1e-15, 1e-2);
    // ½I₁Ω² = Mgl(1 - cos tilt)
    draft.omega[0] = r.sign() * 2.0 * half.sin() / draft.moments[0].sqrt() * (1.0 + off);
    if r.percent(50) {
        draft.omega[1] = r.scaled(1e-15, 1e-2);
    }
    draft
}

fn heavy_sphere(r: &mut Random) -> Draft {
    let weight = r.direction();
    let strength = r.scaled(1e-2, 5.0);
    Draft {
        weight: weight.map(|x| x * strength),
        ..free(r, spherical)
    }
}

fn kovalevskaya(r: &mut Random) -> Draft {
    let m = r.scaled(0.3, 3.0);
    let weight = r.scaled(3e-2, 5.0);
    let turn = r.nil_or(50, |r| r.within(0.0, 2.0 * PI));
    let draft = Draft {
        moments: [2.0 * m, 2.0 * m, m],
        weight: [weight * turn.cos(), weight * turn.sin(), 0.0],
        ..free(r, spherical)
    };
    on_any_axis(r, draft)
}

/// The centre of mass nearly above the pivot, and little but a kick.
fn kovalevskaya_upright(r: &mut Random) -> Draft {
    let mut draft = kovalevskaya(r);
    draft.attitude = [1.0, 0.0, 0.0, 0.0];
    // Axis 1 of the drafts before they are turned: upright is the axis that bears most of the weight.
    let axis = (0..3)
        .max_by(|&i, &j| draft.weight[i].abs().total_cmp(&draft.weight[j].abs()))
        .unwrap_or(0);
    let mut up = [0.0; 3];
    up[axis] = draft.weight[axis].signum();
    draft.attitude = upright(up);
    if r.percent(70) {
        let tilt = r.scaled(1e-15, 1e-2);
        let [x, y, z] = r.direction();
        draft.attitude = multiplied(draft.attitude, [1.0, x * tilt, y * tilt, z * tilt]);
    }
    let kick = r.scaled(1e-3, 2.0);
    let axis = r.whole(3);
    if r.percent(60) {
        draft.omega = [0.0; 3];
        draft.omega[axis] = kick;
    }
    draft
}

/// An attitude in which this direction of the body points up.
fn upright([x, y, z]: [f64; 3]) -> [f64; 4] {
    if z < -0.999_999 {
        return [0.0, 1.0, 0.0, 0.0];
    }
    // q (x, y, z) q⁻¹ = (0, 0, 1): the turn about (x, y, z) ∧ (0, 0, 1).
    [1.0 + z, y, -x, 0.0]
}

/// I₁ = I₂ = 4I₃, the centre of mass on the equator, no vertical angular momentum as well as rounding allows.
fn goryachev(r: &mut Random) -> Draft {
    let m = r.scaled(0.1, 1.0);
    let moments = [4.0 * m, 4.0 * m, m];
    let attitude = door::held(r.attitude());
    let [w, x, y, z] = attitude;
    let up = [
        2.0 * (x * z - w * y),
        2.0 * (y * z + w * x),
        w * w + z * z - x * x - y * y,
    ];
    let l = r.direction();
    let vertical: f64 = (0..3).map(|k| l[k] * up[k]).sum();
    let exact = if r.percent(70) { 1.0 } else { 0.0 };
    let omega = core::array::from_fn(|k| (l[k] - exact * vertical * up[k]) / moments[k]);
    Draft {
        moments,
        weight: [r.scaled(3e-2, 5.0), 0.0, 0.0],
        omega,
        attitude,
        frictions: [None; 4],
    }
}

fn any_weight(r: &mut Random, least: f64, greatest: f64) -> [f64; 3] {
    let strength = r.scaled(least, greatest);
    r.direction().map(|x| x * strength)
}

fn heavy(r: &mut Random) -> Draft {
    let weight = any_weight(r, 1e-2, 5.0);
    let rest = r.percent(10);
    let draft = free(r, asymmetric);
    Draft {
        weight,
        omega: if rest { [0.0; 3] } else { draft.omega },
        ..draft
    }
}

fn heavy_fast(r: &mut Random) -> Draft {
    Draft {
        weight: any_weight(r, 1e-8, 1e-2),
        ..free(r, asymmetric)
    }
}

fn heavy_slow(r: &mut Random) -> Draft {
    let draft = free(r, asymmetric);
    let slow = r.scaled(1e-6, 1e-1);
    Draft {
        weight: any_weight(r, 0.5, 2.0),
        omega: draft.omega.map(|x| x * slow),
        ..draft
    }
}

/// Next to Euler's, Lagrange's or Kovalevskaya's top, and not quite it.
fn nearly_known(r: &mut Random) -> Draft {
    let off = r.scaled(1e-15, 1e-2);
    let mut draft = match r.whole(3) {
        0 => Draft {
            weight: any_weight(r, 1e-15, 1e-8),
            ..near_separatrix(r)
        },
        1 => lagrange(r),
        _ => kovalevskaya(r),
    };
    draft.moments[r.whole(3)] *= 1.0 - off;
    if r.percent(50) {
        draft.weight[r.whole(3)] += off;
    }
    draft
}

fn heavy_vertical(r: &mut Random) -> Draft {
    let mut draft = heavy(r);
    let size = draft.weight.iter().map(|x| x * x).sum::<f64>().sqrt();
    let up = draft.weight.map(|x| x / size);
    let up = if r.percent(50) { up } else { up.map(|x| -x) };
    let tilt = r.scaled(1e-15, 1e-1);
    let [x, y, z] = r.direction();
    draft.attitude = multiplied(upright(up), [1.0, x * tilt, y * tilt, z * tilt]);
    let about = r.direction();
    let kick = r.scaled(1e-12, 1e-1);
    // Spin about the vertical, large or small, and a kick.
    let spin = r.nil_or(50, |r| r.within(-3.0, 3.0));
    draft.omega = core::array::from_fn(|k| spin * up[k] + kick * about[k]);
    draft
}

fn some_top(r: &mut Random) -> Draft {
    match r.whole(8) {
        0 => free(r, asymmetric),
        1 => near_separatrix(r),
        2 => free(r, symmetric),
        3 => lagrange(r),
        4 => near_threshold(r),
        5 => kovalevskaya(r),
        6 => lagrange_fast(r),
        _ => heavy(r),
    }
}

fn braked(r: &mut Random, which: usize) -> Draft {
    let mut draft = some_top(r);
    draft.frictions[which] = Some(r.scaled(1e-4, 3.0));
    draft
}

fn any_frictions(r: &mut Random) -> Frictions {
    let [pivot, bearing, mut air] = [0; 3].map(|_| r.percent(60).then(|| r.scaled(1e-4, 1.0)));
    if pivot.is_none() && bearing.is_none() {
        air = Some(r.scaled(1e-4, 1.0));
    }
    [pivot, bearing, air, None]
}

fn mixed(r: &mut Random) -> Draft {
    let frictions = any_frictions(r);
    Draft {
        frictions,
        ..some_top(r)
    }
}

/// A symmetric top on a dry tip.
fn dry(r: &mut Random) -> Draft {
    let mut draft = match r.whole(6) {
        0 => {
            let (omega, tilt) = (r.direction(), r.within(0.0, PI));
            on_axis(r, omega, 0.0, tilt)
        }
        1 => near_threshold(r),
        2 => asleep(r),
        3 => waking(r),
        _ => {
            let (weight, tilt) = (r.scaled(1e-2, 5.0), r.within(0.0, PI));
            let omega = r.direction();
            on_axis(r, omega, weight, tilt)
        }
    };
    draft.frictions[TIP] = Some(r.scaled(1e-3, 3.0));
    draft
}

fn mixed_and_dry(r: &mut Random) -> Draft {
    let mut draft = dry(r);
    let [.., tip] = draft.frictions;
    draft.frictions = any_frictions(r);
    draft.frictions[TIP] = tip;
    draft
}

impl Draft {
    /// In units of its own, with its times and what is asked of it.
    fn scaled(self, r: &mut Random) -> Case {
        let plain = r.percent(50);
        let [mut inertia, mut rate, mut mass, mut gravity] = [1.0; 4];
        if !plain {
            (inertia, rate) = (r.scaled(1e-9, 1e9), r.scaled(1e-3, 1e4));
            (mass, gravity) = (r.scaled(1e-3, 1e3), r.sign() * r.scaled(1e-1, 1e2));
        }
        let heavy = self.weight != [0.0; 3];
        let unit = |w: f64| w * inertia * rate * rate / (mass * gravity);
        let mut top = Top {
            moments: self.moments.map(|m| m * inertia),
            mass,
            center: self.weight.map(unit),
            gravity: heavy.then_some(gravity),
            frictions: self.frictions,
        };
        let omega = self.omega.map(|o| o * rate);
        let [x, y, z] = omega;
        let fastest = x.hypot(y).hypot(z).hypot(top.fall());
        let turns = r.scaled(0.01, 300.0);
        let backward = r.percent(30);
        let span = turns / fastest;
        let mean = top.moments.iter().sum::<f64>() / 3.0;
        // Backward, drag makes a body faster and faster.
        let most = if backward { 0.3 } else { f64::INFINITY };
        let least = top.moments.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        let spin = (top.moments[2] * omega[2]).abs();
        let size = if spin > 0.0 { spin } else { mean * fastest };
        let [pivot, bearing, air, tip] = &mut top.frictions;
        for (part, span) in [(pivot, span), (bearing, span), (air, span * fastest)] {
            *part = part.map(|part| part.min(most) * least / span);
        }
        *tip = tip.map(|part| part * size / span);
        let end = if backward { -span } else { span };
        let times = match r.whole(20) {
            0..12 => vec![end],
            12..15 => (1..=30).map(|k| end * f64::from(k) / 30.0).collect(),
            15..18 => {
                let count = 2 + r.whole(9);
                let other = if top.lossy() { 0.0 } else { -0.7 };
                (0..count).map(|_| end * r.within(other, 1.0)).collect()
            }
            18 => vec![0.0, end, 0.5 * end, end],
            _ => (0..=100).map(|k| end * f64::from(k) / 100.0).collect(),
        };
        let spin = if r.percent(40) && !top.moments.contains(&0.0) {
            Spin::AngularMomentum(core::array::from_fn(|k| omega[k] * top.moments[k]))
        } else {
            Spin::Omega(omega)
        };
        Case {
            top,
            spin,
            attitude: door::held(self.attitude),
            times,
            accuracy: r.accuracy(),
        }
    }
}

impl Case {
    /// The scene file.
    pub fn text(&self) -> String {
        let Top {
            moments,
            mass,
            center,
            gravity,
            frictions,
        } = &self.top;
        let attitude = self.attitude;
        let spin = match self.spin {
            Spin::Omega(omega) => format!("omega = {omega:?}"),
            Spin::AngularMomentum(l) => format!("angular_momentum = {l:?}"),
        };
        let mut text = format!(
            "[body]\nmass = {mass:?}\nmoments = {moments:?}\ncenter_of_mass = {center:?}\n[initial]\nattitude = {attitude:?}\n{spin}\n[effects]\n"
        );
        line(&mut text, "gravity", *gravity);
        let names = [
            "pivot_friction",
            "bearing_friction",
            "air_drag",
            "tip_friction",
        ];
        for (name, value) in names.into_iter().zip(*frictions) {
            line(&mut text, name, value);
        }
        let (times, accuracy) = (&self.times, self.accuracy);
        text + &format!("[run]\ntimes = {times:?}\naccuracy = {accuracy:?}\n")
    }

    pub fn start(&self) -> Whole {
        let omega = match self.spin {
            Spin::Omega(omega) => omega.map(Into::into),
            Spin::AngularMomentum(l) => self.top.omega_of(l),
        };
        Whole::new(omega, door::held(self.attitude))
    }

    /// Runs the scene and judges what comes back.
    pub fn judged(&self) -> Outcome {
        let start = self.start();
        self.judged_by(&start, &self.top.motion(&start, &self.times))
    }

    /// The same at its furthest time, for a dozen accuracies from the finest that is answered on: there rounding is amplified to about the accuracy.
    pub fn judged_at_the_edge(mut self) -> Vec<Outcome> {
        let furthest = self
            .times
            .iter()
            .fold(0.0, |most: f64, t| most.max(t.abs()));
        self.times.retain(|t| t.abs() == furthest);
        // At more than one time nobody asks what the cheapest run costs.
        self.times = vec![self.times[0]; 2];
        let start = self.start();
        let truth = self.top.motion(&start, &self.times);
        let mut all: Vec<Outcome> = Vec::new();
        self.accuracy = 2e-13;
        while self.accuracy < 1e-2 && all.len() < 12 {
            let outcome = self.judged_by(&start, &truth);
            if !all.is_empty() || matches!(outcome.given, Given::Answer(_)) {
                all.push(outcome);
            }
            self.accuracy *= 1.3;
        }
        all
    }

    fn judged_by(&self, start: &Whole, truth: &Motion) -> Outcome {
        let unit = truth.fastest.max(f64::MIN_POSITIVE);
        let answer = door::simulate(&self.text());
        let given = match answer {
            Answer::Refused(why) => Given::Refused {
                growth: self.top.growth(start, &self.times, unit),
                why,
            },
            Answer::Motion(motion) => {
                let names = ["qw", "qx", "qy", "qz", "omega1", "omega2", "omega3"];
                let rows = motion.rows(&names);
                assert_eq!(rows.len(), truth.states.len());
                let rows = rows.iter().zip(&truth.states);
                let error = greatest(rows.map(|(row, state)| apart(row, state, unit)));
                // A dry tip's jump has no order.
                let smooth = self.top.frictions[TIP].is_none();
                let cheapest = (smooth && self.times.len() == 1 && motion.evaluations > 0)
                    .then(|| self.cheapest(&truth.states[0], unit))
                    .flatten();
                Given::Answer(verdict::Answer {
                    error,
                    estimate: motion.estimate,
                    evaluations: motion.evaluations,
                    cheapest,
                    solver: motion.solver,
                })
            }
        };
        // A fault is one only where the truth is beyond doubt.
        let doubted = |answer: &verdict::Answer| {
            answer.error > self.accuracy.min(answer.estimate)
                && self.top.doubt(start, &self.times, unit) > 0.1 * answer.error
        };
        let given = match given {
            Given::Answer(answer) if doubted(&answer) => Given::BeyondTheTruth,
            given => given,
        };
        Outcome {
            accuracy: self.accuracy,
            known: !self.top.lossy() && (self.top.gravity.is_none() || self.is_lagrange()),
            given,
        }
    }

    fn is_lagrange(&self) -> bool {
        let m = self.top.moments;
        let c = self.top.center;
        m[0] == m[1] && m[1] == m[2]
            || (0..3).any(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                m[i] == m[j] && c[i] == 0.0 && c[j] == 0.0
            })
    }

    /// The evaluations of the cheapest run of order 8 that is as exact as was asked for: tolerances a quarter of a decade apart.
    fn cheapest(&self, truth: &Whole, unit: f64) -> Option<u64> {
        let start = self.start();
        let top = &self.top;
        let moments = top.moments;
        if moments.contains(&0.0) {
            return None;
        }
        let gravity = top.gravity.unwrap_or(0.0);
        let lever = top.center.map(|c| top.mass * c * gravity);
        let [pivot, bearing, air, tip] = top.frictions.map(|part| part.unwrap_or(0.0));
        let rate = |y: &[f64; 7]| {
            let [o1, o2, o3, w, x, y, z] = *y;
            let (omega, up) = ([o1, o2, o3], vertical([w, x, y, z]));
            let speed = (o1 * o1 + o2 * o2 + o3 * o3).sqrt();
            let spun: [f64; 3] = core::array::from_fn(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let mut torque = (moments[i] - moments[j]) * omega[i] * omega[j];
                torque += up[i] * lever[j] - up[j] * lever[i];
                torque -= pivot * omega[k];
                torque -= air * speed * omega[k];
                if k < 2 {
                    torque -= bearing * omega[k];
                } else if omega[2] != 0.0 {
                    torque -= tip.copysign(omega[2]);
                }
                torque / moments[k]
            });
            let ([a, b, c], [w, x, y, z]) = (spun, turned([w, x, y, z], omega));
            [a, b, c, w, x, y, z]
        };
        let [a, b, c] = start.omega.map(|o| o.value());
        let [w, x, y, z] = start.attitude.map(|q| q.value());
        let first = [a, b, c, w, x, y, z];
        let scales = [unit, unit, unit, 1.0, 1.0, 1.0, 1.0];
        let mut tolerance = (1e3 * self.accuracy).min(1.0);
        while tolerance > 1e-16 {
            let run = door::order_eight_once(rate, &first, &scales, self.times[0], tolerance);
            if let Some((state, evaluations)) = run {
                let [a, b, c, w, x, y, z] = state;
                let norm = (w * w + x * x + y * y + z * z).sqrt();
                let row = [w / norm, x / norm, y / norm, z / norm, a, b, c].map(Dd::from);
                if apart(&row, truth, unit) <= self.accuracy {
                    return Some(evaluations);
                }
            }
            tolerance *= 0.1_f64.powf(0.25);
        }
        None
    }
}

/// Three tops that amplify what steps round to about the accuracy. In the first two a start displaced in one sense does not show it, in the third a doubled
/// distance does.
pub fn with_errors_that_cancel() -> [Case; 3] {
    [
        Case {
            top: Top {
                moments: [
                    0.001_249_061_169_647_670_6,
                    0.001_146_634_726_639_157_4,
                    0.001_316_154_357_761_345_2,
                ],
                mass: 0.223_016_688_800_753_37,
                center: [
                    0.139_994_837_414_894_07,
                    0.050_359_961_102_252_38,
                    0.087_486_428_567_560_17,
                ],
                gravity: Some(98.849_060_970_144_45),
                frictions: [None; 4],
            },
            spin: Spin::Omega([
                -31.911_520_689_711_384,
                5.709_863_162_238_593,
                -4.455_797_993_076_492,
            ]),
            attitude: [
                0.641_863_828_925_662_7,
                -0.011_917_156_951_029_162,
                -0.275_842_755_857_439,
                -0.715_387_713_431_021_6,
            ],
            times: vec![3.261_586_716_461_272],
            accuracy: 1.374e-11,
        },
        Case {
            top: Top {
                moments: [
                    0.459_042_386_650_341_64,
                    0.389_946_716_958_106_34,
                    0.123_220_977_486_348_23,
                ],
                mass: 1.0,
                center: [
                    1.314_681_451_740_883,
                    0.539_462_027_986_096_1,
                    -0.289_538_399_855_924_1,
                ],
                gravity: Some(1.0),
                frictions: [Some(7.236_189_190_184_542e-5), None, None, None],
            },
            spin: Spin::Omega([
                0.057_663_636_081_960_97,
                -0.915_498_174_016_649_6,
                -0.398_168_304_170_469_83,
            ]),
            attitude: [
                0.885_164_982_756_866_2,
                0.242_111_441_403_960_6,
                -0.100_032_302_441_782_02,
                0.384_523_785_623_892_3,
            ],
            times: vec![24.042_642_455_869_764],
            accuracy: 2.097e-12,
        },
        Case {
            top: Top {
                moments: [
                    0.664_721_610_367_746,
                    0.705_907_189_946_307_7,
                    0.130_290_076_871_980_96,
                ],
                mass: 1.0,
                center: [
                    0.012_582_552_608_051_203,
                    -0.001_066_031_029_207_252_3,
                    -0.031_156_018_150_136_8,
                ],
                gravity: Some(1.0),
                frictions: [None; 4],
            },
            spin: Spin::Omega([0.0; 3]),
            attitude: [
                -0.275_551_778_097_035_9,
                -0.610_162_722_570_608_9,
                -0.624_973_139_452_219_4,
                -0.401_473_840_413_071_6,
            ],
            times: vec![112.816_207_307_525_2],
            accuracy: 3.2e-13,
        },
    ]
}

/// How far a row is from the truth: radians, and Ω as a part of `unit`.
fn apart(row: &[Dd], truth: &Whole, unit: f64) -> f64 {
    let found = Whole {
        attitude: [row[0], row[1], row[2], row[3]],
        omega: [row[4], row[5], row[6]],
    };
    let [x, y, z, a, b, c] = truth.to(&found);
    let turned = x.hypot(y).hypot(z);
    greatest([turned, a.hypot(b).hypot(c) / unit])
}
