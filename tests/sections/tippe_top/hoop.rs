//! The hoop with clay: the tutorial's estimate, what it leaves out, and the full motion.

use super::*;
use spinning_bodies::tippe_top::HoopWithClay;

/// The tutorial's toy: R = 2 cm, 50 turns a second, μ = 1/3.
fn toy(alpha: f64, gravity: f64) -> HoopWithClay {
    HoopWithClay::new(0.02, 0.02, alpha, 0.4, 1.0 / 3.0, gravity).unwrap()
}

const SPIN: f64 = 100.0 * PI;

/// The toy with clay, α off its centre, let go at a tilt with a spin about the vertical, under friction 1/3.
fn rubbed(alpha: f64, (tilt, spin): (f64, f64), gravity: f64) -> TableTop {
    let toy = bodies::hoop_with_clay(0.02, 0.02, alpha).unwrap();
    let start = Start::about_vertical(tilt, 0.0, spin).unwrap();
    on_a_table(toy, start, gravity, regularised(1.0 / 3.0))
}

#[test]
fn s4_7_hoop_with_clay() {
    // claim: C4.7-3
    // A bare hoop is not roughly spherical: 1/2, 1/2, 1.
    let hoop = shapes::hoop(1.0, 1.0).unwrap();
    assert_eq!(hoop.inertia().principal_axes().moments, [0.5, 0.5, 1.0]);
    let body = bodies::hoop_with_clay(0.02, 0.02, 0.1).unwrap();
    close!(body.center().norm(), 0.1 * 0.02, 0.0..=1e-15);
    // Without clay nothing happens: the contact does not slip, so there is no friction.
    let bare = bodies::hoop_with_clay(0.02, 0.02, 0.0).unwrap();
    let start = Start::about_vertical(0.3, 0.0, SPIN).unwrap();
    let scene = on_a_table(bare, start, G, viscous(0.3));
    let end = last(&run(&scene, 1.0, 10, 1e-9));
    near!(end.tilt(), 0.3, 0.0..=2e-15);
    near!(end.spin(), SPIN, 5e-15..=6e-13);
}

#[test]
fn s4_7_slip_at_the_contact_and_torque_of_friction() {
    // claim: C4.7-4, C4.7-5, C4.7-6, C4.7-17, C4.7-18
    let hoop = toy(0.1, G);
    let (f, r, offset) = (0.02 * G / 3.0, 0.02, 0.002);
    for i in 1..40 {
        // Picture i below the horizontal, picture j above it: nothing changes sign.
        let theta = PI * f64::from(i) / 40.0;
        let slip = hoop.slip(theta, SPIN);
        assert!(slip.y() > 0.0, "into the page");
        close!(slip.norm(), SPIN * offset * theta.sin(), 0.0..=1e-14);
        let torque = hoop.torque(theta);
        let (sine, cosine) = theta.sin_cos();
        let expected = SpaceVector::new(r - offset * cosine, 0.0, offset * sine) * -f;
        assert!((torque - expected).norm() < 1e-15 * f * r);
        // Mostly horizontal.
        assert!(torque.z().abs() < 0.12 * torque.x().abs());
        // d(L·e)/dt = N·e = −R f sin θ, exactly.
        let e = SpaceVector::new(theta.sin(), 0.0, theta.cos());
        observed!((torque.dot(&e) + r * f * theta.sin()).abs(), 0.0..=3e-18);
        assert!(hoop.refined_rate(SPIN, 0.0, theta) > 0.0, "and θ grows");
    }
}

#[test]
fn s4_7_tip_over_time() {
    // claim: C4.7-9, C4.7-10
    let toy = toy(0.1, 10.0);
    let refined = toy.refined_time(SPIN, 0.0, PI);
    close!(refined, 2.164_216_504_307_684, 0.0..=1e-14);
    // The closed form against a quadrature of the rate.
    let sum = integral(|theta| 1.0 / toy.refined_rate(SPIN, 0.0, theta), 0.0, PI);
    close!(sum, refined, 0.0..=4e-15);
    // Without offset the text's value.
    let round = self::toy(0.0, 10.0);
    let off = relative(round.refined_time(SPIN, 0.0, PI), round.tip_over_time(SPIN));
    observed!(off, 0.0..=1e-15);
}

