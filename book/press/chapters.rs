//! The list of chapters, which drives the doctests, the ledger of claims and the checks of the book.

use crate::{Error, Result};
use std::path::Path;

/// A chapter of the book.
#[derive(Debug, Clone, Copy)]
pub struct Chapter {
    /// Name of its Markdown file in `book/src`, without the ending.
    pub name: &'static str,
    /// Its files besides the module, the test and the figures of its own name, relative to the root of the workspace. Folders end in a slash.
    beside: &'static [&'static str],
    /// The scenes to play with: the names of their files.
    scenes: &'static [&'static str],
}

/// The words at the foot of a page for its files, by the folder they are in.
const FOOT: [(&str, &[&str]); 4] = [
    ("Computed in", &["src/", "lab/src/"]),
    (
        "tested in",
        &["tests/", "lab/tests/", "book/tests/", "figures/tests/"],
    ),
    ("drawn in", &["figures/src/"]),
    ("to play with:", &["book/scenes/"]),
];

/// The folders in which files have the name of their chapter.
const NAMESAKES: [&str; 3] = ["src", "tests/sections", "figures/src"];

/// The cover. It may show a figure that belongs to a chapter; there it has no number.
pub const COVER: &str = "index";

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

    /// Its files, relative to the root of the workspace: modules, tests, figures, scenes. Folders end in a slash.
    pub fn files(&self, root: &Path) -> Vec<String> {
        let name = self.name.replace('-', "_");
        let own = NAMESAKES.iter().flat_map(|folder| {
            let both = [format!("{folder}/{name}.rs"), format!("{folder}/{name}/")];
            both.into_iter().filter(|file| root.join(file).exists())
        });
        let scenes = self.scenes.iter();
        let scenes = scenes.map(|name| format!("book/scenes/{name}.toml"));
        own.chain(self.beside.iter().map(ToString::to_string))
            .chain(scenes)
            .collect()
    }

    /// The last line of the page, which names the files of its computations. `None` if it has none of its own.
    pub fn foot(&self, root: &Path) -> Option<String> {
        let files = self.files(root);
        let groups = FOOT.iter().filter_map(|(word, folders)| {
            let there = |file: &&String| folders.iter().any(|folder| file.starts_with(folder));
            let files = files.iter().filter(there);
            let files: Vec<_> = files.map(|file| format!("<code>{file}</code>")).collect();
            (!files.is_empty()).then(|| format!("{word} {}", files.join(", ")))
        });
        let groups: Vec<_> = groups.collect();
        (!groups.is_empty()).then(|| format!("<p class=\"foot\">{}</p>", groups.join(" · ")))
    }
}

macro_rules! chapters {
    ($($module:ident: $name:literal $beside:tt $scenes:tt,)*) => {
        /// All chapters, in reading order.
        pub const CHAPTERS: &[Chapter] = &[$(Chapter {
            name: $name,
            beside: &$beside,
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
        "src/scene/shape/",
        "tests/sections/scenes/shape.rs",
    ] ["cat", "crawler", "paper-cat", "skater", "swivel"],
    inertia: "inertia" [] [],
    conservation: "conservation" [] [],
    examples: "examples" [] [],
    impacts: "impacts" [] ["meteorite"],
    rolling: "rolling" [] ["billiard-shot"],
    spool: "spool" ["src/rolling/spool.rs"] ["spool"],
    sheet: "sheet" ["src/rolling/sheet.rs"] ["withdrawn-sheet"],
    superball: "superball" [] ["superball"],
    tippe_top: "tippe-top" ["src/scene/contact.rs"] ["egg", "hoop-with-clay", "sliding-ball", "tippe-top"],
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
    gyroscope: "gyroscope" ["src/lagrange_top/"] [],
    yo_yo: "yo-yo" [] ["yo-yo", "yo-yo-asleep"],
    falling_strip: "falling-strip" [] ["strip"],
    euler_equations: "euler-equations" [
        "src/ideal_fluid.rs",
        "src/rotating_fluid.rs",
    ] ["heavy-body"],
    euler_top: "euler-top" ["src/elliptic/"] ["racket"],
    lagrange_top: "lagrange-top" [] ["nutation-dies", "sleeping-top"],
    kovalevskaya_top: "kovalevskaya-top" [] [],
    pythagoras: "pythagoras" [] [],
    further_reading: "further-reading" [] [],
    on_your_table: "on-your-table" [
        "src/falling_strip/",
        "src/phenomena/paper_cat.rs",
        "src/tippe_top/",
        "figures/tests/on_your_table.rs",
    ] [],
    scenes: "scenes" [
        "src/scene/",
        "book/tests/book/scenes.rs",
        "book/tests/book/scene_prices.rs",
    ] [],
    accuracy: "accuracy" [
        "src/integrators/",
        "lab/src/accuracy/",
        "lab/tests/lab/accuracy/",
        "tests/sections/integrators/",
    ] [],
    hard_cases: "hard-cases" [
        "lab/src/hard_cases/",
        "lab/tests/lab/hard_cases.rs",
        "tests/hard_cases/",
    ] [],
    gallery: "gallery" [] [],
    errata: "errata" [] [],
    claims: "claims" [] [],
    colophon: "colophon" [] [],
}
