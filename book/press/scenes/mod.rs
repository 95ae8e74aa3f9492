//! Scene files: from a path to a table of numbers. The syntax of a file and the scene that it describes are the library's
//! ([`files`]).
//!
//! | module | what it does |
//! |---|---|
//! | [`film`] | films and stills of the moving body |
//! | [`output`] | CSV and JSON |
//! | [`plot`] | diagrams of columns |
//! | [`scan`] | one file, some of its numbers varied, on all cores |

pub mod film;
pub mod output;
pub mod plot;
pub mod scan;

use std::fs::File;
use std::io::{Read, read_to_string, stdin};
use std::path::{Path, PathBuf};

use lab::general::DifferentialEquations;
use spinning_bodies::scene::files::{self, KeyRow};
pub use spinning_bodies::scene::{AnyScene, Table};
use spinning_bodies::scene::{Progress, Request};

use crate::paths::files_below;
use crate::progress::watched;
use crate::writer::folder_of;
use crate::{Error, Result};

/// A scene to be run, and the request for it.
#[derive(Debug)]
pub struct Motion {
    /// The file's name.
    pub name: String,
    /// Its text.
    pub text: String,
    /// The scene.
    pub scene: AnyScene,
    /// What is asked of it.
    pub request: Request,
}

impl Motion {
    /// From a scene file; `-` is standard input.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that cannot be read; as for [`parse`].
    pub fn read(path: &Path) -> Result<Self> {
        let (name, text) = source(path)?;
        Self::of(&name, &text)
    }

    /// From a file of this name with this text.
    ///
    /// # Errors
    /// As for [`parse`].
    pub fn of(name: &str, text: &str) -> Result<Self> {
        let (scene, request) = parse(name, text)?;
        Ok(Self {
            name: name.to_owned(),
            text: text.to_owned(),
            scene,
            request,
        })
    }

    /// The same with the columns that an option asks for, if there are any.
    ///
    /// # Errors
    /// [`Error::Input`] for a column that it does not have.
    pub fn telling<N: AsRef<str>>(mut self, option: &str, columns: &[N]) -> Result<Self> {
        if !columns.is_empty() {
            let name = &self.name;
            let told = |told| Error::Input(format!("{option}: {name} {told}"));
            self.scene = files::telling(self.scene, columns).map_err(told)?;
        }
        Ok(self)
    }

    /// The same with all of its columns, which a picture of the body needs.
    ///
    /// # Errors
    /// As for [`telling`](Self::telling).
    pub fn telling_all(self) -> Result<Self> {
        let columns = self.scene.columns().iter();
        let names: Vec<&str> = columns.map(|column| column.name).collect();
        self.telling("--film", &names)
    }

