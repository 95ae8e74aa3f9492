//! The formula to first order, its frame and its error.

use super::*;

// claim: C4.2-4
#[test]
fn s4_2_first_order_formula_and_the_frame() {
    let hit = example();
    let rough = hit.first_order().unwrap();
    close(rough, [0.4, -0.275, 0.7], 1.2e-16);
    let error = (rough - hit.omega_after).norm() / hit.omega_after.norm();
    // Observed 3e-16 absolute: a difference of numbers near 1.
    near!(error, 0.011_314_719_127_849_587_469, 5e-16);

    // The same impact watched from a passing ship: the exact answer and the formula with v−V stay, the printed
    // formula follows the ship.
    let ship = V::new(3.0, 1.0, -2.0);
    let planet = Planet::spherical(M, MOMENT, -ship, V::new(0.0, 0.0, 1.0)).unwrap();
    let seen = strike(&planet, &Meteorite::new(SMALL, v() - ship).unwrap(), x()).unwrap();
    assert_eq!(seen.omega_after, hit.omega_after, "integers: bit for bit");
    assert_eq!(seen.first_order_at_rest().unwrap(), rough);
    assert_eq!(seen.energy_lost, hit.energy_lost);
    let off = (seen.first_order().unwrap() - rough).norm();
    let rest = relative(off, SMALL / MOMENT * x().cross(&ship).norm());
    observed!(rest, 0.0..=4e-16);
    assert!(off > 0.05);

    // I a matrix: "divided by I" means I⁻¹.
    let meteorite = Meteorite::new(1e-3, V::new(3.0, 8.0, -20.0)).unwrap();
    let at = V::new(0.4, -1.0, 1.2);
    let hit = strike(&lopsided(), &meteorite, at).unwrap();
    let change = hit.first_order_at_rest().unwrap() - hit.planet.omega;
    let kick = hit.planet.inertia.angular_momentum(change);
    let expected = 1e-3 * at.cross(&(meteorite.velocity - hit.planet.velocity));
    assert!((kick - expected).norm() < 1e-15 * expected.norm().max(1.0));
}

/// Approximate over exact change of Ω, minus one, for a tangential hit on a resting uniform ball.
fn tangential_excess(mass: f64) -> f64 {
    let planet = Planet::spherical(M, MOMENT, V::zero(), V::zero()).unwrap();
    let meteorite = Meteorite::new(mass, V::new(0.0, 7.0, 0.0)).unwrap();
    let hit = strike(&planet, &meteorite, V::new(1.0, 0.0, 0.0)).unwrap();
    hit.first_order().unwrap().z() / hit.omega_after.z() - 1.0
}

// claim: C4.2-5
#[test]
fn s4_2_size_of_the_error() {
    // Exactly, as fractions: for every m, not only to first order.
    for small in [(1, 1_000_000), (1, 100), (1, 2), (7, 1)].map(|(n, d)| rational(n, d)) {
        let rest = [ZERO; 3];
        let (at, flight) = ([ONE, ZERO, ZERO], [ZERO, whole(7), ZERO]);
        let (_, omega) = balances(ONE, rational(2, 5), small, at, flight, rest, rest);
        let rough = small * whole(7) / rational(2, 5);
        assert_eq!(rough / omega[2] - ONE, rational(7, 2) * small);
    }
    for mass in [0.01, 0.5, 7.0] {
        observed!(relative(tangential_excess(mass), 3.5 * mass), 3e-16..=1e-13);
    }
    // At m/M = 1e-6 the quotient has 3.5e-6 in front of 2e-16: ten digits.
    observed!(relative(tangential_excess(1e-6) * 1e6, 3.5), 1e-11..=1e-10);

    // The parts: recoil gives μ for m, the stuck mass I + μR² for I. On the change of Ω (1+m/M)(I+μR²)/I; a spin Ω⟂
    // that was there is reduced by I/(I+μR²) alone.
    let mass = 0.01;
    let spinning = Planet::spherical(M, MOMENT, V::zero(), V::new(0.0, 0.0, 1.0)).unwrap();
    let dead_weight = Meteorite::new(mass, V::zero()).unwrap();
    let hit = strike(&spinning, &dead_weight, V::new(1.0, 0.0, 0.0)).unwrap();
    let mu = mass / 1.01;
    let off = relative(1.0 / hit.omega_after.z() - 1.0, mu / MOMENT);
    observed!(off, 0.0..=1e-14);
}
