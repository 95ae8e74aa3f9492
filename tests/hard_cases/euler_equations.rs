//! Euler's equations where their differences, squares and scales are dangerous.

use spinning_bodies::euler_equations::{
    AxisMoments, HeavyTop, Integrability, Nature, TopState, equilibria, flow, rate,
};
use spinning_bodies::frame::BodyVector;
use support::{close, greatest, observed};

const OMEGA: BodyVector = BodyVector::new(0.75, -0.5, 1.25);

fn moments(i: [f64; 3]) -> AxisMoments {
    AxisMoments::new(i[0], i[1], i[2]).unwrap()
}

/// Relative error of each component.
fn worst(value: BodyVector, truth: [f64; 3]) -> f64 {
    let value = value.components();
    greatest([0, 1, 2].map(|k| (value[k] / truth[k] - 1.0).abs()))
}

#[test]
fn a_body_that_is_round_but_for_an_ulp_turns_by_that_ulp() {
    let ulp = f64::EPSILON;
    let body = moments([1.0, 1.0 + ulp, 1.0 + 2.0 * ulp]);
    // The moments in the denominators differ from 1 by nothing that matters.
    let truth = [0.625 * ulp, 2.0 * 0.9375 * ulp, 0.375 * ulp];
    let change = rate(&body, OMEGA, BodyVector::zero());
    observed!(worst(change, truth), 1e-16..=5e-16, "{change:?}");
    let change = flow(&body, OMEGA);
    observed!(worst(change, truth), 2e-16..=1e-15, "{change:?}");
    let (c, s) = (Nature::Center, Nature::Saddle);
    assert_eq!(equilibria(&body).map(|e| e.nature), [c, c, s, s, c, c]);
    // Symmetric to the last bit is another body.
    let d = Nature::Degenerate;
    let disc = moments([1.0, 1.0, 1.0 + ulp]);
    assert_eq!(equilibria(&disc).map(|e| e.nature), [d, d, d, d, c, c]);
}

#[test]
fn units_do_not_matter() {
    // Moments, rates and torques scaled by powers of two: every bit the same, up to the scale.
    let (plain, torque) = (moments([2.0, 3.5, 4.25]), BodyVector::new(0.3, -0.7, 0.1));
    let here = rate(&plain, OMEGA, torque);
    for power in [-500, -100, 100, 500] {
        let scale = 2.0_f64.powi(power);
        let scaled = moments(plain.values().map(|i| i * scale));
        assert_eq!(rate(&scaled, OMEGA, scale * torque), here);
        assert_eq!(flow(&scaled, scale * OMEGA), scale * flow(&plain, OMEGA));
        let natures = equilibria(&scaled).map(|e| e.nature);
        assert_eq!(natures, equilibria(&plain).map(|e| e.nature), "2^{power}");
    }
    for power in [-200, 200] {
        let scale = 2.0_f64.powi(power);
        let faster = rate(&plain, scale * OMEGA, (scale * scale) * torque);
        assert_eq!(faster, (scale * scale) * here);
    }
}

#[test]
fn next_to_an_axis_nothing_underflows_early() {
    // A tilt of 1e-300: the rate is the tilt times the growth, and keeps its digits.
    let body = moments([1.0, 2.0, 3.0]);
    let omega = BodyVector::new(1e-300, 1.0, 2e-300);
    let change = rate(&body, omega, BodyVector::zero());
    close!(change.x(), -2e-300, 0.0..=3e-16, "{change:?}");
    close!(change.z(), -1e-300 / 3.0, 0.0..=3e-16, "{change:?}");
    observed!(change.y().abs(), 0.0..=1e-308, "second order: gone");
}

#[test]
fn a_top_that_misses_its_ratio_by_an_ulp_is_another_top() {
    let lever = BodyVector::new(1.0, 0.0, 0.0);
    let kind = |i: [f64; 3]| HeavyTop::new(moments(i), lever).unwrap().kind();
    let scale = 2.0_f64.powi(-400);
    assert_eq!(kind([2.0, 2.0, 1.0]), Integrability::Kovalevskaya(2));
    let scaled = [2.0 * scale, 2.0 * scale, scale];
    assert_eq!(kind(scaled), Integrability::Kovalevskaya(2));
    let next = 2.0_f64.next_up();
    assert_eq!(kind([next, next, 1.0]), Integrability::None);
    assert_eq!(kind([2.0, next, 1.0]), Integrability::None);
    assert_eq!(kind([4.0, 4.0, 1.0]), Integrability::GoryachevChaplygin(2));
    assert_eq!(kind([4.0, 4.0, 1.0_f64.next_down()]), Integrability::None);
    // And the motion does not know of names: an ulp of ratio changes the integral by an ulp's worth.
    let near = HeavyTop::new(moments([next, next, 1.0]), lever).unwrap();
    let exact = HeavyTop::new(moments([2.0, 2.0, 1.0]), lever).unwrap();
    let start = TopState {
        omega: OMEGA,
        up: BodyVector::new(0.48, 0.6, 0.64),
    };
    let run = |top: &HeavyTop| (0..2000).fold(start, |s, _| top.step(&s, 1e-3));
    let value = |s: &TopState| exact.further_integral(s).unwrap().value;
    let (here, there) = (value(&run(&exact)), value(&run(&near)));
    observed!((here / there - 1.0).abs(), 1e-16..=2e-15, "{here} {there}");
}
