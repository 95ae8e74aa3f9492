//! The attitude of Kovalevskaya's top at late times, at resonances and with weak gravity.

use spinning_bodies::Error;
use spinning_bodies::frame::{BodyVector, SpaceVector};
use spinning_bodies::kovalevskaya_top::{KovalevskayaTop, Method, Reason};
use support::{observed, refused, vector};

use super::kovalevskaya::{LEVER, MOMENTS, compared, crossing, top};

/// The angle between the attitude at a time and the one that a top set out a little earlier has then.
fn parting(top: &KovalevskayaTop, t: f64, after: f64) -> f64 {
    let here = top.at(t).expect("a state");
    let anew = KovalevskayaTop::new(MOMENTS, LEVER, here.omega, here.attitude).expect("a top");
    let [ahead, expected] =
        [anew.at(after), top.at(t + after)].map(|state| state.expect("a state"));
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
            observed!((kept - l_vert).abs(), 5e-17..=2e-15, "{t}");
            // What it does next it does by the equations of motion. Observed: 1.6e-12 rad at 1e3, 1e-10 at 1e5, 2e-8 at 1e7.
            let apart = parting(&top, t, 20.0);
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
            let apart = parting(&top, t, 20.0);
            assert!(apart < 3e-15 * t, "{t}: {apart:e}");
        }
    }
}

#[test]
fn weaker_and_weaker_gravity() {
    // What it does next it does by the equations of motion; free of gravity it is Euler's.
    let mut methods = Vec::new();
    for exponent in 0..=12 {
        let lever = BodyVector::new(10_f64.powi(-exponent), 0.0, 0.0);
        let (omega, up) = (vector([1.0, 0.5, 0.3]), vector([0.6, 0.0, 0.8]));
        let top = KovalevskayaTop::with_up(MOMENTS, lever, omega, up).expect("a top");
        methods.push(top.method());
        let [here, found] = [280.0, 300.0].map(|t| top.at(t).expect("a state"));
        let anew = KovalevskayaTop::new(MOMENTS, lever, here.omega, here.attitude).expect("a top");
        let expected = anew.at(20.0).expect("a state");
        let apart = found.attitude.angle_to(&expected.attitude);
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

#[test]
fn close_to_a_double_root() {
    // A pendulum about axis 3, pushed a little out of its plane.
    let mut methods = Vec::new();
    for exponent in [0, 1, 2, 4, 8, 12] {
        let push = 10_f64.powi(-exponent);
        let top = top([0.3 * push, push, 0.7], [0.6, 0.8, 0.0]);
        methods.push(top.method());
        match top.at(300.0) {
            Ok(late) => {
                let vertical = late.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
                observed!((vertical - late.up).norm(), 1e-16..=2e-15);
            }
            // More than 106 bits can follow.
            Err(error) => {
                assert!(matches!(error, Error::Integration { time, .. } if time < 300.0));
                assert!(matches!(top.method(), Method::PowerSeries(_)));
            }
        }
    }
    println!("{methods:?}");
    // At 1e-4 the cosine series would need about 2¹⁰ terms, which is where they end.
    assert_eq!(methods[..3], [Method::Separation; 3]);
    assert_eq!(methods[5], Method::PowerSeries(Reason::DoubleRoot));
}
