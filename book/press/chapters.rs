//! The chapters, once: this list drives the doctests, the ledger of claims and the checks of the book.

/// A chapter of the book.
#[derive(Debug, Clone, Copy)]
pub struct Chapter {
    /// Name of its Markdown file in `book/src`, without the ending.
    pub name: &'static str,
    /// The Markdown source.
    pub source: &'static str,
}

macro_rules! chapters {
    ($($module:ident: $name:literal,)*) => {
        /// All chapters, in reading order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter {
            name: $name,
            source: include_str!(concat!("../src/", $name, ".md")),
        },)*];

        $(
            #[cfg(doctest)]
            #[doc = include_str!(concat!("../src/", $name, ".md"))]
            mod $module {}
        )*
    };
}

chapters! {
    index: "index",
    phenomena: "phenomena",
    inertia: "inertia",
    conservation: "conservation",
    examples: "examples",
    impacts: "impacts",
    rolling: "rolling",
    spool: "spool",
    sheet: "sheet",
    superball: "superball",
    tippe_top: "tippe-top",
    chiral_top: "chiral-top",
    rattleback: "rattleback",
    gyroscope: "gyroscope",
    yo_yo: "yo-yo",
    falling_strip: "falling-strip",
    euler_equations: "euler-equations",
    euler_top: "euler-top",
    lagrange_top: "lagrange-top",
    kovalevskaya_top: "kovalevskaya-top",
    pythagoras: "pythagoras",
    further_reading: "further-reading",
    scenes: "scenes",
    accuracy: "accuracy",
    hard_cases: "hard-cases",
    errata: "errata",
    claims: "claims",
    colophon: "colophon",
}
