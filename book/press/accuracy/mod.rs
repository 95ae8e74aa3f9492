//! The command `accuracy`: every method on the motions of [`lab::accuracy`], timed here and now.
//!
//! | module | what it does |
//! |---|---|
//! | [`patience`] | the sweep of a method; what would take too long |
//! | [`table`] | the table that a person reads, with the winners |
//! | [`scene`] | a scene file as a problem |
//! | [`winners`] | the table of the chapter |

pub mod patience;
pub mod scene;
pub mod table;
pub mod winners;

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use lab::accuracy::{Measurement, NAMES, Problem, candidates, named, problems};

use crate::progress::watched;
use crate::scenes::{self, output::Format};
use crate::writer::Target;
use crate::{Error, Result};

/// The header of the CSV file.
pub const HEADER: &str =
    "problem,method,parameter,error_attitude,error_omega,evaluations,steps,seconds,status";

/// One method on one problem.
#[derive(Debug)]
pub struct Swept {
    /// Its measurements, from coarse to fine.
    pub rows: Vec<Measurement>,
    /// Its name.
    pub method: String,
    /// How many finer efforts would have taken too long.
    pub left_out: usize,
}

/// Measures a problem (or its lengths, or a scene file), or all of them; writes the CSV file, and gives the tables.
///
/// # Errors
/// [`Error::Input`] for an unknown name, a scene that cannot be measured, or a file that cannot be there; [`Error::File`].
pub fn run(root: &Path, scene: Option<&str>, csv: Option<&Path>) -> Result<String> {
    let file = scene.and_then(|name| scenes::file(root, Path::new(name)));
    Format::of(Some(Format::Csv), csv)?;
    let target = csv.map(|path| Target::new(Some(path), file.as_deref()));
    let target = target.transpose()?;
    // What is measured, for whoever waits.
    let now = Mutex::new((0.0, "the reference motion".to_owned()));
    let lock = || now.lock().unwrap_or_else(PoisonError::into_inner);
    let how_far = || {
        let (part, told) = &*lock();
        (*part, format!("measuring: {told}"))
    };
    let (text, rows) = watched(how_far, || -> Result<(String, String)> {
        let chosen = match scene {
            None => problems().map_err(broken)?,
            Some(name) => chosen(name, file.as_deref())?,
        };
        if cfg!(debug_assertions) {
            let _ = writeln!(
                std::io::stderr(),
                "this is a debug build: errors and evaluations only; for times, cargo run --release -- accuracy"
            );
        }
        let (mut text, mut rows) = (String::new(), format!("{HEADER}\n"));
        for (place, problem) in chosen.iter().enumerate() {
            let methods = candidates(problem).map_err(broken)?;
            let mut swept = Vec::new();
            for (done, candidate) in methods.iter().enumerate() {
                let part = done as f64 / methods.len() as f64;
                let (place, all) = (place as f64, chosen.len());
                let told = format!(
                    "{} of {all} problems done, now {} by {}",
                    place,
                    problem.name(),
                    candidate.name()
                );
                *lock() = ((place + part) / all as f64, told);
                swept.push(patience::swept(problem, candidate));
            }
            text.push_str(&table::text(problem, &swept));
            for row in swept.iter().flat_map(|s| &s.rows) {
                rows.push_str(&line(row));
            }
        }
        Ok((text, rows))
    })?;
    if let Some(target) = target {
        target.write(|to| to.write_all(rows.as_bytes()))?;
    }
    Ok(text)
}

/// The problems that a name stands for: those of the library first, then scene files.
fn chosen(name: &str, file: Option<&Path>) -> Result<Vec<Problem>> {
    let found = named(name).map_err(broken)?;
    if !found.is_empty() {
        return Ok(found);
    }
    match file {
        Some(file) => Ok(vec![scene::problem(file)?]),
        None => Err(Error::Input(format!(
            "'{name}' is neither a problem nor a scene file; problems are {}, one length of them {}/10",
            NAMES.join(", "),
            NAMES[0],
        ))),
    }
}

fn broken(error: spinning_bodies::Error) -> Error {
    Error::Failed(error.to_string())
}

fn line(row: &Measurement) -> String {
    let mut text = format!("{},{}", row.problem, row.method);
    for number in [row.parameter, row.error_attitude, row.error_omega] {
        // `{:?}` is the shortest text that is read back as the same number. Writing to a string cannot fail.
        let _ = write!(text, ",{number:?}");
    }
    let seconds = row.seconds.map_or(String::new(), |s| format!("{s:?}"));
    let status = row.status.word();
    let _ = writeln!(
        text,
        ",{},{},{seconds},{status}",
        row.evaluations, row.steps
    );
    text
}
