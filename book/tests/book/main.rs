//! The book and its press: the chapters as they are written, the pages as they are printed, and every command with what it refuses.

mod accuracy;
mod accuracy_page;
mod chapters;
mod columns;
mod command;
mod ebook;
mod hard_cases_page;
mod ledger;
mod numbers;
mod own_words;
mod pages;
mod scan;
mod scene_prices;
mod scenes;

use press::drawings::{self, Drawing};
use std::process::Output;
use std::sync::OnceLock;

/// A scene file.
const RACKET: &str = "
title = \"A racket\"
[body]
moments = [1.0, 2.0, 3.0]
[initial]
omega = [0.01, 1.0, 0.01]
[effects]
[run]
until = 10.0
samples = 11
";

/// All figures as they are printed, drawn once.
fn drawings() -> &'static [Drawing] {
    static DRAWINGS: OnceLock<Vec<Drawing>> = OnceLock::new();
    DRAWINGS
        .get_or_init(|| drawings::draw(figures::all(), &figures::Values::default(), || ()).unwrap())
}

/// No fault, or all of them.
fn none(faults: &[String]) {
    assert!(
        faults.is_empty(),
        "{} faults:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Exit status 2, one line that has these words, and nothing printed.
fn refused(output: &Output, words: &[&str]) {
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert_eq!(told.lines().count(), 1, "{told}");
    for word in words {
        assert!(told.contains(word), "{word}: {told}");
    }
    assert!(output.stdout.is_empty());
}
