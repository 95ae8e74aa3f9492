//! What the tests against the tables of 32 digits share: cells that are read once and exactly, and a report of the worst rows.

use std::collections::BTreeMap;

use spinning_bodies::frame::Attitude;

use crate::decimal::{decimal, hexadecimal};
use crate::double_double::Dd;
use crate::multiplied;

/// One line of a table, its cells by number.
pub struct Cells(Vec<&'static str>);

/// The lines below the head.
pub fn lines(table: &'static str) -> impl Iterator<Item = Cells> {
    let lines = table.lines().skip(1);
    lines.map(|line| Cells(line.split(',').collect()))
}

impl Cells {
    pub fn text(&self, cell: usize) -> &'static str {
        self.0[cell]
    }

    pub fn id(&self) -> usize {
        self.0[0].parse().expect("a number")
    }

    pub fn number(&self, cell: usize) -> f64 {
        self.0[cell].parse().expect("a number")
    }

    /// Floats that were printed exactly, from this cell on.
    pub fn exact<const N: usize>(&self, from: usize) -> [f64; N] {
        core::array::from_fn(|k| hexadecimal(self.0[from + k]))
    }

    /// Decimals of 32 digits, from this cell on.
    pub fn decimals<const N: usize>(&self, from: usize) -> [Dd; N] {
        core::array::from_fn(|k| decimal(self.0[from + k]))
    }
}

/// Twice the vector part of q⁻¹p in 106 bits: the angle between the attitudes without a subtraction from 1.
pub fn angle(found: &Attitude, exact: [Dd; 4]) -> f64 {
    let p = found.quaternion();
    let [a, b, c, d] = exact;
    let turn = multiplied([a, -b, -c, -d], [p.w, p.i, p.j, p.k].map(Dd::from));
    let [_, x, y, z] = turn.map(Dd::value);
    2.0 * x.hypot(y).hypot(z)
}

/// The three errors of an answer that is none.
pub const WRONG: [f64; 3] = [f64::INFINITY; 3];

/// The worst errors of each group and length of time, and the rows beyond the bar.
pub struct Report {
    /// What the three errors are of.
    names: [&'static str; 3],
    bar: f64,
    /// Each length of time by the greatest number of cycles in it, and how it is called.
    spans: &'static [(f64, &'static str)],
    worst: BTreeMap<(&'static str, usize), ([f64; 3], usize)>,
    failures: Vec<String>,
    rows: usize,
}

impl Report {
    pub fn new(names: [&'static str; 3], bar: f64, spans: &'static [(f64, &'static str)]) -> Self {
        Self {
            names,
            bar,
            spans,
            worst: BTreeMap::new(),
            failures: Vec::new(),
            rows: 0,
        }
    }

    /// One row after so many periods, or after so many turns where nothing has a period; `row` tells which it is.
    pub fn add(
        &mut self,
        group: &'static str,
        [periods, turns]: [f64; 2],
        errors: [f64; 3],
        row: impl FnOnce() -> String,
    ) {
        self.rows += 1;
        let cycles = if periods.is_finite() { periods } else { turns };
        let shorter = self.spans.iter().filter(|(most, _)| cycles > *most).count();
        let (worst, count) = self.worst.entry((group, shorter)).or_default();
        for (worst, error) in worst.iter_mut().zip(errors) {
            if error.is_nan() || error > *worst {
                *worst = error;
            }
        }
        *count += 1;
        if !errors.iter().all(|error| *error <= self.bar) {
            let shown = self.shown(errors);
            self.failures.push(format!("{}: {shown}", row()));
        }
    }

    fn shown(&self, errors: [f64; 3]) -> String {
        [0, 1, 2]
            .map(|k| format!("{} {:.1e}", self.names[k], errors[k]))
            .join(", ")
    }

    /// Prints the worst of each group and fails if a row is beyond the bar, or if there are not so many.
    pub fn finish(self, rows: usize) {
        for ((group, span), (errors, count)) in &self.worst {
            println!(
                "{group:>20} {:>16}, {count:>3} rows: {}",
                self.spans[*span].1,
                self.shown(*errors)
            );
        }
        assert_eq!(self.rows, rows);
        assert!(
            self.failures.is_empty(),
            "{} of {rows} rows\n{}",
            self.failures.len(),
            self.failures.join("\n")
        );
    }
}
