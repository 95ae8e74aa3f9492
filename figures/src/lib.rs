//! The figures of the book: one file a chapter, one style for all.
//!
//! A figure takes values from the library and draws them; it computes no physics itself.

use spinning_bodies::Result;

mod accuracy;
mod compare;
mod euler_equations;
mod euler_top;
mod falling_strip;
pub mod finish;
mod hard_cases;
mod impacts;
mod inertia;
mod kovalevskaya_top;
mod lagrange_top;
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

pub use compare::{Difference, compare};

/// A finished figure. Alt text and caption are part of the type: there is no figure without them.
#[derive(Debug, Clone)]
pub struct Figure {
    /// The one message, as a sentence; first sentence of the caption.
    pub claim: String,
    /// The rest of the caption: parameters and computed numbers, as Markdown-free plain text with `$…$` formulas.
    pub details: String,
    /// What is seen and what follows from it, for readers who do not see it. Plain text.
    pub alt: String,
    /// The picture, a complete SVG document whose colours are variables of the page.
    pub svg: String,
    /// Computed numbers by name, as they are to be printed: the prose quotes them, `{{value FIGURE.NAME}}`.
    pub values: Vec<(&'static str, String)>,
}

impl Figure {
    /// The picture as a file for any program, in plain colours; [`Figure::svg`] takes those of the page around it.
    pub fn file(&self) -> String {
        finish::plain(&self.svg)
    }

