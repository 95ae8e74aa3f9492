//! The contact as springs.

use super::*;

/// One contact with springs k_n and k_t, integrated by RK4: heights, velocities, stretch; k_n = M = R = 1.
fn contact_by_integration(before: Motion<f64>, kappa: f64, tuning: f64) -> (Motion<f64>, f64) {
    let tangential = tuning * kappa / (1.0 + kappa);
    // Compression and its rate, stretch along the surface, V, RΩ.
    let rate = |_: f64, y: [f64; 5]| {
        let force = -tangential * y[2];
        [y[1], -y[0], y[3] - y[4], force, -force / kappa]
    };
    let start = [0.0, 1.0, 0.0, before.velocity, before.rim_speed];
    let y = runge_kutta(rate, start, (4000, PI / 4000.0), |_| ());
    observed!(y[0].abs(), 5e-16..=6e-14, "the contact has ended");
    (moving(y[3], y[4]), y[2])
}

// claim: C4.6-14, C4.6-3
#[test]
fn s4_6_spring_contact() -> Result<()> {
    let before = moving(1.0, 0.3);
    for kappa in [BALL, 2.0 / 3.0, 1.0] {
        let law = bounce(before, Surface::Floor, kappa);
        let tuned = spring_bounce(before, Surface::Floor, kappa, 1.0)?;
        assert_eq!(tuned.motion, law);
        observed!(tuned.kept_by_spring, 0.0..=1e-31);
        for tuning in [1.0, 0.7, 1.3, 0.0] {
            let (integrated, stretch) = contact_by_integration(before, kappa, tuning);
            let closed = spring_bounce(before, Surface::Floor, kappa, tuning)?;
            // RK4 with 4000 steps; observed 1e-14.
            near!(closed.motion.velocity, integrated.velocity, 1e-13);
            near!(closed.motion.rim_speed, integrated.rim_speed, 1e-13);
            let spring = tuning * kappa / (1.0 + kappa) * stretch * stretch;
            let contact = kappa / (1.0 + kappa) * before.contact_speed(Surface::Floor).powi(2);
            near!(closed.kept_by_spring, spring / contact, 1e-13);
            let missing = before.energy(kappa) - closed.motion.energy(kappa);
            near!(missing, spring, 1e-13);
        }
        for mistuned in [0.7, 1.3] {
            let off = spring_bounce(before, Surface::Floor, kappa, mistuned)?;
            assert!((off.motion.velocity - law.velocity).abs() > 1e-2);
        }
    }
    // The ceiling is the floor with the spin reversed.
    let mirrored = moving(before.velocity, -before.rim_speed);
    let floor = spring_bounce(mirrored, Surface::Floor, BALL, 0.7)?.motion;
    let ceiling = spring_bounce(before, Surface::Ceiling, BALL, 0.7)?.motion;
    assert_eq!(floor, moving(ceiling.velocity, -ceiling.rim_speed));
    Ok(())
}

#[test]
fn a_spring_has_no_speed_beyond_the_doubles() {
    let before = moving(1e308, -1e308);
    refused!(spring_bounce(before, Surface::Floor, 0.4, 1.0), NotFinite);
}
