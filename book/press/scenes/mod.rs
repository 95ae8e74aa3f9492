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

use spinning_bodies::scene::Request;
use spinning_bodies::scene::UnknownColumn;
pub use spinning_bodies::scene::{AnyScene, Table};

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

/// Runs a scene, `name` being that of its file. Every number of what it gives back is finite.
///
/// # Errors
/// As for [`simulate`].
pub fn run(name: &str, scene: &AnyScene, request: &Request) -> Result<Table> {
    let table = scene
        .simulate(request)
        .map_err(|error| told(name, request.times(), error))?;
    match table.not_finite() {
        None => Ok(table),
        Some((column, t, number)) => Err(Error::Failed(format!(
            "{name}: `{column}` is {number} at t = {t:?} s: the motion leaves the range of doubles; other units, or an earlier end, may keep it within"
        ))),
    }
}

/// Reads a scene file, `-` being standard input, runs the scene, and gives what came of it with the seconds it took.
///
/// # Errors
/// [`Error::Input`] for a file that is not a scene, and for a scene that is impossible; [`Error::Failed`] where the motion could not be
/// followed; [`Error::File`].
pub fn simulate(path: impl AsRef<Path>) -> Result<(Table, f64)> {
    let (name, text) = source(path.as_ref())?;
    let (scene, request) = parse(&name, &text)?;
    let start = Instant::now();
    let table = run(&name, &scene, &request)?;
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
    let columns = section.optional_words("columns", "a list of names of numbers to be told")?;
    let scene = match columns {
        None => scene,
        Some(names) => telling(scene, &names).map_err(|told| section.refused("columns", told))?,
    };
    section.done()?;
    let asked = file.asked();
    file.done()?;
    Ok((scene, request, asked))
}

/// The scene telling these numbers.
///
/// # Errors
/// A name that is none, and what was probably meant.
pub fn telling<N: AsRef<str>>(
    scene: AnyScene,
    names: &[N],
) -> std::result::Result<AnyScene, String> {
    let told = |unknown: UnknownColumn| {
        let UnknownColumn { name, names } = unknown;
        let meant = reader::meant(&name, names.iter().copied());
        format!(
            "has no column `{name}` to tell; there are {}{meant}",
            names.join(", ")
        )
    };
    scene.telling(names).map_err(told)
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
