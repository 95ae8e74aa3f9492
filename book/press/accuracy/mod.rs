//! The command `accuracy`: every method on the motions of [`lab::accuracy`] or on that of a scene file, timed on this machine.
//!
//! | module | what it does |
//! |---|---|
//! | [`patience`] | the sweep of a method, without runs that would take too long |
//! | [`table`] | the table that a person reads, with the winners |

pub mod patience;
pub mod table;

use std::path::Path;
use std::sync::{Mutex, PoisonError};

use figures::Figure;
use figures::own::{Curve, prices};
use lab::accuracy::{JudgedScene, Measurement, NAMES, Problem, Trial, candidates, named, problems};
use spinning_bodies::scene::{Solver, files};

use crate::progress::watched;
use crate::scenes::{self, Motion, TIMES, output::Format};
use crate::writer::{Target, tell};
use crate::{Error, Result};
use patience::{PATIENCE, Swept};

/// The header of the CSV file.
pub const HEADER: &str =
    "problem,method,parameter,error_attitude,error_omega,evaluations,steps,seconds,status";

/// Measures a problem (or its lengths, or a scene file), or all of them; writes the CSV file, and gives the tables and curves.
///
/// # Errors
/// [`Error::Input`] for an unknown name, a scene that cannot be measured, or a file that cannot be there; [`Error::File`].
pub fn run(root: &Path, scene: Option<&str>, csv: Option<&Path>) -> Result<Report> {
    let file = scene.and_then(|name| scenes::file(root, Path::new(name)));
    Format::of(Some(Format::Csv), csv)?;
    let target = csv.map(|path| Target::new(Some(path), file.as_deref()));
    let target = target.transpose()?;
    // What is being measured, for the progress bar.
    let now = Mutex::new((0.0, "the reference motion".to_owned()));
    let lock = || now.lock().unwrap_or_else(PoisonError::into_inner);
    let how_far = || {
        let (part, told) = &*lock();
        (*part, format!("measuring: {told}"))
    };
    let report = watched(how_far, || -> Result<Report> {
        let problems = scene.map_or_else(problems, named).map_err(broken)?;
        let told = |part: f64, what: String| *lock() = (part, what);
        match (scene, file) {
            (Some(_), Some(file)) if problems.is_empty() => measured(&file, PATIENCE, told),
            (Some(name), None) if problems.is_empty() => Err(Error::Input(format!(
                "the motions that can be measured are {}; one length of one is named like {}/10; {}",
                NAMES.join(", "),
                NAMES[0],
                scenes::not_found(root, Path::new(name), &NAMES),
            ))),
            _ => listed(&problems, told),
        }
    })?;
    if let Some(target) = target {
        target.put(format!("{HEADER}\n{}", report.rows))?;
    }
    Ok(report)
}

/// What the command prints, and the rows of its CSV file.
#[derive(Debug, Default)]
pub struct Report {
    /// The tables.
    pub text: String,
    /// Below the [`HEADER`].
    pub rows: String,
    /// The cost of each method against its error.
    pub curves: Vec<Curve>,
}

impl Report {
    fn add(&mut self, heading: &str, floor: f64, swept: &[Swept]) {
        self.text.push_str(&table::text(heading, floor, swept));
        self.rows
            .extend(swept.iter().flat_map(|s| &s.rows).map(line));
        let curve = |one: &Swept| (one.method.clone(), table::points(&one.rows));
        self.curves.extend(swept.iter().map(curve));
    }
}

/// Measures one motion, as [`run`] does, and draws the cost of each method against its error.
///
/// # Errors
/// [`Error::Input`] for several motions; those of [`run`].
pub fn picture(root: &Path, scene: &str, csv: Option<&Path>) -> Result<Figure> {
    if named(scene).map_err(broken)?.len() > 1 {
        let told = format!("--plot: {scene} has several lengths, expected one, such as {scene}/10");
        return Err(Error::Input(told));
    }
    let report = run(root, Some(scene), csv)?;
    let price = match cfg!(debug_assertions) {
        true => "evaluations",
        false => "time, s",
    };
    let path = scene.strip_suffix(".toml");
    let title = path.map_or(scene, |path| path.rsplit('/').next().unwrap_or(path));
    Ok(prices(title, [price, "error"], &report.curves))
}

