//! A motion as CSV or JSON, row by row; every number is read back exactly.

use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;

use serde_json::{Map, Value, json};
use spinning_bodies::conservation::Law;
use spinning_bodies::integrators::Cost;
use spinning_bodies::scene::{AnyScene, Plan, Progress, Reached, Request, Table};

use crate::progress::watched;
use crate::{Error, Result};

/// How a motion is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// A header line, and one row a time.
    Csv,
    /// One object: plan, cost, ledger, units, rows.
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

    /// Runs a scene and writes its rows as they come, however many there are. Nothing is written before the first of them can be.
    ///
    /// # Errors
    /// What the writer says; what [`run`](super::run) says, inside.
    pub fn write(self, motion: &Motion<'_>, to: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Csv => csv(motion, to),
            Self::Json => json(motion, to),
        }
    }
}

/// A scene that will be run.
#[derive(Debug, Clone, Copy)]
pub struct Motion<'a> {
    /// The file's name.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a AnyScene,
    /// What is asked of it.
    pub request: &'a Request,
}

/// A long motion is run again and again to so many rows further: what has been written is not kept. The steps to the beginning of each part are taken anew,
/// which costs little where rows are many.
const PART: usize = 200_000;

/// What is told of all parts.
struct Told {
    plan: Plan,
    cost: Cost,
    error: f64,
    /// Quantity, law, value at the start, relative drift.
    ledger: Vec<(&'static str, &'static str, f64, f64)>,
}

impl Told {
    fn with(before: Option<Self>, table: &Table) -> Self {
        let entries = table.ledger.entries().iter().map(|entry| {
            let law = match entry.law {
                Law::Conserved => "conserved",
                Law::NonIncreasing => "non-increasing",
                Law::NonDecreasing => "non-decreasing",
            };
            (entry.name, law, entry.first(), entry.relative_drift())
        });
        let ledger: Vec<_> = entries.collect();
        let Some(mut told) = before else {
            return Self {
                plan: table.plan.clone(),
                cost: table.cost,
                error: table.error_estimate,
                ledger,
            };
        };
        told.cost += table.cost;
        told.error = told.error.max(table.error_estimate);
        for (entry, new) in told.ledger.iter_mut().zip(ledger) {
            entry.3 = entry.3.max(new.3);
        }
        told
    }
}

impl Motion<'_> {
    /// The first and the last of the times that are asked for, s.
    pub fn ends(&self) -> [f64; 2] {
        let times = self.request.times().iter();
        let [least, greatest] = [f64::INFINITY, f64::NEG_INFINITY];
        times.fold([least, greatest], |[low, high], &t| {
            [low.min(t), high.max(t)]
        })
    }

    /// The time from the first to the last, s, for an option that draws what goes on in it.
    ///
    /// # Errors
    /// [`Error::Input`] for a single time.
    pub fn span(&self, option: &str) -> Result<f64> {
        let [first, last] = self.ends();
        if last > first {
            return Ok(last - first);
        }
        let name = self.name;
        let told = "key `until` or `times` in [run]: expected times that go on, got one";
        Err(Error::Input(format!("{option}: {name}: {told}")))
    }

    fn is_long(&self) -> bool {
        self.request.times().len() > PART
    }

    /// The motion at these times, s, with a bar for whoever waits.
    ///
    /// # Errors
    /// As for [`run`](super::run).
    pub fn table(&self, times: &[f64]) -> Result<Table> {
        let progress = Progress::default();
        let request = self.request.of_times(times).watched(&progress);
        let how_far = || how_far(&progress);
        watched(how_far, || super::run(self.name, self.scene, &request))
    }

    /// Hands on the motion in parts, with what is told so far, and whether it is the first part.
    fn each(
        &self,
        mut hand_on: impl FnMut(&Table, &Told, bool) -> io::Result<()>,
    ) -> io::Result<Option<Told>> {
        let run = |times: &[f64]| self.table(times).map_err(io::Error::other);
        if self.is_long() {
            // What cannot be followed to its end is refused before anything is written.
            let farther = |a: &f64, b: &f64| a.abs().total_cmp(&b.abs());
            let furthest = self.request.times().iter().copied().max_by(farther);
            run(furthest.as_slice())?;
        }
        let mut told = None;
        for times in self.request.times().chunks(PART) {
            let (table, first) = (run(times)?, told.is_none());
            let now = Told::with(told, &table);
            hand_on(&table, &now, first)?;
            told = Some(now);
        }
        Ok(told)
    }
}

/// How far a motion has come, for a bar and in words.
fn how_far(progress: &Progress) -> (f64, String) {
    let Reached {
        evaluations,
        most,
        time,
        until,
    } = progress.reached();
    let millions = |evaluations: u64| evaluations as f64 / 1e6;
    let told = format!(
        "simulating: t = {time:.4e} of {until:.4e} s, {:.0} of at most {:.0} million evaluations",
        millions(evaluations),
        millions(most)
    );
    (time / until, told)
}

fn csv(motion: &Motion<'_>, to: &mut dyn Write) -> io::Result<()> {
    let told = motion.each(|table, _, first| {
        if first {
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
        Ok(())
    });
    told.map(drop)
}

/// One object: plan, cost, ledger, units, rows; of a long motion the rows come first, for the rest is not known before they are.
fn json(motion: &Motion<'_>, to: &mut dyn Write) -> io::Result<()> {
    let begin = Instant::now();
    let about = |told: &Told, to: &mut dyn Write| -> io::Result<()> {
        let ledger = told.ledger.iter().map(|(name, law, first, drift)| {
            json!({"quantity": name, "law": law, "value": first, "drift": drift})
        });
        let about = [
            (
                "plan",
                json!({"solver": told.plan.solver.name(), "reason": told.plan.reason, "error_estimate": told.error}),
            ),
            (
                "cost",
                json!({"evaluations": told.cost.evaluations, "steps": told.cost.steps, "seconds": begin.elapsed().as_secs_f64()}),
            ),
            ("ledger", ledger.collect()),
        ];
        let lines = about.map(|(name, value)| format!("  \"{name}\": {value}"));
        to.write_all(lines.join(",\n").as_bytes())
    };
    let (long, mut before) = (motion.is_long(), "\n    ");
    let told = motion.each(|table, told, first| {
        if first {
            to.write_all(b"{\n")?;
            if !long {
                about(told, to)?;
                to.write_all(b",\n")?;
            }
            let mut units = Map::from_iter([("t".to_owned(), json!("s"))]);
            for column in &table.columns {
                units.insert(column.name.to_owned(), json!(column.unit));
            }
            let units = Value::Object(units);
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
        Ok(())
    })?;
    to.write_all(b"\n  ]")?;
    if let Some(told) = told.filter(|_| long) {
        to.write_all(b",\n")?;
        about(&told, to)?;
    }
    to.write_all(b"\n}\n")
}
