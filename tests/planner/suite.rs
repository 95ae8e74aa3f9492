//! Random tops of every kind, and the truth about them.

use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::geometric::Phase;
use spinning_bodies::scene::top::{Body, Gravity, Listed, PivotFriction, Start, State, Top};
use spinning_bodies::scene::{Absent, Motion, Request, Scene};

use super::taylor::Series;

/// What a top is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Free,
    NearSeparatrix,
    NearlySymmetric,
    Lagrange,
    NearSleeping,
    Fast,
    Kovalevskaya,
    Heavy,
    Braked,
}

/// Kinds and how many there are of each: 240 in all.
pub const KINDS: [(Kind, usize); 9] = [
    (Kind::Free, 20),
    (Kind::NearSeparatrix, 16),
    (Kind::NearlySymmetric, 16),
    (Kind::Lagrange, 28),
    (Kind::NearSleeping, 14),
    (Kind::Fast, 14),
    (Kind::Kovalevskaya, 36),
    (Kind::Heavy, 80),
    (Kind::Braked, 16),
];

/// A top and the times at which it is asked for.
#[derive(Debug, Clone)]
pub struct Case {
    pub kind: Kind,
    pub moments: [f64; 3],
    pub lever: [f64; 3],
    pub friction: f64,
    pub l: [f64; 3],
    pub q: [f64; 4],
    pub times: Vec<f64>,
}

/// Numbers uniform in 0..1, the same on every machine.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }

    /// Evenly in the logarithm.
    fn scaled(&mut self, a: f64, b: f64) -> f64 {
        self.within(a.ln(), b.ln()).exp()
    }

    fn direction(&mut self) -> [f64; 3] {
        loop {
            let v: [f64; 3] = core::array::from_fn(|_| self.within(-1.0, 1.0));
            let square: f64 = v.iter().map(|x| x * x).sum();
            if (0.01..1.0).contains(&square) {
                return v.map(|x| x / square.sqrt());
            }
        }
    }

    fn moments(&mut self) -> [f64; 3] {
        loop {
            let m: [f64; 3] = core::array::from_fn(|_| self.scaled(0.3, 3.0));
            if (0..3).all(|k| m[k] < 0.99 * (m[(k + 1) % 3] + m[(k + 2) % 3])) {
                return m;
            }
        }
    }
}

/// All cases of the suite.
pub fn cases(seed: u64) -> Vec<Case> {
    let mut random = Uniform(seed);
    let mut all = Vec::new();
    for (kind, count) in KINDS {
        all.extend((0..count).map(|n| case(kind, n, &mut random)));
    }
    all
}

fn case(kind: Kind, n: usize, random: &mut Uniform) -> Case {
    let mut moments = random.moments();
    let spin = random.scaled(0.3, 3.0);
    let mut l = random.direction();
    l = core::array::from_fn(|k| l[k] * spin * moments[k]);
    let axis = random.direction();
    let half = random.within(0.0, 1.5);
    let mut q = [half.cos(), 0.0, 0.0, 0.0];
    for k in 0..3 {
        q[k + 1] = axis[k] * half.sin();
    }
    let energy = |m: &[f64; 3], l: &[f64; 3]| (0..3).map(|k| 0.5 * l[k] * l[k] / m[k]).sum::<f64>();
    let mut lever = [0.0; 3];
    let mut friction = 0.0;
    match kind {
        Kind::Free => {}
        Kind::NearSeparatrix => {
            moments.sort_by(f64::total_cmp);
            let [a, b, c] = moments;
            // On the separatrix L1²(1/I1 - 1/I2) = L3²(1/I2 - 1/I3).
            let off = random.scaled(1e-12, 1e-3) * (random.next() - 0.5).signum();
            l[2] = l[0] * ((1.0 / a - 1.0 / b) / (1.0 / b - 1.0 / c)).sqrt() * (1.0 + off);
        }
        Kind::NearlySymmetric => {
            let m = random.within(0.8, 1.2);
            let off = random.scaled(1e-14, 1e-2);
            moments = [m, m * (1.0 + off), random.within(0.3, 1.4)];
            moments.rotate_left(n % 3);
        }
        Kind::Lagrange | Kind::NearSleeping | Kind::Fast => {
            let (m, axial) = (random.within(0.8, 1.2), random.within(0.3, 1.4));
            moments = [m, m, axial];
            let torque = energy(&moments, &l) * random.scaled(1e-2, 5.0);
            lever[2] = torque * (random.next() - 0.3).signum();
            if kind == Kind::NearSleeping {
                // Nearly upright, and spinning within a tenth of the threshold 4 I1 Mgl.
                lever[2] = torque;
                let tilt = random.scaled(1e-8, 1e-1);
                q = [(0.5 * tilt).cos(), (0.5 * tilt).sin(), 0.0, 0.0];
                l = [
                    0.0,
                    0.0,
                    (4.0 * m * torque).sqrt() * random.within(0.9, 1.1),
                ];
            }
            if kind == Kind::Fast {
                l[2] += 10.0 * axial * spin;
            }
            let shift = n % 3;
            moments.rotate_left(shift);
            lever.rotate_left(shift);
            l.rotate_left(shift);
        }
        Kind::Kovalevskaya => {
            let m = random.within(0.3, 1.0);
            moments = [2.0 * m, 2.0 * m, m];
            let torque = energy(&moments, &l) * random.scaled(1e-2, 5.0);
            let angle = random.within(0.0, core::f64::consts::TAU);
            lever = [torque * angle.cos(), torque * angle.sin(), 0.0];
        }
        Kind::Heavy | Kind::Braked => {
            let torque = energy(&moments, &l) * random.scaled(1e-3, 10.0);
            lever = random.direction().map(|x| x * torque);
            if kind == Kind::Braked {
                friction = random.scaled(1e-3, 1e-1) * spin * moments[0];
            }
        }
    }
    let mut case = Case {
        kind,
        moments,
        lever,
        friction,
        l,
        q,
        times: Vec::new(),
    };
    let turns = random.scaled(0.5, 25.0);
    let end = turns * core::f64::consts::TAU / case.fastest();
    // One sample, a few, or a film.
    let count = [1, 1, 1, 5, 1, 1, 1, 50][n % 8];
    case.times = (1..=count)
        .map(|k| end * f64::from(k) / f64::from(count))
        .collect();
    case
}

