//! What a scene's accuracy is worth: random tops of every kind, at every accuracy from 1e-3 to 1e-12, against Taylor series in two words.

mod suite;
mod taylor;

use rayon::prelude::*;
use spinning_bodies::Error;
use suite::{Kind, cases};

/// Decades of accuracy.
const DECADES: core::ops::RangeInclusive<i32> = 3..=12;

#[test]
fn the_error_obtained_is_the_error_asked_for() {
    let all = cases(1);
    assert!(all.len() >= 200);
    let outcomes: Vec<(Kind, i32, f64, f64)> = all
        .par_iter()
        .flat_map_iter(|case| {
            let truth = case.truth(22);
            let scene = case.scene();
            DECADES.map(move |decade| {
                let asked = 10.0_f64.powi(-decade);
                match scene.simulate(&case.request(asked)) {
                    Ok(motion) => {
                        let error = case.error(&motion, &truth);
                        let told = motion.error_estimate.unwrap_or(f64::INFINITY);
                        (case.kind, decade, error / asked, error / told)
                    }
                    // Refused is not wrong, if it is rare: below.
                    Err(Error::Accuracy { .. }) => (case.kind, decade, -1.0, 0.0),
                    Err(other) => panic!("{case:?} {decade}: {other}"),
                }
            })
        })
        .collect();
    let refused = outcomes.iter().filter(|o| o.2 < 0.0);
    let above = outcomes.iter().filter(|o| o.2 > 1.0).count();
    let worst = outcomes.iter().max_by(|a, b| a.2.total_cmp(&b.2)).unwrap();
    let boldest = outcomes.iter().max_by(|a, b| a.3.total_cmp(&b.3)).unwrap();
    println!("worst {worst:?}, boldest estimate {boldest:?}, {above} above the accuracy");
    println!("refused: {:?}", refused.clone().collect::<Vec<_>>());
    let bold = |limit: f64| outcomes.iter().filter(|o| o.3 > limit).count();
    println!(
        "error above what was told {}, above ten times {}, of {}",
        bold(1.0),
        bold(10.0),
        outcomes.len()
    );
    for outcome in &outcomes {
        assert!(outcome.2 <= 10.0, "{outcome:?}");
    }
    // What is told is what mostly comes out, and never far from it.
    assert!(bold(1.0) <= outcomes.len() / 40);
    assert_eq!(bold(10.0), 0);
    assert!(refused.count() <= 24);
}

/// Seventeen hundred turns without a closed form: what is reached is right, and what is not is refused.
#[test]
fn a_long_run_is_right_or_refused() {
    let (moments, center, g) = ([0.01, 0.015, 0.02], [0.05, 0.03, 0.1], 9.80665);
    let omega = [0.7, -1.1, 6.0];
    let case = suite::Case {
        kind: Kind::Heavy,
        moments,
        lever: center.map(|c| 0.3 * c * g),
        friction: 0.0,
        l: core::array::from_fn(|k| moments[k] * omega[k]),
        q: [0.9, 0.3, -0.2, 0.25],
        times: vec![1000.0],
    };
    let truth = case.truth(22);
    let motion = case.scene().simulate(&case.request(1e-8)).unwrap();
    let error = case.error(&motion, &truth);
    println!("{error:e}, told {:?}", motion.error_estimate);
    assert!(error < 1e-8 && error < motion.error_estimate.unwrap());
    let refused = case.scene().simulate(&case.request(1e-11));
    assert!(
        matches!(refused, Err(Error::Accuracy { .. })),
        "{refused:?}"
    );
}

/// The judge: two orders of Taylor series agree to more digits than it is asked for.
#[test]
fn the_truth_does_not_depend_on_its_order() {
    let all = cases(1);
    let worst = all
        .par_iter()
        .step_by(9)
        .map(|case| {
            let (a, b) = (case.truth(22), case.truth(30));
            let (a, b) = (a.last().unwrap().1, b.last().unwrap().1);
            let turned = (0..4).map(|k| (a.q[k] - b.q[k]).abs());
            let faster = (0..3).map(|k| (a.l[k] - b.l[k]).abs());
            turned.chain(faster).fold(0.0, f64::max)
        })
        .reduce(|| 0.0, f64::max);
    assert!(worst < 1e-15, "{worst:e}");
}
