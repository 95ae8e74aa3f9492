//! Draws the figures, writes their files, and compares a fresh drawing with the committed one.

use crate::paths::write_if_changed;
use crate::{Error, Result};
use figures::{Entry, Figure};
use std::path::Path;
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

/// Draws figures on every processor; `done` hears of each as it is finished. The order of the entries is kept.
pub fn draw(entries: &[Entry], done: impl Fn(&str) + Sync) -> Result<Vec<Drawing>> {
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
                    let result = (entry.draw)()
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

/// Writes `FOLDER/NAME.svg` for each drawing; files whose bytes would not change are left alone. Returns how many
/// changed.
pub fn write(drawings: &[Drawing], folder: &Path) -> Result<usize> {
    let mut changed = 0;
    for drawing in drawings {
        let path = folder.join(format!("{}.svg", drawing.entry.name));
        changed += usize::from(write_if_changed(&path, drawing.figure.svg.as_bytes())?);
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
                if let Err(difference) = same_drawing(&committed, &drawing.figure.svg) {
                    differences.push(format!("{}: {difference}", path.display()));
                }
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

/// Whether two drawings are the same up to one canvas unit in each number: the last bits of a sine differ between
/// processors, and coordinates are rounded to whole units.
pub fn same_drawing(old: &str, new: &str) -> std::result::Result<(), String> {
    let (mut a, mut b) = (tokens(old), tokens(new));
    loop {
        match (a.next(), b.next()) {
            (None, None) => return Ok(()),
            (Some(x), Some(y)) if x == y => {}
            (Some(x), Some(y)) => match (x.parse::<f64>(), y.parse::<f64>()) {
                (Ok(p), Ok(q)) if (p - q).abs() <= 1.0 => {}
                _ => return Err(format!("'{}' became '{}'", short(x), short(y))),
            },
            (x, y) => {
                let which = if x.is_some() { "shorter" } else { "longer" };
                let from = short(x.or(y).unwrap_or_default());
                return Err(format!("the new drawing is {which}, from '{from}' on"));
            }
        }
    }
}

fn short(token: &str) -> String {
    token.trim().chars().take(40).collect()
}

/// Numbers, and the text between them.
fn tokens(svg: &str) -> impl Iterator<Item = &str> {
    let part_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let mut rest = svg;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let kind = part_of_number(first);
        // A minus sign inside a run starts the next number.
        let end = rest
            .char_indices()
            .skip(1)
            .find(|&(_, c)| part_of_number(c) != kind || (kind && c == '-'))
            .map_or(rest.len(), |(i, _)| i);
        let (token, after) = rest.split_at(end);
        rest = after;
        Some(token)
    })
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
    fn one_unit_is_forgiven_and_two_are_not() {
        assert_eq!(
            same_drawing("<p d=\"M10-20 x\"/>", "<p d=\"M11-21 x\"/>"),
            Ok(())
        );
        assert!(same_drawing("<p d=\"M10-20\"/>", "<p d=\"M12-20\"/>").is_err());
        assert!(same_drawing("<p d=\"M10\"/>", "<q d=\"M10\"/>").is_err());
        assert!(same_drawing("<p/>", "<p/><p/>").is_err());
    }

    #[test]
    fn the_distance_counts_edits() {
        assert_eq!(distance("polhode", "polhodes"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
    }
}
