//! 3.2: momentum and its splits for particles and rigid bodies.

use spinning_bodies::Result;
use spinning_bodies::conservation::{Ledger, Particle, Particles};
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{MassProperties, RigidMotion};
use support::{observed, relative};

use super::common::V;

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
fn s3_2_momentum_changes_by_the_outside_force_alone() -> Result<()> {
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
    let moved = ledger.open_vector("P − Ft", start.momentum())?;
    let spin = ledger.open_vector("L about C", start.angular_momentum_split(V::zero()).spin)?;
    let h = 1e-3;
    for step in 1..=2000 {
        state = spring_step(&state, &masses, h, g);
        let now = particles(&state);
        let force = now.force_and_torque(now.center(), |p| p.mass * g)?;
        let t = h * f64::from(step);
        ledger.record_vector(moved, now.momentum() - t * force.force)?;
        ledger.record_vector(spin, now.angular_momentum_split(V::zero()).spin)?;
    }
    // Runge–Kutta keeps linear invariants to rounding: observed 1.5e-14 over 2000 steps. The quadratic L about C it
    // keeps only to its order: observed 2e-10 at this step.
    let drifts: Vec<f64> = ledger
        .entries()
        .iter()
        .map(|e| e.relative_drift())
        .collect();
    observed!(drifts[0], 5e-15..=4e-14, "{ledger}");
    observed!(drifts[1], 7e-11..=4e-10, "{ledger}");
    // Inside forces did something: the springs swung, so relative kinetic energy changed by a lot.
    let change = particles(&state).energy_split().relative - start.energy_split().relative;
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
    observed!(relative(e.of_rotation, f.relative), 1e-16..=1e-15);
    observed!(relative(e.of_motion, f.translational), 0.0..=1e-15);
}
