//! Scene files: converts a TOML text into a scene, or into the list of its mistakes.
//!
//! The kind is read first, then that kind's tables. Each table is declared once, key by key with unit, bounds and default; the page of keys lists what
//! the reader looks for in an empty file. The numbers of a file can be replaced by [`set`], for scans. Nothing here opens a file.
//!
//! ```
//! use spinning_bodies::scene::files::parse;
//! let text = "[body]\nmoments = [1, 2, 3]\n[initial]\nomega = [0, 1, 5]\n[run]\ntimes = [1.0]\n";
//! let (scene, request) = parse("mine.toml", text)?;
//! assert_eq!(scene.simulate(&request).map(|table| table.rows().count()), Ok(1));
//! let Err(mistakes) = parse("mine.toml", &text.replace("[0, 1, 5]", "\"fast\"")) else { panic!() };
//! let told = "mine.toml:4: key `omega` in [initial] must be an angular velocity in rad/s, a list of 3 numbers, got the string \"fast\"";
//! assert_eq!(mistakes.to_string(), told);
//! # Ok::<(), spinning_bodies::scene::files::Mistakes>(())
//! ```
//!
//! | file | content |
//! |---|---|
//! | `reader` | tables and keys of one text; mistakes, each in one line |
//! | `keys` | a key: its name, the expected value, its row on the page of keys |
//! | `values` | the values of keys, and the declarations of tables |
//! | `run` | times, accuracy, solver, columns |
//! | `body` | the tables of a rigid body |
//! | `file` | all that a kind imports, how effects are added to its scene, and how it gets its picture |
//! | `look` | the drawing of a scene |
//! | one for each kind or several | the tables of the kind, and the scene made from them |
//!
//! A new kind needs its tables, a function that makes a scene from them, and a line in `KINDS`.

mod body;
mod changing;
mod contact;
mod file;
mod keys;
mod look;
mod reader;
mod run;
mod strip;
mod table_top;
mod top;
mod values;
mod yo_yo;

pub use keys::KeyRow;
use reader::Open;
pub use reader::{Mistakes, meant};
pub use run::telling;

use toml::de::{DeTable, DeValue};

use super::{AnyScene, Request};
use file::*;
use reader::{find, joined};
use run::Run;

