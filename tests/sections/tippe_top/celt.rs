//! Chirality of rolling: celt-ended tops, the register's chiral top, the rattleback.

use super::*;
use spinning_bodies::tippe_top::rolling_growth_rates;

#[test]
fn s4_7_celt_ended_tops() {
    // claim: C4.7-14
    let first = bodies::celt_ended_top(0.288, [0.351, 0.550, 0.505], 0.745, 0.144).unwrap();
    let second = bodies::celt_ended_top(0.265, [0.261, 0.507, 0.406], 0.845, 0.129).unwrap();
    for (body, spin, time, up, down, rest) in [
        (first, 102.4, 0.20, 144.0, 7.8, 0.3),
        (second, 62.6, 1.32, 90.0, 9.4, 0.15),
    ] {
        let scene = |sense: f64| {
            let start = Start::about_vertical(3f64.to_radians(), 20f64.to_radians(), sense * spin);
            on_a_table(body, start.unwrap(), G, regularised(0.5))
        };
        let over = run(&scene(1.0), 2.0, 1000, 1e-3);
        let under = run(&scene(-1.0), 3.0, 600, 1e-3);
        let at = passage(&over, degrees, 90.0).unwrap();
        observed!((at / time - 1.0).abs(), 4e-3..=0.015);
        assert!(most(&over, degrees) > up);
        assert!((most(&under, degrees) - down).abs() < 0.2);
        assert!(degrees(&last(&under)) < 2.0 * rest);
    }
}

/// The register's body, in centimetres and grams: semi-axes 2.13, 1.87, 1.83, C 0.06 below the centre, inertia turned by −0.39.
fn skew(turn: f64) -> ConvexBody {
    let turn = Attitude::about_axis(vector([0.0, 0.0, 1.0]), turn).unwrap();
    let inertia = InertiaMatrix::from_matrix(Matrix3::from_diagonal(&[1.3, 2.33, 2.26].into()));
    let surface = Surface::ellipsoid([2.13, 1.87, 1.83]).unwrap();
    let center = vector([0.0, 0.0, 0.06]);
    ConvexBody::new(1.0, inertia.unwrap().rotated(&turn), surface, center).unwrap()
}

#[test]
fn s4_7_an_ellipsoid_with_skew_inertia_is_chiral() {
    // claim: C4.7-14
    let law = viscous(0.009);
    let growth = |body: &ConvexBody, spin: f64| {
        quasi_steady(body, 981.0, law, spin).unwrap().growth_rates[0].growth
    };
    let body = skew(-0.39);
    near!(growth(&body, 55.0), 4.0672, 6e-6..=2e-4);
    observed!((growth(&body, -55.0) + 0.0958).abs(), 1e-5..=2e-4);
    // The mirror image the other way round; without skew no difference.
    let off = (growth(&body.mirrored(), -55.0) - growth(&body, 55.0)).abs();
    observed!(off, 0.0..=1e-6);
    let off = (growth(&skew(0.0), -55.0) - growth(&skew(0.0), 55.0)).abs();
    observed!(off, 0.0..=1e-6);
    let scene = |spin: f64| {
        let start = Start::about_vertical(0.02, 0.0, spin).unwrap();
        on_a_table(body, start, 981.0, law)
    };
    let over = run(&scene(55.0), 3.0, 1500, 1e-6);
    let under = run(&scene(-55.0), 3.0, 600, 1e-6);
    let at = passage(&over, |s| -s.up().z(), 0.9);
    near!(at.unwrap(), 1.52, 4e-3..=0.02);
    assert!(most(&under, |s| s.tilt()) < 0.1);
    assert!(-most(&over, |s| -s.reaction) > 0.97 * 981.0);
}

#[test]
fn s4_7_rattleback() {
    // claim: C4.7-14
    let stone = bodies::rattleback().unwrap();
    for (spin, growth, frequency, reversal) in
        [(-5.0, 2.121, 109.4, 2.77), (5.0, 0.2025, 34.1, 11.46)]
    {
        let rates = rolling_growth_rates(&stone, G, spin).unwrap();
        near!(rates[0].growth, growth, 1e-4..=6e-4);
        near!(rates[0].frequency.abs(), frequency, 1e-2..=0.06);
        // Half a degree about each of the long axes, as Kane and Levinson.
        let half = 0.25_f64.to_radians().tan();
        let attitude = Attitude::from_quaternion(1.0, half, half, 0.0).unwrap();
        let start = Start::spinning(attitude, vector([0.0, 0.0, spin])).unwrap();
        let scene = on_a_table(stone, start, G, NoSlip);
        let rows = run(&scene, 1.3 * reversal, 1500, 1e-6);
        let at = passage(&rows, |s| -s.spin() * spin.signum(), 0.0);
        observed!((at.unwrap() / reversal - 1.0).abs(), 1e-3..=0.05);
        let drift = drift(&rows, |s| s.energy);
        observed!(drift, 7e-11..=3e-9);
        assert!(most(&rows, degrees) < 30.0);
    }
}
