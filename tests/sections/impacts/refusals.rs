//! What is refused, and that nothing panics.

use super::*;
use support::any;

#[test]
fn what_is_refused() {
    let ball = |mass, moment| Planet::spherical(mass, moment, V::zero(), V::zero());
    refused!(ball(0.0, 1.0), NotPositive);
    refused!(ball(f64::NAN, 1.0), NotFinite);
    refused!(ball(1.0, -1.0), NotPositive);
    refused!(Meteorite::new(-1.0, v()), NotPositive);
    let endless = V::new(f64::INFINITY, 0.0, 0.0);
    refused!(Meteorite::new(1.0, endless), NotFinite);
    // A needle does not resist a turn about itself.
    let needle = InertiaMatrix::diagonal(0.0, 1.0, 1.0).unwrap();
    refused!(Planet::new(1.0, needle, V::zero(), V::zero()), NotPositive);
    let planet = ball(1.0, 1.0).unwrap();
    let meteorite = Meteorite::new(1.0, v()).unwrap();
    let nowhere = V::new(f64::NAN, 0.0, 0.0);
    refused!(strike(&planet, &meteorite, nowhere), NotFinite);
    // A planet that does not spin has no axis to tilt; a hit on the centre does not start it spinning.
    let hit = strike(&planet, &meteorite, V::zero()).unwrap();
    refused!(hit.tilt(), ZeroVector);
    refused!(hit.closing_speed(), ZeroVector);
    assert!(grazing_mass_ratio(0.4, 1.0, 1.0, 4.0).is_err());
}

fn moderate() -> impl Strategy<Value = V> {
    [-5.0..5.0_f64, -5.0..5.0, -5.0..5.0].prop_map(|[a, b, c]| V::new(a, b, c))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn nothing_panics_on_any_input(n in prop::collection::vec(any(), 12)) {
        let planet = Planet::spherical(n[0], n[1], V::new(n[2], n[3], n[4]), V::new(n[5], n[6], n[7]));
        let meteorite = Meteorite::new(n[8], V::new(n[9], n[10], n[11]));
        if let (Ok(planet), Ok(meteorite)) = (planet, meteorite)
            && let Ok(hit) = strike(&planet, &meteorite, V::new(n[2], n[7], n[11]))
        {
            prop_assert!(hit.omega_after.is_finite() && hit.velocity_after.is_finite());
            prop_assert!(hit.energy_lost.is_finite());
            let _ = (hit.first_order(), hit.first_order_at_rest(), hit.closing_speed());
            if let Ok(tilt) = hit.tilt() {
                prop_assert!((0.0..=3.2).contains(&tilt));
            }
        }
        let _ = grazing_mass_ratio(n[0], n[1], n[2], n[3]);
    }

    #[test]
    fn balances_and_dissipation_for_any_impact(at in moderate(), flight in moderate(), mass in 1e-6..100.0_f64) {
        let planet = lopsided();
        let hit = strike(&planet, &Meteorite::new(mass, flight).unwrap(), at).unwrap();
        let (momentum, spin) = defects(&hit);
        // Relative to masses up to 100 kg, 9 m, 20 m/s: observed 3e-16 of the product.
        prop_assert!(momentum.norm() < 1e-15 * (1.0 + mass) * 20.0, "{:?}", momentum);
        prop_assert!(spin.norm() < 1e-15 * (1.0 + mass) * 180.0, "{:?}", spin);
        prop_assert!(hit.energy_lost >= 0.0);
    }

    /// Turning all vectors and the body turns the answer.
    #[test]
    fn axes_do_not_matter(at in moderate(), flight in moderate(), w in moderate()) {
        use spinning_bodies::frame::{Attitude, SpaceVector};
        let attitude = Attitude::from_quaternion(1.0, w.x(), w.y(), w.z()).unwrap();
        let turn = |vector: V| {
            let turned: SpaceVector = attitude.to_space(vector);
            V::from_components(turned.components())
        };
        let planet = lopsided();
        let there = Planet::new(5.0, planet.inertia.rotated(&attitude), turn(planet.velocity), turn(planet.omega)).unwrap();
        let here = strike(&planet, &Meteorite::new(0.3, flight).unwrap(), at).unwrap();
        let there = strike(&there, &Meteorite::new(0.3, turn(flight)).unwrap(), turn(at)).unwrap();
        prop_assert!((turn(here.omega_after) - there.omega_after).norm() < 2e-14);
    }
}
