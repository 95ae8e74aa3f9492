//! A motion as a diagram: `--plot`.

use std::path::Path;

use figures::own::{Quantity, diagram};

use spinning_bodies::scene::Column;

use super::output::Motion;
use crate::pictures::{Copying, Form, file};
use crate::{Error, Result};

/// More rows than a picture can show.
const MOST: usize = 100_000;

/// So many rows make a smooth line: a scene that asks for fewer is drawn at as many, evenly from its first time to its last.
const SMOOTH: usize = 2001;

/// What is drawn in a panel: `COLUMN` against time, or `X:Y`, the second against the first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panel {
    across: String,
    up: String,
}

impl std::str::FromStr for Panel {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let (across, up) = text.split_once(':').unwrap_or(("t", text));
        if across.is_empty() || up.is_empty() || up.contains(':') {
            return Err("expected COLUMN, or X:Y for one against another".into());
        }
        Ok(Self {
            across: across.into(),
            up: up.into(),
        })
    }
}

/// The columns that the panels need.
pub fn columns(panels: &[Panel]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in panels.iter().flat_map(|panel| [&panel.across, &panel.up]) {
        if name != "t" && !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}

/// The form of the picture, of these, that a file's name ends with; the first on the standard output.
///
/// # Errors
/// [`Error::Input`] for a name that ends otherwise.
pub fn form(output: Option<&Path>, forms: &[Form]) -> Result<Form> {
    let Some(output) = output else {
        return Ok(forms[0]);
    };
    let ending = output.extension().unwrap_or_default().to_ascii_lowercase();
    let found = forms.iter().find(|form| ending == form.ending());
    found.copied().ok_or_else(|| {
        let endings = forms.iter().map(|form| format!("`.{}`", form.ending()));
        let (output, endings) = (output.display(), endings.collect::<Vec<_>>().join(" or "));
        Error::Input(format!(
            "{output}: what is drawn is a picture, and its name should end with {endings}"
        ))
    })
}

/// Runs the scene, which tells the [`columns`] of the panels, and draws them.
///
/// # Errors
/// [`Error::Input`] for more rows than can be drawn; what [`run`](super::run) says.
pub fn plot(motion: &Motion<'_>, panels: &[Panel], form: Form) -> Result<Vec<u8>> {
    let rows = motion.request.times().len();
    if rows > MOST {
        return Err(Error::Input(format!(
            "--plot: {} asks for {rows} rows, expected at most {MOST}: set [run] samples",
            motion.name
        )));
    }
    let span = motion.span("--plot")?;
    let table = match rows < SMOOTH {
        true => {
            let share = |k: usize| k as f64 / (SMOOTH - 1) as f64;
            let times = (0..SMOOTH).map(|k| motion.ends()[0] + share(k) * span);
            motion.table(&times.collect::<Vec<_>>())?
        }
        false => motion.table(motion.request.times())?,
    };
    let quantity = |name: &str| {
        let place = table.columns.iter().position(|column| column.name == name);
        let value = |(t, row): (f64, Vec<f64>)| place.map_or(t, |place| row[place]);
        let column = place.map(|place| &table.columns[place]);
        quantity(name, column, table.rows().map(value).collect())
    };
    let pairs = panels
        .iter()
        .map(|panel| [quantity(&panel.across), quantity(&panel.up)]);
    let title = Path::new(motion.name).file_stem().unwrap_or_default();
    let title = format!("The motion of {}", title.display());
    let figure = diagram(&title, &pairs.collect::<Vec<_>>());
    file(&figure, Copying::of(form))
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
