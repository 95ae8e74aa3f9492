//! A motion as CSV or JSON, row by row; every number is read back exactly.

use std::io::{self, Write};
use std::path::Path;

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Value, json};
use spinning_bodies::conservation::Law;
use spinning_bodies::scene::Column;

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

impl Format {
    /// The format asked for, or else the one that a file's name ends with; CSV if nothing tells. The name of a device or a pipe tells nothing.
    ///
    /// # Errors
    /// [`Error::Input`] for a name that ends as neither does, or as the other one.
    pub fn of(asked: Option<Self>, path: Option<&Path>) -> Result<Self> {
        let file = path.filter(|path| path.is_file() || !path.exists());
        let ending = file.and_then(Path::extension).unwrap_or_default();
        let ending = ending.to_string_lossy().to_ascii_lowercase();
        match (ending.as_str(), asked) {
            ("json", None | Some(Self::Json)) => Ok(Self::Json),
            ("csv" | "txt", None | Some(Self::Csv)) => Ok(Self::Csv),
            ("txt", Some(Self::Json)) => Ok(Self::Json),
            ("", asked) => Ok(asked.unwrap_or(Self::Csv)),
            (_, asked) => {
                let (wanted, ending) = match asked {
                    Some(Self::Json) => ("JSON", "`.json`"),
                    Some(Self::Csv) => ("CSV", "`.csv`"),
                    None => ("CSV or JSON", "`.csv` or `.json`"),
                };
                let name = path.unwrap_or(Path::new("")).display();
                Err(Error::Input(format!(
                    "{name}: what is written is {wanted}, and its name should end with {ending}"
                )))
            }
        }
    }

    /// Writes a motion.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write(self, table: &Table, seconds: f64, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Csv => csv(table, to),
            Self::Json => {
                serde_json::to_writer_pretty(&mut *to, &Whole { table, seconds })?;
                to.write_all(b"\n")
            }
        }
    }
}

/// The text of a motion.
pub fn text(table: &Table, seconds: f64, format: Format) -> String {
    let mut text = Vec::new();
    // Writing to memory cannot fail.
    let _ = format.write(table, seconds, &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

fn csv(table: &Table, to: &mut dyn Write) -> io::Result<()> {
    to.write_all(b"t")?;
    for column in &table.columns {
        write!(to, ",{}", column.name)?;
    }
    to.write_all(b"\n")?;
    for (t, numbers) in table.rows() {
        // `{:?}` is the shortest text that is read back as the same number.
        write!(to, "{t:?}")?;
        for number in numbers {
            write!(to, ",{number:?}")?;
        }
        to.write_all(b"\n")?;
    }
    Ok(())
}

struct Whole<'a> {
    table: &'a Table,
    seconds: f64,
}

impl Serialize for Whole<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let Table {
            plan,
            cost,
            error_estimate,
            ledger,
            ..
        } = self.table;
        let plan = json!({
            "solver": plan.solver.name(),
            "reason": plan.reason,
            "error_estimate": error_estimate,
        });
        let cost = json!({
            "evaluations": cost.evaluations,
            "steps": cost.steps,
            "seconds": self.seconds,
        });
        let ledger = ledger.entries().iter().map(|entry| {
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
        let mut whole = serializer.serialize_map(Some(4))?;
        whole.serialize_entry("plan", &plan)?;
        whole.serialize_entry("cost", &cost)?;
        whole.serialize_entry("ledger", &ledger.collect::<Value>())?;
        whole.serialize_entry("rows", &Rows(self.table))?;
        whole.end()
    }
}

struct Rows<'a>(&'a Table);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let columns = &self.0.columns;
        serializer.collect_seq(self.0.rows().map(|(t, numbers)| Row(columns, t, numbers)))
    }
}

struct Row<'a>(&'a [Column], f64, Vec<f64>);

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let numbers = self.0.iter().map(|column| column.name).zip(&self.2);
        serializer.collect_map(core::iter::once(("t", &self.1)).chain(numbers))
    }
}