/// Makes a scene from the tables of its kind.
type Kind = fn(&Table<'_>) -> Option<AnyScene>;

/// The kinds of scene; the first is that of a file without `kind`.
const KINDS: [(&str, Kind); 13] = [
    ("top", |file| then(file, top::top)),
    ("meteorite", |file| then(file, contact::meteorite)),
    ("roller", |file| then(file, contact::roller)),
    ("spool", |file| then(file, contact::spool)),
    ("superball", |file| then(file, contact::superball)),
    ("yo-yo", |file| then(file, yo_yo::yo_yo)),
    ("strip", |file| then(file, strip::strip)),
    ("swivel", |file| then(file, changing::swivel)),
    ("skater", |file| then(file, changing::skater)),
    ("cat", |file| then(file, changing::cat)),
    ("paper-cat", |file| then(file, changing::paper_cat)),
    ("crawler", |file| then(file, changing::crawler)),
    ("table-top", |file| then(file, table_top::table_top)),
];

impl Word for Kind {
    fn words() -> Vec<(&'static str, Self)> {
        KINDS.to_vec()
    }
}

/// The scene that is made from these keys, once all of them are read.
fn then<K: Section>(
    whole: &Table<'_>,
    made: fn(&Reader<'_>, K) -> Option<AnyScene>,
) -> Option<AnyScene> {
    made(whole.reader, K::fields(whole)?)
}

/// The scene and the request in a file of the given kind, or of the kind that it names. Every table is read before the first mistake ends the reading.
fn scene(file: &Reader<'_>, kind: Option<Kind>) -> Option<(AnyScene, Request)> {
    let whole = Table::new(file, String::new());
    key!(whole, title: Option<String>, "a title in quotes");
    let named = key!(whole, kind: Kind, "");
    let scene = kind.or(named)?(&whole);
    let run = whole.part("run", Run::fields);
    whole.done();
    let request = run.as_ref().and_then(|run| run.request(file));
    Some((run?.told(file, scene?)?, request?))
}

/// The scene and the request described by a file's text; `name` names the file in messages.
///
/// # Errors
/// All mistakes in the text. A mesh named by the file cannot be read.
///
/// ```
/// use spinning_bodies::scene::files::parse;
/// let text = "[body]\nmoments = [1, 2, 3]\n[initial]\nomega = [0, 0, 2]\n[run]\ntimes = [1.0]\n";
/// let (scene, request) = parse("mine.toml", text)?;
/// let table = scene.simulate(&request).expect("a free top");
/// assert_eq!(table.numbers(["energy"]).ok(), Some(vec![[6.0]]));
/// # Ok::<(), spinning_bodies::scene::files::Mistakes>(())
/// ```
pub fn parse(name: &str, text: &str) -> Result<(AnyScene, Request), Mistakes> {
    parse_with(name, text, &out_of_reach)
}

fn out_of_reach(_: &str) -> Result<Vec<u8>, String> {
    Err("other files are out of reach here".to_owned())
}

/// Like [`parse`], for a file that may name others, such as the mesh of a body: `open` returns their bytes.
///
/// # Errors
/// All mistakes in the text.
///
/// ```
/// use spinning_bodies::scene::files::{parse, parse_with};
/// let text = "[body]\nmass = 2\nshape = \"mesh\"\nfile = \"corner.obj\"\n[initial]\nomega = [0, 0, 1]\n[run]\ntimes = [0]\n";
/// let corner = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n";
/// assert!(parse_with("mine.toml", text, &|_| Ok(corner.to_vec())).is_ok());
/// assert!(parse("mine.toml", text).is_err());
/// ```
pub fn parse_with(
    name: &str,
    text: &str,
    open: &Open<'_>,
) -> Result<(AnyScene, Request), Mistakes> {
    let reader = Reader::new(name, text, open)?;
    let made = scene(&reader, None);
    reader.finish(made)
}

/// A mistake that only the motion shows, in these keys, given by their paths and separated by commas; the line is that of the first one there.
///
/// # Errors
/// Always: the mistake.
///
/// ```
/// use spinning_bodies::scene::files::refused;
/// let mistake = refused::<()>("mine.toml", "[run]\nuntil = -1\n", "run.times, run.until", " must not be negative");
/// assert_eq!(mistake.unwrap_err().to_string(), "mine.toml:2: key `times`, `until` in [run] must not be negative");
/// ```
pub fn refused<T>(name: &str, text: &str, keys: &str, told: &str) -> Result<T, Mistakes> {
    let reader = Reader::new(name, text, &out_of_reach)?;
    let none = reader.wrong(keys, told);
    reader.finish(none)
}

/// The possible values of `kind`; the first is the default.
///
/// ```
/// use spinning_bodies::scene::files::kinds;
/// assert_eq!(kinds().next(), Some("top"));
/// ```
pub fn kinds() -> impl ExactSizeIterator<Item = &'static str> {
    KINDS.iter().map(|(name, _)| *name)
}

/// The keys of a kind in `[body]`, `[initial]` and `[effects]`; for `run` the keys common to all kinds, at the top and in `[run]`; for `shapes` the sizes
/// of all shapes, with the shape in place of the section. `None` for any other word.
///
/// ```
/// use spinning_bodies::scene::files::keys;
/// let count = |kind, key| keys(kind).map(|rows| rows.iter().filter(|row| row.key == key).count());
/// assert_eq!((count("top", "gravity"), count("ghost", "gravity")), (Some(1), None));
/// assert!(count("run", "accuracy") == Some(1) && count("shapes", "radius") > Some(1));
/// ```
pub fn keys(kind: &str) -> Option<Vec<KeyRow>> {
    let reader = Reader::new("", "", &out_of_reach).ok()?;
    // The common keys are read with the first kind.
    let known = KINDS.iter().find(|known| [known.0, "run"].contains(&kind));
    match kind {
        "shapes" => body::read_all_shapes(&reader),
        _ => drop(scene(&reader, Some(known?.1))),
    }
    let mut rows = reader.absent.into_inner();
    let is_shared = |row: &KeyRow| ["", "run"].contains(&row.section.as_str());
    rows.retain(|row| is_shared(row) == (kind == "run"));
    Some(rows)
}

/// The paths of all numbers in a file.
///
/// ```
/// use spinning_bodies::scene::files::numbers;
/// let text = "title = \"mine\"\n[run]\ntimes = [1, 2.5]\n";
/// assert_eq!(numbers(text), ["run.times.0", "run.times.1"]);
/// ```
pub fn numbers(text: &str) -> Vec<String> {
    fn gather(path: &str, value: &DeValue<'_>, found: &mut Vec<String>) {
        match value {
            DeValue::Table(table) => {
                for (key, value) in table {
                    gather(&joined(path, key.get_ref()), value.get_ref(), found);
                }
            }
            DeValue::Array(list) => {
                for (place, value) in list.iter().enumerate() {
                    gather(&joined(path, &place.to_string()), value.get_ref(), found);
                }
            }
            value if values::number(value).is_some() => found.push(path.to_owned()),
            _ => {}
        }
    }
    let mut found = Vec::new();
    if let Ok(table) = DeTable::parse(text) {
        gather("", &DeValue::Table(table.into_inner()), &mut found);
    }
    found
}

/// The file's text with the number at `path` replaced: "body.moments.2", with places in a list counted from 0; `None` if there is no number there. An integer stays
/// one if it can, since some keys take no other number.
///
/// ```
/// use spinning_bodies::scene::files::set;
/// let text = "[run]\nuntil = 1.5\n";
/// assert_eq!(set(text, "run.until", 2.0).as_deref(), Some("[run]\nuntil = 2.0\n"));
/// ```
pub fn set(text: &str, path: &str, number: f64) -> Option<String> {
    let table = DeTable::parse(text).ok()?;
    let value = find(table.get_ref(), path)?;
    values::number(value.get_ref())?;
    let exact = format!("{number:?}");
    let written = match value.get_ref() {
        DeValue::Integer(_) => exact.trim_end_matches(".0"),
        _ => &exact,
    };
    let place = value.span();
    Some([text.get(..place.start)?, written, text.get(place.end..)?].concat())
}
