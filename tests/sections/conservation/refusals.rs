//! No number makes the ledger panic, or its drift not a number.

use super::*;

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
            prop_assert!(!entry.relative_drift().is_nan());
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
                prop_assert!(star.rotation.is_finite() && star.energy_ratio.is_finite());
            }
            if let Ok(star) = MaclaurinSpheroid::from_axis_ratio(value) {
                prop_assert!(star.rotation.is_finite() && star.energy_ratio.is_finite());
            }
            let _ = JacobiEllipsoid::from_axis_ratio(value);
        }
    }
}
