//! Scene files: from a path to a table of numbers. What a file may say, and the scene that it makes, is the library's
//! ([`files`]).
//!
//! | module | what it does |
//! |---|---|
//! | [`film`] | the body itself, moving |
//! | [`output`] | CSV and JSON |
//! | [`plot`] | numbers as diagrams |
//! | [`prices`] | what each effect costs |
//! | [`scan`] | one file, some of its numbers varied, on all cores |

pub mod film;
pub mod output;
pub mod plot;
pub mod prices;
pub mod scan;

use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::Instant;

use lab::general::DifferentialEquations;
use spinning_bodies::scene::Request;
use spinning_bodies::scene::files::{self, KeyRow};
pub use spinning_bodies::scene::{AnyScene, Table};

use crate::{Error, Result};

/// Runs a scene, `name` being that of its file. Every number of what it gives back is finite.
///
/// # Errors
/// As for [`simulate`].
pub fn run(name: &str, scene: &AnyScene, request: &Request) -> Result<Table> {
    let table = scene
        .simulate(request)
        .map_err(|error| told(name, request.times(), error))?;
    let not_finite = table.rows().find_map(|(t, row)| {
        let mut pairs = table.columns.iter().zip(row);
        let found = pairs.find(|(_, number)| !number.is_finite());
        found.map(|(column, number)| (column.name, t, number))
    });
    match not_finite {
        None => Ok(table),
        Some((column, t, number)) => Err(Error::Failed(format!(
            "{name}: `{column}` is {number} at t = {t:?} s: the motion leaves the range of doubles; other units, or an earlier end, may keep it within"
        ))),
    }
}

/// Reads a scene file, `-` being standard input, runs the scene, and gives what came of it with the seconds it took.
///
/// # Errors
/// [`Error::Scene`] for a file that is not a scene, [`Error::Input`] for a scene that is impossible; [`Error::Failed`] where the motion could not be
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
    let mut places = [name.to_owned(), scenes.join(name), scenes.join(ending)].into_iter();
    places.find(|place| place.exists() && !place.is_dir())
}

/// What was looked for, for a name that no file has, and what was probably meant: a scene of the book, or one of these other words.
pub fn not_found(root: &Path, name: &Path, others: &[&str]) -> String {
    let stem = |path: &Path| {
        path.file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned()
    };
    let files = std::fs::read_dir(root.join("book/scenes")).into_iter();
    let stems: Vec<String> = files
        .flatten()
        .flatten()
        .map(|file| stem(&file.path()))
        .collect();
    let all = stems
        .iter()
        .map(String::as_str)
        .chain(others.iter().copied());
    let near = files::meant(&stem(name), all);
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

/// Reads what a scene file names, such as a mesh: a path seen from its folder.
fn beside(name: &str) -> impl Fn(&str) -> std::result::Result<Vec<u8>, String> + use<> {
    let folder = Path::new(name).parent().map(Path::to_owned);
    move |file| {
        let mut bytes = Vec::new();
        let path = folder.clone().unwrap_or_default().join(file);
        let opened = std::fs::File::open(path);
        let read =
            opened.and_then(|opened| opened.take(MOST_OF_A_MESH + 1).read_to_end(&mut bytes));
        match read {
            Err(error) => Err(error.to_string()),
            Ok(_) if bytes.len() as u64 > MOST_OF_A_MESH => Err(format!(
                "a mesh has at most {MOST_OF_A_MESH} bytes, this one has more"
            )),
            Ok(_) => Ok(bytes),
        }
    }
}

/// Most bytes of a file that a scene file names.
const MOST_OF_A_MESH: u64 = 200_000_000;

/// Keys as a table of Markdown, `of` being what its first column is: the table of the file, or the shape.
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

/// The keys of a kind, and those that all kinds share; those of the shapes for `shapes`.
///
/// # Errors
/// [`Error::Input`] for a word that is no kind.
pub fn keys(kind: &str) -> Result<String> {
    match (files::keys("run"), files::keys(kind)) {
        (_, Some(sizes)) if kind == "shapes" => Ok(key_table("shape", &sizes)),
        (Some(shared), Some(keys)) => Ok(key_table("table", &[shared, keys].concat())),
        _ => {
            let (kinds, meant) = (files::kinds(), files::meant(kind, files::kinds()));
            let kinds = kinds.collect::<Vec<_>>().join(", ");
            Err(Error::Input(format!(
                "--keys: there is no kind `{kind}`; there are {kinds}, and shapes{meant}"
            )))
        }
    }
}

/// Most bytes of a scene file.
const MOST_BYTES: u64 = 4_000_000;

pub(crate) fn source(path: &Path) -> Result<(String, String)> {
    let (name, read) = match path == Path::new("-") {
        true => ("standard input".to_owned(), text_of(std::io::stdin())),
        false => (
            path.display().to_string(),
            std::fs::File::open(path).and_then(text_of),
        ),
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
