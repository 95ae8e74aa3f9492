//! 3.2: momentum and its splits for particles and rigid bodies.

use super::*;
use spinning_bodies::inertia::RigidMotion;

/// Places and velocities of the three.
fn parts(state: &[f64; 18]) -> [[V; 3]; 2] {
    let of = |k: usize| V::new(state[k], state[k + 1], state[k + 2]);
    [[0, 3, 6].map(of), [9, 12, 15].map(of)]
}

/// Three masses on springs and under gravity: how the state changes.
fn swing(state: &[f64; 18], masses: [f64; 3], g: V) -> [f64; 18] {
    let [places, velocities] = parts(state);
    let pulls = [0, 1, 2].map(|i| {
        let springs = places.map(|place| {
            let d = place - places[i];
            let own = d == V::zero();
            let strain = if own { 0.0 } else { 1.0 - 1.0 / d.norm() };
            40.0 * strain * d
        });
        g + springs.into_iter().sum::<V>() / masses[i]
    });
    let rates = [velocities, pulls];
    core::array::from_fn(|i| rates[i / 9][i / 3 % 3].components()[i % 3])
}

// claim: C3.2-1
#[test]
fn s3_2_momentum_changes_by_the_outside_force_alone() -> Result<()> {
    let masses = [1.0, 2.5, 0.5];
    let g = V::new(0.3, -0.2, -9.8);
    let state = [
        0.0, 0.0, 0.0, 1.3, 0.0, 0.0, 0.2, 1.1, 0.4, 1.0, 0.0, 2.0, 0.0, -1.0, 0.0, -2.0, 0.5, 0.0,
    ];
    let particles = |state: &[f64; 18]| {
        let [places, velocities] = parts(state);
        Particles::new([0, 1, 2].map(|k| Particle {
            mass: masses[k],
            position: places[k],
            velocity: velocities[k],
        }))
        .unwrap()
    };
    let start = particles(&state);
    let mut ledger = Ledger::new();
    let moved = ledger.open_vector("P − Ft", start.momentum())?;
    let spin = ledger.open_vector("L about C", start.angular_momentum_split(V::zero()).spin)?;
    let (h, mut steps) = (1e-3, 0.0);
    let rate = |_: f64, state: [f64; 18]| swing(&state, masses, g);
    let end = runge_kutta(rate, state, (2000, h), |state| {
        let now = particles(state);
        steps += 1.0;
        let force = now.force_and_torque(now.center(), |p| p.mass * g).unwrap();
        let left = now.momentum() - h * steps * force.force;
        ledger.record_vector(moved, left).unwrap();
        let turning = now.angular_momentum_split(V::zero()).spin;
        ledger.record_vector(spin, turning).unwrap();
    });
    // Runge–Kutta keeps linear invariants to rounding: observed 1.5e-14 over 2000 steps. The quadratic L about C it
    // keeps only to its order: observed 2e-10 at this step.
    let drift = |line: usize| ledger.entries()[line].relative_drift();
    observed!(drift(0), 5e-15..=4e-14, "{ledger}");
    observed!(drift(1), 7e-11..=4e-10, "{ledger}");
    // Inside forces did something: the springs swung, so relative kinetic energy changed by a lot.
    let change = particles(&end).energy_split().relative - start.energy_split().relative;
    assert!(change.abs() > 0.1, "{change}");
    Ok(())
}

/// Splits of 2.2 and 2.3, which 3.2 builds on, and the rigid body as a special case of particles.
#[test]
fn s3_2_splits_and_the_rigid_body() {
    // Four masses fixed to a body: the rigid body composed of them, in motion, against the masses one by one.
    let parts = [
        (1.0, 1.0, 2.0, 0.0),
        (1.0, -1.0, 0.5, 1.0),
        (2.0, 0.0, -1.5, 2.0),
        (0.5, 0.0, -1.0, -3.0),
    ]
    .map(|(m, x, y, z)| MassProperties::particle(m, vector([x, y, z])).unwrap());
    let body = MassProperties::compose(&parts).unwrap();
    let motion = RigidMotion {
        base: body.center(),
        velocity: vector([1.0, 2.0, 3.0]),
        omega: vector([0.7, -1.1, 2.0]),
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
        within((left - right).norm(), 1e-15 * right.norm());
    }
    assert_eq!(parts.orbital, V::zero());
    let (e, f) = (motion.energy(&body).unwrap(), swarm.energy_split());
    observed!(relative(e.of_rotation, f.relative), 1e-16..=1e-15);
    observed!(relative(e.of_motion, f.translational), 0.0..=1e-15);
}
