//! Tutorial 4.10: strips of paper tumble rather than flutter beyond a certain aspect ratio.

use super::*;
use rayon::prelude::*;
use spinning_bodies::falling_strip::{
    Coefficients, Fall, LongRun, Regime, Sheet, Start, transition,
};

/// Let go on edge, spinning.
const SPINNING: Start = Start {
    tilt: 1.4,
    velocity: [0.0, 0.0],
    omega: 1.0,
};

fn long_run(ratio: f64, coefficients: Coefficients) -> LongRun {
    let fall = Fall::new(ratio, coefficients).unwrap();
    fall.long_run(Start::TILTED, 400.0, 400.0).unwrap()
}

// claim: C4.10-1
#[test]
fn s4_10_a_published_tumbler() {
    let tumbling = long_run(1.4, Coefficients::PUBLISHED);
    rounded(tumbling.rotation.abs(), 4, 0.4892);
    rounded(tumbling.drift.abs(), 4, 0.7559);
    rounded(tumbling.descent, 4, 0.3267);
}

// claim: C4.10-1
#[test]
fn s4_10_flutter_ends_where_its_period_grows_without_bound() {
    let periods = [
        (1.0, 13.3),
        (1.1, 16.0),
        (1.15, 18.8),
        (1.2, 25.2),
        (1.21, 29.0),
    ];
    for (ratio, period) in periods {
        let run = long_run(ratio, Coefficients::PUBLISHED);
        rounded(run.period.unwrap(), 1, period);
    }
    let ends = [
        (Coefficients::PUBLISHED, 1.1, 1.3),
        (Coefficients::PAPER, 0.4, 0.6),
    ];
    let found: Vec<f64> = ends
        .par_iter()
        .map(|&(coefficients, low, high)| transition(coefficients, low, high, 1e-5, 600.0).unwrap())
        .collect();
    // The authors give 1.2191. Runs twice as long move the fifth digit.
    rounded(found[0], 4, 1.2191);
    rounded(found[1], 4, 0.5267);
}

/// The ends of its swings, found between the samples, against samples a hundred times as dense.
#[test]
fn s4_10_how_far_it_swings() {
    let fall = Fall::new(0.8, Coefficients::PUBLISHED).unwrap();
    let run = fall.long_run(Start::TILTED, 400.0, 60.0).unwrap();
    let times: Vec<f64> = (0..=60_000).map(|k| 400.0 + 1e-3 * f64::from(k)).collect();
    let path = fall.path(Start::TILTED, &times).unwrap();
    let angles = || path.iter().map(|state| state[2]);
    let half = 0.5 * (angles().fold(f64::MIN, f64::max) - angles().fold(f64::MAX, f64::min));
    near!(run.swing.unwrap(), half, 1e-9..=3e-8);
    assert_eq!(long_run(1.4, Coefficients::PUBLISHED).swing, None);
}

// claim: C4.10-1
#[test]
fn s4_10_bounded_angle_below_tumbling_above() {
    for ratio in [0.5, 0.8, 1.0, 1.1, 1.3, 1.4] {
        let tumbles = ratio > 1.2;
        let regime = if tumbles {
            Regime::Tumble
        } else {
            Regime::Flutter
        };
        for start in [Start::TILTED, SPINNING] {
            let fall = Fall::new(ratio, Coefficients::PUBLISHED).unwrap();
            let run = fall.long_run(start, 300.0, 300.0).unwrap();
            assert_eq!(run.regime, regime, "{ratio}");
        }
    }
}

// claim: C4.10-2
#[test]
fn s4_10_the_tumbling_strip_drifts_and_the_fluttering_one_does_not() {
    for ratio in [1.3, 1.4] {
        let run = long_run(ratio, Coefficients::PUBLISHED);
        // Along the chord's plane, which is at right angles to the long axis: the model has no other direction. In 400 units of time:
        assert!(run.reach > 250.0, "{}", run.reach);
        // To the side to which the lift of its rotation points: turning clockwise, to the right... of this model, with the sense of ω.
        assert_eq!(run.drift.signum(), run.rotation.signum());
        // Roughly straight: never further than two half-widths from the mean slope.
        let fall = Fall::new(ratio, Coefficients::PUBLISHED).unwrap();
        let period = run.period.unwrap();
        let time = |k: i32| 400.0 + f64::from(k) * period / 40.0;
        let times: Vec<f64> = (0..400).map(time).collect();
        let path = fall.path(Start::TILTED, &times).unwrap();
        let slope = run.drift.hypot(run.descent);
        let off = greatest(path.iter().map(|y| {
            let (x, down) = (y[0] - path[0][0], path[0][1] - y[1]);
            ((x * run.descent - down * run.drift) / slope).abs()
        }));
        assert!(off < 2.5, "{ratio}: {off}");
    }
    let fluttering = long_run(0.8, Coefficients::PUBLISHED);
    within(fluttering.reach, 5.0);
    within(fluttering.drift.abs(), 1e-6);
}

