//! Section 3 of the tutorial: conservation laws, the ledger, and the star that turns.

#![expect(
    clippy::excessive_precision,
    reason = "expected values keep all the digits they were computed to"
)]

use approx::assert_relative_eq;
use num_rational::Ratio;
use proptest::prelude::*;
use spinning_bodies::conservation::{
    CompensatedSum, ForceAndTorque, Law, Ledger, Particle, Particles, angular_momentum_rate,
    uniform_gravity,
};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::inertia::{MassProperties, RigidMotion};
use spinning_bodies::phenomena::Waist;
use spinning_bodies::rotating_fluid::{JacobiEllipsoid, MaclaurinSpheroid};

type V = SpaceVector;

/// Small random integers as a linear congruential sequence: with them, and a total mass of 16, every sum below is
/// exact in double precision, so the laws can be asserted with `==`.
struct Integers(u64);

impl Integers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 40) as u32 % 17) - 8.0
    }

    fn vector(&mut self) -> V {
        V::new(self.next(), self.next(), self.next())
    }
}

const MASSES: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 6.0];

/// Five particles in uniformly accelerated flight, and their state at any time.
struct Flight {
    start: Vec<(V, V, V)>,
}

impl Flight {
    fn random(seed: u64) -> Self {
        let mut random = Integers(seed);
        let start = MASSES.map(|_| (random.vector(), random.vector(), random.vector()));
        Self {
            start: start.to_vec(),
        }
    }

    fn at(&self, t: f64) -> Particles {
        let particles: Vec<_> = MASSES
            .iter()
            .zip(&self.start)
            .map(|(&mass, &(x, v, a))| Particle {
                mass,
                position: x + t * v + (0.5 * t * t) * a,
                velocity: v + t * a,
            })
            .collect();
        Particles::new(particles).unwrap()
    }

    /// Force and torque about `point` now: what makes the particles accelerate as they do.
    fn forces(&self, point: V) -> ForceAndTorque {
        let mut accelerations = self.start.iter().map(|&(_, _, a)| a);
        self.at(0.0)
            .force_and_torque(point, |p| p.mass * accelerations.next().unwrap())
            .unwrap()
    }
}

// claim: C3.2-2, C3.2-3
#[test]
fn s3_2_angular_momentum_about_any_point() {
    // Positions are quadratic in t and L is then quadratic too (v∧a + a∧v cancels), so the central difference
    // over ±1 is the derivative itself, and all numbers are integers or halves.
    for seed in 0..50 {
        let flight = Flight::random(seed);
        let now = flight.at(0.0);
        let origin = Integers(seed + 1000).vector();
        let u = Integers(seed + 2000).vector();

        let rate = |about: &dyn Fn(f64) -> V| {
            let after = flight.at(1.0).angular_momentum_about(about(1.0));
            let before = flight.at(-1.0).angular_momentum_about(about(-1.0));
            0.5 * (after - before)
        };
        let n = flight.forces(origin).torque;
        assert_eq!(rate(&|_| origin), n, "O at rest, seed {seed}");

        // A moving O adds −Ut∧P(t), again quadratic: the same difference is exact.
        let derivative = rate(&|t| origin + t * u);
        let expected = angular_momentum_rate(n, u, now.momentum());
        assert_eq!(derivative, expected, "moving O, seed {seed}");
        let extra = expected - n;
        assert_eq!(extra, -u.cross(&now.momentum()));

        // About C the extra term vanishes although C moves and accelerates.
        let about_center = flight.forces(now.center()).torque;
        let spin = |t: f64| flight.at(t).angular_momentum_split(V::zero()).spin;
        assert_eq!(
            0.5 * (spin(1.0) - spin(-1.0)),
            about_center,
            "O = C, seed {seed}"
        );
    }
    // A velocity parallel to P costs nothing: the contact point of a body that rolls straight.
    let p = V::new(3.0, -6.0, 9.0);
    assert_eq!(angular_momentum_rate(V::zero(), p / 3.0, p), V::zero());
    assert_ne!(
        angular_momentum_rate(V::zero(), V::new(1.0, 0.0, 0.0), p),
        V::zero()
    );
}

