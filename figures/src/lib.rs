//! The figures of the book: one file a chapter, one style for all.
//!
//! A figure takes values from the library and draws them; it computes no physics itself.

use plotters_backend::{DrawingBackend, DrawingErrorKind};
use plotters_svg::SVGBackend;
use spinning_bodies::Result;

mod accuracy;
pub mod canvas;
mod compare;
mod conservation;
mod euler_equations;
mod euler_top;
mod falling_strip;
mod finish;
mod gyroscope;
mod hard_cases;
mod impacts;
mod inertia;
mod kovalevskaya_top;
mod lagrange_top;
pub mod own;
mod parameter;
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
pub use compare::{Difference, compare};
pub use finish::{Look, Theme};
pub use parameter::{Handle, Parameter, Spacing, Values};

/// A finished figure. Alt text and caption are part of the type: there is no figure without them.
#[derive(Debug, Clone)]
pub struct Figure {
    name: &'static str,
    /// The one message, as a sentence; first sentence of the caption.
    pub claim: String,
    /// The rest of the caption: parameters and computed numbers, as Markdown-free plain text with `$…$` formulas.
    pub details: String,
    /// What is seen and what follows from it, for readers who do not see it. Plain text.
    pub alt: String,
    /// Computed numbers by name, as they are to be printed: the prose quotes them, `{{value FIGURE.NAME}}`.
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
    /// What stands in a row, with its unit: `time (s)`.
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

    /// What the pen left, in its order, canvas units.
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