#[test]
fn s4_7_tilt_grows_at_about_the_estimated_rate() {
    // claim: C4.7-8, C4.7-10
    for (alpha, spin, simulated, refined) in
        [(0.1, SPIN, 1.7678, 1.754), (0.05, 600.0, 3.5018, 3.495)]
    {
        let hoop = toy(alpha, 10.0);
        let formula = hoop.refined_time(spin, 0.3, PI - 0.3);
        near!(formula, refined, 1e-4..=1e-3);
        let scene = rubbed(alpha, (0.3, spin), 10.0);
        let rows = run(&scene, 4.0, 2000, 1e-6);
        let t = |level| passage(&rows, |s| s.tilt(), level).unwrap_or(0.0);
        // The start counts as the first passage, unless the transient dips below it.
        let time = t(PI - 0.3) - t(0.3).min(0.1);
        observed!((time / simulated - 1.0).abs(), 1e-6..=3e-5);
        observed!((time / formula - 1.0).abs(), 2e-3..=0.02);
    }
}

#[test]
fn s4_7_the_tutorials_estimate_against_the_full_motion() {
    // claim: C4.7-8, C4.7-13
    let rows = run(&rubbed(0.1, (0.1, SPIN), G), 2.4, 2400, 1e-6);
    let t = |level| passage(&rows, degrees, level).unwrap();
    near!(t(165.0), 2.0, 8e-4..=0.1);
    // Past the horizontal it goes on rising, where centrifugal force alone would hold it back.
    assert!(t(120.0) > t(90.0) && t(150.0) > t(120.0));
    let hoop = toy(0.1, G);
    let pull = |theta: f64| hoop.centrifugal_potential(theta, SPIN);
    assert!(pull(1.6) > pull(PI / 2.0) && pull(1.5) > pull(PI / 2.0));
    assert_eq!(pull(1.0), pull(PI - 1.0).min(pull(1.0)));
}

#[test]
fn s4_7_jellett_and_the_angular_momentum() {
    // claim: C4.7-7, C4.7-15
    let scene = rubbed(0.1, (0.3, SPIN), 10.0);
    let rows = run(&scene, 1.8, 900, 1e-9);
    observed!(drift(&rows, |s| s.jellett), 0.0..=8e-15);
    // L, vertical up to a tremble, falls as Jellett's integral says.
    let until = passage(&rows, |s| s.tilt(), PI - 0.3).unwrap();
    let body = bodies::hoop_with_clay(0.02, 0.02, 0.1).unwrap();
    let (mut lean, mut ratio) = (0.0_f64, 1.0);
    let length = body.inertia().angular_momentum(rows[0].1.omega).norm();
    for (_, state) in rows.iter().filter(|row| row.0 <= until) {
        let l = body.inertia().angular_momentum(state.omega);
        let across = l.cross(&state.up()).norm();
        lean = lean.max(across.atan2(state.vertical_angular_momentum));
        ratio = l.norm() / length;
    }
    assert!(lean < 0.012);
    let expected = toy(0.1, 10.0).spin_ratio(0.3, PI - 0.3);
    close!(expected, 0.825_594_313_771_396_4, 0.0..=1e-14);
    near!(ratio, expected, 1e-5..=2e-4);
}

#[test]
fn s4_7_window_of_validity() {
    // claim: C4.7-11
    // ε Ω² is only three times μ g: no inversion.
    near!(toy(0.05, 10.0).validity(100.0), 3.0, 1e-14);
    let slow = rubbed(0.05, (0.1, 100.0), 10.0);
    assert!(most(&run(&slow, 3.0, 600, 1e-6), |s| s.tilt()) < 2.5);
}

#[test]
fn s4_7_sluggish_spin_rises_part_of_the_way() -> Result<()> {
    // claim: C4.7-12, C4.7-19
    // Centimetres and grams, as in the register.
    let g = 1000.0;
    let top = TippeTop::new(1.0, 2.0, 0.1, 1.6, 1.6, g)?;
    for (spin, end) in [
        (28.0, 0.0),
        (36.0, 1.084),
        (40.0, 1.612),
        (45.0, 2.315),
        (60.0, PI),
    ] {
        let tilt = top.final_tilt(top.jellett_of_spin(spin, 0.0), 0.0)?;
        near!(tilt, end, 8e-5..=1e-2, "{spin}: {tilt}");
        let start = Start::about_vertical(0.02, 0.0, spin)?;
        let scene = on_a_table(top.body()?, start, g, viscous(0.02));
        let rows = run(&scene, 30.0, 300, 1e-6);
        near!(last(&rows).tilt(), tilt, 1e-3..=0.03);
        if spin == 40.0 {
            // cos θ = (R² + ε² − J √(R/(I M g)))/(2 R ε), J = I Ω (R − ε).
            close!(tilt, 1.611_976_789_532_037_5, 0.0..=3e-15);
            let slip = |i: usize| rows[i].1.slip.norm();
            let greatest = most(&rows, |s| s.slip.norm());
            assert!(slip(300) < 0.02 * greatest && slip(300) < slip(240));
        }
    }
    Ok(())
}
