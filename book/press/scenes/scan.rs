//! Scans: one scene file, some of its numbers varied over a grid, all cores at work.

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
        match self.count {
            1 => self.from,
            count => self.from + (self.to - self.from) * (place as f64 / (count - 1) as f64),
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
        if !matches!(here, Value::Float(_) | Value::Integer(_)) {
            return Err(missing());
        }
        *here = Value::Float(value);
        Ok(())
    }
}

/// Runs the scene at every point of the grid, on all cores, and gives one line of CSV a point: the varied numbers, the last row of the
/// motion, and `ok` or why there is none. `done` is called after each.
///
/// # Errors
/// [`Error::Input`] for a file that is not a scene, or a number that it does not have; a point that fails is a line that says so.
pub fn scan(path: &Path, overs: &[Over], done: impl Fn() + Sync) -> Result<String> {
    let (name, text) = source(path)?;
    let table = super::table(&name, &text)?;
    let (_, request, _) = prepare(&name, &table)?;
    let count = points(&name, overs)?;
    let latest = (0..request.times().len())
        .max_by(|&i, &j| request.times()[i].total_cmp(&request.times()[j]));
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
        let outcome =
            prepare(&name, &table).and_then(|(scene, request, _)| scene.run(&name, &request));
        done();
        Ok((varied, outcome))
    });
    let lines: Vec<(Vec<f64>, Result<super::Table>)> = lines.collect::<Result<_>>()?;
    let columns = lines.iter().find_map(|(_, outcome)| outcome.as_ref().ok());
    let columns = columns.map_or(&[][..], |table| table.columns);
    let mut text = String::new();
    for over in overs {
        text += &format!("{},", over.path);
    }
    text += &format!("t,{},status\n", columns.join(","));
    for (varied, outcome) in &lines {
        for value in varied {
            text += &format!("{value:?},");
        }
        match (outcome, latest) {
            (Ok(table), Some(latest)) => {
                let (t, row) = table.row(latest);
                text += &format!("{t:?},");
                for number in row {
                    text += &format!("{number:?},");
                }
                text += "ok\n";
            }
            (Err(error), _) => {
                text += &",".repeat(columns.len() + 1);
                text += &format!("{}\n", error.to_string().replace([',', '\n'], ";"));
            }
            (Ok(_), None) => {}
        }
    }
    Ok(text)
}

/// How many points the grid has.
///
/// # Errors
/// [`Error::Input`] for more than a million.
pub fn points(name: &str, overs: &[Over]) -> Result<usize> {
    let count = overs
        .iter()
        .try_fold(1_usize, |n, over| n.checked_mul(over.count));
    count
        .filter(|&n| n <= MOST)
        .ok_or_else(|| Error::Input(format!("{name}: a scan has at most {MOST} points")))
}
