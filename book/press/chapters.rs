//! The list of chapters, which drives the doctests, the ledger of claims and the checks of the book.

use crate::{Error, Result};
use std::path::Path;

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

/// The Markdown of a chapter in the workspace at `root`: read, not compiled in, so that a changed word compiles nothing.
pub fn source(root: &Path, chapter: &str) -> Result<String> {
    let path = root.join("book/src").join(chapter).with_extension("md");
    std::fs::read_to_string(&path).map_err(Error::file(&path))
}

/// The line of a page that names the files of its computations: those that have the chapter's name, and those `beside`, relative to the root of the
/// workspace. Folders end in a slash.
///
/// # Errors
/// What is wrong, for a file that is not there.
pub fn foot(root: &Path, chapter: &str, beside: &[&str]) -> std::result::Result<String, String> {
    let lacks = |file: &&&str| !root.join(file).exists();
    if let Some(file) = beside.iter().find(lacks) {
        return Err(format!("there is no file '{file}'"));
    }
    let name = chapter.replace('-', "_");
    let own = NAMESAKES.map(|folder| [format!("{folder}/{name}.rs"), format!("{folder}/{name}/")]);
    let own = own.as_flattened().iter().map(String::as_str);
    let own = own.filter(|file| root.join(file).exists());
    let files: Vec<&str> = own.chain(beside.iter().copied()).collect();
    let groups = FOOT.map(|(word, folders)| {
        let within = |file: &&&str| folders.iter().any(|folder| file.starts_with(folder));
        let files = files.iter().filter(within);
        let files: Vec<_> = files.map(|file| format!("<code>{file}</code>")).collect();
        (word, files.join(", "))
    });
    let groups = groups.iter().filter(|(_, files)| !files.is_empty());
    let groups: Vec<_> = groups
        .map(|(word, files)| format!("{word} {files}"))
        .collect();
    Ok(format!("<p class=\"foot\">{}</p>\n", groups.join(" · ")))
}

macro_rules! chapters {
    ($($module:ident: $name:literal,)*) => {
        /// All chapters, in reading order.
        pub const CHAPTERS: &[&str] = &[$($name,)*];

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
    on_your_table: "on-your-table",
    scenes: "scenes",
    accuracy: "accuracy",
    hard_cases: "hard-cases",
    gallery: "gallery",
    errata: "errata",
    claims: "claims",
    colophon: "colophon",
}