    /// The figure with the numbers of a curve: rows of these columns, which are the same for all curves of a figure.
    #[must_use]
    pub fn data(
        mut self,
        curve: impl Into<String>,
        columns: &[&'static str],
        rows: impl IntoIterator<Item = Vec<f64>>,
    ) -> Self {
        let curve = curve.into();
        self.data.columns = columns.to_vec();
        let rows = rows.into_iter().map(|row| (curve.clone(), row));
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
    /// What may be chosen, in the order of the sliders; nothing for most drawings of a table.
    pub parameters: &'static [Parameter],
    draw: Draw,
}

/// The function of a figure: of its values, if it has any parameters.
#[derive(Debug, Clone, Copy)]
enum Draw {
    Constant(fn() -> Result<Figure>),
    Of(fn(&Values) -> Result<Figure>),
}

impl Entry {
    /// Draws it. The same values give the same bytes.
    ///
    /// # Errors
    /// What the library refuses.
    pub fn draw(&self, values: &Values) -> Result<Figure> {
        match self.draw {
            Draw::Constant(draw) => draw(),
            Draw::Of(draw) => draw(values),
        }
    }

    /// The parameter of a name.
    ///
    /// # Errors
    /// Which names there are, on one line.
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

const fn constant(
    name: &'static str,
    chapter: &'static str,
    draw: fn() -> Result<Figure>,
) -> Entry {
    Entry {
        name,
        chapter,
        parameters: &[],
        draw: Draw::Constant(draw),
    }
}

const fn of(
    name: &'static str,
    chapter: &'static str,
    parameters: &'static [Parameter],
    draw: fn(&Values) -> Result<Figure>,
) -> Entry {
    Entry {
        name,
        chapter,
        parameters,
        draw: Draw::Of(draw),
    }
}

/// All figures, in the order of the book.
pub fn all() -> &'static [Entry] {
    &ALL
}

static ALL: [Entry; 83] = [
    constant("cat-animated", "phenomena", phenomena::cat_animated),
    of("ice", "phenomena", phenomena::ICE, phenomena::ice),
    of(
        "crawler",
        "phenomena",
        phenomena::CRAWLER,
        phenomena::crawler,
    ),
    of("swivel", "phenomena", phenomena::SWIVEL, phenomena::swivel),
    constant("cat-film", "phenomena", phenomena::cat_film),
    of(
        "shape-loops",
        "phenomena",
        phenomena::SHAPE_LOOPS,
        phenomena::shape_loops,
    ),
    of(
        "back-bend",
        "phenomena",
        phenomena::BACK_BEND,
        phenomena::back_bend,
    ),
    of(
        "paper-cat",
        "phenomena",
        phenomena::PAPER_CAT,
        phenomena::paper_cat,
    ),
    of(
        "paper-cat-fall",
        "phenomena",
        phenomena::PAPER_CAT_FALL,
        phenomena::paper_cat_fall,
    ),
    constant("cube-quiz", "inertia", inertia::quiz),
    of("leaning", "inertia", inertia::LEANING, inertia::leaning),
    of(
        "ellipsoid-of-inertia",
        "inertia",
        inertia::ELLIPSOID,
        inertia::ellipsoid,
    ),
    constant("cube-rosettes", "inertia", inertia::rosettes),
    of(
        "thrown-brick",
        "conservation",
        conservation::THROWN_BRICK,
        conservation::thrown_brick,
    ),
    of(
        "meteorite",
        "impacts",
        impacts::METEORITE,
        impacts::meteorite,
    ),
    of("billiard", "rolling", rolling::BILLIARD, rolling::billiard),
    of("slide-to-roll", "rolling", rolling::LINES, rolling::lines),
    of("spool", "spool", spool::THREE_TUGS, spool::three_tugs),
    of("spool-dial", "spool", spool::DIAL, spool::dial),
    of("withdrawn-sheet", "sheet", sheet::SPEEDS, sheet::speeds),
    constant("sheet-animated", "sheet", sheet::animated),
    of(
        "superball",
        "superball",
        superball::UNDER_THE_TABLE,
        superball::under_the_table,
    ),
    of(
        "three-superballs",
        "superball",
        superball::THREE_BALLS,
        superball::three_balls,
    ),
    of(
        "bounce-reflections",
        "superball",
        superball::REFLECTIONS,
        superball::reflections,
    ),
    constant("tippe-top-animated", "tippe-top", tippe_top::turning_over),
    of(
        "egg-film",
        "tippe-top",
        tippe_top::FILM,
        tippe_top::egg_film,
    ),
    of(
        "hoop-with-clay",
        "tippe-top",
        tippe_top::HOOP,
        tippe_top::hoop_with_clay,
    ),
    of(
        "tip-over",
        "tippe-top",
        tippe_top::TIP_OVER,
        tippe_top::tip_over,
    ),
    of(
        "contact-path",
        "tippe-top",
        tippe_top::PATH,
        tippe_top::contact_path,
    ),
    of(
        "tippe-energy",
        "tippe-top",
        tippe_top::ENERGY,
        tippe_top::height_and_energy,
    ),
    of(
        "tippe-potential",
        "tippe-top",
        tippe_top::POTENTIAL,
        tippe_top::effective_potential,
    ),
    of(
        "tippe-diagram",
        "tippe-top",
        tippe_top::DIAGRAM,
        tippe_top::energy_and_momentum,
    ),
    constant("egg-angle", "tippe-top", tippe_top::how_far_eggs_rise),
    of(
        "chiral-top",
        "chiral-top",
        tippe_top::BOTH_SPINS,
        tippe_top::both_spins,
    ),
    of(
        "chiral-twins",
        "chiral-top",
        tippe_top::TWINS,
        tippe_top::twins,
    ),
    of(
        "chiral-strobe",
        "chiral-top",
        tippe_top::STROBED,
        tippe_top::strobed,
    ),
    constant("chiral-map", "chiral-top", tippe_top::outcomes),
    of(
        "chiral-growth",
        "chiral-top",
        tippe_top::GROWTH,
        tippe_top::growth_rates,
    ),
    constant("chiral-beads", "chiral-top", tippe_top::beads),
    of(
        "rattleback",
        "rattleback",
        tippe_top::REVERSALS,
        tippe_top::reversals,
    ),
    of(
        "rattleback-stone",
        "rattleback",
        tippe_top::STONE,
        tippe_top::two_pairs_of_axes,
    ),
    of(
        "gyroscope",
        "gyroscope",
        gyroscope::GYROSCOPE,
        gyroscope::gyroscope,
    ),
    constant("yo-yo-animated", "yo-yo", yo_yo::animated),
    of("yo-yo-speed", "yo-yo", yo_yo::SPEED, yo_yo::speed),
    of("yo-yo-turn", "yo-yo", yo_yo::TURN, yo_yo::turn),
    of("yo-yo-string", "yo-yo", yo_yo::STRING, yo_yo::string),
    constant("strip-animated", "falling-strip", falling_strip::animated),
    constant("strip-paths", "falling-strip", falling_strip::paths),
    constant("strip-regimes", "falling-strip", falling_strip::regimes),
    constant("strip-rate", "falling-strip", falling_strip::rate),
    of(
        "momentum-flow",
        "euler-equations",
        euler_equations::FLOW,
        euler_equations::momentum_flow,
    ),
    of(
        "triangle-of-tops",
        "euler-equations",
        euler_equations::TRIANGLE,
        euler_equations::triangle_of_tops,
    ),
    of(
        "poinsot-ellipsoid",
        "euler-top",
        euler_top::POINSOT,
        euler_top::rolling_ellipsoid,
    ),
    of(
        "polhodes",
        "euler-top",
        euler_top::POLHODES,
        euler_top::polhodes,
    ),
    of("racket-flip", "euler-top", euler_top::FILM, euler_top::film),
    constant("racket-flip-animated", "euler-top", euler_top::animated),
    of(
        "flip-time",
        "euler-top",
        euler_top::FLIP_TIME,
        euler_top::flip_time,
    ),
    of(
        "polar-circles",
        "euler-top",
        euler_top::CIRCLES,
        euler_top::polar_circles,
    ),
    of(
        "precession-cones",
        "euler-top",
        euler_top::CONES,
        euler_top::precession_cones,
    ),
    of(
        "euler-solution",
        "euler-top",
        euler_top::SOLUTION,
        euler_top::solution,
    ),
    of(
        "toutatis",
        "euler-top",
        euler_top::TOUTATIS,
        euler_top::two_axes_in_the_sky,
    ),
    of(
        "wooden-top",
        "lagrange-top",
        lagrange_top::WOODEN,
        lagrange_top::wooden_top,
    ),
    of(
        "wooden-top-let-go",
        "lagrange-top",
        lagrange_top::WOODEN,
        lagrange_top::let_go,
    ),
    of(
        "nutations",
        "lagrange-top",
        lagrange_top::NUTATIONS,
        lagrange_top::nutations,
    ),
    constant("top-animated", "lagrange-top", lagrange_top::top_animated),
    of(
        "sleeping-threshold",
        "lagrange-top",
        lagrange_top::SLEEPING,
        lagrange_top::sleeping_threshold,
    ),
    of(
        "sleep-ends",
        "lagrange-top",
        lagrange_top::WAKING,
        lagrange_top::waking,
    ),
    of(
        "cycloid",
        "lagrange-top",
        lagrange_top::CYCLOIDS,
        lagrange_top::cycloids,
    ),
    of(
        "precession-rates",
        "lagrange-top",
        lagrange_top::RATES,
        lagrange_top::precession_rates,
    ),
    of(
        "kovalevskaya-circle",
        "kovalevskaya-top",
        kovalevskaya_top::CIRCLE,
        kovalevskaya_top::circle,
    ),
    of(
        "kovalevskaya-bands",
        "kovalevskaya-top",
        kovalevskaya_top::BANDS,
        kovalevskaya_top::bands,
    ),
    of(
        "appelrot-classes",
        "kovalevskaya-top",
        kovalevskaya_top::CLASSES,
        kovalevskaya_top::classes,
    ),
    of(
        "gas-box",
        "pythagoras",
        pythagoras::GAS_BOX,
        pythagoras::gas_box,
    ),
    constant("scene-prices", "scenes", scenes::prices),
    constant("accuracy-map", "accuracy", accuracy::map),
    constant("accuracy-seconds", "accuracy", accuracy::seconds),
    constant("accuracy-orders", "accuracy", accuracy::orders),
    constant("accuracy-numbers", "accuracy", accuracy::three_numbers),
    constant("accuracy-growth", "accuracy", accuracy::growth),
    constant("accuracy-drift", "accuracy", accuracy::energy_drift),
    constant("hard-cases", "hard-cases", hard_cases::overview),
    constant("hard-cases-tops", "hard-cases", hard_cases::tops),
    constant("hard-cases-bodies", "hard-cases", hard_cases::bodies),
];
