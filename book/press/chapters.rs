//! The chapters, once: this list drives the doctests, the ledger of claims and the checks of the book.

use crate::{Error, Result};
use std::path::Path;

/// A chapter of the book.
#[derive(Debug, Clone, Copy)]
pub struct Chapter {
    /// Name of its Markdown file in `book/src`, without the ending.
    pub name: &'static str,
    /// What it is made of, from the root of the workspace: modules, tests, figures. Folders end in a slash.
    made_of: &'static [&'static str],
    /// The scenes to play with: the names of their files.
    scenes: &'static [&'static str],
}

/// What the foot of a page says of its files, by the folder they are in.
const FOOT: [(&str, &[&str]); 4] = [
    ("Computed in", &["src/", "lab/src/"]),
    (
        "tested in",
        &["tests/", "lab/tests/", "book/tests/", "figures/tests/"],
    ),
    ("drawn in", &["figures/src/"]),
    ("to play with:", &["book/scenes/"]),
];

impl Chapter {
    /// Its Markdown in the workspace at `root`: read, not compiled in, so that a changed word compiles nothing.
    pub fn source(&self, root: &Path) -> Result<String> {
        let path = root.join("book/src").join(self.name).with_extension("md");
        std::fs::read_to_string(&path).map_err(Error::file(&path))
    }

    /// The chapter whose Markdown file is called `file`.
    pub fn of(file: &str) -> Option<&'static Chapter> {
        let name = file.strip_suffix(".md")?;
        CHAPTERS.iter().find(|chapter| chapter.name == name)
    }

    /// What it is made of, from the root of the workspace, and its scenes.
    pub fn files(&self) -> impl Iterator<Item = String> {
        let scene = |name: &&str| format!("book/scenes/{name}.toml");
        let scenes = self.scenes.iter().map(scene);
        self.made_of.iter().map(ToString::to_string).chain(scenes)
    }

    /// The last line of the page: where its computations live. `None` if it has none of its own.
    pub fn foot(&self) -> Option<String> {
        let groups = FOOT.iter().filter_map(|(word, folders)| {
            let there = |file: &String| folders.iter().any(|folder| file.starts_with(folder));
            let files = self.files().filter(there);
            let files: Vec<_> = files.map(|file| format!("<code>{file}</code>")).collect();
            (!files.is_empty()).then(|| format!("{word} {}", files.join(", ")))
        });
        let groups: Vec<_> = groups.collect();
        (!groups.is_empty()).then(|| format!("<p class=\"foot\">{}</p>", groups.join(" · ")))
    }
}

macro_rules! chapters {
    ($($module:ident: $name:literal $made_of:tt $scenes:tt,)*) => {
        /// All chapters, in reading order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter {
            name: $name,
            made_of: &$made_of,
            scenes: &$scenes,
        },)*];

        $(
            #[cfg(doctest)]
            #[doc = include_str!(concat!("../src/", $name, ".md"))]
            mod $module {}
        )*
    };
}

