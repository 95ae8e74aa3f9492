//! Pieces of HTML that are put into the pages after mdBook has written them.
//!
//! mdBook reads everything a preprocessor hands it as Markdown, and puts every text in the search index. A formula's
//! HTML would be mangled by the first and indexed three times by the second; so would the tick labels of a figure.
//! The chapter therefore holds a `<span data-piece="17">` with the plain text, and the page gets the piece.

use crate::paths::files_below;
use crate::{Error, Result};
use base64::prelude::{BASE64_STANDARD, Engine};
use indexmap::IndexSet;
use regex::{Captures, Regex};
use sha2::{Digest, Sha256};
use std::path::Path;
use std::sync::LazyLock;

const OPEN: &str = "<span data-piece=\"";
/// A placeholder with its number, and the ending, the unit and the marks that follow it.
static PLACEHOLDER: LazyLock<Regex> = LazyLock::new(|| {
    let pattern = r#"<span data-piece="(\d+)">[^<]*</span>((?:-th)?(?: (?:kg|cm|mm|rad|[mgsNJ])\b[^ <.,;:!?)’]*)?[.,;:!?)’]*)"#;
    Regex::new(pattern).expect("it is well formed")
});

/// The pieces of one book.
#[derive(Debug, Default)]
pub struct Pieces(IndexSet<String>);

impl Pieces {
    /// Keeps `html` and returns the placeholder to write in its place. `plain` is what the search index will hold.
    pub fn keep(&mut self, html: String, plain: &str) -> String {
        let (number, _) = self.0.insert_full(html);
        format!("{OPEN}{number}\">{}</span>", inert(plain))
    }

    /// Puts the pieces into a page.
    pub fn fill(&self, page: &str) -> Result<String> {
        let piece = |number: &str| self.0.get_index(number.parse().ok()?);
        let filled = PLACEHOLDER.replace_all(page, |found: &Captures<'_>| {
            let (_, [number, marks]) = found.extract();
            match piece(number) {
                None => found[0].to_owned(),
                Some(piece) if marks.is_empty() => piece.clone(),
                // A browser may break a line after anything that is not text, even before a full stop.
                Some(piece) => {
                    let marks = marks.replace(' ', "\u{a0}");
                    format!("<span class=\"unbroken\">{piece}{marks}</span>")
                }
            }
        });
        match filled.contains(OPEN) {
            true => Err(Error::Failed("a page holds a damaged placeholder".into())),
            false => Ok(filled.into_owned()),
        }
    }

    /// Puts the pieces into every page of a folder.
    pub fn fill_folder(&self, folder: &Path) -> Result<()> {
        for path in files_below(folder)? {
            if path.extension().is_some_and(|ending| ending == "html") {
                let page = std::fs::read_to_string(&path).map_err(Error::file(&path))?;
                let filled = with_hashes(&flush_left(&self.fill(&page)?));
                std::fs::write(&path, filled).map_err(Error::file(&path))?;
            }
        }
        Ok(())
    }
}

/// The page with each piece of quoted source moved to the left edge, since methods are indented in their files.
pub fn flush_left(page: &str) -> String {
    const SOURCE: &str = "<code class=\"language-rs\">";
    let mut parts = page.split(SOURCE);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (source, after) = part.split_once("</code>").unwrap_or((part, ""));
        let written = |line: &&str| !line.trim().is_empty();
        let indent = |line: &str| line.len() - line.trim_start_matches(' ').len();
        let margin = source.lines().filter(written).map(indent).min();
        let moved = |line| str::get(line, margin.unwrap_or(0)..).unwrap_or("");
        let lines: Vec<_> = source.split('\n').map(moved).collect();
        out += &format!("{SOURCE}{}</code>{after}", lines.join("\n"));
    }
    out
}

/// The page with the hashes of its own scripts in its content-security policy, which allows no others.
fn with_hashes(page: &str) -> String {
    let scripts = page.split("<script>").skip(1);
    let scripts = scripts.filter_map(|rest| rest.split("</script>").next());
    let hash = |script: &str| BASE64_STANDARD.encode(Sha256::digest(script));
    let hashes: Vec<_> = scripts.map(|s| format!("'sha256-{}'", hash(s))).collect();
    page.replace("'own-scripts'", &hashes.join(" "))
}

/// Text in which no line ends between a number and its unit, nor within the unit, and with a true minus sign before a number.
pub fn unbroken(text: &str) -> String {
    static NUMBER: LazyLock<Regex> = LazyLock::new(|| {
        let signs = "[ckmµ]?m|[km]?g|[mnµ]?s|m?[JN]|rad";
        let words =
            "bits|days|degrees|digits|metres|per cent|periods|radians|seconds|times|turns|years";
        let pattern = format!(r"(\d) (%|(?:{signs}|{words}|(?:centi|milli)\w+)\b)");
        Regex::new(&pattern).expect("it is well formed")
    });
    let bound = NUMBER.replace_all(text, "$1\u{a0}$2");
    static MINUS: LazyLock<Regex> =
        LazyLock::new(|| Regex::new(r" -(\d)").expect("it is well formed"));
    MINUS
        .replace_all(&bound, " \u{2212}$1")
        .replace("kg m", "kg\u{a0}m")
        .replace("N m", "N\u{a0}m")
}

/// A command in the line, in which no line ends between the hyphens of an option and its name.
pub fn options(code: &str) -> String {
    let word = |word: &str| match word.starts_with('-') {
        true => format!("<span class=\"unbroken\">{}</span>", inert(word)),
        false => inert(word),
    };
    code.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// Text without any Markdown: everything except letters, digits and spaces is written as an entity.
pub fn inert(text: &str) -> String {
    let written = |c: char| match c {
        ' ' | '\n' | '\t' | '\r' => " ".to_owned(),
        c if c.is_ascii() && !c.is_ascii_alphanumeric() => format!("&#{};", c as u32),
        c => c.to_string(),
    };
    text.chars().map(written).collect()
}
