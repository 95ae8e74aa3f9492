//! A figure, and its entry in the list of all.

use spinning_bodies::{Error, Result};

use crate::canvas::Mark;
use crate::parameter::{Parameter, Values};

/// A finished figure. Alt text and caption are part of the type: there is no figure without them.
#[derive(Debug, Clone)]
pub struct Figure {
    pub(crate) name: &'static str,
    /// The one message, as a sentence; first sentence of the caption.
    pub claim: String,
    /// The rest of the caption: parameters and computed numbers, as Markdown-free plain text with `$…$` formulas.
    pub details: String,
    /// What the picture shows and what follows from it, for readers who cannot see it. Plain text.
    pub alt: String,
    /// Computed numbers by name, as they are printed where the prose quotes them by `{{value FIGURE.NAME}}`.
    pub values: Vec<(&'static str, String)>,
    /// The numbers that were drawn.
    pub data: Data,
    /// Width and height of the canvas.
    pub size: [u32; 2],
    pub(crate) marks: Vec<(Mark, String)>,
    pub(crate) moving: String,
}

/// Numbers that were drawn, as a table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Data {
    /// The columns of a row, with their units: `time (s)`.
    pub columns: Vec<&'static str>,
    /// The name of the curve or body that a row belongs to, and the row.
    pub rows: Vec<(String, Vec<f64>)>,
}

impl Figure {
    /// The marks of the pen, in their order, canvas units.
    pub fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.marks.iter().map(|(mark, _)| mark)
    }

    /// The figure with one more number for the prose to quote.
    #[must_use]
    pub fn value(mut self, name: &'static str, text: impl Into<String>) -> Self {
        self.values.push((name, text.into()));
        self
    }

    /// The figure with the numbers of a curve: rows below a head, its columns apart by ` | `, which is the same for all curves of a figure.
    #[must_use]
    pub fn data(
        mut self,
        curve: impl Into<String>,
        head: &'static str,
        rows: impl IntoIterator<Item: Into<Vec<f64>>>,
    ) -> Self {
        let curve = curve.into();
        self.data.columns = head.split(" | ").collect();
        let rows = rows.into_iter().map(|row| (curve.clone(), row.into()));
        self.data.rows.extend(rows);
        self
    }

    /// The figure with elements that move, on top of what was drawn; SVG with its styles.
    #[must_use]
    pub(crate) fn moving(mut self, elements: &str) -> Self {
        self.moving.push_str(elements);
        self
    }
}

/// A figure that can be drawn by name.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Name of the figure, of its file `figures/svg/NAME.svg` and of its anchor in the book.
    pub name: &'static str,
    /// Chapter that shows it: the name of its Markdown file without the ending.
    pub chapter: &'static str,
    /// The parameters, in the order of the sliders; none for most drawings of a table.
    pub parameters: &'static [Parameter],
    pub(crate) draw: fn(&Values) -> Result<Figure>,
}

impl Entry {
    /// Draws it. The same values give the same bytes.
    ///
    /// # Errors
    /// What the library refuses.
    pub fn draw(&self, values: &Values) -> Result<Figure> {
        (self.draw)(values)
    }

    /// The parameter of a name.
    ///
    /// # Errors
    /// The names that exist, on one line.
    pub fn parameter(&self, key: &str) -> core::result::Result<&'static Parameter, String> {
        let found = self.parameters.iter().find(|known| known.key == key);
        found.ok_or_else(|| {
            let keys: Vec<&str> = self.parameters.iter().map(|known| known.key).collect();
            let there_are = match keys[..] {
                [] => "it has none".to_owned(),
                _ => format!("expected one of [{}]", keys.join(", ")),
            };
            format!("figure {} has no parameter '{key}': {there_are}", self.name)
        })
    }
}

/// The figure of this name, drawn from the values of these parameters.
pub(crate) const fn of(
    name: &'static str,
    parameters: &'static [Parameter],
    draw: fn(&Values) -> Result<Figure>,
) -> Entry {
    // A figure without parameters needs no code on the page: the WebAssembly module leaves it out, with its tables, and is half as large.
    let draw = match cfg!(target_family = "wasm") && parameters.is_empty() {
        true => |_: &Values| {
            Err(Error::Empty {
                quantity: "the list of parameters of a figure that is drawn on a page",
            })
        },
        false => draw,
    };
    Entry {
        name,
        chapter: "",
        parameters,
        draw,
    }
}
