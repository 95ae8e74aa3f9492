//! The command `accuracy`: every method on the motions of [`spinning_bodies::accuracy`], timed here and now.
//!
//! | module | what it does |
//! |---|---|
//! | [`stopwatch`] | the least of repeated runs; what would take too long |
//! | [`table`] | the table that a person reads, with the winners |
//! | [`scene`] | a scene file as a problem |
//! | [`winners`] | the table of the chapter |

pub mod scene;
pub mod stopwatch;
pub mod table;
pub mod winners;

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};
use spinning_bodies::accuracy::{
    Judged, Measurement, NAMES, Problem, candidates, named, problems, sweep,
};

use crate::scenes::output;
use crate::{Error, Result};
use stopwatch::{Stopwatch, Times};

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
    if let Some(file) = csv {
        writable(file)?;
    }
    let chosen = match scene {
        None => problems().map_err(broken)?,
        Some(name) => chosen(root, name)?,
    };
    let times = if cfg!(debug_assertions) {
        let _ = writeln!(
            std::io::stderr(),
            "this is a debug build: errors and evaluations only; for times, cargo run --release -- accuracy"
        );
        Times::None
    } else {
        Times::Least
    };
    let (mut text, mut rows) = (String::new(), format!("{HEADER}\n"));
    let bar = ProgressBar::new(chosen.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:32} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    for problem in &chosen {
        let swept = measured(problem, times, &bar)?;
        text.push_str(&table::text(problem, &swept));
        for row in swept.iter().flat_map(|s| &s.rows) {
            rows.push_str(&line(row));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(file) = csv {
        output::write(file, &rows)?;
    }
    Ok(text)
}

/// Every method that can run the problem.
fn measured(problem: &Problem, times: Times, bar: &ProgressBar) -> Result<Vec<Swept>> {
    let mut all = Vec::new();
    for candidate in candidates(problem).map_err(broken)? {
        bar.set_message(format!("{} {}", problem.name(), candidate.name()));
        let watch = Stopwatch::new(times);
        let rows = sweep(
            problem,
            &candidate,
            Judged::AtTheEnd,
            &mut |run| watch.time(run),
            &mut |rows, next| watch.affords(problem, &candidate, rows, next),
        );
        all.push(Swept {
            left_out: if watch.gave_up() {
                candidate.efforts().len() - rows.len()
            } else {
                0
            },
            rows,
            method: candidate.name().to_owned(),
        });
    }
    Ok(all)
}

/// The problems that a name stands for: those of the library first, then scene files.
fn chosen(root: &Path, name: &str) -> Result<Vec<Problem>> {
    let found = named(name).map_err(broken)?;
    if !found.is_empty() {
        return Ok(found);
    }
    match scene::file(root, name) {
        Some(file) => Ok(vec![scene::problem(&file)?]),
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

/// Whether a file can be there, asked before minutes of measuring.
fn writable(file: &Path) -> Result<()> {
    let folder = match file.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        let told = format!("--csv {}: there is no such folder", file.display());
        return Err(Error::Input(told));
    }
    if file.is_dir() || file.file_name().is_none() {
        let told = format!("--csv {}: a file is expected, not a folder", file.display());
        return Err(Error::Input(told));
    }
    Ok(())
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
