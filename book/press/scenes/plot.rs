//! A motion as a diagram: `--plot`.

use std::collections::BTreeSet;

use figures::Figure;
use figures::own::{Quantity, diagram};

use spinning_bodies::scene::Column;

use super::{Motion, stem};
use crate::{Error, Result};

/// More rows than a picture can show.
const MOST: usize = 100_000;

/// This many rows make a smooth line: a scene that asks for fewer is drawn with this many, evenly from its first time to its last.
const SMOOTH: usize = 2001;

/// A panel: the second column is drawn against the first; `t` is the time.
pub type Panel = [String; 2];

/// `COLUMN` against time, or `X:Y`, the second against the first.
///
/// # Errors
/// What is expected.
pub fn panel(text: &str) -> std::result::Result<Panel, String> {
    let (across, up) = text.split_once(':').unwrap_or(("t", text));
    if across.is_empty() || up.is_empty() || up.contains(':') {
        return Err("expected COLUMN, or X:Y for one against another".into());
    }
    Ok([across, up].map(str::to_owned))
}

/// The columns that the panels need.
pub fn columns(panels: &[Panel]) -> Vec<&str> {
    let names = panels.iter().flatten().map(String::as_str);
    let names: BTreeSet<&str> = names.filter(|name| *name != "t").collect();
    names.into_iter().collect()
}

/// Runs the scene, which must have the [`columns`] of the panels, and draws them.
///
/// # Errors
/// [`Error::Input`] for more rows than can be drawn; those of [`run`](Motion::run).
pub fn plot(motion: &Motion, panels: &[Panel]) -> Result<Figure> {
    let rows = motion.request.times().len();
    if rows > MOST {
        return Err(Error::Input(format!(
            "--plot: {} asks for {rows} rows, expected at most {MOST}: set [run] samples",
            motion.name
        )));
    }
    motion.span("--plot")?;
    let table = match rows < SMOOTH {
        true => motion.evenly(SMOOTH)?,
        false => motion.awaited(motion.request.times())?,
    };
    let quantity = |name: &String| {
        let column = table.columns.iter().find(|column| column.name == name);
        let values = table.numbers([name])?.into_iter().flatten();
        Ok::<_, Error>(quantity(name, column, values.collect()))
    };
    let pair = |[across, up]: &Panel| Ok([quantity(across)?, quantity(up)?]);
    let pairs: Vec<_> = panels.iter().map(pair).collect::<Result<_>>()?;
    let title = format!("The motion of {}", stem(&motion.name));
    Ok(diagram(&title, &pairs))
}

/// The values of a column as they are drawn; of none, times.
pub fn quantity(name: &str, column: Option<&Column>, values: Vec<f64>) -> Quantity {
    Quantity {
        name: name.to_owned(),
        unit: column.map_or("s", |column| column.unit),
        goes_round: column.is_some_and(|column| column.goes_round),
        logarithmic: false,
        values,
    }
}
