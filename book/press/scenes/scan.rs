//! Scans: one scene file, some of its numbers varied over a grid, all cores at work.

use std::io::Write;
use std::path::Path;
use std::str::FromStr;

use rayon::prelude::*;
use toml::{Table, Value};

use super::{prepare, source};
use crate::{Error, Result};

/// One number of a scene file and the values that it takes: `initial.omega.2=50..200:16`.
#[derive(Debug, Clone, PartialEq)]
pub struct Over {
    path: String,
    from: f64,
    to: f64,
    count: usize,
}

/// Most scenes of a scan.
const MOST: usize = 1_000_000;

impl FromStr for Over {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let expected = || {
            format!(
                "`{text}` should look like initial.omega.2=50..200:16, a number of the file, its range, and how many values"
            )
        };
        let (path, range) = text.split_once('=').ok_or_else(expected)?;
        let (range, count) = range.rsplit_once(':').ok_or_else(expected)?;
        let (from, to) = range.split_once("..").ok_or_else(expected)?;
        if to.starts_with('.') {
            // Three dots: one may be a decimal point, and nobody can tell which.
            return Err(expected());
        }
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|n| n.is_finite());
        let over = Self {
            path: path.trim().to_owned(),
            from: number(from).ok_or_else(expected)?,
            to: number(to).ok_or_else(expected)?,
            count: count.trim().parse().map_err(|_| expected())?,
        };
        if over.path.is_empty() || !(1..=MOST).contains(&over.count) {
            return Err(expected());
        }
        Ok(over)
    }
}

impl Over {
    fn value(&self, place: usize) -> f64 {
        if place == 0 {
            return self.from;
        }
        if place == self.count - 1 {
            return self.to;
        }
        let part = place as f64 / (self.count - 1) as f64;
        let span = self.to - self.from;
        if span.is_finite() {
            self.from + span * part
        } else {
            self.from * (1.0 - part) + self.to * part
        }
    }

    /// Puts a value in its place in the file.
    fn set(&self, name: &str, table: &mut Table, value: f64) -> Result<()> {
        let missing = || {
            Error::Input(format!(
                "{name}: there is no number `{}` to vary; keys are joined by dots, places in a list count from 0",
                self.path
            ))
        };
        let mut steps = self.path.split('.');
        let first = steps.next().ok_or_else(missing)?;
        let mut here = table.get_mut(first).ok_or_else(missing)?;
        for step in steps {
            here = match here {
                Value::Table(table) => table.get_mut(step),
                Value::Array(list) => step.parse::<usize>().ok().and_then(|k| list.get_mut(k)),
                _ => None,
            }
            .ok_or_else(missing)?;
        }
        *here = match here {
            // A whole number stays one as long as it can: some keys take no other.
            Value::Integer(_) if value.fract() == 0.0 && value.abs() < 1e15 => {
                Value::Integer(value as i64)
            }
            Value::Float(_) | Value::Integer(_) => Value::Float(value),
            _ => return Err(missing()),
        };
        Ok(())
    }
}

/// The keys that say how a body resists being turned, whatever its mass.
const ABSOLUTE: [&str; 3] = ["moments", "inertia", "axial"];

/// What a reader of the rows must know: the mass alone varies, beside an inertia that is not per mass.
fn warning(name: &str, table: &Table, overs: &[Over]) -> Option<String> {
    let varies = |key: &str| {
        let mut heads = overs.iter().map(|over| over.path.split('.').take(2));
        heads.any(|head| head.eq(["body", key]))
    };
    let body = table.get("body")?.as_table()?;
    let stays = ABSOLUTE.into_iter().find(|key| body.contains_key(*key))?;
    (varies("mass") && !ABSOLUTE.into_iter().any(varies)).then(|| {
        format!("{name}: `body.mass` varies and `{stays}` in [body] stays as it is: each row is another body, not the same one made heavier")
    })
}

/// Runs the scene at every point of the grid, on all cores, and gives one line of CSV a point: the varied numbers, the last row of the
/// motion, and `ok` or why there is none; beside them, whether any point could be run. `done` is called after each. A warning goes to standard error.
///
/// # Errors
/// [`Error::Input`] for a file that is not a scene, or a number that it does not have; a point that fails is a line that says so.
pub fn scan(path: &Path, overs: &[Over], done: impl Fn() + Sync) -> Result<(String, Result<()>)> {
    let (name, text) = source(path)?;
    let table = super::table(&name, &text)?;
    prepare(&name, &table)?;
    let count = points(&name, overs)?;
    if let Some(warning) = warning(&name, &table, overs) {
        // Nothing is left to be done if standard error is closed.
        let _ = writeln!(std::io::stderr(), "warning: {warning}");
    }
    let lines = (0..count).into_par_iter().map(|point| {
        let mut place = point;
        let mut table = table.clone();
        let mut varied = Vec::with_capacity(overs.len());
        // The last number named runs fastest.
        for over in overs.iter().rev() {
            let value = over.value(place % over.count);
            place /= over.count;
            over.set(&name, &mut table, value)?;
            varied.push(value);
        }
        varied.reverse();
        let outcome = prepare(&name, &table)
            .and_then(|(scene, request, _)| super::run(&name, &scene, &request));
        done();
        Ok((varied, outcome.map(last)))
    });
    let lines: Vec<(Vec<f64>, Result<Last>)> = lines.collect::<Result<_>>()?;
    let ran = lines.iter().find_map(|(_, outcome)| outcome.as_ref().ok());
    let columns = ran.map_or(&[][..], |last| &last.0);
    let paths = overs.iter().map(|over| over.path.as_str());
    let head = paths.chain(["t"]).chain(columns.iter().copied());
    let mut text = head.chain(["status"]).collect::<Vec<_>>().join(",") + "\n";
    for (varied, outcome) in &lines {
        for value in varied {
            text += &format!("{value:?},");
        }
        match outcome {
            Ok((_, row)) => {
                for number in row {
                    text += &format!("{number:?},");
                }
                text += "ok\n";
            }
            Err(error) => {
                text += &",".repeat(columns.len() + 1);
                text += &format!("{}\n", error.to_string().replace([',', '\n'], ";"));
            }
        }
    }
    let ran = match (ran, lines.first()) {
        (None, Some((_, Err(error)))) => Err(Error::Failed(format!(
            "no point of the scan could be run; the first: {error}"
        ))),
        _ => Ok(()),
    };
    Ok((text, ran))
}

/// The columns of a motion, and its latest row behind the time: what is left of it in a scan.
type Last = (Vec<&'static str>, Vec<f64>);

fn last(table: super::Table) -> Last {
    let latest = table.rows().max_by(|a, b| a.0.total_cmp(&b.0));
    let row = latest.map(|(t, row)| core::iter::once(t).chain(row).collect());
    let names = table.columns.iter().map(|column| column.name);
    (names.collect(), row.unwrap_or_default())
}

/// How many points the grid has.
///
/// # Errors
/// [`Error::Input`] for more than a million, and for a number that is to be varied twice.
pub fn points(name: &str, overs: &[Over]) -> Result<usize> {
    for (place, over) in overs.iter().enumerate() {
        if overs[..place].iter().any(|other| other.path == over.path) {
            let told = format!("{name}: `--over {}` stands twice", over.path);
            return Err(Error::Input(told));
        }
    }
    let count = overs
        .iter()
        .try_fold(1_usize, |n, over| n.checked_mul(over.count));
    count
        .filter(|&n| n <= MOST)
        .ok_or_else(|| Error::Input(format!("{name}: a scan has at most {MOST} points")))
}
