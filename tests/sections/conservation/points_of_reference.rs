//! 3.2: angular momentum about any point, gravity at the centre of mass.

use super::*;
use spinning_bodies::conservation::angular_momentum_rate;

// claim: C3.2-2, C3.2-3
#[test]
fn s3_2_angular_momentum_about_any_point() {
    // Positions are quadratic in t and L is then quadratic too (v∧a + a∧v cancels), so the central difference
    // over ±1 is the derivative itself, and all numbers are integers or halves.
    for seed in 0..50 {
        let flight = Flight::random(seed);
        let now = flight.at(0.0);
        let origin = integers(&mut Uniform(seed + 1000));
        let u = integers(&mut Uniform(seed + 2000));

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
        // O = C.
        assert_eq!(0.5 * (spin(1.0) - spin(-1.0)), about_center);
    }
    // A velocity parallel to P costs nothing: the contact point of a body that rolls straight.
    let p = V::new(3.0, -6.0, 9.0);
    assert_eq!(angular_momentum_rate(V::zero(), p / 3.0, p), V::zero());
    let aside = angular_momentum_rate(V::zero(), V::new(1.0, 0.0, 0.0), p);
    assert_ne!(aside, V::zero());
}

// claim: C3.2-4, C3.2-5
#[test]
fn s3_2_uniform_gravity_acts_at_the_centre_of_mass() -> Result<()> {
    for seed in 0..20 {
        let body = Flight::random(seed).at(0.0);
        let o = integers(&mut Uniform(seed + 5));
        let g = V::new(1.0, 2.0, -10.0);
        let mass = MASSES.iter().sum();
        let summed = body.force_and_torque(o, |p| p.mass * g)?;
        let at_center = uniform_gravity(mass, body.center(), o, g)?;
        assert_eq!(summed, at_center, "exact: integers and sixteenths");
        let about_c = body.force_and_torque(body.center(), |p| p.mass * g)?;
        assert_eq!(about_c.torque, V::zero());

        // Dimensions: with masses × a, lengths × b, times ÷ c the torque scales by a b² c², as the energy does. Powers
        // of two, so the scaling is exact.
        let (a, b, c) = (8.0, 0.25, 16.0);
        let scaled: Vec<_> = Flight::random(seed)
            .particles(0.0)
            .iter()
            .map(|p| Particle {
                mass: a * p.mass,
                position: b * p.position,
                velocity: b * c * p.velocity,
            })
            .collect();
        let scaled = Particles::new(scaled)?;
        let turned = scaled.force_and_torque(b * o, |p| p.mass * (b * c * c) * g)?;
        let energy = a * b * b * c * c;
        assert_eq!(turned.torque, energy * summed.torque);
        let [before, after] = [&body, &scaled].map(Particles::energy_split);
        assert_eq!(after.translational, energy * before.translational);
        assert_eq!(after.relative, energy * before.relative);
    }
    // Not uniform: a field that grows with height does turn a body about C.
    let body = Flight::random(3).at(0.0);
    let tide =
        body.force_and_torque(body.center(), |p| p.mass * V::new(0.0, 0.0, p.position.x()))?;
    assert!(tide.torque.norm() > 1.0);
    Ok(())
}
