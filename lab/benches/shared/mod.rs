//! What the benchmarks share: bodies, tables, and whether there is anything to measure.

#![allow(
    dead_code,
    reason = "each of the benchmarks that include this file uses its own part"
)]

use std::fmt::Display;

/// Free tops: moments, L at the start, and the time over which states are asked.
pub const FREE_BODIES: [(&str, [f64; 3], [f64; 3], f64); 9] = [
    ("ordinary", [0.6, 0.8, 1.0], [1.8, 0.4, -0.9], 10.0),
    ("lamina", [1.0, 2.0, 3.0], [0.9, 1.5, 2.4], 10.0),
    ("the other sector", [0.6, 0.8, 1.0], [0.9, 0.4, 1.8], 10.0),
    ("racket, 1e-3", [1.0, 2.0, 3.0], [1e-3, 2.0, 3e-3], 100.0),
    (
        "2e-12 from the edge",
        [1.5, 3.0, 4.0],
        [1.0, 0.5, 2.0 + 4e-12],
        100.0,
    ),
    ("separatrix", [1.5, 3.0, 4.0], [1.0, 0.5, 2.0], 10.0),
    ("symmetric", [1.0, 1.0, 1.5], [0.3, 0.4, 2.0], 10.0),
    ("sphere", [1.0, 1.0, 1.0], [0.3, 0.4, 2.0], 10.0),
    ("a million turns", [0.6, 0.8, 1.0], [1.8, 0.4, -0.9], 1e6),
];

/// The head of a table.
pub fn head(title: &str, columns: &[&str]) {
    println!("\n{title}\n");
    line("", columns);
}

/// A line of it.
pub fn line(name: &str, cells: &[impl Display]) {
    let cells: String = cells.iter().map(|cell| format!(" {cell:>14}")).collect();
    println!("{name:>28}{cells}");
}

/// A line of numbers; what is not a number is not there.
pub fn numbers(name: &str, numbers: &[f64]) {
    let shown = |x: &f64| match x.abs() {
        _ if x.is_nan() => "-".to_owned(),
        0.0 | 1e-2..1e6 => format!("{x:.3}"),
        _ => format!("{x:.1e}"),
    };
    line(name, &numbers.iter().map(shown).collect::<Vec<_>>());
}

/// Whether this is `cargo test --benches`, which passes a flag: there is nothing to measure then.
pub fn only_tested() -> bool {
    std::env::args().any(|argument| argument == "--test")
}
