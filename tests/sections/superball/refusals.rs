//! What is refused, and that nothing panics.

use super::*;

#[test]
fn superball_refuses_what_is_no_ball() {
    refused!(BounceRotation::new(f64::NAN), NotFinite);
    refused!(BounceRotation::new(1.1), OutOfRange);
    refused!(BounceRotation::of_fraction(1, 0), NotPositive);
    let start = moving(1.0, 0.0);
    refused!(spring_bounce(start, Surface::Floor, 0.4, -1.0), Negative);
    let exact_start = moving(ONE, ZERO);
    let far = moving(whole(i128::MAX), whole(-1));
    for (start, kappa) in [(exact_start, whole(-1)), (far, KAPPA)] {
        assert_eq!(checked_bounce(start, Surface::Floor, kappa), None);
    }
}

proptest! {
    #[test]
    fn superball_never_panics(v in any::<f64>(), w in any::<f64>(), kappa in any::<f64>(), tuning in any::<f64>(), n in any::<u64>()) {
        let start = moving(v, w );
        let _ = bounce(start, Surface::Ceiling, kappa);
        let _ = (UnderTable::new(start, kappa).positions().nth(5), reach(kappa));
        let _ = spring_bounce(start, Surface::Floor, kappa, tuning);
        if let Ok(rotation) = BounceRotation::new(kappa) {
            let _ = (rotation.angle(), rotation.after(start, n));
        }
    }

    #[test]
    fn superball_bounces_back_the_way_it_came(v in -10i128..10, w in -10i128..10, k in 1i128..20) {
        let start = moving(rational(v, 3), rational(w, 7));
        let kappa = rational(k, 20);
        for surface in [Surface::Floor, Surface::Ceiling] {
            let after = bounce(start, surface, kappa);
            prop_assert_eq!(bounce(after, surface, kappa), start);
            prop_assert_eq!(checked_bounce(start, surface, kappa), Some(after));
        }
    }
}
