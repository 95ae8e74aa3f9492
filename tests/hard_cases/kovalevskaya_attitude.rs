//! The attitude of Kovalevskaya's top at late times, at resonances and with weak gravity.

use spinning_bodies::frame::{BodyVector, SpaceVector};
use spinning_bodies::kovalevskaya_top::{KovalevskayaTop, Method};
use support::{near, observed, refused, vector};

use super::kovalevskaya::{compared, crossing};
use support::kovalevskaya::{LEVER, MOMENTS, top};

/// The angle between the attitude at a time and the one that a top set out a little earlier has then.
fn parting(top: &KovalevskayaTop, lever: [f64; 3], t: f64) -> f64 {
    let here = top.at(t).expect("a state");
    let anew =
        KovalevskayaTop::new(MOMENTS, vector(lever), here.omega, here.attitude).expect("a top");
    let [ahead, expected] = [anew.at(20.0), top.at(t + 20.0)].map(|state| state.expect("a state"));
    ahead.attitude.angle_to(&expected.attitude)
}

#[test]
fn as_late_as_you_like() {
    for (omega, up) in [
        ([1.0, 0.5, 0.3], [0.6, 0.0, 0.8]),
        ([0.8, 0.4, 0.0], [0.5, -0.8, 0.331_662]),
        ([0.0, 0.0, 0.0], [0.6, 0.48, 0.64]),
        ([-1.3, 1.1, 1.4], [0.3, 0.4, -0.9]),
    ] {
        let top = top(omega, up);
        assert_eq!(top.method(), Method::Separation);
        for t in [1e3, -1e3, 1e5, 1e7, 1e8, -1e8, 9e8] {
            let state = top.at(t).expect("a state");
            let vertical = state.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
            // Observed: 5e-16.
            observed!((vertical - state.up).norm(), 1e-16..=2e-15, "{t}");
            let l_vert = top.constants().vertical_angular_momentum;
            let kept = state.angular_momentum.dot(&state.up);
            near!(kept, l_vert, 5e-17..=2e-15, "{t}");
            // What it does next it does by the equations of motion. Observed: 1.6e-12 rad at 1e3, 1e-10 at 1e5, 2e-8 at 1e7.
            let apart = parting(&top, LEVER, t);
            assert!(apart < 3e-14 + 3e-15 * t.abs(), "{t:e}: {apart:e}");
        }
        refused!(top.at(2.2e9), OutOfRange);
    }
}

#[test]
fn commensurable_frequencies() {
    // Ω₃ such that k₁n₁ = k₂n₂ to the last digit: a divisor of the series is zero, or rounding.
    for (k1, k2, ends) in [
        (1.0, 1.0, [1.2, 1.3]),
        (1.0, 3.0, [0.9, 1.0]),
        (2.0, 3.0, [0.1, 0.2]),
    ] {
        let made = |spin: f64| top([1.0, 0.5, spin], [0.6, 0.0, 0.8]);
        let divisor = |spin: f64| {
            let [n1, n2] = made(spin).frequencies().expect("separated");
            k1 * n1 - k2 * n2
        };
        assert!(divisor(ends[0]) * divisor(ends[1]) < 0.0, "{k1} {k2}");
        let [low, _] = crossing(divisor, ends);
        observed!(divisor(low).abs(), 0.0..=1e-15);
        let top = made(low);
        assert_eq!(top.method(), Method::Separation);
        let [_, attitude] = compared(&top, &[1.0, 10.0, 30.0]);
        observed!(attitude, 1e-14..=1e-13);
        for t in [1e4, 1e6] {
            let apart = parting(&top, LEVER, t);
            assert!(apart < 3e-15 * t, "{t}: {apart:e}");
        }
    }
}

#[test]
fn weaker_and_weaker_gravity() {
    // What it does next it does by the equations of motion; free of gravity it is Euler's.
    let mut methods = Vec::new();
    for exponent in 0..=12 {
        let lever = [10_f64.powi(-exponent), 0.0, 0.0];
        let (omega, up) = (vector([1.0, 0.5, 0.3]), vector([0.6, 0.0, 0.8]));
        let top = KovalevskayaTop::with_up(MOMENTS, vector(lever), omega, up).expect("a top");
        methods.push(top.method());
        let apart = parting(&top, lever, 280.0);
        observed!(apart, 3e-14..=7e-13, "1e-{exponent}: {apart:e}");
    }
    assert_eq!(methods[0], Method::Separation);
    assert!(matches!(methods[12], Method::PowerSeries(_)));
    let (omega, up) = (vector([1.0, 0.5, 0.3]), vector([0.6, 0.0, 0.8]));
    let free = KovalevskayaTop::with_up(MOMENTS, BodyVector::zero(), omega, up).expect("a top");
    assert_eq!(free.method(), Method::FreeTop);
    assert!(free.at(1e12).is_ok());
    // A lever along axis 2 that comes to nothing over I₃: no axes are turned for it, at time 0 neither.
    let (moments, lever) = (MOMENTS.map(|i| 1e10 * i), vector([0.0, 5e-324, 0.0]));
    let gone = KovalevskayaTop::with_up(moments, lever, omega, up).expect("a top");
    assert_eq!(gone.method(), Method::FreeTop);
    assert_eq!(gone.at(0.0).expect("the start").omega, omega);
}

#[test]
fn what_is_prepared_makes_no_difference() {
    let fresh = top([1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
    let prepared = fresh.clone();
    let near = fresh.at(250.0).expect("a state");
    let far = prepared.at(1e4).expect("a state");
    assert_eq!(fresh, prepared);
    // Nor do the same times give other digits after it than before, nor in another order.
    assert_eq!(prepared.at(250.0).expect("a state"), near);
    assert_eq!(fresh.at(1e4).expect("a state"), far);
    assert_eq!(prepared.clone().at(1e4).expect("a state"), far);
    let first = fresh.states([1e4, 250.0]).next();
    assert_eq!(first, fresh.states([1e4]).next());
}
