//! Draws the figures, writes their files, and compares a fresh drawing with the committed one.

use crate::pictures::{self, Copying};
use crate::writer::write_if_changed;
use crate::{Error, Result};
use figures::on_your_table::Paper;
use figures::{Entry, Figure, Look, Values};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A figure with its name.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// Its entry in the register of figures.
    pub entry: Entry,
    /// What was drawn.
    pub figure: Figure,
}

/// The registered figures with these names, all of them if no name is given.
pub fn chosen(names: &[String]) -> Result<Vec<Entry>> {
    let all = figures::all();
    if names.is_empty() {
        return Ok(all.to_vec());
    }
    names
        .iter()
        .map(|name| {
            let found = all.iter().find(|entry| entry.name == name);
            found.copied().ok_or_else(|| unknown_figure(name))
        })
        .collect()
}

/// Writes the things of the page "On your table" for this paper into a folder, and returns where they are.
///
/// # Errors
/// [`Error::Failed`] for what the library refuses, and those of writing.
pub fn sheets(paper: Paper, folder: &Path) -> Result<Vec<PathBuf>> {
    let sheets = figures::on_your_table::sheets(paper);
    let sheets = sheets.map_err(|error| Error::Failed(format!("on your table: {error}")))?;
    sheets
        .iter()
        .map(|sheet| {
            let path = folder.join(&sheet.name);
            write_if_changed(&path, &sheet.contents)?;
            Ok(path)
        })
        .collect()
}

/// "There is no such figure", with the nearest name there is.
pub fn unknown_figure(name: &str) -> Error {
    let nearest = figures::all()
        .iter()
        .map(|entry| entry.name)
        .min_by_key(|known| distance(known, name));
    let hint = match nearest {
        Some(near) => {
            format!("expected a name of `cargo run -- figures --list`, the nearest is '{near}'")
        }
        None => "no figures are registered".into(),
    };
    Error::Input(format!("no figure is called '{name}': {hint}"))
}

/// A line for each figure; with its parameters if they are wanted.
pub fn list(entries: &[Entry], parameters: bool) -> String {
    let width = entries.iter().map(|e| e.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for entry in entries {
        let count = match entry.parameters.len() {
            0 => String::new(),
            1 => "  1 number to choose".into(),
            n => format!("  {n} numbers to choose"),
        };
        text += &format!("{:width$}  {}.md{count}\n", entry.name, entry.chapter);
        if parameters {
            let lines = entry.parameters.iter();
            text.extend(lines.map(|parameter| format!("  {parameter}\n")));
        }
    }
    text
}

/// The values of the one figure that is drawn, `KEY=VALUE` each.
pub fn values(entries: &[Entry], set: &[String]) -> Result<Values> {
    let entry = match (entries, set) {
        (_, []) => return Ok(Values::default()),
        ([entry], _) => entry,
        _ => {
            let why = "--set: expected the NAME of one figure before it";
            return Err(Error::Input(why.into()));
        }
    };
    let told = |told: String| Error::Input(format!("--set: {told}"));
    set.iter().try_fold(Values::default(), |values, set| {
        let wrong = || told(format!("'{set}' is no KEY=VALUE"));
        let (key, value) = set.split_once('=').ok_or_else(wrong)?;
        let parameter = entry.parameter(key).map_err(told)?;
        let value = value.parse().map_err(|_| wrong())?;
        values.with(parameter, value).map_err(told)
    })
}

/// The numbers that one figure draws, as CSV.
pub fn data(drawings: &[Drawing]) -> Result<String> {
    let [drawing] = drawings else {
        let why = "--data: expected the NAME of one figure before it";
        return Err(Error::Input(why.into()));
    };
    let data = &drawing.figure.data;
    if data.rows.is_empty() {
        let name = drawing.entry.name;
        return Err(Error::Input(format!(
            "--data: figure {name} draws no curve of numbers"
        )));
    }
    let mut text = format!("curve,{}\n", data.columns.join(","));
    for (curve, row) in &data.rows {
        let row: Vec<String> = row.iter().map(f64::to_string).collect();
        text += &format!("{curve},{}\n", row.join(","));
    }
    Ok(text)
}

/// Draws figures of these values on every processor; `done` hears of each as it is finished. The order of the entries is kept.
pub fn draw(
    entries: &[Entry],
    values: &Values,
    done: impl Fn(&str) + Sync,
) -> Result<Vec<Drawing>> {
    let next = AtomicUsize::new(0);
    let drawn: Vec<Mutex<Option<Result<Drawing>>>> =
        entries.iter().map(|_| Mutex::new(None)).collect();
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..workers.min(entries.len()) {
            scope.spawn(|| {
                while let Some((&entry, place)) = {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    entries.get(i).zip(drawn.get(i))
                } {
                    let result = entry
                        .draw(values)
                        .map(|figure| Drawing { entry, figure })
                        .map_err(|e| Error::Failed(format!("figure {}: {e}", entry.name)));
                    if let Ok(mut place) = place.lock() {
                        *place = Some(result);
                    }
                    done(entry.name);
                }
            });
        }
    });
    drawn
        .into_iter()
        .map(|place| {
            let result = place.into_inner().ok().flatten();
            result.unwrap_or_else(|| Err(Error::Failed("a figure was not drawn".into())))
        })
        .collect()
}

/// Writes `FOLDER/NAME.svg`, or another form, for each drawing; files whose bytes would not change are left alone. Returns how many
/// changed.
pub fn write(drawings: &[Drawing], copying: Copying, folder: &Path) -> Result<usize> {
    let mut changed = 0;
    for drawing in drawings {
        let name = format!("{}.{}", drawing.entry.name, copying.form.ending());
        let bytes = pictures::file(&drawing.figure, copying)?;
        changed += usize::from(write_if_changed(&folder.join(name), &bytes)?);
    }
    Ok(changed)
}

/// Compares fresh drawings with the committed files. The error names every figure that differs, and where.
pub fn check(drawings: &[Drawing], folder: &Path) -> Result<()> {
    let mut differences = Vec::new();
    for drawing in drawings {
        let path = folder.join(format!("{}.svg", drawing.entry.name));
        match std::fs::read_to_string(&path) {
            Err(error) => differences.push(format!("{}: {error}", path.display())),
            Ok(committed) => {
                let compared = figures::compare(
                    drawing.entry.name,
                    &committed,
                    &drawing.figure.file(Look::default()),
                );
                differences.extend(compared.err().map(|difference| difference.to_string()));
            }
        }
    }
    if differences.is_empty() {
        Ok(())
    } else {
        Err(Error::Failed(format!(
            "{} of {} figures differ from the committed ones: {}",
            differences.len(),
            drawings.len(),
            differences.join("; ")
        )))
    }
}

/// Edit distance, for the nearest name.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut corner = row[0];
        row[0] = i + 1;
        for (j, &y) in b.iter().enumerate() {
            let change = corner + usize::from(x != y);
            corner = row[j + 1];
            row[j + 1] = change.min(corner + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_counts_edits() {
        assert_eq!(distance("polhode", "polhodes"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
    }
}
