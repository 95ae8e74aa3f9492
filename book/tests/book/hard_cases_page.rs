//! The table of the chapter "Hard cases" is what the library computes.

use super::kept;

use lab::hard_cases::{Comparison, families};

/// How close, and the heading.
const COLUMNS: [(f64, &str); 4] = [
    (1e-3, "$10^{-3}$"),
    (1e-6, "$10^{-6}$"),
    (1e-9, "$10^{-9}$"),
    (1e-12, "$10^{-12}$"),
];

/// How many digits are right.
fn digits(error: f64) -> String {
    // No answer has none.
    let right = if error.is_nan() { 0.0 } else { -error.log10() };
    format!("{:.0}", right.max(0.0).round().abs())
}

/// Several formulas, each on its line.
fn lines(formulas: &str) -> String {
    formulas.replace(",\\;", "$<br />$")
}

fn table() -> String {
    let mut text = String::from("| asked | as printed, and instead | ");
    let headings: Vec<&str> = COLUMNS.iter().map(|column| column.1).collect();
    text += &headings.join(" | ");
    text += " | ours |\n|---|---|---|---|---|---|---|\n";
    for family in families() {
        let steps = family.comparisons().unwrap();
        let at = |nearness: f64| {
            let off = |step: &&Comparison| (step.nearness / nearness).ln().abs();
            let best = steps.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
            digits(best.unwrap().textbook)
        };
        let cells: Vec<String> = COLUMNS.iter().map(|column| at(column.0)).collect();
        let worst = steps.iter().map(|step| step.ours).fold(0.0, f64::max);
        let (name, of, at) = (
            family.name.replace('-', " "),
            family.quantity,
            family.paragraph,
        );
        let (printed, cure) = (lines(family.printed), lines(family.cure));
        text += &format!("| **{name}**: {of} ({at}) | ${printed}$<br />${cure}$ | ");
        text += &format!("{} | {} |\n", cells.join(" | "), digits(worst));
    }
    text
}

#[test]
fn the_table_is_what_is_computed() {
    kept("src/tables/hard-cases.md", &table());
}
