//! The ledger: the claims of the tutorial, and where each is tested and computed.
//!
//! A mark is a comment `// claim: C2.7-2, C2.7-3` in a test or in a Rust block of a chapter (there usually hidden by
//! `# `), or an HTML comment `<!-- claim: C3.1-1 -->` on a line of its own in a chapter.

use crate::chapters::{self, CHAPTERS};
use crate::paths::files_below;
use crate::{Error, Result};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};
use regex::Regex;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::ErrorKind;
use std::path::Path;
use std::sync::LazyLock;

const REGISTER: &str = include_str!("../claims.toml");

/// A claim of the tutorial, as the register `book/claims.toml` has it.
#[derive(Debug, Clone, Deserialize)]
pub struct Claim {
    /// Its name, such as `C2.7-2`.
    pub id: String,
    /// Its paragraph in the tutorial, such as `2.7`.
    pub section: String,
    /// A few words.
    pub title: String,
    /// The verdict on it.
    pub verdict: Verdict,
    /// What the tutorial says.
    pub statement: String,
}

/// The verdict on a claim, displayed by the words that the register has for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It holds.
    Verified,
    /// It holds under a condition that the tutorial leaves unsaid.
    #[serde(rename = "verified with condition")]
    VerifiedWithCondition,
    /// It does not hold as printed.
    Erratum,
    /// Asked or announced there without an answer; a test and a chapter have one.
    #[serde(rename = "posed there, answered here")]
    Answered,
    /// Asked there, and not answered here either.
    #[serde(rename = "open question")]
    OpenQuestion,
    /// Nothing that a test of the library could show: history, a definition, an outlook, a theorem quoted.
    Context,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl Verdict {
    /// Whether a claim of this verdict is computed, or only discussed.
    pub fn is_computed(self) -> bool {
        !matches!(self, Verdict::OpenQuestion | Verdict::Context)
    }
}

/// A place that names a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The claim, as written.
    pub claim: String,
    /// The name of the chapter, or the file of the test, from the root of the workspace.
    pub file: String,
    /// In a chapter the line of the opening fence or of the comment, counted from 1; in a file of tests the function.
    pub spot: String,
    /// Whether a test or a block proves it, or prose discusses it.
    pub kind: Kind,
}

/// What names a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A comment of a test.
    Test,
    /// A comment in a Rust block of a chapter.
    Block,
    /// An HTML comment in a chapter.
    Comment,
}

/// The claims and every place that names one.
#[derive(Debug, Clone, Deserialize)]
pub struct Ledger {
    /// Number and title of the tutorial's sections.
    pub sections: Vec<(String, String)>,
    /// The claims in the order of the tutorial.
    #[serde(rename = "claim")]
    pub claims: Vec<Claim>,
    /// Where the chapters, in their order, and the tests name claims.
    #[serde(skip)]
    pub places: Vec<Place>,
}

impl Ledger {
    /// Reads the register (as compiled in), and the chapters and tests under `root`. A chapter that is not there names no claims.
    pub fn read(root: &Path) -> Result<Ledger> {
        let register = toml::from_str(REGISTER);
        let mut ledger: Ledger =
            register.map_err(|error| Error::Input(format!("book/claims.toml: {error}")))?;
        for chapter in CHAPTERS {
            match chapters::source(root, chapter) {
                Err(Error::File(_, error)) if error.kind() == ErrorKind::NotFound => {}
                read => ledger.places.extend(in_chapter(chapter, &read?)),
            }
        }
        for path in files_below(&root.join("tests"))? {
            if path.extension().is_some_and(|ending| ending == "rs") {
                let source = std::fs::read_to_string(&path).map_err(Error::file(&path))?;
                let file = path.strip_prefix(root).unwrap_or(&path).to_string_lossy();
                let places = in_tests(&file.replace('\\', "/"), &source);
                ledger.places.extend(places);
            }
        }
        Ok(ledger)
    }