fn warn_of_debug() {
    if cfg!(debug_assertions) {
        tell(
            "this is a debug build, so only errors and evaluations are given; for times, cargo run --release -- accuracy",
        );
    }
}

/// Measures problems of the laboratory by all of their candidates; `told` is called with the progress.
fn listed(problems: &[Problem], told: impl Fn(f64, String)) -> Result<Report> {
    warn_of_debug();
    let mut report = Report::default();
    for (place, problem) in problems.iter().enumerate() {
        let (name, all) = (problem.name(), problems.len());
        let methods = candidates(problem).map_err(broken)?;
        let mut swept = Vec::new();
        for (done, candidate) in methods.iter().enumerate() {
            let part = place as f64 + done as f64 / methods.len() as f64;
            let method = &candidate.name;
            let what = format!("{place} of {all} problems done, now {name} by {method}");
            told(part / all as f64, what);
            let trial = Trial::of(problem, candidate);
            let first = |effort| patience::first(problem, candidate, effort);
            swept.push(patience::swept(&trial, PATIENCE, first));
        }
        let heading = format!(
            "{name}: {}\n{} turns, {} s; error: angle between the attitudes at the end, rad",
            problem.description(),
            problem.turns(),
            problem.end()
        );
        report.add(&heading, 0.0, &swept);
    }
    Ok(report)
}

/// Most evaluations of a run of a scene: a second or so.
const MOST_EVALUATIONS: u64 = 5_000_000;

/// Measures a scene file from its start to its last time by all solvers, no run taking more than `patience` seconds; `told` is called with the progress.
///
/// # Errors
/// [`Error::Scene`] for a file that is no scene, a scene that ends where it begins, or one that cannot be judged.
pub fn measured(file: &Path, patience: f64, told: impl Fn(f64, String)) -> Result<Report> {
    let motion = Motion::read(file)?;
    let [_, end] = motion.ends();
    if end <= 0.0 {
        let told = "the last time must be positive to measure a motion";
        return motion.wrong(TIMES, told);
    }
    let judged = JudgedScene::new(motion.scene, end).or_else(|error| {
        let told = format!(": a run to {end:?} s cannot be judged: {error}");
        files::refused(&motion.name, &motion.text, TIMES, &told)
    })?;
    warn_of_debug();
    let stem = scenes::stem(file);
    let solvers: Vec<Solver> = Solver::all().collect();
    let mut swept = Vec::new();
    for (done, &solver) in solvers.iter().enumerate() {
        let part = done as f64 / solvers.len() as f64;
        told(part, format!("{stem} by {solver}"));
        let efforts = judged.efforts(solver);
        let trial = judged.trial(&stem, solver, &efforts, MOST_EVALUATIONS);
        swept.push(patience::swept(&trial, patience, |_| 0.0));
    }
    let judges: Vec<&str> = judged.judges().iter().map(|judge| judge.name()).collect();
    let heading = format!(
        "{stem}: {:?} s, judged by {}; errors up to {:.0e} are not distinguishable from zero\n{}",
        judged.end(),
        judges.join(" and "),
        judged.floor(),
        match judged.has_attitude() {
            true =>
                "error: angle between the attitudes at the end, rad; of omega: over the fastest of the motion",
            false =>
                "error: of the rates at the end, over the fastest of the motion; positions and angles are not judged",
        }
    );
    let mut report = Report::default();
    report.add(&heading, judged.floor(), &swept);
    Ok(report)
}

fn broken(error: spinning_bodies::Error) -> Error {
    Error::Failed(error.to_string())
}

fn line(row: &Measurement) -> String {
    // `{:?}` is the shortest text that is read back as the same number; NaN is left empty.
    let number = |x: f64| match x.is_nan() {
        true => String::new(),
        false => format!("{x:?}"),
    };
    let (seconds, status) = (row.seconds.unwrap_or(f64::NAN), row.status.word());
    let numbers = [row.parameter, row.error_attitude, row.error_omega, seconds];
    let [parameter, attitude, omega, seconds] = numbers.map(number);
    format!(
        "{},{},{parameter},{attitude},{omega},{},{},{seconds},{status}\n",
        row.problem, row.method, row.evaluations, row.steps
    )
}
