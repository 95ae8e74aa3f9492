//! Draws the figures, writes their files, and compares a fresh drawing with the committed one.

use crate::pictures::{self, Copying};
use crate::progress::on_all_processors;
use crate::writer::{ending, several, write_if_changed};
use crate::{Error, Result};
use figures::on_your_table::{Paper, Sheet};
use figures::{Entry, Figure, Look, Parameter, Values};
use serde_json::{Value as Json, json};
use spinning_bodies::scene::files;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A figure with its name.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// Its entry in the register of figures.
    pub entry: Entry,
    /// What was drawn.
    pub figure: Figure,
}

/// The registered figures with these names, each of them once; all of them if no name is given.
pub fn chosen(names: &[String]) -> Result<Vec<Entry>> {
    let all = figures::all();
    if names.is_empty() {
        return Ok(all.to_vec());
    }
    let named = |name: &String| {
        let found = all.iter().find(|entry| entry.name == name);
        found.copied().ok_or_else(|| unknown_figure(name))
    };
    let mut once = BTreeSet::new();
    let names = names.iter().filter(|name| once.insert(*name));
    names.map(named).collect()
}

/// Writes the sheets of the page "On your table" for this paper size into a folder, and returns their paths.
///
/// # Errors
/// [`Error::Failed`] for what the library refuses, and those of writing.
pub fn sheets(paper: Paper, folder: &Path) -> Result<Vec<PathBuf>> {
    let sheets = figures::on_your_table::sheets(paper);
    let sheets = sheets.map_err(|error| Error::Failed(format!("on your table: {error}")))?;
    let write = |sheet: &Sheet| {
        let path = folder.join(&sheet.name);
        write_if_changed(&path, &sheet.contents)?;
        Ok(path)
    };
    sheets.iter().map(write).collect()
}

/// "There is no such figure", with the name that was probably meant.
pub fn unknown_figure(name: &str) -> Error {
    let meant = files::meant(name, figures::all().iter().map(|entry| entry.name));
    Error::Input(format!(
        "no figure is called '{name}': expected a name of `cargo run -- figures --list`{meant}"
    ))
}

/// A line for each figure; with its parameters if they are wanted.
pub fn list(entries: &[Entry], parameters: bool) -> String {
    let width = entries.iter().map(|e| e.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for entry in entries {
        let count = match entry.parameters.len() {
            0 => String::new(),
            n => several(n, "parameter"),
        };
        let line = format!("{:width$}  {}.md  {count}", entry.name, entry.chapter);
        text += &format!("{}\n", line.trim_end());
        if parameters {
            let lines = entry.parameters.iter();
            text.extend(lines.map(|parameter| format!("  {parameter}\n")));
        }
    }
    text
}

/// A parameter as JSON, for programs.
pub fn parameter(one: &Parameter) -> Json {
    json!({
        "key": one.key, "symbol": one.symbol, "meaning": one.meaning, "unit": one.unit,
        "least": one.range[0], "greatest": one.range[1], "scale": one.spacing.to_string(), "default": one.default,
    })
}

/// Each figure as JSON, for programs: its claim as the book shows it, with formulas in dollars, and its parameters.
pub fn described(drawings: &[Drawing]) -> Json {
    let figure = |Drawing { entry, figure }: &Drawing| {
        json!({
            "name": entry.name, "chapter": entry.chapter, "claim": figure.claim,
            "parameters": entry.parameters.iter().map(parameter).collect::<Vec<_>>(),
        })
    };
    drawings.iter().map(figure).collect()
}

/// The only figure of the list, for an option that needs exactly one.
///
/// # Errors
/// [`Error::Input`] for none or several.
pub fn only<'a, T>(list: &'a [T], option: &str) -> Result<&'a T> {
    match list {
        [one] => Ok(one),
        _ => Err(Error::Input(format!(
            "{option}: expected the NAME of one figure before it"
        ))),
    }
}