/// Three masses on springs and under gravity, one Runge–Kutta step of the fourth order.
fn spring_step(state: &[(V, V)], masses: &[f64], h: f64, g: V) -> Vec<(V, V)> {
    let rate = |s: &[(V, V)]| -> Vec<(V, V)> {
        (0..s.len())
            .map(|i| {
                let mut force = masses[i] * g;
                for j in (0..s.len()).filter(|&j| j != i) {
                    let d = s[j].0 - s[i].0;
                    force += 40.0 * (1.0 - 1.0 / d.norm()) * d;
                }
                (s[i].1, force / masses[i])
            })
            .collect()
    };
    let shifted = |k: &[(V, V)], h: f64| -> Vec<(V, V)> {
        state
            .iter()
            .zip(k)
            .map(|(s, k)| (s.0 + h * k.0, s.1 + h * k.1))
            .collect()
    };
    let k1 = rate(state);
    let k2 = rate(&shifted(&k1, 0.5 * h));
    let k3 = rate(&shifted(&k2, 0.5 * h));
    let k4 = rate(&shifted(&k3, h));
    (0..state.len())
        .map(|i| {
            let x = k1[i].0 + 2.0 * k2[i].0 + 2.0 * k3[i].0 + k4[i].0;
            let v = k1[i].1 + 2.0 * k2[i].1 + 2.0 * k3[i].1 + k4[i].1;
            (state[i].0 + (h / 6.0) * x, state[i].1 + (h / 6.0) * v)
        })
        .collect()
}

// claim: C3.2-1
#[test]
fn s3_2_momentum_changes_by_the_outside_force_alone() {
    let masses = [1.0, 2.5, 0.5];
    let g = V::new(0.3, -0.2, -9.8);
    let mut state = vec![
        (V::new(0.0, 0.0, 0.0), V::new(1.0, 0.0, 2.0)),
        (V::new(1.3, 0.0, 0.0), V::new(0.0, -1.0, 0.0)),
        (V::new(0.2, 1.1, 0.4), V::new(-2.0, 0.5, 0.0)),
    ];
    let particles = |state: &[(V, V)]| {
        let list: Vec<_> = masses
            .iter()
            .zip(state)
            .map(|(&mass, &(position, velocity))| Particle {
                mass,
                position,
                velocity,
            })
            .collect();
        Particles::new(list).unwrap()
    };
    let start = particles(&state);
    let mut ledger = Ledger::new();
    let moved = ledger.open_vector("P − Ft", start.momentum()).unwrap();
    let spin = ledger
        .open_vector("L about C", start.angular_momentum_split(V::zero()).spin)
        .unwrap();
    let h = 1e-3;
    for step in 1..=2000 {
        state = spring_step(&state, &masses, h, g);
        let now = particles(&state);
        let force = now.force_and_torque(now.center(), |p| p.mass * g).unwrap();
        let t = h * f64::from(step);
        ledger
            .record_vector(moved, now.momentum() - t * force.force)
            .unwrap();
        ledger
            .record_vector(spin, now.angular_momentum_split(V::zero()).spin)
            .unwrap();
    }
    // Runge–Kutta keeps linear invariants to rounding: observed 1.5e-14 over 2000 steps. The quadratic L about C it
    // keeps only to its order: observed 2e-10 at this step.
    let drifts: Vec<f64> = ledger
        .entries()
        .iter()
        .map(|e| e.relative_drift())
        .collect();
    assert!(drifts[0] < 4e-14, "{ledger}");
    assert!(drifts[1] < 4e-10, "{ledger}");
    // Inside forces did something: the springs swung, so relative kinetic energy changed by a lot.
    let change = particles(&state).energy_split().relative - start.energy_split().relative;
    assert!(change.abs() > 0.1, "{change}");
}

