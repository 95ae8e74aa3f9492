//! The figures of the book: one file for each chapter, one style for all.
//!
//! A figure takes values from the library and draws them; it computes no physics itself.

use std::sync::LazyLock;

#[macro_use]
mod parameter;

mod accuracy;
pub mod canvas;
mod compare;
mod conservation;
mod euler_equations;
mod euler_top;
mod falling_strip;
mod figure;
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
mod prelude;
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
pub use figure::{Data, Entry, Figure};
pub use finish::{Look, Theme};
pub use parameter::{Parameter, Spacing, Values};

/// All figures, in the order of the book.
pub fn all() -> &'static [Entry] {
    static ALL: LazyLock<Vec<Entry>> = LazyLock::new(|| {
        let chapters = CHAPTERS.into_iter().flat_map(|(chapter, entries)| {
            let shown = move |entry: &Entry| Entry { chapter, ..*entry };
            entries.iter().map(shown)
        });
        chapters.collect()
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