chapters! {
    index: "index" [] [],
    phenomena: "phenomena" [
        "src/phenomena/",
        "src/scene/shape/",
        "tests/sections/phenomena/",
        "tests/sections/scenes/shape.rs",
        "figures/src/phenomena/",
    ] ["cat", "crawler", "paper-cat", "skater", "swivel"],
    inertia: "inertia" [
        "src/inertia/",
        "tests/sections/inertia/",
        "figures/src/inertia.rs",
        "figures/src/inertia/",
    ] [],
    conservation: "conservation" [
        "src/conservation/",
        "tests/sections/conservation/",
        "figures/src/conservation.rs",
    ] [],
    examples: "examples" [] [],
    impacts: "impacts" [
        "src/impacts.rs",
        "tests/sections/impacts/",
        "figures/src/impacts.rs",
    ] ["meteorite"],
    rolling: "rolling" [
        "src/rolling/",
        "tests/sections/rolling/",
        "figures/src/rolling.rs",
        "figures/src/rolling/",
    ] ["billiard-shot"],
    spool: "spool" [
        "src/rolling/spool.rs",
        "tests/sections/spool.rs",
        "figures/src/spool.rs",
    ] ["spool"],
    sheet: "sheet" [
        "src/rolling/sheet.rs",
        "tests/sections/sheet.rs",
        "figures/src/sheet.rs",
    ] ["withdrawn-sheet"],
    superball: "superball" [
        "src/superball/",
        "tests/sections/superball/",
        "figures/src/superball.rs",
        "figures/src/superball/",
    ] ["superball"],
    tippe_top: "tippe-top" [
        "src/tippe_top/",
        "src/scene/contact.rs",
        "tests/sections/tippe_top/",
        "figures/src/tippe_top/",
    ] ["egg", "hoop-with-clay", "sliding-ball", "tippe-top"],
    chiral_top: "chiral-top" [
        "src/tippe_top/chirality.rs",
        "src/tippe_top/growth.rs",
        "tests/sections/tippe_top/chiral.rs",
        "figures/src/tippe_top/",
    ] ["chiral-top", "chiral-top-other-way"],
    rattleback: "rattleback" [
        "src/tippe_top/bodies.rs",
        "src/tippe_top/growth.rs",
        "tests/sections/tippe_top/celt.rs",
        "figures/src/tippe_top/rattleback.rs",
    ] ["rattleback"],
    gyroscope: "gyroscope" [
        "src/lagrange_top/",
        "tests/sections/gyroscope.rs",
        "figures/src/gyroscope.rs",
    ] [],
    yo_yo: "yo-yo" [
        "src/yo_yo/",
        "tests/sections/yo_yo.rs",
        "figures/src/yo_yo/",
    ] ["yo-yo", "yo-yo-asleep"],
    falling_strip: "falling-strip" [
        "src/falling_strip/",
        "tests/sections/falling_strip.rs",
        "figures/src/falling_strip/",
    ] ["strip"],
    euler_equations: "euler-equations" [
        "src/euler_equations/",
        "src/ideal_fluid.rs",
        "src/rotating_fluid.rs",
        "tests/sections/euler_equations/",
        "figures/src/euler_equations.rs",
        "figures/src/euler_equations/",
    ] ["heavy-body"],
    euler_top: "euler-top" [
        "src/euler_top/",
        "src/elliptic/",
        "tests/sections/euler_top/",
        "figures/src/euler_top/",
    ] ["racket"],
    lagrange_top: "lagrange-top" [
        "src/lagrange_top/",
        "tests/sections/lagrange_top/",
        "figures/src/lagrange_top/",
    ] ["nutation-dies", "sleeping-top"],
    kovalevskaya_top: "kovalevskaya-top" [
        "src/kovalevskaya_top/",
        "tests/sections/kovalevskaya_top/",
        "figures/src/kovalevskaya_top.rs",
    ] [],
    pythagoras: "pythagoras" [
        "src/pythagoras.rs",
        "tests/sections/pythagoras.rs",
        "figures/src/pythagoras.rs",
    ] [],
    further_reading: "further-reading" [] [],
    on_your_table: "on-your-table" [
        "src/falling_strip/",
        "src/phenomena/paper_cat.rs",
        "src/tippe_top/",
        "figures/src/on_your_table/",
        "figures/tests/on_your_table.rs",
    ] [],
    scenes: "scenes" [
        "src/scene/",
        "tests/sections/scenes/",
        "book/tests/book/scenes.rs",
        "book/tests/book/scene_prices.rs",
        "figures/src/scenes.rs",
    ] [],
    accuracy: "accuracy" [
        "src/integrators/",
        "lab/src/accuracy/",
        "lab/tests/lab/accuracy/",
        "tests/sections/integrators/",
        "figures/src/accuracy/",
    ] [],
    hard_cases: "hard-cases" [
        "lab/src/hard_cases/",
        "lab/tests/lab/hard_cases.rs",
        "tests/hard_cases/",
        "figures/src/hard_cases.rs",
    ] [],
    gallery: "gallery" [] [],
    errata: "errata" [] [],
    claims: "claims" [] [],
    colophon: "colophon" [] [],
}
