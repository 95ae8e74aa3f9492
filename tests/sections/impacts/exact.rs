//! The exact solution, its balances, and a capture by springs.

use super::*;

fn rational_example() -> (Q3, Q3) {
    balances(
        ONE,
        rational(2, 5),
        rational(1, 100),
        [rational(3, 5), ZERO, rational(4, 5)],
        [whole(-10), whole(-20), whole(5)],
        [ZERO; 3],
        [ZERO, ZERO, ONE],
    )
}

// claim: C4.2-3
#[test]
fn s4_2_exact_solution() {
    let (velocity, omega) = rational_example();
    let known = [(412, 1035), (-55, 207), (242, 345)].map(|(n, d)| rational(n, d));
    assert_eq!(omega, known);
    let known = [(-2026, 20907), (-206, 1035), (334, 6969)].map(|(n, d)| rational(n, d));
    assert_eq!(velocity, known);
    // Observed: 1.2e-16 and 3e-17, within 2 ulp of each component.
    let hit = example();
    close(hit.omega_after, omega.map(exact), 2.3e-16);
    close(hit.velocity_after, velocity.map(exact), 6e-17);

    // The matrix is the inertia of the joined body about its own centre: L about that centre, from the composed body.
    let round = InertiaMatrix::diagonal(MOMENT, MOMENT, MOMENT).unwrap();
    let alone = MassProperties::new(M, V::zero(), round).unwrap();
    let stuck = MassProperties::particle(SMALL, x()).unwrap();
    let joined = MassProperties::compose(&[alone, stuck]).unwrap();
    let mu = M * SMALL / (M + SMALL);
    let l = joined.inertia().angular_momentum(hit.omega_after);
    let brought = MOMENT * V::new(0.0, 0.0, 1.0) + mu * x().cross(&v());
    within((l - brought).norm(), 2e-16 * brought.norm().max(1.0));

    // With scalar I the component of Ω along x does not change.
    let along = x().dot(&(hit.omega_after - hit.planet.omega));
    observed!(along.abs(), 0.0..=1.2e-16);

    // Twenty more with a moving planet, all fractions: the float answer follows the rational one.
    for k in 1..=20_i128 {
        let (at, flight) = (
            [rational(k, 7), rational(-2, 3), rational(1, k)],
            [rational(-3, 2), rational(k, 4), whole(9)],
        );
        let (velocity, omega) = (
            [rational(1, 3), rational(-k, 5), TWO],
            [rational(1, k), whole(3), rational(-1, 2)],
        );
        let (big, moment, small) = (whole(3), rational(k + 1, 2), rational(k, 10));
        let truth = balances(big, moment, small, at, flight, velocity, omega);
        let vector = |value: Q3| vector(value.map(exact));
        let (v, turning) = (vector(velocity), vector(omega));
        let planet = Planet::spherical(exact(big), exact(moment), v, turning).unwrap();
        let meteorite = Meteorite::new(exact(small), vector(flight)).unwrap();
        let hit = strike(&planet, &meteorite, vector(at)).unwrap();
        // Absolute, numbers up to 10: observed 2e-15.
        close(hit.velocity_after, truth.0.map(exact), 4e-15);
        close(hit.omega_after, truth.1.map(exact), 4e-15);
    }
}

// claim: C4.2-1, C4.2-2
#[test]
fn s4_2_both_balances_hold() {
    let (momentum, spin) = defects(&example());
    // m v is 0.23, x∧mv 0.19. Observed 1.5e-17 and 3e-17.
    observed!(momentum.norm(), 0.0..=4e-17, "{momentum:?}");
    observed!(spin.norm(), 0.0..=8e-17, "{spin:?}");

    let meteorite = Meteorite::new(0.7, V::new(3.0, 8.0, -20.0)).unwrap();
    let hit = strike(&lopsided(), &meteorite, V::new(0.4, -1.0, 1.2)).unwrap();
    let (momentum, spin) = defects(&hit);
    // m v is 15, x∧mv 15. Observed 2e-15 and 4e-15.
    observed!(momentum.norm(), 0.0..=4e-15, "{momentum:?}");
    observed!(spin.norm(), 0.0..=8e-15, "{spin:?}");
}

/// A meteorite caught by a spring of `stiffness` N/m and a damper instead of at once: Ω of the planet, and
/// the total angular momentum about the origin at the end. Classical Runge–Kutta; nothing in it knows 4.2.
fn capture(stiffness: f64) -> (V, V) {
    let damping = 2.0 * (stiffness * SMALL).sqrt();
    // X, V, Ω, anchor seen from X, x_m, v_m.
    let parts = |y: &[f64; 18]| [0, 3, 6, 9, 12, 15].map(|k| V::new(y[k], y[k + 1], y[k + 2]));
    let together = |parts: [V; 6]| core::array::from_fn(|i| parts[i / 3].components()[i % 3]);
    let rate = |_: f64, y: [f64; 18]| {
        let [center, velocity, omega, anchor, place, flight] = parts(&y);
        let arm = place - center;
        let stretch = arm - anchor;
        let closing = flight - velocity - omega.cross(&arm);
        let force = -stiffness * stretch - damping * closing;
        // Action and reaction at the meteorite's place, so the angular momentum balances exactly.
        let (push, twist) = (-force / M, -arm.cross(&force) / MOMENT);
        together([
            velocity,
            push,
            twist,
            omega.cross(&anchor),
            flight,
            force / SMALL,
        ])
    };
    let start = together([V::zero(), V::zero(), V::new(0.0, 0.0, 1.0), x(), x(), v()]);
    // Thirty times the time constant of the spring, in 3000 steps.
    let time = 30.0 * (SMALL / stiffness).sqrt();
    let end = runge_kutta(rate, start, (3000, time / 3000.0), |_| ());
    let [center, velocity, omega, _, place, flight] = parts(&end);
    let l = MOMENT * omega + M * center.cross(&velocity) + SMALL * place.cross(&flight);
    (omega, l)
}

// claim: C4.2-1, C4.2-2
#[test]
fn s4_2_brute_force_capture() {
    let exact = example().omega_after;
    let error = |stiffness| (capture(stiffness).0 - exact).norm();
    // 4e6 N/m, over in 1.5 ms.
    let (omega, l) = capture(4e6);
    // Observed 8.25e-6, the trace of half a millimetre of stretch.
    let off = (omega - exact).norm();
    observed!(off, 2e-6..=1e-5);
    let before = MOMENT * V::new(0.0, 0.0, 1.0) + SMALL * x().cross(&v());
    assert!((l - before).norm() < 1e-12 * before.norm());
    // Sticking at once is the limit: a hundred times the stiffness, a tenth of the difference.
    observed!(relative(error(4e6) / error(4e8), 10.0), 5e-6..=1e-3);
}
