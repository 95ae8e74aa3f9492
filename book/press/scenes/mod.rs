//! Scene files: a TOML file becomes a scene of the library, the scene a table of numbers.
//!
//! | module | what it does |
//! |---|---|
//! | [`reader`] | tables and keys; every refusal in one line that names file and key |
//! | [`run`] | times, accuracy, solver |
//! | [`output`] | CSV and JSON |
//! | [`prices`] | what each effect costs |
//! | [`scan`] | one file, some of its numbers varied, on all cores |
//! | one a kind | the scene that the file describes: `top` (no `kind` given), … |
//!
//! A new kind brings a module with a function `read(&Section) -> Result<AnyScene>` and a line in `KINDS`.

mod contact;
pub mod output;
pub mod prices;
pub mod reader;
pub mod run;
pub mod scan;
mod shape;
mod strip;
mod table_top;
mod top;
mod yo_yo;

use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::Instant;

use spinning_bodies::conservation::Ledger;
use spinning_bodies::integrators::Cost;
use spinning_bodies::scene::{Plan, Progress, Request, Scene, Tabulated};

use crate::{Error, Result};
use reader::{Key, Section};

/// Reads a scene of one kind: all sections but `[run]`.
type Reader = fn(&Section<'_>) -> Result<AnyScene>;

/// The kinds of scene, the first being the one without `kind`.
const KINDS: &[(&str, Reader)] = &[
    ("top", top::read),
    ("meteorite", contact::meteorite),
    ("roller", contact::roller),
    ("spool", contact::spool),
    ("superball", contact::superball),
    ("yo-yo", yo_yo::read),
    ("strip", strip::read),
    ("swivel", shape::swivel),
    ("skater", shape::skater),
    ("cat", shape::cat),
    ("paper-cat", shape::paper_cat),
    ("crawler", shape::crawler),
    ("table-top", table_top::read),
];

/// The words that may stand after `kind`.
pub fn kinds() -> Vec<&'static str> {
    KINDS.iter().map(|(kind, _)| *kind).collect()
}

/// Runs a scene.
type Simulation = dyn Fn(&Request) -> spinning_bodies::Result<Table>;

/// A scene that is ready to run.
pub struct AnyScene(Box<Simulation>);

/// A motion as numbers.
pub struct Table {
    /// The solver, and why.
    pub plan: Plan,
    /// What the solver spent.
    pub cost: Cost,
    /// By how much the numbers may be off.
    pub error_estimate: f64,
    /// What was kept.
    pub ledger: Ledger,
    /// Names of the numbers in a row, after the time.
    pub columns: &'static [&'static str],
    /// How many rows there are.
    count: usize,
    /// A row by its number: time, and as many numbers as there are columns. States become numbers one at a time.
    row: Box<dyn Fn(usize) -> (f64, Vec<f64>) + Send>,
}

impl std::fmt::Debug for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {} rows", self.plan, self.count)
    }
}

impl std::fmt::Debug for AnyScene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("AnyScene")
    }
}

impl Table {
    /// The numbers of a motion.
    fn of<S: Tabulated + Send + 'static>(motion: spinning_bodies::scene::Motion<S>) -> Self {
        let rows = motion.rows;
        Self {
            plan: motion.plan,
            cost: motion.cost,
            error_estimate: motion.error_estimate,
            ledger: motion.ledger,
            columns: S::COLUMNS,
            count: rows.len(),
            row: Box::new(move |place| (rows[place].0, rows[place].1.row())),
        }
    }

    /// The time (s) and the numbers of a row, counted from 0.
    pub fn row(&self, place: usize) -> (f64, Vec<f64>) {
        (self.row)(place)
    }

    /// All rows, in the order asked for.
    pub fn rows(&self) -> impl Iterator<Item = (f64, Vec<f64>)> {
        (0..self.count).map(|place| self.row(place))
    }

    /// A number that is none, with its column and its time.
    fn not_finite(&self) -> Option<(&'static str, f64, f64)> {
        self.rows().find_map(|(t, row)| {
            let mut pairs = self.columns.iter().zip(row);
            let found = pairs.find(|(_, number)| !number.is_finite());
            found.map(|(column, number)| (*column, t, number))
        })
    }

    /// The numbers of these names, `t` being the time, in the order of the rows.
    ///
    /// # Errors
    /// [`Error::Input`] for a name that is no column.
    pub fn numbers<const N: usize>(&self, names: [&str; N]) -> Result<Vec<[f64; N]>> {
        let mut places = [0; N];
        for (place, name) in places.iter_mut().zip(names) {
            let mut columns = core::iter::once("t").chain(self.columns.iter().copied());
            *place = columns.position(|column| column == name).ok_or_else(|| {
                let columns = self.columns.join(", ");
                Error::Input(format!("no column {name}; there are t, {columns}"))
            })?;
        }
        Ok(self
            .rows()
            .map(|(t, row)| places.map(|place| if place == 0 { t } else { row[place - 1] }))
            .collect())
    }
}