// claim: C3.2-4, C3.2-5
#[test]
fn s3_2_uniform_gravity_acts_at_the_centre_of_mass() {
    for seed in 0..20 {
        let body = Flight::random(seed).at(0.0);
        let o = Integers(seed + 5).vector();
        let g = V::new(1.0, 2.0, -10.0);
        let summed = body.force_and_torque(o, |p| p.mass * g).unwrap();
        let at_center = uniform_gravity(body.mass(), body.center(), o, g).unwrap();
        assert_eq!(summed, at_center, "exact: integers and sixteenths");
        let about_c = body
            .force_and_torque(body.center(), |p| p.mass * g)
            .unwrap();
        assert_eq!(about_c.torque, V::zero());
        assert_eq!(summed.about(body.center() - o), about_c);

        // Dimensions: with masses × a, lengths × b, times ÷ c the torque scales by a b² c², as the energy does. Powers
        // of two, so the scaling is exact.
        let (a, b, c) = (8.0, 0.25, 16.0);
        let scaled: Vec<_> = body
            .particles()
            .iter()
            .map(|p| Particle {
                mass: a * p.mass,
                position: b * p.position,
                velocity: b * c * p.velocity,
            })
            .collect();
        let scaled = Particles::new(scaled).unwrap();
        let torque = scaled
            .force_and_torque(b * o, |p| p.mass * (b * c * c) * g)
            .unwrap()
            .torque;
        assert_eq!(torque, (a * b * b * c * c) * summed.torque);
        assert_eq!(
            scaled.energy_split().total(),
            a * b * b * c * c * body.energy_split().total()
        );
    }
    // Not uniform: a field that grows with height does turn a body about C.
    let body = Flight::random(3).at(0.0);
    let tide = body
        .force_and_torque(body.center(), |p| p.mass * V::new(0.0, 0.0, p.position.x()))
        .unwrap();
    assert!(tide.torque.norm() > 1.0);
}