/// The values of the one figure that is drawn, `KEY=VALUE` each.
pub fn values(entries: &[Entry], set: &[String]) -> Result<Values> {
    if set.is_empty() {
        return Ok(Values::default());
    }
    let entry = only(entries, "--set")?;
    let told = |told: String| Error::Input(format!("--set: {told}"));
    let mut keys = BTreeSet::new();
    set.iter().try_fold(Values::default(), |values, set| {
        let bare = || told(format!("'{set}' has no value, expected KEY=VALUE"));
        let (key, value) = set.split_once('=').ok_or_else(bare)?;
        if !keys.insert(key) {
            return Err(told(format!("{key} is given twice")));
        }
        let known = entry.parameters.iter().map(|parameter| parameter.key);
        let meant = |unknown| told(format!("{unknown}{}", files::meant(key, known)));
        let parameter = entry.parameter(key).map_err(meant)?;
        let wrong = |_| told(format!("{key} is '{value}', expected a number"));
        let value = value.parse().map_err(wrong)?;
        values.with(parameter, value).map_err(told)
    })
}

/// The numbers that one figure draws, as CSV.
pub fn data(drawings: &[Drawing]) -> Result<String> {
    let Drawing { entry, figure } = only(drawings, "--data")?;
    let data = &figure.data;
    if data.rows.is_empty() {
        let told = format!("--data: figure {} draws no curve of numbers", entry.name);
        return Err(Error::Input(told));
    }
    let columns: Vec<String> = data.columns.iter().map(|name| cell(name)).collect();
    let mut text = format!("curve,{}\n", columns.join(","));
    for (curve, row) in &data.rows {
        let row: Vec<String> = row.iter().map(f64::to_string).collect();
        text += &format!("{},{}\n", cell(curve), row.join(","));
    }
    Ok(text)
}

/// A name in CSV: in quotes if it has a comma.
fn cell(name: &str) -> String {
    if name.contains(',') {
        return format!("\"{name}\"");
    }
    name.to_owned()
}

/// Draws figures with these values on all processors; `done` is called after each. The order of the entries is kept.
pub fn draw(entries: &[Entry], values: &Values, done: impl Fn() + Sync) -> Result<Vec<Drawing>> {
    let draw = |n: usize| {
        let entry = entries[n];
        let drawn = entry.draw(values);
        done();
        let figure = drawn.map_err(|e| Error::Failed(format!("figure {}: {e}", entry.name)))?;
        Ok(Drawing { entry, figure })
    };
    on_all_processors(entries.len(), draw).into_iter().collect()
}

/// Writes `FOLDER/NAME.svg`, or another form, for each drawing; files that hold the picture already are left alone. Returns how many changed.
pub fn write(drawings: &[Drawing], copying: Copying, folder: &Path) -> Result<usize> {
    let mut changed = 0;
    for Drawing { entry, figure } in drawings {
        let path = folder.join(format!("{}.{}", entry.name, ending(&copying.form)));
        let bytes = pictures::file(figure, copying)?;
        let holds = |drawn| path.is_file() && difference(&path, entry.name, drawn).is_none();
        if !std::str::from_utf8(&bytes).is_ok_and(holds) {
            changed += usize::from(write_if_changed(&path, &bytes)?);
        }
    }
    Ok(changed)
}

/// The difference of a file from this SVG, if there is one. Coordinates may differ by one unit, as another processor may round them.
fn difference(path: &Path, name: &str, drawn: &str) -> Option<String> {
    let old = std::fs::read_to_string(path);
    let old = old.map_err(|error| format!("{}: {error}", path.display()));
    old.and_then(|old| figures::compare(name, &old, drawn))
        .err()
}

/// Compares fresh drawings with the committed files. The error names every figure that differs, and where.
pub fn check(drawings: &[Drawing], folder: &Path) -> Result<()> {
    let difference = |Drawing { entry, figure }: &Drawing| {
        let path = folder.join(format!("{}.svg", entry.name));
        difference(&path, entry.name, &figure.file(Look::default()))
    };
    let differences: Vec<String> = drawings.iter().filter_map(difference).collect();
    if differences.is_empty() {
        return Ok(());
    }
    let (count, all) = (differences.len(), drawings.len());
    let told = differences.join("; ");
    Err(Error::Failed(format!(
        "{count} of {all} figures differ from the committed ones: {told}"
    )))
}