    /// The first and the last of the times that are asked for, s.
    pub fn ends(&self) -> [f64; 2] {
        let times = || self.request.times().iter().copied();
        let first = times().fold(f64::INFINITY, f64::min);
        [first, times().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// The time from the first to the last, s, for an option that draws the motion.
    ///
    /// # Errors
    /// [`Error::Scene`] for a single time.
    pub fn span(&self, option: &str) -> Result<f64> {
        let [first, last] = self.ends();
        if last > first {
            return Ok(last - first);
        }
        self.wrong(TIMES, &format!("{option}: expected more than one time"))
    }

    fn asked(&self, times: &[f64]) -> Result<Request> {
        let asked = self.request.of_times(times);
        asked.or_else(|error| self.refused(times, error))
    }

    /// Runs the scene. Every number returned is finite.
    ///
    /// # Errors
    /// As for [`simulate`].
    pub fn run(&self, request: &Request) -> Result<Table> {
        let table = self.scene.simulate(request);
        let table = table.or_else(|error| self.refused(request.times(), error))?;
        for (t, row) in table.rows() {
            let mut row = table.columns.iter().zip(row);
            if let Some((column, number)) = row.find(|(_, number)| !number.is_finite()) {
                let (name, column) = (&self.name, column.name);
                return Err(Error::Failed(format!(
                    "{name}: `{column}` is {number} at t = {t:?} s: the motion leaves the range of doubles; other units or an earlier end may help"
                )));
            }
        }
        Ok(table)
    }

    /// The error for a file that asks for something impossible, or for a motion that could not be followed: they have different exit statuses.
    fn refused<T>(&self, times: &[f64], error: spinning_bodies::Error) -> Result<T> {
        use spinning_bodies::Error as Refusal;
        let name = &self.name;
        let failed = |more: &str| Err(Error::Failed(format!("{name}: {error}{more}")));
        let mut columns = self.scene.columns().iter();
        match error {
            Refusal::OutOfRange { value, .. } if times.contains(&value) => {
                self.wrong(TIMES, &error.to_string())
            }
            Refusal::Solver { condition } => self.wrong("run.solver", condition),
            Refusal::Condition { .. } if columns.any(|column| column.name == "bounces") => {
                self.wrong(LOSSES, &error.to_string())
            }
            Refusal::Integration { .. }
            | Refusal::Budget { .. }
            | Refusal::Ledger { .. }
            | Refusal::Amplified { .. } => failed(""),
            Refusal::Accuracy { .. } => failed("; sizes closer to each other may do"),
            // The numbers of a file are right one by one, so what is made of them has overflowed or underflowed.
            _ => failed(": numbers of this size lead out of the range of doubles"),
        }
    }

    /// The error for keys of the file, given as for [`files::refused`].
    ///
    /// # Errors
    /// [`Error::Scene`], always.
    pub fn wrong<T>(&self, keys: &str, told: &str) -> Result<T> {
        let told = format!(": {told}");
        Ok(files::refused(&self.name, &self.text, keys, &told)?)
    }

    /// The motion at these times, s.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn at(&self, times: &[f64]) -> Result<Table> {
        self.run(&self.asked(times)?)
    }

    /// The same, showing its progress.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn awaited(&self, times: &[f64]) -> Result<Table> {
        let progress = Progress::default();
        let request = self.asked(times)?.watched(&progress);
        let how_far = || {
            let now = progress.reached();
            let [ran, most] = [now.evaluations, now.most].map(|count| count as f64 / 1e6);
            let told = format!(
                "simulating: t = {:.4e} of {:.4e} s, {ran:.0} of at most {most:.0} million evaluations",
                now.time, now.until
            );
            (now.time / now.until, told)
        };
        watched(how_far, || self.run(&request))
    }

    /// The motion at this many equal steps from the first of its times to the last, showing its progress.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn evenly(&self, count: usize) -> Result<Table> {
        let [first, last] = self.ends();
        let time = |k: usize| match k {
            0 => first,
            k if k + 1 == count => last,
            k => first + (last - first) * (k as f64 / (count - 1) as f64),
        };
        self.awaited(&(0..count).map(time).collect::<Vec<_>>())
    }
}

/// The keys of the times of a run.
pub const TIMES: &str = "run.times, run.until";

/// The keys of what a superball keeps at a bounce: the only condition of a motion that is neither of its times nor of its solver.
const LOSSES: &str = "effects.tangential_restitution, effects.restitution";

/// The title of a picture of the motion of this file: the file's name without folder and ending.
pub fn stem(name: impl AsRef<Path>) -> String {
    let stem = name.as_ref().file_stem().unwrap_or_default();
    stem.display().to_string()
}

/// Reads a scene file (`-` is standard input) and runs the scene.
///
/// # Errors
/// [`Error::Input`] for a file that cannot be read; as for [`run`].
pub fn simulate(path: impl AsRef<Path>) -> Result<Table> {
    let (name, text) = source(path.as_ref())?;
    run(&name, &text)
}

/// Runs the scene that a text describes; `name` stands in errors.
///
/// # Errors
/// [`Error::Scene`] for a file that is not a scene, or not one that can be run; [`Error::Input`] for a scene that is impossible; [`Error::Failed`] where the motion could not be
/// followed.
pub fn run(name: &str, text: &str) -> Result<Table> {
    let motion = Motion::of(name, text)?;
    motion.run(&motion.request)
}

/// The file that a name stands for: a path, or a file of `book/scenes` with or without its ending.
pub fn file(root: &Path, name: &Path) -> Option<PathBuf> {
    let scene = root.join("book/scenes").join(name);
    let ended = scene.with_added_extension("toml");
    let mut places = [name.to_owned(), scene, ended].into_iter();
    places.find(|place| place.exists() && !place.is_dir())
}

