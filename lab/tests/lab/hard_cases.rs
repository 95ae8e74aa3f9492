//! The formula of the textbook beside ours, on the cases of the chapter "Hard cases".

use lab::hard_cases::{Comparison, families, named};
use support::observed;

/// Observed: 2.9e-16 at most; 1.0e-15 for the longest time, where a phase of 106 bits begins to show.
#[test]
fn ours_are_right_to_a_rounding_at_every_step() {
    for family in families() {
        for step in family.comparisons().unwrap() {
            let long = family.name == "long-time";
            let phase = if long { 1e-30 / step.nearness } else { 0.0 };
            assert!(step.ours < 4e-16 + phase, "{}: {step:?}", family.name);
        }
    }
}

/// The cases are hard, and they become hard: the formula has 13 digits or more at the first step and four at most at the last.
#[test]
fn the_textbook_is_right_on_paper_and_runs_out_of_digits() {
    for family in families() {
        let steps = family.comparisons().unwrap();
        assert_eq!(steps.len(), family.inputs().unwrap().len());
        let (first, last) = (steps[0], steps[steps.len() - 1]);
        observed!(first.textbook, 2e-15..=1e-14, "{}: {first:?}", family.name);
        // Not a number is no answer.
        let lost = last.textbook.is_nan() || last.textbook > 5e-8;
        assert!(lost, "{}: {last:?}", family.name);
        let nearer = |pair: &[Comparison]| pair[1].nearness < pair[0].nearness;
        assert!(steps.windows(2).all(nearer));
    }
}

/// No line of the table belongs to no family, and none is left out.
#[test]
fn every_row_of_the_table_is_a_step() {
    let table = include_str!("../../../tests/reference/hard_cases.csv");
    let steps = families().map(|family| family.comparisons().unwrap().len());
    assert!(steps.iter().all(|&count| count >= 14), "{steps:?}");
    assert_eq!(steps.iter().sum::<usize>(), table.lines().count() - 1);
}

#[test]
fn what_is_not_there_is_not_found() {
    assert!(named("far-side").is_none());
    assert!(named("needle").is_some_and(|family| (family.ours)(&[]).is_err()));
}
