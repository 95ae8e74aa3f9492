//! 7.4: released from a tilt, the top dips, draws something close to a cycloid, and settles.

use super::*;

const TILT: f64 = FRAC_PI_3;

// claim: C7.4-1
#[test]
fn s7_4_released_it_dips() {
    let expected = [
        (2.0, 0.0),
        (5.0, 0.43514832519349639086),
        (10.0, 0.48469865573747429242),
        (20.0, 0.49623122715401389267),
    ];
    for (l3, lowest) in expected {
        let top = released(TILT, l3);
        assert_eq!(top.kind(), Nutation::Cusps);
        let [h1, h2, _] = roots(&top);
        // The start is the upper root: whatever comes next is lower.
        near!(h2, 0.5, 0.0..=3e-16);
        near!(h1, lowest, 0.0..=3e-16);
        for t in [1e-3, -1e-3, 0.02] {
            assert!(at(&top, t).height < 0.5);
        }
        near!(at(&top, 0.5 * top.period()).height, lowest, 0.0..=3e-16);
        // λ − √(λ² − 2λh₀ + 1) with λ = L₃²/4, as a quotient.
        let lambda: f64 = 0.25 * l3 * l3;
        let closed = (lambda - 1.0) / (lambda + (lambda * lambda - lambda + 1.0).sqrt());
        near!(closed, lowest, 0.0..=3e-16);
    }
}

// claim: C7.4-2
#[test]
fn s7_4_nearly_a_cycloid() {
    let mut deviations = Vec::new();
    for l3 in [5.0, 10.0, 20.0] {
        let top = released(TILT, l3);
        let amplitude = TILT.sin() / (l3 * l3);
        let period = top.period();
        let worst = |height_only: bool, stretched: bool| {
            (0..=400).fold(0.0, |worst: f64, k| {
                let part = f64::from(k) / 400.0;
                let u = TAU * part;
                let tilt = at(&top, part * period).height.acos() - TILT;
                let off = (tilt - amplitude * (1.0 - u.cos())).abs();
                if height_only {
                    return worst.max(off);
                }
                let azimuth = gained_azimuth(&top, part * period, 8);
                let along = azimuth * if stretched { 1.0 } else { TILT.sin() };
                let ahead = (along - amplitude * (u - u.sin())).abs();
                worst.max(off).max(ahead)
            }) / amplitude
        };
        assert!(worst(true, false) <= worst(false, false));
        // Against φ itself, without sin θ₀, it is no cycloid however fast the spin.
        assert!(worst(false, true) > 0.8, "{}", worst(false, true));
        deviations.push(worst(false, false));
    }
    for (deviation, expected) in deviations.iter().zip([0.358, 0.0934, 0.0235]) {
        near!(*deviation, expected, 5.1e-4 * f64::max(1.0, expected * 2.0));
    }
    near!(deviations[2], 0.0235113, 2e-8..=2e-7);
    // The approach is as 1/L₃².
    within((deviations[1] / deviations[2] - 4.0).abs(), 0.05);
    within((deviations[2] * 400.0 - 9.4).abs(), 0.01);
}

// claim: C7.4-3
#[test]
fn s7_4_mean_precession_and_nutation() {
    let ten = released(TILT, 10.0);
    let expected = 0.063765492185492136721;
    let error = (ten.precession_per_nutation().unwrap() / expected - 1.0).abs();
    observed!(error, 0.0..=2e-14);
    close!(ten.period(), 0.63454896882682277416, 0.0..=3e-16);
    let mut off = Vec::new();
    for l3 in [5.0, 10.0, 20.0] {
        let top = released(TILT, l3);
        let precession = top.mean_precession_rate().unwrap() * l3 - 1.0;
        let nutation = TAU / top.period() / l3 - 1.0;
        off.push([precession, nutation].map(|x| x * l3 * l3));
    }
    // Both tend to 1 as L₃⁻²: the differences times L₃² settle.
    for [a, b, c] in [0, 1].map(|k| [off[0][k], off[1][k], off[2][k]]) {
        assert!([a, b, c].iter().all(|x| x.abs() < 2.0), "{a} {b} {c}");
        assert!((c - b).abs() < 0.3 * (b - a).abs(), "{a} {b} {c}");
    }
}

// claim: C7.4-4
#[test]
fn s7_4_damped_nutation_settles_to_the_slow_precession() {
    // Damping −0.3 θ' along the line of nodes: L₃ = 2 and L_vert = 1 survive. RK4 in (θ, θ').
    let (l3, vertical, damping) = (2.0, 1.0, 0.3);
    let precession = |theta: f64| (vertical - l3 * theta.cos()) / theta.sin().powi(2);
    let rate = |_: f64, [theta, speed]: [f64; 2]| {
        let w = precession(theta);
        let (sine, h) = theta.sin_cos();
        [speed, (w * w * h - l3 * w + 1.0) * sine - damping * speed]
    };
    let y = runge_kutta(rate, [TILT, 0.0], (40_000, 0.01), |_| ());
    let h = y[0].cos();
    near!(h, 0.2487264104239672447862852, 0.0..=2e-15);
    let w = precession(y[0]);
    near!(w, 0.5356873867918730526614059, 1e-16..=3e-15);
    // It is the slower root of h w² − L₃w + Mgl = 0.
    let slow = 2.0 / (l3 + (l3 * l3 - 4.0 * h).sqrt());
    near!(w, slow, 1e-16..=3e-15);
    // There the library's top precesses and does not nutate. The undamped one from the same start does not settle.
    let top = spun(y[0], 0.0, w, l3);
    observed!(band(&top), 1e-16..=4e-15);
    near!(at(&top, 30.0).height, h, 2e-16..=3e-15);
    let [h1, h2, _] = roots(&released(TILT, l3));
    assert!(h1 < 1e-15 && h2 > 0.4999);
}
