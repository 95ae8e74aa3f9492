//! Swivelling: a net turn without angular momentum, and the area that it is.

use super::*;
use spinning_bodies::phenomena::{Swivel, Waist};
use spinning_bodies::scene::effects::FourPhases;

const DEFAULT: Waist = waist(2.0, 0.7, 0.6);

const fn waist(upper_arms_out: f64, upper_arms_in: f64, lower: f64) -> Waist {
    Waist {
        upper_arms_out,
        upper_arms_in,
        lower,
    }
}

/// Four phases with the arms of the default, a quarter turn.
fn phases(duration: f64, pace: Pace) -> FourPhases {
    FourPhases {
        arms_out: 2.0,
        arms_in: 0.7,
        twist: FRAC_PI_2,
        duration,
        pace,
    }
}

// claim: C1.1-3, C1.1-4, C3.5-3
#[test]
fn s1_1_the_swivel_turns_further_than_it_turns_back() {
    let body = waist(3.0, 1.0, 1.0);
    let exact = [
        (body.swivel_angle(FRAC_PI_2).unwrap(), -FRAC_PI_8),
        (body.phases(FRAC_PI_2).unwrap()[0], -3.0 * FRAC_PI_8),
        (body.phases(FRAC_PI_2).unwrap()[1], FRAC_PI_4),
    ];
    for (value, truth) in exact {
        close!(value, truth, 0.0..=4e-16);
    }
    let turn = DEFAULT.swivel_angle(FRAC_PI_2).unwrap().to_degrees();
    observed!((turn + 20.769).abs(), 7e-5..=5e-4, "{turn}");
    // Exactly −90 · 0.6 · 1.3 / (2.6 · 1.3) = −270/13 degrees.
    close!(turn, -270.0 / 13.0, 0.0..=5e-16);
    // A/(A + B) grows with A.
    let plane = Swivel { lower: 0.6 };
    let shares = (1..100).map(|k| plane.turn_back(0.1 * f64::from(k)));
    assert!(shares.is_sorted_by(|a, b| a < b));
    // The limits.
    let still = [
        (waist(2.0, 2.0, 0.6), 1.0),
        (waist(2.0, 0.7, 0.0), 1.0),
        (DEFAULT, 0.0),
    ];
    for (waist, twist) in still {
        assert_eq!(waist.swivel_angle(twist).unwrap(), 0.0);
    }
    let heavy = waist(3.0, 1.0, 1e300).swivel_angle(FRAC_PI_2).unwrap();
    observed!(heavy.abs(), 0.0..=1e-299);
    for lower in [1e9, 1e-9] {
        let waist = Waist { lower, ..DEFAULT };
        observed!(waist.swivel_angle(1.0).unwrap().abs(), 4e-10..=2e-9);
    }
}

// claim: C1.1-5
#[test]
fn s1_1_the_sense_of_the_swivel() -> Result<()> {
    // Anticlockwise is positive: twist that way with the arms out, and the net turn is clockwise.
    assert!(DEFAULT.swivel_angle(1.0)? < 0.0);
    let swapped = waist(0.7, 2.0, 0.6);
    let off = relative(swapped.swivel_angle(1.0)?, -DEFAULT.swivel_angle(1.0)?);
    observed!(off, 0.0..=3e-16);
    assert_eq!(DEFAULT.swivel_angle(-1.0)?, -DEFAULT.swivel_angle(1.0)?);
    Ok(())
}

// claim: C1.1-6
#[test]
fn s1_1_the_best_lower_moment() {
    let body = waist(3.0, 1.0, 1.0);
    let best = body.best_lower().unwrap();
    close!(best, 3.0_f64.sqrt(), 0.0..=3e-16);
    let turn = |lower: f64| Waist { lower, ..body }.swivel_angle(FRAC_PI_2).unwrap();
    close!(turn(best), -FRAC_PI_2 * (2.0 - 3.0_f64.sqrt()), 0.0..=5e-16);
    close!(turn(best), -0.420_893_607_238_466_46, 0.0..=3e-16);
    for k in -40..=40 {
        let other = best * 1.1_f64.powi(k);
        assert!(k == 0 || turn(other) > turn(best));
        assert!(turn(other).abs() < FRAC_PI_2);
    }
}