    /// The figure with one more number for the prose to quote.
    #[must_use]
    pub fn value(mut self, name: &'static str, text: impl Into<String>) -> Self {
        self.values.push((name, text.into()));
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
    /// Draws it.
    pub draw: fn() -> Result<Figure>,
}

/// All figures, in the order of the book.
pub fn all() -> &'static [Entry] {
    &[
        Entry {
            name: "cat-animated",
            chapter: "phenomena",
            draw: phenomena::cat_animated,
        },
        Entry {
            name: "ice",
            chapter: "phenomena",
            draw: phenomena::ice,
        },
        Entry {
            name: "crawler",
            chapter: "phenomena",
            draw: phenomena::crawler,
        },
        Entry {
            name: "swivel",
            chapter: "phenomena",
            draw: phenomena::swivel,
        },
        Entry {
            name: "cat-film",
            chapter: "phenomena",
            draw: phenomena::cat_film,
        },
        Entry {
            name: "shape-loops",
            chapter: "phenomena",
            draw: phenomena::shape_loops,
        },
        Entry {
            name: "back-bend",
            chapter: "phenomena",
            draw: phenomena::back_bend,
        },
        Entry {
            name: "paper-cat",
            chapter: "phenomena",
            draw: phenomena::paper_cat,
        },
        Entry {
            name: "paper-cat-fall",
            chapter: "phenomena",
            draw: phenomena::paper_cat_fall,
        },
        Entry {
            name: "ellipsoid-of-inertia",
            chapter: "inertia",
            draw: inertia::ellipsoid,
        },
        Entry {
            name: "cube-rosettes",
            chapter: "inertia",
            draw: inertia::rosettes,
        },
        Entry {
            name: "meteorite",
            chapter: "impacts",
            draw: impacts::meteorite,
        },
        Entry {
            name: "billiard",
            chapter: "rolling",
            draw: rolling::billiard,
        },
        Entry {
            name: "slide-to-roll",
            chapter: "rolling",
            draw: rolling::lines,
        },
        Entry {
            name: "spool",
            chapter: "spool",
            draw: spool::three_tugs,
        },
        Entry {
            name: "spool-dial",
            chapter: "spool",
            draw: spool::dial,
        },
        Entry {
            name: "withdrawn-sheet",
            chapter: "sheet",
            draw: sheet::speeds,
        },
        Entry {
            name: "sheet-animated",
            chapter: "sheet",
            draw: sheet::animated,
        },
        Entry {
            name: "superball",
            chapter: "superball",
            draw: superball::under_the_table,
        },
        Entry {
            name: "three-superballs",
            chapter: "superball",
            draw: superball::three_balls,
        },
        Entry {
            name: "bounce-reflections",
            chapter: "superball",
            draw: superball::reflections,
        },
        Entry {
            name: "tippe-top-animated",
            chapter: "tippe-top",
            draw: tippe_top::turning_over,
        },
        Entry {
            name: "egg-film",
            chapter: "tippe-top",
            draw: tippe_top::egg_film,
        },
        Entry {
            name: "hoop-with-clay",
            chapter: "tippe-top",
            draw: tippe_top::hoop_with_clay,
        },
        Entry {
            name: "tip-over",
            chapter: "tippe-top",
            draw: tippe_top::tip_over,
        },
        Entry {
            name: "contact-path",
            chapter: "tippe-top",
            draw: tippe_top::contact_path,
        },
        Entry {
            name: "tippe-energy",
            chapter: "tippe-top",
            draw: tippe_top::height_and_energy,
        },
        Entry {
            name: "tippe-potential",
            chapter: "tippe-top",
            draw: tippe_top::effective_potential,
        },
        Entry {
            name: "tippe-diagram",
            chapter: "tippe-top",
            draw: tippe_top::energy_and_momentum,
        },
        Entry {
            name: "egg-angle",
            chapter: "tippe-top",
            draw: tippe_top::how_far_eggs_rise,
        },
        Entry {
            name: "chiral-top",
            chapter: "chiral-top",
            draw: tippe_top::both_spins,
        },
        Entry {
            name: "chiral-strobe",
            chapter: "chiral-top",
            draw: tippe_top::strobed,
        },
        Entry {
            name: "chiral-map",
            chapter: "chiral-top",
            draw: tippe_top::outcomes,
        },
        Entry {
            name: "chiral-growth",
            chapter: "chiral-top",
            draw: tippe_top::growth_rates,
        },
        Entry {
            name: "chiral-beads",
            chapter: "chiral-top",
            draw: tippe_top::beads,
        },
        Entry {
            name: "rattleback",
            chapter: "rattleback",
            draw: tippe_top::reversals,
        },
        Entry {
            name: "yo-yo-string",
            chapter: "yo-yo",
            draw: yo_yo::string,
        },
        Entry {
            name: "yo-yo-speed",
            chapter: "yo-yo",
            draw: yo_yo::speed,
        },
        Entry {
            name: "yo-yo-animated",
            chapter: "yo-yo",
            draw: yo_yo::animated,
        },
        Entry {
            name: "strip-animated",
            chapter: "falling-strip",
            draw: falling_strip::animated,
        },
        Entry {
            name: "strip-paths",
            chapter: "falling-strip",
            draw: falling_strip::paths,
        },
        Entry {
            name: "strip-regimes",
            chapter: "falling-strip",
            draw: falling_strip::regimes,
        },
        Entry {
            name: "strip-rate",
            chapter: "falling-strip",
            draw: falling_strip::rate,
        },
        Entry {
            name: "momentum-flow",
            chapter: "euler-equations",
            draw: euler_equations::momentum_flow,
        },
        Entry {
            name: "triangle-of-tops",
            chapter: "euler-equations",
            draw: euler_equations::triangle_of_tops,
        },
        Entry {
            name: "poinsot-ellipsoid",
            chapter: "euler-top",
            draw: euler_top::rolling_ellipsoid,
        },
        Entry {
            name: "polhodes",
            chapter: "euler-top",
            draw: euler_top::polhodes,
        },
        Entry {
            name: "racket-flip",
            chapter: "euler-top",
            draw: euler_top::film,
        },
        Entry {
            name: "racket-flip-animated",
            chapter: "euler-top",
            draw: euler_top::animated,
        },
        Entry {
            name: "flip-time",
            chapter: "euler-top",
            draw: euler_top::flip_time,
        },
        Entry {
            name: "polar-circles",
            chapter: "euler-top",
            draw: euler_top::polar_circles,
        },
        Entry {
            name: "precession-cones",
            chapter: "euler-top",
            draw: euler_top::precession_cones,
        },
        Entry {
            name: "euler-solution",
            chapter: "euler-top",
            draw: euler_top::solution,
        },
        Entry {
            name: "toutatis",
            chapter: "euler-top",
            draw: euler_top::two_axes_in_the_sky,
        },
        Entry {
            name: "nutations",
            chapter: "lagrange-top",
            draw: lagrange_top::nutations,
        },
        Entry {
            name: "sleeping-threshold",
            chapter: "lagrange-top",
            draw: lagrange_top::sleeping_threshold,
        },
        Entry {
            name: "sleep-ends",
            chapter: "lagrange-top",
            draw: lagrange_top::waking,
        },
        Entry {
            name: "cycloid",
            chapter: "lagrange-top",
            draw: lagrange_top::cycloids,
        },
        Entry {
            name: "precession-rates",
            chapter: "lagrange-top",
            draw: lagrange_top::precession_rates,
        },
        Entry {
            name: "top-animated",
            chapter: "lagrange-top",
            draw: lagrange_top::top_animated,
        },
        Entry {
            name: "kovalevskaya-circle",
            chapter: "kovalevskaya-top",
            draw: kovalevskaya_top::circle,
        },
        Entry {
            name: "kovalevskaya-bands",
            chapter: "kovalevskaya-top",
            draw: kovalevskaya_top::bands,
        },
        Entry {
            name: "appelrot-classes",
            chapter: "kovalevskaya-top",
            draw: kovalevskaya_top::classes,
        },
        Entry {
            name: "gas-box",
            chapter: "pythagoras",
            draw: pythagoras::gas_box,
        },
        Entry {
            name: "scene-prices",
            chapter: "scenes",
            draw: scenes::prices,
        },
        Entry {
            name: "accuracy-evaluations",
            chapter: "accuracy",
            draw: accuracy::work,
        },
        Entry {
            name: "accuracy-orders",
            chapter: "accuracy",
            draw: accuracy::orders,
        },
        Entry {
            name: "accuracy-numbers",
            chapter: "accuracy",
            draw: accuracy::three_numbers,
        },
        Entry {
            name: "accuracy-growth",
            chapter: "accuracy",
            draw: accuracy::growth,
        },
        Entry {
            name: "accuracy-drift",
            chapter: "accuracy",
            draw: accuracy::energy_drift,
        },
        Entry {
            name: "accuracy-seconds",
            chapter: "accuracy",
            draw: accuracy::seconds,
        },
        Entry {
            name: "hard-cases",
            chapter: "hard-cases",
            draw: hard_cases::overview,
        },
        Entry {
            name: "hard-cases-tops",
            chapter: "hard-cases",
            draw: hard_cases::tops,
        },
        Entry {
            name: "hard-cases-bodies",
            chapter: "hard-cases",
            draw: hard_cases::bodies,
        },
    ]
}
