//! A motion as CSV or JSON; every number is read back exactly.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use serde_json::{Map, Value, json};
use spinning_bodies::conservation::Law;

use super::Table;
use crate::{Error, Result};

/// How a motion is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// A header line, and one row a time.
    Csv,
    /// One object: plan, cost, ledger, rows.
    Json,
}

/// The text of a motion.
pub fn text(table: &Table, seconds: f64, format: Format) -> String {
    match format {
        Format::Csv => csv(table),
        Format::Json => format!("{:#}\n", object(table, seconds)),
    }
}

fn csv(table: &Table) -> String {
    let mut text = format!("t,{}\n", table.columns.join(","));
    for (t, numbers) in &table.rows {
        // `{:?}` is the shortest text that is read back as the same number. Writing to a string cannot fail.
        let _ = write!(text, "{t:?}");
        for number in numbers {
            let _ = write!(text, ",{number:?}");
        }
        text.push('\n');
    }
    text
}

fn object(table: &Table, seconds: f64) -> Value {
    let rows = table.rows.iter().map(|(t, numbers)| {
        let named = table.columns.iter().map(|name| (*name).to_owned());
        let numbers = numbers.iter().map(|&number| json!(number));
        let first = [("t".to_owned(), json!(t))];
        Value::Object(Map::from_iter(first.into_iter().chain(named.zip(numbers))))
    });
    let ledger = table.ledger.entries().iter().map(|entry| {
        json!({
            "quantity": entry.name(),
            "law": match entry.law() {
                Law::Conserved => "conserved",
                Law::NonIncreasing => "non-increasing",
                Law::NonDecreasing => "non-decreasing",
            },
            "value": entry.first(),
            "drift": entry.relative_drift(),
        })
    });
    json!({
        "plan": {
            "solver": table.plan.solver.name(),
            "reason": table.plan.reason,
            "error_estimate": table.error_estimate,
        },
        "cost": {
            "evaluations": table.cost.evaluations,
            "steps": table.cost.steps,
            "seconds": seconds,
        },
        "ledger": ledger.collect::<Vec<Value>>(),
        "rows": rows.collect::<Vec<Value>>(),
    })
}

/// Writes a file whole or not at all: beside, then renamed.
///
/// # Errors
/// [`Error::File`].
pub fn write(path: &Path, text: &str) -> Result<()> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut beside = tempfile::NamedTempFile::new_in(folder).map_err(Error::file(path))?;
    beside
        .write_all(text.as_bytes())
        .map_err(Error::file(path))?;
    beside
        .persist(path)
        .map_err(|error| Error::file(path)(error.error))?;
    Ok(())
}
