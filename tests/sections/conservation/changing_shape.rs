//! 3.5: a body that changes its shape turns without angular momentum.

use super::*;

// claim: C3.5-3, C1.1-3
#[test]
fn s3_5_a_body_that_changes_shape_turns_without_angular_momentum() {
    let body = Waist {
        upper_arms_out: 3.0,
        upper_arms_in: 1.0,
        lower: 1.0,
    };
    let quarter = FRAC_PI_2;
    let turn = body.swivel_angle(quarter).unwrap();
    observed!(relative(turn, -FRAC_PI_8), 0.0..=4e-16);

    // At zero angular momentum, A(β' + ψ') + Bβ' = 0: integrate the four phases at an uneven pace, arms moving in
    // phases two and four, when nothing turns. Midpoint rule in a pace s(u) = u³; the turn is linear in ψ: exact.
    let mut beta = Dd::ZERO;
    let mut l = Ledger::new();
    let none = l.open_scaled("angular momentum", Law::Conserved, 0.0, 1.0);
    let none = none.unwrap();
    for (upper, from, to) in [(3.0, 0.0, quarter), (1.0, quarter, 0.0)] {
        let steps = 1000;
        let psi = |i: i32| from + (to - from) * (f64::from(i) / f64::from(steps)).powi(3);
        for i in 0..steps {
            let twist = psi(i + 1) - psi(i);
            let lower = -upper * twist / (upper + 1.0);
            beta = beta + Dd::from(lower);
            l.record(none, upper * (lower + twist) + lower).unwrap();
        }
        if upper == 3.0 {
            let off = relative(beta.value(), -3.0 * FRAC_PI_8);
            observed!(off, 0.0..=1e-15);
        }
    }
    observed!(relative(beta.value(), turn), 0.0..=2e-15);
    assert!(l.is_kept_within(1e-17).unwrap(), "{l}");
    let upper_arms_in = body.upper_arms_out;
    let held = Waist {
        upper_arms_in,
        ..body
    };
    let [light, heavy] = [0.0, 1e300].map(|lower| Waist { lower, ..body });
    for (still, twist) in [(held, quarter), (light, quarter), (body, 0.0)] {
        assert_eq!(still.swivel_angle(twist).unwrap(), 0.0);
    }
    observed!(heavy.swivel_angle(quarter).unwrap().abs(), 0.0..=1e-299);
}
