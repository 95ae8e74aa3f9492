//! The functions for the special motions of 7.3 to 7.6, held against exact numbers, the motion itself and their own hard cases.

use super::*;
use spinning_bodies::lagrange_top::{
    PurePrecession, apsides, dip, fast_spin, pure_precession, sleeping_threshold, tilt_after_kick,
};

/// Slow and fast, where there are two.
fn two(transverse: f64, weight: f64, l3: f64, h: f64) -> [f64; 2] {
    match pure_precession(transverse, weight, l3, h).unwrap() {
        PurePrecession::Two { slow, fast } => [slow, fast],
        other => panic!("{other:?}"),
    }
}

#[test]
fn s7_3_rates_of_exact_numbers() {
    // I₁cos θ = p, L₃ = p(a + b), Mgl = pab has the rates a and b, whatever the sizes; all of these are doubles.
    let mut numbers = Uniform(173);
    let mut whole = || f64::from((numbers.next() * 2000.0) as i32 - 1000);
    for _ in 0..500 {
        let (a, b) = (whole(), whole());
        if a.abs() >= b.abs() || b == 0.0 {
            continue;
        }
        for exponent in [-300, -20, 0, 20, 300] {
            let unit = 2_f64.powi(exponent);
            for h in [0.5, -0.25, 1.0] {
                let found = two(unit, h * a * b * unit, h * (a + b) * unit, h);
                assert_eq!(found, [a, b], "{h} {exponent}");
            }
        }
    }
    // Next to each other, one unit of 2⁻⁵⁰ apart: the discriminant is 2⁻¹⁰⁰ of its terms.
    let step = 2_f64.powi(-24);
    let (a, b) = (1.0, 1.0 + step);
    assert_eq!(two(1.0, b, a + b, 1.0), [a, b]);
    // The slow one of a fast top, to the last place: Mgl/L₃ (1 + x + …) with x below a rounding.
    assert_eq!(two(1.0, 1.0, 1e200, 0.5)[0], 1e-200);
    assert_eq!(two(1.0, 1e-200, 1e150, 0.5), [0.0, 2e150]);
}

/// By how much the limits of fast spin are off, above the horizon and below: x = I₁Mgl cos θ/L₃² with its sign.
// claim: C7.3-3
#[test]
fn s7_3_the_first_order_of_fast_spin() {
    for (weight, l3, h) in [(2.0, 40.0, 0.5), (2.0, 40.0, -0.5), (-3.0, -50.0, 0.75)] {
        let limit = fast_spin(1.5, weight, l3, h).unwrap();
        assert_eq!(limit.x, 1.5 * weight * h / (l3 * l3));
        let [slow, fast] = two(1.5, weight, l3, h);
        // Observed: 5x³, 1e-9.
        let x = limit.x;
        assert!((slow / limit.slow - (1.0 + x + 2.0 * x * x)).abs() < 6.0 * x.abs().powi(3));
        assert!((fast / limit.fast - (1.0 - x - x * x)).abs() < 3.0 * x.abs().powi(3));
    }
}

#[test]
fn s7_3_where_there_are_no_two_rates() {
    let kind = |weight, l3, h| pure_precession(1.0, weight, l3, h).unwrap();
    assert_eq!(kind(1.0, 1.0, 0.5), PurePrecession::None);
    assert_eq!(kind(1.0, 0.0, 0.0), PurePrecession::None);
    assert_eq!(kind(0.0, 0.0, 0.0), PurePrecession::Any);
    assert_eq!(kind(0.0, 0.0, 0.5), PurePrecession::One(0.0));
    assert_eq!(kind(1.0, -4.0, 0.0), PurePrecession::One(-0.25));
    assert_eq!(kind(2.0, 2.0, 0.5), PurePrecession::One(2.0));
    // Without gravity the axis stands or goes round freely; with gravity upwards the sky is below.
    assert_eq!(two(1.0, 0.0, 3.0, 0.5), [0.0, 6.0]);
    let [slow, fast] = two(1.0, 1.0, 1.0, -0.5);
    assert_eq!(two(1.0, -1.0, -1.0, 0.5), [slow, fast]);
    assert_eq!(two(1.0, -1.0, 1.0, 0.5), [-slow, -fast]);
    let limit = fast_spin(1.0, 1.0, -2.0, 0.0).unwrap();
    assert_eq!(limit.fast, f64::NEG_INFINITY);
}

#[test]
fn s7_4_the_dip_is_that_of_the_motion() {
    let mut numbers = Uniform(174);
    for _ in 0..300 {
        let (tilt, l3) = (0.01 + 3.1 * numbers.next(), 6.0 * numbers.signed());
        let found = dip(1.0, 1.0, l3, tilt).unwrap();
        let [h1, ..] = roots(&spun(tilt, 0.0, 0.0, l3));
        near!(found.lowest_height, h1, 0.0..=5e-16);
        near!(found.lowest_tilt - tilt, found.depth, 2e-16..=9e-16);
        near!(found.lowest_tilt.cos(), h1, 1e-16..=9e-16);
    }
    // A dip far below the rounding of the tilt: 2a with a = sin θ₀/L₃².
    for l3 in [1e9, 1e100] {
        let found = dip(1.0, 1.0, l3, 1.0).unwrap();
        close!(found.depth, 2.0 * found.cycloid.radius, 0.0..=3e-16);
        close!(found.cycloid.radius * l3 * l3, 1_f64.sin(), 0.0..=5e-16);
    }
    assert_eq!(dip(1.0, 1.0, 0.0, 1.0).unwrap().lowest_tilt, PI);
    // Without spin it falls through the bottom, from next to the top and from next to the bottom; π is 1.2e-16 more than its double.
    for tilt in [1e-10, 0.01, 2.0, PI - 1e-10] {
        let fallen = dip(1.0, 1.0, 0.0, tilt).unwrap().depth;
        close!(
            fallen,
            PI - tilt + 1.2246467991473532e-16,
            0.0..=4e-16,
            "{tilt}"
        );
    }
}