/// Splits of 2.2 and 2.3, which 3.2 builds on, and the rigid body as a special case of particles.
#[test]
fn s3_2_splits_and_the_rigid_body() {
    let flight = Flight::random(11).at(0.0);
    let o = V::new(1.0, -2.0, 5.0);
    assert_eq!(
        flight.angular_momentum_split(o).total(),
        flight.angular_momentum_about(o)
    );
    let direct: f64 = flight
        .particles()
        .iter()
        .map(|p| 0.5 * p.mass * p.velocity.dot(&p.velocity))
        .sum();
    assert_eq!(flight.energy_split().total(), direct);

    // Four masses fixed to a body: the rigid body composed of them, in motion, against the masses one by one.
    let parts = [
        (1.0, 1.0, 2.0, 0.0),
        (1.0, -1.0, 0.5, 1.0),
        (2.0, 0.0, -1.5, 2.0),
        (0.5, 0.0, -1.0, -3.0),
    ]
    .map(|(m, x, y, z)| MassProperties::particle(m, BodyVector::new(x, y, z)).unwrap());
    let body = MassProperties::compose(&parts).unwrap();
    let motion = RigidMotion {
        base: body.center(),
        velocity: BodyVector::new(1.0, 2.0, 3.0),
        omega: BodyVector::new(0.7, -1.1, 2.0),
    };
    let attitude = Attitude::from_quaternion(0.3, -0.4, 0.5, 0.7).unwrap();
    let swarm = Particles::new(parts.map(|part| Particle {
        mass: part.mass(),
        position: attitude.to_space(part.center()),
        velocity: attitude.to_space(motion.velocity_at(part.center())),
    }))
    .unwrap();
    let l = motion.angular_momentum(&body).unwrap();
    let parts = swarm.angular_momentum_split(swarm.center());
    // Observed 4e-16 relative.
    for (left, right) in [
        (l.of_rotation, parts.spin),
        (motion.momentum(&body), swarm.momentum()),
    ] {
        let left = attitude.to_space(left);
        assert!(
            (left - right).norm() < 1e-15 * right.norm(),
            "{left:?} {right:?}"
        );
    }
    assert_eq!(parts.orbital, V::zero());
    let (e, f) = (motion.energy(&body).unwrap(), swarm.energy_split());
    assert_relative_eq!(
        e.of_rotation,
        f.relative,
        max_relative = 1e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(
        e.of_motion,
        f.translational,
        max_relative = 1e-15,
        epsilon = 0.0
    );
}

// claim: C3.3-1
#[test]
fn s3_3_energy_with_heat() {
    // Exactly, as fractions: sliding ends when the speed V₀ − τ meets the rim speed τ/κ, τ = μgt.
    type Q = Ratio<i128>;
    for (kappa, kept, heat) in [
        (Q::new(2, 5), Q::new(5, 7), Q::new(2, 7)),
        (Q::new(2, 3), Q::new(3, 5), Q::new(2, 5)),
        (Q::new(1, 2), Q::new(2, 3), Q::new(1, 3)),
        (Q::new(1, 1), Q::new(1, 2), Q::new(1, 2)),
    ] {
        let one = Q::from_integer(1);
        let tau = kappa / (kappa + one);
        let speed = one - tau;
        assert_eq!(speed, tau / kappa, "it rolls");
        assert_eq!(speed, kept);
        let slip = tau - tau * tau * (one + kappa.recip()) / 2; // × V₀²/(μg)
        let energy = speed * speed * (one + kappa) / 2;
        assert_eq!(
            Q::new(1, 2) - energy,
            slip,
            "lost energy = μMg × slip distance"
        );
        assert_eq!(slip * 2, heat);
    }
    // The same by force alone, Coulomb friction integrated in small steps, watched by the ledger.
    let (mass, radius, mu, g, v0) = (0.17, 0.028, 0.2, 9.80665, 2.0);
    let inertia = 0.4 * mass * radius * radius;
    let (mut v, mut omega) = (v0, 0.0);
    let mut heat = CompensatedSum::new();
    let kinetic = |v: f64, omega: f64| 0.5 * mass * v * v + 0.5 * inertia * omega * omega;
    let e0 = kinetic(v, omega);
    let mut ledger = Ledger::new();
    let with_heat = ledger.open("energy with heat", Law::Conserved, e0).unwrap();
    let without = ledger
        .open("kinetic energy", Law::NonIncreasing, e0)
        .unwrap();
    let warm = ledger
        .open_scaled("heat", Law::NonDecreasing, 0.0, e0)
        .unwrap();
    let h = 1e-6;
    while v - radius * omega > 0.0 {
        let friction = mu * mass * g;
        let slip = v - radius * omega;
        v -= h * friction / mass;
        omega += h * friction * radius / inertia;
        // The trapezoidal rule is exact for a slip speed that falls linearly.
        heat.add(friction * h * 0.5 * (slip + v - radius * omega));
        ledger
            .record(with_heat, kinetic(v, omega) + heat.value())
            .unwrap();
        ledger.record(without, kinetic(v, omega)).unwrap();
        ledger.record(warm, heat.value()).unwrap();
    }
    // Sliding is left one step late at most: μgh/V₀ = 1e-6 of the speed. Observed 4e-7 and 1e-7.
    assert_relative_eq!(v / v0, 5.0 / 7.0, max_relative = 1e-6, epsilon = 0.0);
    assert_relative_eq!(
        heat.value() / e0,
        2.0 / 7.0,
        max_relative = 1e-6,
        epsilon = 0.0
    );
    // The books balance to rounding all the way, 291 000 steps. The last, overshooting step can return at most
    // (μgh)² of kinetic energy, far below the bound.
    assert!(ledger.is_kept_within(1e-11).unwrap(), "{ledger}");
    assert_eq!(ledger.entries()[0].records(), ledger.entries()[2].records());
}

// claim: C3.4-1
#[test]
fn s3_4_equal_and_opposite_is_not_enough() {
    let particle = |x, y| Particle {
        mass: 1.0,
        position: V::new(x, y, 0.0),
        velocity: V::zero(),
    };
    let pair = Particles::new([particle(0.0, 0.0), particle(1.0, 0.0)]).unwrap();
    let sideways = pair.internal_torque(|_, _| V::new(0.0, 1.0, 0.0)).unwrap();
    assert_eq!(sideways, V::new(0.0, 0.0, -1.0));
    let central = pair
        .internal_torque(|a, b| 7.0 * (a.position - b.position))
        .unwrap();
    assert_eq!(central, V::zero());

    let swarm = Flight::random(77).at(0.0);
    let square = |a: &Particle, b: &Particle| {
        let d = a.position - b.position;
        d.dot(&d) * d
    };
    assert_eq!(swarm.internal_torque(square).unwrap(), V::zero());
    // The same torque about any point, since the forces sum to zero; here the twisted forces have one.
    let twisted = swarm
        .internal_torque(|a, b| V::new(1.0, 0.0, 0.0).cross(&(a.position - b.position)))
        .unwrap();
    assert!(twisted.norm() > 1.0);
}

/// Potential coefficient A_i of a spheroid by Simpson's rule, straight from its definition
/// a²c ∫ du/(Δ (a_i²+u)) with u = c² s²/(1−s)².
fn coefficient_by_quadrature(q: f64, along: f64) -> f64 {
    let n = 4000;
    let integrand = |s: f64| {
        if s >= 1.0 {
            return 0.0;
        }
        let u = q * q * s * s / ((1.0 - s) * (1.0 - s));
        let du = 2.0 * q * q * s / (1.0 - s).powi(3);
        q / ((1.0 + u) * (q * q + u).sqrt() * (along * along + u)) * du
    };
    let h = 1.0 / f64::from(n);
    (0..=n)
        .map(|i| {
            let weight = if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * integrand(h * f64::from(i)) * h / 3.0
        })
        .sum()
}

// claim: C3.5-1
#[test]
fn s3_5_maclaurin_spheroids() {
    // Against 32 digits, in units of machine epsilon. Observed: 4 and 4.
    let (mut worst, mut worst_ratio) = (0.0_f64, 0.0_f64);
    for line in include_str!("reference/maclaurin.csv").lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let star = MaclaurinSpheroid::from_eccentricity(row[0]).unwrap();
        worst = worst.max((star.rotation() / row[1] - 1.0).abs() / f64::EPSILON);
        worst_ratio = worst_ratio.max((star.energy_ratio() / row[2] - 1.0).abs() / f64::EPSILON);
    }
    assert!(worst <= 4.5, "{worst} ulp");
    assert!(worst_ratio <= 4.5, "{worst_ratio} ulp");

    let rotation = |e| MaclaurinSpheroid::from_eccentricity(e).unwrap().rotation();
    assert_relative_eq!(
        rotation(0.6),
        0.201_352_059_619_914_088_2,
        max_relative = 4e-16,
        epsilon = 0.0
    );
    assert_eq!(rotation(0.0), 0.0);
    assert_relative_eq!(
        rotation(1e-8),
        8.0 / 15.0 * 1e-16,
        max_relative = 4e-16,
        epsilon = 0.0
    );
    // The disc: πq.
    let disc = MaclaurinSpheroid::from_axis_ratio(1e-12).unwrap();
    assert_relative_eq!(
        disc.rotation(),
        std::f64::consts::PI * 1e-12,
        max_relative = 3e-12,
        epsilon = 0.0
    );

    // Ω²/(πGρ) = 2(A₁ − A₃c²/a²) with the coefficients integrated. Simpson's error here: observed 2e-13.
    for q in [0.3_f64, 0.6, 0.9] {
        let star = MaclaurinSpheroid::from_axis_ratio(q).unwrap();
        let (a1, a3) = (
            coefficient_by_quadrature(q, 1.0),
            coefficient_by_quadrature(q, q),
        );
        assert_relative_eq!(2.0 * a1 + a3, 2.0, max_relative = 1e-12, epsilon = 0.0);
        assert_relative_eq!(
            star.rotation(),
            2.0 * (a1 - a3 * q * q),
            max_relative = 1e-11,
            epsilon = 0.0
        );
    }

    // Expected values of the register, 20 digits. Observed: 2 ulp at most.
    let fastest = MaclaurinSpheroid::fastest();
    assert_relative_eq!(
        fastest.eccentricity(),
        0.929_955_685_456_232_994_18,
        max_relative = 5e-16,
        epsilon = 0.0
    );
    assert_relative_eq!(
        fastest.rotation(),
        0.449_331_412_123_913_854_36,
        max_relative = 9e-16,
        epsilon = 0.0
    );
    for e in [0.5, 0.9, 0.929, 0.931, 0.95] {
        assert!(rotation(e) < fastest.rotation());
    }
}