// claim: C4.10-1
#[test]
fn s4_10_the_coefficients_for_paper() {
    let table = [
        (0.6, 0.777, 0.911, 1.042, 48.8, 0.562),
        (1.0, 0.929, 0.978, 0.754, 37.6, 0.753),
        (2.0, 0.932, 0.946, 0.695, 36.3, 0.794),
        (4.0, 0.844, 0.901, 0.781, 40.9, 0.708),
        (8.0, 0.720, 0.831, 0.920, 47.9, 0.581),
        (16.0, 0.587, 0.728, 1.062, 55.6, 0.456),
    ];
    table
        .par_iter()
        .for_each(|&(ratio, rotation, drift, descent, glide, tip)| {
            let run = long_run(ratio, Coefficients::PAPER);
            assert_eq!(run.regime, Regime::Tumble);
            rounded(run.rotation.abs(), 3, rotation);
            rounded(run.drift.abs(), 3, drift);
            rounded(run.descent, 3, descent);
            rounded(run.glide_angle().to_degrees(), 1, glide);
            rounded(run.rotation.abs() / run.drift.hypot(run.descent), 3, tip);
        });
    // No gap: from 0.54 to 16 it tumbles from either start.
    let ratio = |k: i32| 0.54 * (16.0_f64 / 0.54).powf(f64::from(k) / 39.0);
    let ratios: Vec<f64> = (0..40).map(ratio).collect();
    ratios.par_iter().for_each(|&ratio| {
        let fall = Fall::new(ratio, Coefficients::PAPER).unwrap();
        for start in [Start::TILTED, SPINNING] {
            let run = fall.long_run(start, 200.0, 100.0).unwrap();
            assert_eq!(run.regime, Regime::Tumble, "{ratio}");
        }
    });
}

// claim: C4.10-1
#[test]
fn s4_10_paper_of_eighty_grams() {
    let sheet = |centimetres: f64| Sheet::of_paper(centimetres / 100.0).unwrap();
    rounded(sheet(1.0).speed(), 4, 0.6453);
    // Where flutter ends, by our fit, by the measurement and by the published set: centimetres of width.
    let widths = [0.5267, 4.0 / PI * 0.67 * 0.67, 1.2191];
    let widths = widths.map(|ratio| 100.0 * sheet(1.0).width_for(ratio).unwrap());
    rounded(widths[0], 1, 16.1);
    rounded(widths[1], 1, 14.9);
    rounded(widths[2], 1, 7.0);
    let turning = |centimetres: f64| {
        let sheet = sheet(centimetres);
        let run = long_run(sheet.mass_ratio(), Coefficients::PAPER);
        (run.regime, run.rotation.abs() / sheet.time() / TAU)
    };
    for (width, hertz) in [(1.0, 14.6), (2.0, 8.6), (3.0, 6.1), (5.0, 3.9), (15.0, 1.0)] {
        let (regime, rate) = turning(width);
        assert_eq!(regime, Regime::Tumble);
        rounded(rate, 1, hertz);
    }
    assert_eq!(turning(18.0).0, Regime::Flutter);
    // Rate against width: about the −0.77th power, not the −1st of the scaling law; it would be that if a ω/U did not fall with I*.
    let [narrow, wide] = [0.78, 2.8].map(turning);
    let exponent = (narrow.1 / wide.1).ln() / (0.78_f64 / 2.8).ln();
    rounded(exponent, 2, -0.77);
}

#[test]
fn chaos_has_averages() {
    // Paths of I* = 2.2 part after some tens of units; what they have in common is the mean rate of descent. Observed with steps
    // of two kinds: 0.555 to 0.624 from eight starts, their means 0.572 and 0.588.
    let fall = Fall::new(2.2, Coefficients::PUBLISHED).unwrap();
    let starts: Vec<f64> = (1..=8).map(|k| 0.1 * f64::from(k)).collect();
    let runs: Vec<LongRun> = starts
        .par_iter()
        .map(|&tilt| Start {
            tilt,
            ..Start::TILTED
        })
        .map(|start| fall.long_run(start, 100.0, 2000.0).unwrap())
        .collect();
    let mean = runs.iter().map(|run| run.descent).sum::<f64>() / runs.len() as f64;
    near!(mean, 0.58, 5e-3..=0.015, "{mean}");
    for run in &runs {
        assert_eq!((run.regime, run.period), (Regime::Mixed, None));
        near!(run.descent, mean, 0.02..=0.06, "{}", run.descent);
        assert!(run.drift.abs() < 0.15, "{}", run.drift);
    }
}

#[test]
fn what_is_no_strip_is_refused() {
    assert!(Fall::new(0.0, Coefficients::PAPER).is_err());
    assert!(Fall::new(f64::NAN, Coefficients::PAPER).is_err());
    assert!(Sheet::of_paper(-1.0).is_err());
    let fall = Fall::new(1.0, Coefficients::PAPER).unwrap();
    refused!(fall.long_run(Start::TILTED, 1.0, 1e9), OutOfRange);
    assert!(fall.long_run(Start::TILTED, f64::INFINITY, 1.0).is_err());
    let bracket = transition(Coefficients::PAPER, 0.6, 0.8, 1e-3, 100.0);
    refused!(bracket, Condition);
}

#[test]
fn a_strip_wider_than_any_double_is_refused() {
    let paper = Sheet::of_paper(0.04).unwrap();
    refused!(paper.width_for(5e-324), NotFinite, "the width of the strip");
}
