//! The figures of the book: one file for each chapter, one style for all.
//!
//! A figure takes values from the library and draws them; it computes no physics itself.

use std::sync::LazyLock;

use plotters_backend::{DrawingBackend, DrawingErrorKind};
use plotters_svg::SVGBackend;
use spinning_bodies::{Error, Result};

#[macro_use]
mod parameter;

mod accuracy;
pub mod canvas;
mod compare;
mod conservation;
mod euler_equations;
mod euler_top;
mod falling_strip;
pub mod film;
mod finish;
mod gyroscope;
mod hard_cases;
mod impacts;
mod inertia;
mod kovalevskaya_top;
mod lagrange_top;
pub mod on_your_table;
pub mod own;
mod phenomena;
mod plot;
mod pythagoras;
mod rolling;
mod scenes;
mod sheet;
mod solid;
mod spool;
pub mod style;
mod superball;
mod tippe_top;
mod yo_yo;

pub use canvas::Mark;
pub use compare::compare;
pub use finish::{Look, Theme};
pub use parameter::{Parameter, Spacing, Values};

/// The drawing tools of all figures: a figure then imports only what it takes from the library.
mod prelude {
    pub(crate) use crate::plot::*;
    pub(crate) use crate::solid::*;
    pub(crate) use crate::style::*;
    pub(crate) use crate::{Entry, Figure, Parameter, Values, of};
    pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};
    pub(crate) use spinning_bodies::Result;
}

/// A finished figure. Alt text and caption are part of the type: there is no figure without them.
#[derive(Debug, Clone)]
pub struct Figure {
    name: &'static str,
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
    size: [u32; 2],
    marks: Vec<(Mark, String)>,
    moving: String,
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
    /// The picture, a complete SVG document whose colours are variables of the page around it.
    pub fn svg(&self) -> String {
        let mut raw = String::new();
        {
            let mut backend = SVGBackend::with_string(&mut raw, (self.size[0], self.size[1]));
            self.draw(&mut backend)
                .expect("a string takes every letter");
        }
        finish::finish(self, &raw)
    }

    /// What was drawn, without the document around it.
    pub(crate) fn elements(&self) -> String {
        let svg = self.svg();
        let inside = svg
            .split_once("</title>\n")
            .map_or("", |(_, inside)| inside);
        inside.trim_end().trim_end_matches("</svg>").to_owned()
    }

    /// Draws the marks on any backend of plotters, in the colours that stand for their roles.
    ///
    /// # Errors
    /// Those of the backend.
    pub fn draw<B: DrawingBackend>(
        &self,
        backend: &mut B,
    ) -> core::result::Result<(), DrawingErrorKind<B::ErrorType>> {
        canvas::draw(self.marks(), backend)
    }

    /// The picture as a file for any program, in plain colours.
    pub fn file(&self, look: Look) -> String {
        finish::plain(&self.svg(), look)
    }

    /// The marks of the pen, in their order, canvas units.
    pub fn marks(&self) -> impl Iterator<Item = &Mark> {
        self.marks.iter().map(|(mark, _)| mark)
    }

    /// Width and height of the canvas.
    pub fn size(&self) -> [u32; 2] {
        self.size
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
    draw: fn(&Values) -> Result<Figure>,
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
const fn of(
    name: &'static str,
    parameters: &'static [Parameter],
    draw: fn(&Values) -> Result<Figure>,
) -> Entry {
    // A figure without parameters needs no code on the page: the WebAssembly module leaves it out, with its tables, and is half as large.
    let draw = match cfg!(target_family = "wasm") && parameters.is_empty() {
        true => drawn_by_the_press,
        false => draw,
    };
    Entry {
        name,
        chapter: "",
        parameters,
        draw,
    }
}

fn drawn_by_the_press(_: &Values) -> Result<Figure> {
    Err(Error::Empty {
        quantity: "the list of parameters of a figure that is drawn on a page",
    })
}

/// All figures, in the order of the book.
pub fn all() -> &'static [Entry] {
    static ALL: LazyLock<Vec<Entry>> = LazyLock::new(|| {
        let of_chapter = |(chapter, entries): &(&'static str, &[Entry])| {
            let shown = |entry: &Entry| Entry { chapter, ..*entry };
            entries.iter().map(shown).collect::<Vec<_>>()
        };
        CHAPTERS.iter().flat_map(of_chapter).collect()
    });
    &ALL
}

/// The figures of each chapter that has any, in the order of the book.
const CHAPTERS: [(&str, &[Entry]); 23] = [
    ("phenomena", phenomena::FIGURES),
    ("inertia", inertia::FIGURES),
    ("conservation", conservation::FIGURES),
    ("impacts", impacts::FIGURES),
    ("rolling", rolling::FIGURES),
    ("spool", spool::FIGURES),
    ("sheet", sheet::FIGURES),
    ("superball", superball::FIGURES),
    ("tippe-top", tippe_top::TIPPE_TOP),
    ("chiral-top", tippe_top::CHIRAL_TOP),
    ("rattleback", tippe_top::RATTLEBACK),
    ("gyroscope", gyroscope::FIGURES),
    ("yo-yo", yo_yo::FIGURES),
    ("falling-strip", falling_strip::FIGURES),
    ("euler-equations", euler_equations::FIGURES),
    ("euler-top", euler_top::FIGURES),
    ("lagrange-top", lagrange_top::FIGURES),
    ("kovalevskaya-top", kovalevskaya_top::FIGURES),
    ("pythagoras", pythagoras::FIGURES),
    ("on-your-table", on_your_table::FIGURES),
    ("scenes", scenes::FIGURES),
    ("accuracy", accuracy::FIGURES),
    ("hard-cases", hard_cases::FIGURES),
];