// claim: C3.5-1
#[test]
fn s3_5_jacobi_ellipsoids_branch_off() {
    let branch = MaclaurinSpheroid::at_jacobi_bifurcation();
    assert_relative_eq!(
        branch.eccentricity(),
        0.812_670_010_611_742_949_48,
        max_relative = 2e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(
        branch.rotation(),
        0.374_229_674_786_195_634_35,
        max_relative = 2e-15,
        epsilon = 0.0
    );
    // An independent closed form of the same condition: arcsin e = e√(1−e²)(3+10e²)/(3+8e²−8e⁴) (Chandrasekhar 1969).
    let e2 = branch.eccentricity().powi(2);
    let closed = branch.eccentricity() * (1.0 - e2).sqrt() * (3.0 + 10.0 * e2)
        / (3.0 + 8.0 * e2 - 8.0 * e2 * e2);
    assert_relative_eq!(
        branch.eccentricity().asin(),
        closed,
        max_relative = 3e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(
        branch.energy_ratio(),
        0.137_528,
        max_relative = 3e-6,
        epsilon = 0.0
    );

    // Jacobi's own sequence: starts where it branches, turns slower as it lengthens (models of the field: six digits).
    let start = JacobiEllipsoid::from_axis_ratio(1.0).unwrap();
    assert_relative_eq!(
        start.rotation(),
        branch.rotation(),
        max_relative = 2e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(
        start.angular_momentum(),
        branch.angular_momentum(),
        max_relative = 2e-15,
        epsilon = 0.0
    );
    for (b, c, rotation) in [
        (0.9, 0.551_873, 0.372_567),
        (0.7, 0.478_110, 0.355_679),
        (0.5, 0.383_309, 0.309_557),
        (0.432_232, 0.345_069, 0.284_030),
    ] {
        let star = JacobiEllipsoid::from_axis_ratio(b).unwrap();
        assert_relative_eq!(star.axes()[2], c, max_relative = 2e-6, epsilon = 0.0);
        assert_relative_eq!(
            star.rotation(),
            rotation,
            max_relative = 2e-6,
            epsilon = 0.0
        );
        assert!(star.angular_momentum() > branch.angular_momentum());
    }
    // Twenty digits from quadrature in multiple precision. Observed 7e-16.
    for (b, c, rotation) in [
        (
            0.5,
            0.383_308_578_573_099_843_7,
            0.309_557_013_747_839_172_16,
        ),
        (
            0.1,
            0.096_815_242_566_304_156_552,
            0.060_472_160_195_441_782_64,
        ),
    ] {
        let star = JacobiEllipsoid::from_axis_ratio(b).unwrap();
        assert_relative_eq!(star.axes()[2], c, max_relative = 1.2e-15, epsilon = 0.0);
        assert_relative_eq!(
            star.rotation(),
            rotation,
            max_relative = 1.2e-15,
            epsilon = 0.0
        );
    }
    // As near to 1 as one likes, without a jump from the limit a²−b² → 0.
    let near = JacobiEllipsoid::from_axis_ratio(1.0 - 1e-9).unwrap();
    assert_relative_eq!(
        near.axes()[2],
        branch.axis_ratio(),
        max_relative = 2e-9,
        epsilon = 0.0
    );
}

// claim: C3.5-3, C1.1-3
#[test]
fn s3_5_a_body_that_changes_shape_turns_without_angular_momentum() {
    let body = Waist {
        upper_arms_out: 3.0,
        upper_arms_in: 1.0,
        lower: 1.0,
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let turn = body.swivel_angle(quarter).unwrap();
    assert_relative_eq!(
        turn,
        -std::f64::consts::FRAC_PI_8,
        max_relative = 4e-16,
        epsilon = 0.0
    );

    // At zero angular momentum, A(β' + ψ') + Bβ' = 0: integrate the four phases at an uneven pace, arms moving in
    // phases two and four, when nothing turns. Midpoint rule in a pace s(u) = u³; the turn is linear in ψ: exact.
    let mut beta = CompensatedSum::new();
    let mut l = Ledger::new();
    let none = l
        .open_scaled("angular momentum", Law::Conserved, 0.0, 1.0)
        .unwrap();
    for (upper, from, to) in [(3.0, 0.0, quarter), (1.0, quarter, 0.0)] {
        let steps = 1000;
        let psi = |i: i32| from + (to - from) * (f64::from(i) / f64::from(steps)).powi(3);
        for i in 0..steps {
            let twist = psi(i + 1) - psi(i);
            let lower = -upper * twist / (upper + 1.0);
            beta.add(lower);
            l.record(none, upper * (lower + twist) + lower).unwrap();
        }
        if upper == 3.0 {
            assert_relative_eq!(
                beta.value(),
                -3.0 * std::f64::consts::FRAC_PI_8,
                max_relative = 1e-15,
                epsilon = 0.0
            );
        }
    }
    assert_relative_eq!(beta.value(), turn, max_relative = 2e-15, epsilon = 0.0);
    assert!(l.is_kept_within(1e-17).unwrap(), "{l}");
    for (still, twist) in [
        (
            Waist {
                upper_arms_in: 3.0,
                ..body
            },
            quarter,
        ),
        (Waist { lower: 0.0, ..body }, quarter),
        (body, 0.0),
    ] {
        assert_eq!(still.swivel_angle(twist).unwrap(), 0.0);
    }
    assert!(
        Waist {
            lower: 1e300,
            ..body
        }
        .swivel_angle(quarter)
        .unwrap()
        .abs()
            < 1e-299
    );
}

fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![
        -10.0..10.0_f64,
        any::<f64>(),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(0.0),
        Just(f64::MAX),
        Just(5e-324),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn nothing_panics_and_no_drift_is_nan(values in prop::collection::vec(anything(), 9)) {
        let vector = V::new(values[0], values[1], values[2]);
        let mut ledger = Ledger::new();
        let scalars = [Law::Conserved, Law::NonIncreasing, Law::NonDecreasing]
            .map(|law| ledger.open("x", law, values[3]));
        let line = ledger.open_vector("l", vector);
        for &value in &values {
            for account in scalars.iter().flatten() {
                let _ = ledger.record(*account, value);
            }
            if let Ok(line) = line {
                let _ = ledger.record_vector(line, V::new(value, values[4], values[5]));
            }
        }
        for entry in ledger.entries() {
            prop_assert!(!entry.relative_drift().is_nan() && !entry.absolute_drift().is_nan());
            if values.iter().any(|v| !v.is_finite()) {
                prop_assert!(entry.relative_drift() == f64::INFINITY);
            }
        }
        let particle = Particle { mass: values[6], position: vector, velocity: V::new(values[3], values[4], values[5]) };
        if let Ok(swarm) = Particles::new([particle, particle]) {
            let _ = (swarm.energy_split(), swarm.angular_momentum_split(vector));
            let _ = swarm.force_and_torque(vector, |p| values[7] * p.velocity);
            let _ = swarm.internal_torque(|p, _| values[8] * p.velocity);
        }
        let _ = uniform_gravity(values[0], vector, vector, vector);
        let _ = Waist { upper_arms_out: values[0], upper_arms_in: values[1], lower: values[2] }.swivel_angle(values[3]);
        for value in values {
            if let Ok(star) = MaclaurinSpheroid::from_eccentricity(value) {
                prop_assert!(star.rotation().is_finite() && star.energy_ratio().is_finite());
            }
            if let Ok(star) = MaclaurinSpheroid::from_axis_ratio(value) {
                prop_assert!(star.rotation().is_finite() && star.energy_ratio().is_finite());
            }
            let _ = JacobiEllipsoid::from_axis_ratio(value);
        }
    }
}