impl Case {
    /// The scale of Ω, as scenes have it: Ω, and what a fall from upright would make of it.
    pub fn fastest(&self) -> f64 {
        let omega: f64 = (0..3).map(|k| (self.l[k] / self.moments[k]).powi(2)).sum();
        let weight = self.lever.iter().map(|x| x * x).sum::<f64>().sqrt();
        let least = self.moments.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        omega.sqrt().hypot((2.0 * weight / least).sqrt())
    }

    fn parts(&self) -> (Body, Start) {
        let [x, y, z] = self.lever;
        let body = Body::new(self.moments).unwrap();
        let body = body
            .with_center_of_mass(1.0, BodyVector::new(x, y, z))
            .unwrap();
        let [a, b, c] = self.l;
        let [w, x, y, z] = self.q;
        let attitude = Attitude::from_quaternion(w, x, y, z).unwrap();
        let start = Start::with_angular_momentum(BodyVector::new(a, b, c), attitude);
        (body, start)
    }

    /// The scene, with unit gravity: MgC is the lever.
    pub fn scene(&self) -> Box<dyn Scene<State = State>> {
        let (body, start) = self.parts();
        let heavy = self.lever != [0.0; 3];
        let listed = Listed {
            gravity: heavy.then(|| Gravity::new(1.0).unwrap()),
            pivot_friction: (self.friction != 0.0)
                .then(|| PivotFriction::new(self.friction).unwrap()),
            ..Listed::default()
        };
        listed.on(body, start).unwrap()
    }

    /// The same as a type, for those without friction.
    #[allow(dead_code, reason = "the benchmark asks for it")]
    pub fn top(&self) -> Top<Gravity> {
        let (body, start) = self.parts();
        let top: Top<Absent> = Top::new(body, start).unwrap();
        top.with_gravity(Gravity::new(1.0).unwrap())
    }

    pub fn request(&self, accuracy: f64) -> Request {
        let request = Request::at(self.times.clone()).unwrap();
        request.to_accuracy(accuracy).unwrap()
    }

    /// L and attitude at the start.
    pub fn start(&self) -> Phase {
        let [w, x, y, z] = self.q;
        let attitude = Attitude::from_quaternion(w, x, y, z).unwrap();
        let [a, b, c] = self.l;
        Phase::new(BodyVector::new(a, b, c), &attitude)
    }

    /// The truth at the first, the middle and the last time: place and phase.
    pub fn truth(&self, order: usize) -> Vec<(usize, Phase)> {
        let series = Series::new(self.moments, self.lever, self.friction, order);
        let last = self.times.len() - 1;
        let mut places = vec![0, last / 2, last];
        places.dedup();
        let start = self.start();
        places
            .into_iter()
            .map(|n| (n, series.at(&start, self.times[n])))
            .collect()
    }

    /// The most that a motion is off: attitude in radians, Ω in its scale.
    pub fn error(&self, motion: &Motion<State>, truth: &[(usize, Phase)]) -> f64 {
        let mut worst = 0.0_f64;
        for (n, phase) in truth {
            let state = motion.rows[*n].1;
            let turned = state.attitude.angle_to(&phase.attitude().unwrap());
            let omega = state.omega.components();
            let off: f64 = (0..3)
                .map(|k| (omega[k] - phase.l[k] / self.moments[k]).powi(2))
                .sum();
            worst = worst.max(turned).max(off.sqrt() / self.fastest());
        }
        worst
    }
}