impl AnyScene {
    /// This scene of the library.
    pub fn scene<S: Tabulated + Send + 'static>(scene: Box<dyn Scene<State = S>>) -> Self {
        Self(Box::new(move |request| {
            scene.simulate(request).map(Table::of)
        }))
    }

    /// Runs it, `name` being that of its file. Every number of what it gives back is finite.
    ///
    /// # Errors
    /// As for [`simulate`].
    pub fn run(&self, name: &str, request: &Request) -> Result<Table> {
        let table = (self.0)(request).map_err(|error| told(name, request.times(), error))?;
        match table.not_finite() {
            None => Ok(table),
            Some((column, t, number)) => Err(Error::Failed(format!(
                "{name}: `{column}` is {number} at t = {t:?} s: the motion leaves the range of doubles; other units, or an earlier end, may keep it within"
            ))),
        }
    }
}

/// Reads a scene file, `-` being standard input, runs the scene, and gives what came of it with the seconds it took.
///
/// # Errors
/// [`Error::Input`] for a file that is not a scene, and for a scene that is impossible; [`Error::Failed`] where the motion could not be
/// followed; [`Error::File`].
pub fn simulate(path: impl AsRef<Path>) -> Result<(Table, f64)> {
    simulate_watched(path, &Progress::default())
}

/// The same while `progress` tells another thread how far the motion has come.
///
/// # Errors
/// As for [`simulate`].
pub fn simulate_watched(path: impl AsRef<Path>, progress: &Progress) -> Result<(Table, f64)> {
    let (name, text) = source(path.as_ref())?;
    let (scene, request) = parse(&name, &text)?;
    let start = Instant::now();
    let table = scene.run(&name, &request.watched(progress))?;
    Ok((table, start.elapsed().as_secs_f64()))
}

/// The file that a name stands for: a path, or a file of `book/scenes` with or without its ending.
pub fn file(root: &Path, name: &Path) -> Option<PathBuf> {
    let scenes = root.join("book/scenes");
    let mut ending = name.as_os_str().to_owned();
    ending.push(".toml");
    let places = [name.to_owned(), scenes.join(name), scenes.join(ending)];
    places
        .into_iter()
        .find(|place| place.exists() && !place.is_dir())
}

/// The scene and the request that a file's text describes.
///
/// # Errors
/// [`Error::Input`].
pub fn parse(name: &str, text: &str) -> Result<(AnyScene, Request)> {
    let (scene, request, _) = prepare(name, &table(name, text)?)?;
    Ok((scene, request))
}

pub(crate) fn table(name: &str, text: &str) -> Result<toml::Table> {
    text.parse().map_err(|error: toml::de::Error| {
        let line = error.span().map_or(1, |span| line_of(text, span.start));
        Error::Input(format!("{name}:{line}: {}", error.message()))
    })
}

fn prepare(name: &str, table: &toml::Table) -> Result<(AnyScene, Request, Vec<Key>)> {
    let file = Section::whole(name, table);
    file.optional_text("title", "a title in quotes")?;
    let read = file.word("kind", KINDS)?;
    let scene = read(&file)?;
    let section = file.section("run")?;
    let request = run::read(&section)?;
    section.done()?;
    let asked = file.asked();
    file.done()?;
    Ok((scene, request, asked))
}

/// Most bytes of a scene file.
const MOST_BYTES: u64 = 4_000_000;

pub(crate) fn source(path: &Path) -> Result<(String, String)> {
    let (name, read) = if path == Path::new("-") {
        (
            "standard input".to_owned(),
            text_of(std::io::stdin().lock()),
        )
    } else {
        let read = std::fs::File::open(path).and_then(text_of);
        (path.display().to_string(), read)
    };
    match read {
        Ok(text) if text.len() as u64 > MOST_BYTES => Err(Error::Input(format!(
            "{name}: a scene file has at most {MOST_BYTES} bytes, this one has more"
        ))),
        Ok(text) => Ok((name, text)),
        Err(error) => Err(Error::Input(format!(
            "{name}: {error}; a scene file is expected"
        ))),
    }
}

/// The text, or a little more of it than a scene file may have.
fn text_of(from: impl Read) -> std::io::Result<String> {
    let mut text = String::new();
    from.take(MOST_BYTES + 1).read_to_string(&mut text)?;
    Ok(text)
}

/// The file asks for something impossible, or the motion could not be followed: two exit statuses.
fn told(name: &str, times: &[f64], error: spinning_bodies::Error) -> Error {
    use spinning_bodies::Error as Refusal;
    match error {
        // The numbers of a file are finite, so it is one of their products or powers.
        Refusal::NotFinite { .. } => Error::Failed(format!(
            "{name}: {error}: with numbers of this size it is beyond what doubles hold"
        )),
        Refusal::OutOfRange { value, .. } if times.contains(&value) => {
            Error::Input(format!("{name}: keys `times`, `until` in [run]: {error}"))
        }
        Refusal::Integration { .. }
        | Refusal::Budget { .. }
        | Refusal::Ledger { .. }
        | Refusal::Amplified { .. } => Error::Failed(format!("{name}: {error}")),
        Refusal::Accuracy { .. } => Error::Failed(format!(
            "{name}: {error}; ask for less by `accuracy` in [run], or for a shorter time"
        )),
        Refusal::Solver { condition } => {
            Error::Input(format!("{name}: key `solver` in [run]: {condition}"))
        }
        other => Error::Input(format!("{name}: {other}")),
    }
}

fn line_of(text: &str, place: usize) -> usize {
    text.get(..place)
        .map_or(1, |before| before.matches('\n').count() + 1)
}