    /// The claim of this name.
    pub fn claim(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// Where a claim is named in one of these ways.
    pub fn places<'a>(&'a self, id: &'a str, kinds: &'a [Kind]) -> impl Iterator<Item = &'a Place> {
        let named = move |place: &&Place| place.claim == id && kinds.contains(&place.kind);
        self.places.iter().filter(named)
    }

    /// What a claim still lacks of what its verdict requires: a test and a block, or a mention.
    pub fn missing(&self, claim: &Claim) -> Vec<&'static str> {
        let wanted: &[(&str, &[Kind])] = match claim.verdict.is_computed() {
            true => &[
                ("a test", &[Kind::Test]),
                ("a block in a chapter", &[Kind::Block]),
            ],
            false => &[("a mention in a chapter", IN_CHAPTERS)],
        };
        let lacks = |kinds| self.places(&claim.id, kinds).next().is_none();
        let missing = wanted.iter().filter(|(_, kinds)| lacks(kinds));
        missing.map(|(what, _)| *what).collect()
    }
}

/// What names a claim in a chapter.
pub const IN_CHAPTERS: &[Kind] = &[Kind::Block, Kind::Comment];

/// The claims that a line names in a comment of Rust, which may be hidden or quoted, or of HTML.
fn named(line: &str) -> impl Iterator<Item = String> {
    static COMMENT: LazyLock<Regex> = LazyLock::new(|| {
        let pattern = r"^(?:[ >]*(?:# *)?//+|<!--) *claim:(.*?)(?:-->)?\s*$";
        Regex::new(pattern).expect("it is well formed")
    });
    let marked = Some(line).filter(|line| line.contains("claim:"));
    let list = marked.and_then(|line| COMMENT.captures(line)?.get(1));
    let ids = list.map_or("", |list| list.as_str()).split([',', ' ']);
    ids.filter(|id| !id.is_empty()).map(str::to_owned)
}

/// The options mdBook reads its Markdown with, and formulas.
pub fn markdown_options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_SMART_PUNCTUATION
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// The claims that a part of a chapter names, `text`, and what names them.
pub fn claims_of(event: &Event<'_>, text: &str) -> Option<(Kind, Vec<String>)> {
    let kind = match event {
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if is_rust(info) => Kind::Block,
        Event::Html(_) | Event::InlineHtml(_) => Kind::Comment,
        _ => return None,
    };
    let claims: Vec<String> = text.lines().flat_map(named).collect();
    (!claims.is_empty()).then_some((kind, claims))
}

/// The number of the line on which a text goes on, counted from 1.
pub fn line_after(text: &str) -> usize {
    text.matches('\n').count() + 1
}

/// Where a chapter names claims.
fn in_chapter(chapter: &str, source: &str) -> Vec<Place> {
    let mut places = Vec::new();
    for (event, span) in Parser::new_ext(source, markdown_options()).into_offset_iter() {
        let Some((kind, claims)) = claims_of(&event, &source[span.clone()]) else {
            continue;
        };
        places.extend(claims.into_iter().map(|claim| Place {
            claim,
            file: chapter.to_owned(),
            spot: line_after(&source[..span.start]).to_string(),
            kind,
        }));
    }
    places
}

/// Whether a fence opens a block that `cargo test` runs.
pub fn is_rust(info: &str) -> bool {
    info.split([',', ' ']).next() == Some("rust")
}

/// Where a file of tests names claims: a comment belongs to the function that it stands directly above, else to the one it stands in.
fn in_tests(file: &str, source: &str) -> Vec<Place> {
    let (mut places, mut above, mut inside) = (Vec::new(), Vec::new(), "");
    for line in source.lines().map(str::trim_start) {
        above.extend(named(line));
        if line.is_empty() || line.starts_with("//") || line.starts_with("#[") {
            continue;
        }
        inside = function_name(line).unwrap_or(inside);
        places.extend(above.drain(..).map(|claim| Place {
            claim,
            file: file.to_owned(),
            spot: inside.to_owned(),
            kind: Kind::Test,
        }));
    }
    places
}

/// `name` of a line such as `fn name(…`.
fn function_name(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub ").unwrap_or(line);
    let rest = rest.strip_prefix("fn ")?;
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    Some(rest.split(|c| !is_letter(c)).next()?).filter(|name| !name.is_empty())
}
