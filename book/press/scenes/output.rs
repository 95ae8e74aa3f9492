//! A motion as CSV or JSON, row by row; every number can be read back exactly.

use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;

use clap::ValueEnum;
use serde_json::{Value, json};
use spinning_bodies::conservation::Law;
use spinning_bodies::integrators::Cost;
use spinning_bodies::scene::Table;

use super::Motion;
use crate::Result;
use crate::writer::by_ending;

/// The format of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A header line, and a line for each row.
    Csv,
    /// One object: plan, cost, ledger, units and rows of a motion; rows and refused points of a scan.
    Json,
}

impl Format {
    /// The format asked for, or else the one given by the file's ending; CSV if neither decides.
    ///
    /// # Errors
    /// [`Error::Input`](crate::Error::Input) for a name with another ending, or with that of the other format.
    pub fn of(asked: Option<Self>, path: Option<&Path>) -> Result<Self> {
        let (what, known) = match &asked {
            None => ("CSV or JSON", Self::value_variants()),
            Some(Self::Csv) => ("CSV", &[Self::Csv][..]),
            Some(Self::Json) => ("JSON", &[Self::Json][..]),
        };
        let tells = |path: &&Path| {
            let ending = path.extension().unwrap_or_default();
            !ending.is_empty() && !ending.eq_ignore_ascii_case("txt")
        };
        by_ending(path.filter(tells), what, known)
    }

    /// Runs a scene and writes its rows as they are computed, however many there are. Nothing is written before the first row is known.
    ///
    /// # Errors
    /// Those of the writer, and inside them those of [`run`](Motion::run).
    pub fn write(self, motion: &Motion, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Csv => csv(motion, to),
            Self::Json => json(motion, to),
        }
    }
}

/// A long motion is run again for each part of this many rows, so that rows already written need not be kept. The steps up to the beginning of each part are repeated,
/// which costs little where rows are many.
const PART: usize = 200_000;

/// Summary of the parts of a motion.
struct Sum {
    cost: Cost,
    error: f64,
    /// Of each quantity of the ledger.
    drifts: Vec<f64>,
}

impl Sum {
    /// Of a part and those before it.
    fn of(table: &Table, before: Option<Self>) -> Self {
        let drifts = table.ledger.entries().iter();
        let mut sum = Self {
            cost: table.cost,
            error: table.error_estimate,
            drifts: drifts.map(|entry| entry.relative_drift()).collect(),
        };
        if let Some(before) = before {
            sum.cost += before.cost;
            sum.error = before.error.max(sum.error);
            for (drift, before) in sum.drifts.iter_mut().zip(before.drifts) {
                *drift = before.max(*drift);
            }
        }
        sum
    }

    /// The first lines of the object; what all parts have in common is that of the last one.
    fn told(&self, last: &Table, seconds: f64) -> String {
        let (plan, cost) = (&last.plan, &self.cost);
        let solver = plan.solver.name();
        let plan = json!({"solver": solver, "reason": plan.reason, "error_estimate": self.error});
        let cost =
            json!({"evaluations": cost.evaluations, "steps": cost.steps, "seconds": seconds});
        let entries = last.ledger.entries().iter().zip(&self.drifts);
        let entries = entries.map(|(entry, drift)| {
            let law = match entry.law {
                Law::Conserved => "conserved",
                Law::NonIncreasing => "non-increasing",
                Law::NonDecreasing => "non-decreasing",
            };
            json!({"quantity": entry.name, "law": law, "value": entry.first(), "drift": drift})
        });
        let ledger: Value = entries.collect();
        format!("  \"plan\": {plan},\n  \"cost\": {cost},\n  \"ledger\": {ledger}")
    }
}

fn is_long(motion: &Motion) -> bool {
    motion.request.times().len() > PART
}

/// A motion in parts. One that cannot be followed to its end is refused before the first.
fn parts(motion: &Motion) -> io::Result<impl Iterator<Item = io::Result<Table>>> {
    let run = |times: &[f64]| motion.awaited(times).map_err(io::Error::other);
    let times = motion.request.times();
    if is_long(motion) {
        let farther = |a: &f64, b: &f64| a.abs().total_cmp(&b.abs());
        run(times.iter().copied().max_by(farther).as_slice())?;
    }
    Ok(times.chunks(PART).map(run))
}

fn csv(motion: &Motion, to: &mut dyn Write) -> io::Result<()> {
    for (place, table) in parts(motion)?.enumerate() {
        let table = table?;
        if place == 0 {
            to.write_all(b"t")?;
            for column in &table.columns {
                write!(to, ",{}", column.name)?;
            }
            to.write_all(b"\n")?;
        }
        for (t, numbers) in table.rows() {
            // `{:?}` is the shortest text that is read back as the same number.
            write!(to, "{t:?}")?;
            for number in numbers {
                write!(to, ",{number:?}")?;
            }
            to.write_all(b"\n")?;
        }
    }
    Ok(())
}

/// One object: plan, cost, ledger, units, rows; for a long motion the rows come first, because the rest is known only after them.
fn json(motion: &Motion, to: &mut dyn Write) -> io::Result<()> {
    let begin = Instant::now();
    let (long, mut before, mut sum, mut told) = (is_long(motion), "\n    ", None, String::new());
    for table in parts(motion)? {
        let table = table?;
        let first = sum.is_none();
        let now = Sum::of(&table, sum);
        told = now.told(&table, begin.elapsed().as_secs_f64());
        sum = Some(now);
        if first {
            to.write_all(b"{\n")?;
            if !long {
                writeln!(to, "{told},")?;
            }
            let named = table
                .columns
                .iter()
                .map(|column| (column.name, column.unit));
            let units: Value = std::iter::once(("t", "s")).chain(named).collect();
            write!(to, "  \"units\": {units},\n  \"rows\": [")?;
        }
        for (t, numbers) in table.rows() {
            write!(to, "{before}{{\"t\":{t:?}")?;
            before = ",\n    ";
            for (column, number) in table.columns.iter().zip(numbers) {
                write!(to, ",\"{}\":{number:?}", column.name)?;
            }
            to.write_all(b"}")?;
        }
    }
    to.write_all(b"\n  ]")?;
    if long {
        write!(to, ",\n{told}")?;
    }
    to.write_all(b"\n}\n")
}