/// The message for a name that no file has, with what was probably meant: a scene of the book, or one of these other words.
pub fn not_found(root: &Path, name: &Path, others: &[&str]) -> String {
    let files = files_below(&root.join("book/scenes")).unwrap_or_default();
    let stems: Vec<String> = files.iter().map(stem).collect();
    let all = stems.iter().map(String::as_str);
    let near = files::meant(&stem(name), all.chain(others.iter().copied()));
    let name = name.display();
    format!("there is no file '{name}', nor a scene of that name in book/scenes{near}")
}

/// The scene and the request that a file's text describes, with the general methods at hand.
///
/// # Errors
/// [`Error::Scene`].
pub fn parse(name: &str, text: &str) -> Result<(AnyScene, Request)> {
    let (scene, request) = files::parse_with(name, text, &beside(name))?;
    Ok((scene, request.with_methods(&DifferentialEquations)))
}

/// Reads a file that a scene file names, such as a mesh, by a path relative to its folder.
fn beside(name: &str) -> impl Fn(&str) -> std::result::Result<Vec<u8>, String> + use<> {
    let folder = folder_of(Path::new(name)).to_owned();
    move |file| {
        let mut bytes = Vec::new();
        let opened = File::open(folder.join(file)).map(|opened| opened.take(MOST_OF_A_MESH + 1));
        match opened.and_then(|mut opened| opened.read_to_end(&mut bytes)) {
            Err(error) => Err(error.to_string()),
            Ok(size) if size as u64 > MOST_OF_A_MESH => Err(format!(
                "a mesh may have at most {MOST_OF_A_MESH} bytes, this one has more"
            )),
            Ok(_) => Ok(bytes),
        }
    }
}

/// Most bytes of a file that a scene file names, and of a scene file.
const MOST_OF_A_MESH: u64 = 200_000_000;
const MOST_BYTES: u64 = 4_000_000;

/// Keys as a Markdown table; `of` is the heading of its first column: the table of the file, or the shape.
pub fn key_table(of: &str, keys: &[KeyRow]) -> String {
    let mut text = format!("| {of} | key | what | if absent |\n|---|---|---|---|\n");
    for row in keys {
        let (section, key, expected) = (&row.section, row.key, &row.expected);
        let absent = match row.absent.as_deref() {
            None => "needed".to_owned(),
            Some("") => "–".to_owned(),
            Some(value) => format!("`{value}`"),
        };
        text += &format!("| {section} | `{key}` | {expected} | {absent} |\n");
    }
    text
}

/// The keys of a kind and those that all kinds share; for `shapes`, those of the shapes.
///
/// # Errors
/// [`Error::Input`] for a word that is no kind.
pub fn keys(kind: &str) -> Result<String> {
    match (files::keys("run"), files::keys(kind)) {
        (_, Some(sizes)) if kind == "shapes" => Ok(key_table("shape", &sizes)),
        (Some(shared), Some(keys)) if kind != "run" => {
            Ok(key_table("table", &[shared, keys].concat()))
        }
        _ => {
            let (kinds, meant) = (files::kinds(), files::meant(kind, files::kinds()));
            let kinds = kinds.collect::<Vec<_>>().join(", ");
            Err(Error::Input(format!(
                "--keys: there is no kind `{kind}`; there are {kinds}, and shapes{meant}"
            )))
        }
    }
}

/// The name of a file, `-` being standard input, and its text.
pub(crate) fn source(path: &Path) -> Result<(String, String)> {
    // Reads one byte more than a scene file may have.
    let text = |from: &mut dyn Read| read_to_string(from.take(MOST_BYTES + 1));
    let (name, read) = match path == Path::new("-") {
        true => ("standard input".to_owned(), text(&mut stdin())),
        false => {
            let read = File::open(path).and_then(|mut file| text(&mut file));
            (path.display().to_string(), read)
        }
    };
    match read {
        Ok(text) if text.len() as u64 > MOST_BYTES => Err(Error::Input(format!(
            "{name}: a scene file may have at most {MOST_BYTES} bytes, this one has more"
        ))),
        Ok(text) => Ok((name, text)),
        Err(error) => Err(Error::Input(format!(
            "{name}: {error}; expected a scene file"
        ))),
    }
}
