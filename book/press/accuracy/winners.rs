//! The table of the chapter, from the command's CSV file: the price of the closed form, and the cheapest method that steps.

use std::fmt::Write as _;

use lab::accuracy::measured::{EXACT, MOTIONS, SWEEP, TARGETS, ranking, rows};

/// A Markdown table: for each motion over its longest run the time of the closed form, and for each accuracy the quickest stepper with its own.
pub fn markdown() -> String {
    let rows = rows(SWEEP);
    let mut text = "| motion | exact | $10^{-3}$ | $10^{-6}$ | $10^{-9}$ | $10^{-12}$ |\n|---|---|---|---|---|---|\n"
        .to_owned();
    for (motion, name, [.., turns]) in MOTIONS {
        let run = format!("{motion}/{turns}");
        let told = |target: f64, exact: bool| {
            let ranked = ranking(&rows, &run, target);
            let first = ranked.iter().find(|row| (row.0 == EXACT) == exact);
            first.map(|&(method, seconds)| (method, time(seconds)))
        };
        let exact = TARGETS.iter().find_map(|&target| told(target, true));
        let _ = write!(
            text,
            "| {name} | {}",
            exact.map_or("—".to_owned(), |(_, time)| time)
        );
        for target in TARGETS {
            let cell = told(target, false);
            let cell = cell.map_or("—".to_owned(), |(method, time)| {
                format!("{method} {time}")
            });
            let _ = write!(text, " | {cell}");
        }
        text.push_str(" |\n");
    }
    text
}

fn time(seconds: f64) -> String {
    if seconds < 1e-3 {
        format!("{}\u{a0}µs", short(1e6 * seconds))
    } else {
        format!("{}\u{a0}ms", short(1e3 * seconds))
    }
}

/// Two digits: more would not be the same tomorrow.
fn short(value: f64) -> String {
    if value < 9.95 {
        format!("{value:.1}")
    } else {
        let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
        format!("{:.0}", (value / unit).round() * unit)
    }
}