/// The loop A = 2 + cos s, ψ = sin s.
fn ellipse(s: f64) -> Step {
    let (sin, cos) = s.sin_cos();
    Step {
        shape: [2.0 + cos, sin],
        rate: [-sin, cos],
    }
}

// claim: C1.1-7
#[test]
fn s1_1_the_turn_is_an_area_and_the_pace_does_not_matter() -> Result<()> {
    let plane = Swivel { lower: 1.0 };
    // 2π(1 − 3/√8).
    let truth = -0.381_139_100_057_962_9;
    let along = turn_along(&plane, ellipse)?;
    let within = turn_within(&plane, ellipse, Hub::Point([2.0, 0.0]))?;
    let aside = turn_within(&plane, ellipse, Hub::Point([1.4, 0.3]))?;
    // Observed: 1.5e-16, 3e-16, 6e-16.
    for value in [along, within, aside] {
        close!(value, truth, 0.0..=2e-15);
    }
    // Two other ways of going round it in time.
    let late = |s: f64| {
        let warped = s + 0.7 * s.sin();
        let mut step = ellipse(warped);
        step.rate = step.rate.map(|r| r * (1.0 + 0.7 * s.cos()));
        step
    };
    close!(turn_along(&plane, late)?, truth, 0.0..=2e-15);
    for duration in [0.3, 60.0] {
        for pace in [Pace::Even, Pace::Late] {
            let scene = shape::Swivel::new(0.6, 2.0)?.with(phases(duration, pace))?;
            let motion = scene.simulate(&Request::at([duration])?)?;
            let (turn, area) = (motion.rows[0].1.lower, DEFAULT.swivel_angle(FRAC_PI_2)?);
            assert!(relative(turn, area) < 2e-14, "{turn}");
        }
    }
    // Round the other way: back again. A loop without area: nothing.
    let back = |s: f64| {
        let mut step = ellipse(-s);
        step.rate = step.rate.map(|r| -r);
        step
    };
    close!(turn_along(&plane, back)?, -truth, 0.0..=2e-15);
    let line = |s: f64| Step {
        shape: [2.0 + s.sin(), s.sin()],
        rate: [s.cos(), s.cos()],
    };
    observed!(turn_along(&plane, line)?.abs(), 0.0..=1e-15);
    // A rim with 32 waves, or 512, from whose crests alone the circle would seem wider: −∮ (2 + a cos ks)/(…) ds = −2π(1 − 1/√(9 − a²)).
    for waves in [1.0, 32.0, 512.0] {
        let rim = |s: f64| Step {
            shape: [2.0 + 0.5 * (waves * s).cos(), s],
            rate: [-0.5 * waves * (waves * s).sin(), 1.0],
        };
        let truth = -TAU * (1.0 - 1.0 / 8.75_f64.sqrt());
        close!(turn_along(&plane, rim)?, truth, 0.0..=2e-15);
    }
    Ok(())
}

// claim: C1.1-12
#[test]
fn s1_1_picture_b_the_four_frames() {
    let scene = shape::Swivel::new(0.6, 2.0).unwrap();
    let scene = scene.with(phases(4.0, Pace::Even)).unwrap();
    let request = Request::at([1.0, 2.0, 3.0, 4.0]).unwrap();
    let motion = scene.simulate(&request).unwrap();
    let [there, back] = DEFAULT.phases(FRAC_PI_2).unwrap();
    let whole = DEFAULT.swivel_angle(FRAC_PI_2).unwrap();
    // ΨB/(A + B) and −ΨA/(A + B).
    let upper = FRAC_PI_2 * 0.6 / 2.6;
    let expected = [
        [there, upper],
        [there, upper],
        [there + back; 2],
        [whole; 2],
    ];
    for ((_, state), [lower, upper]) in motion.rows.iter().zip(expected) {
        // Observed: 4e-16.
        near!(state.lower, lower, 0.0..=2e-15, "{state:?}");
        near!(state.upper, upper, 0.0..=2e-15, "{state:?}");
    }
}