#[test]
fn s7_4_the_wheel_keeps_its_digits_at_the_cusp() {
    let wheel = dip(1.0, 1.0, 10.0, 1.0).unwrap().cycloid;
    // u − sin u = u³/6 (1 − u²/20 + …), 1 − cos u = u²/2 (1 − u²/12 + …).
    for u in [1e-3, 1e-6, 1e-100] {
        let [sunk, turned] = wheel.at(u);
        let square = u * u;
        let off = (sunk / (0.5 * wheel.radius * square) - (1.0 - square / 12.0)).abs();
        observed!(off, 9e-16..=3e-14);
        let arc = turned * wheel.sine / wheel.radius / (u * square / 6.0);
        near!(arc, 1.0 - square / 20.0, 4e-16..=2e-14);
    }
    // Both formulas agree where they meet.
    let below = wheel.at(1.0)[1];
    let above = wheel.at(1_f64.next_up())[1];
    observed!((above / below - 1.0).abs(), 3e-16..=4e-15);
    let off = (below * wheel.sine / wheel.radius - (1.0 - 1_f64.sin())).abs();
    observed!(off, 0.0..=3e-16);
}

// claim: C7.5-3
#[test]
fn s7_5_threshold_and_kick() {
    // Powers of two are exact, up to the ends of the range.
    assert_eq!(sleeping_threshold(1.0, AXIAL, 1.0).unwrap(), 4.0);
    let tiny = 2_f64.powi(-600);
    assert_eq!(sleeping_threshold(tiny, tiny, tiny).unwrap(), 2.0);
    assert!(sleeping_threshold(1.0, 0.0, 1.0).is_err());
    // Against the roots of the top that is kicked: on both sides of the threshold and next to it.
    for l3 in [0.0, 0.3, 1.9, 2.0 - 1e-9, 2.0, 2.0 + 1e-9, 2.5, 30.0] {
        for kick in [1e-12, 1e-6, 0.01, 1.0, 7.0] {
            let tilt = tilt_after_kick(1.0, 1.0, l3, kick).unwrap();
            let lower = kicked(l3, kick).roots();
            let expected = 2.0 * lower.one_less[0].sqrt().atan2(lower.one_more[0].sqrt());
            observed!((tilt / expected - 1.0).abs(), 0.0..=5e-16);
        }
    }
    // Weightless: L leans by atan(ε/l), and the axis goes round it on the other side.
    let free = tilt_after_kick(1.0, 0.0, 2.0, 1.0).unwrap();
    near!(free, 2.0 * 0.5_f64.atan(), 0.0..=3e-16);
    // So near the threshold that L₃² and 4I₁Mgl differ by less than a last place.
    let [weight, l3] = [0.3333333666666667, 2.0000000999999976];
    let tilt = tilt_after_kick(3.0, weight, l3, 1e-20).unwrap();
    close!(tilt, 3.955_965_325_603_573_252e-12, 0.0..=3e-16);
    assert_eq!(tilt_after_kick(1.0, 0.0, 0.0, 1.0).unwrap(), PI);
    assert!(tilt_after_kick(1.0, -1.0, 1.0, 1.0).is_err());
}

#[test]
fn s7_6_apsides() {
    // Small swings: the law, and what it leaves goes with the square of the swing.
    let mut left = Vec::new();
    for size in [0.4, 0.2, 0.1] {
        let turn = apsides(0.5 * size, size).unwrap();
        left.push((turn.small_swing / turn.advance - 1.0) / (size * size));
    }
    assert!(left.iter().all(|x| (-0.2..0.0).contains(x)), "{left:?}");
    within((left[1] / left[2] - 1.0).abs(), 0.01);
    // The conical pendulum: √(g cos θ … ) in closed form, 2π/√(1 + 3cos²θ) an apsis to the next.
    for angle in [0.1, 0.7, 1.5_f64] {
        let pendulum = pendulum_between(angle, angle, 2.0).unwrap();
        let off = (pendulum.at(0.0).unwrap().height + angle.cos()).abs();
        observed!(off, 0.0..=3e-16);
        observed!(band(&pendulum), 0.0..=3e-8);
        let turn = apsides(angle, angle).unwrap().advance + PI;
        let expected = TAU / (1.0 + 3.0 * angle.cos().powi(2)).sqrt();
        observed!((turn / expected - 1.0).abs(), 0.0..=2e-15);
    }
    let pendulum = pendulum_between(0.2, 1.0, 1.0).unwrap();
    assert_eq!(pendulum.kind(), Nutation::SphericalPendulum);
    // Nearly plane: next to no advance, and no accident. Hardly swinging and round: the law, to the rounding of π.
    for (a, b, bound) in [
        (1e-300, 1.0, 1e-15),
        (1e-9, 1.0, 2e-10),
        (1e-150, 1e-150, 1e-15),
        (1e-9, 1e-9, 1e-15),
    ] {
        let turn = apsides(a, b).unwrap();
        within((turn.advance - turn.small_swing).abs(), bound);
    }
}
