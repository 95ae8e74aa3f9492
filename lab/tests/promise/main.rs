//! The promise of a scene: what it returns is within the accuracy asked, attitude in radians and Ω relative to the fastest rate of the
//! motion; every answer carries an estimate, and it is never below the error. At accuracies of 1e-10 and coarser no free or Lagrange
//! top is refused, nor any motion in which a change of 1e-15 in the start grows to less than a tenth of the accuracy; each refusal
//! names the growth. The median run costs at most three times the evaluations of the cheapest that would have done.

mod door;
mod extrapolation;
mod kinds;
mod number;
mod random;
mod top_series;
mod tops;
mod verdict;

use rayon::prelude::*;
use verdict::{Judged, Outcome};

/// Cases of the strata with this in their name, one of so many.
fn chosen(strata: &[(&'static str, usize)], only: &str, of: usize) -> Vec<(usize, usize)> {
    let wanted = strata.iter().enumerate();
    wanted
        .filter(|(_, stratum)| stratum.0.contains(only))
        .flat_map(|(place, stratum)| (0..stratum.1.div_ceil(of)).map(move |n| (place, n)))
        .collect()
}

/// Judged side by side: the outcome of a case, and its text.
fn run(
    strata: &[(&'static str, usize)],
    only: &str,
    of: usize,
    case: impl Fn(usize, usize) -> (Outcome, String) + Sync,
) -> Vec<Judged> {
    chosen(strata, only, of)
        .par_iter()
        .map(|&(place, number)| {
            let (outcome, text) = case(place, number);
            Judged {
                stratum: strata[place].0,
                number,
                outcome,
                text,
            }
        })
        .collect()
}

fn tops(only: &str, of: usize) -> Vec<Judged> {
    let strata = tops::STRATA.map(|(name, count, _)| (name, count));
    run(&strata, only, of, |place, number| {
        let case = tops::case(place, number);
        (case.judged(), case.text())
    })
}

fn scenes(only: &str, of: usize) -> Vec<Judged> {
    let strata = kinds::STRATA.map(|(name, count, _)| (name, count));
    run(&strata, only, of, |place, number| {
        let case = kinds::case(place, number);
        (case.judged(), case.text())
    })
}

/// All of them are kept.
fn keep(all: &[Judged]) {
    let broken = all.iter().any(|judged| !judged.outcome.faults().is_empty());
    println!("{}", verdict::table(all));
    assert!(!broken, "{}", verdict::report(all, 3));
}

/// Part of a stratum's name, to look at it alone.
fn only() -> String {
    std::env::var("STRATUM").unwrap_or_default()
}

#[test]
fn three_hundred_keep_the_promise() {
    let mut all = tops("", 20);
    all.extend(scenes("", 20));
    keep(&all);
}

/// By one displaced start, and with what steps round counted once, all were answered, and were off by 2.0, 1.2 and 1.2 times the accuracy.
#[test]
fn errors_that_cancel_are_seen() {
    for case in tops::with_errors_that_cancel() {
        let outcome = case.judged();
        assert!(outcome.faults().is_empty(), "{outcome:?}");
    }
}

/// It rocks without slip over 500 radians and makes a change of its start 200 times as great. With steps whose errors were eight times as large it was refused.
#[test]
fn a_long_rocking_is_answered() {
    const ROCKING: &str = "kind = \"table-top\"
        [body]\nmass = 0.43\nmoments = [1.75e-5, 5.8e-5, 5.65e-5]\nsemi_axes = [0.024, 0.0107, 0.0094]
        [initial]\ntilt = 2.593\nazimuth = 3.013\naxial_spin = 0.0
        [effects]\ngravity = 9.81\nfriction_law = \"no-slip\"\npivoting_resistance = 1.6e-5
        [run]\ntimes = [4, 8, 12, 16, 20]\naccuracy = 1e-10\n";
    let by = |solver: &str| match door::simulate(&format!("{ROCKING}solver = \"{solver}\"\n")) {
        door::Answer::Motion(motion) => motion,
        door::Answer::Refused(why) => panic!("{solver}: {why}"),
    };
    let [ours, others] = ["auto", "verner98"].map(by);
    let [rows, beside] =
        [&ours, &others].map(|motion| motion.rows(&["omega1", "omega2", "omega3"]));
    let (numbers, beside) = (rows.concat(), beside.concat());
    let apart = numbers
        .iter()
        .zip(&beside)
        .map(|(a, b)| (*a - *b).value().abs());
    let fastest = support::greatest(numbers.iter().map(|rate| rate.value().abs()));
    let apart = support::greatest(apart) / fastest;
    assert!(apart < ours.estimate + others.estimate, "{apart:e}");
}

#[test]
#[ignore = "two hundred and fifty tops, three thousand times: .ci/run"]
fn no_top_at_the_edge_of_refusal_is_off() {
    let strata = tops::STRATA.map(|(name, count, _)| (name, count));
    let tops = chosen(&strata, &only(), 20);
    let judged = tops.par_iter().flat_map_iter(|&(place, number)| {
        let case = tops::case(place, number);
        let text = case.text();
        let outcomes = case.judged_at_the_edge().into_iter();
        outcomes.map(move |outcome| Judged {
            stratum: strata[place].0,
            number,
            outcome,
            text: text.clone(),
        })
    });
    keep(&judged.collect::<Vec<_>>());
}

#[test]
#[ignore = "five thousand: .ci/run"]
fn every_top_keeps_the_promise() {
    let all = tops(&only(), 1);
    keep(&all);
    let cost = verdict::cost(&all);
    assert!(
        cost.is_nan() || cost <= 3.0,
        "the median run costs {cost} times the cheapest"
    );
}

#[test]
#[ignore = "a thousand: .ci/run"]
fn every_scene_keeps_the_promise() {
    keep(&scenes(&only(), 1));
}
