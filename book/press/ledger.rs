//! The ledger: the claims of the tutorial, and where each is tested and computed.
//!
//! A mark is a comment `// claim: C2.7-2, C2.7-3` in a test or in a Rust block of a chapter (there usually hidden by
//! `# `), or an HTML comment `<!-- claim: C3.1-1 -->` on a line of its own in a chapter.

use crate::chapters::{self, CHAPTERS};
use crate::paths::files_below;
use crate::{Error, Result};
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::ErrorKind;
use std::ops::Range;
use std::path::Path;

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

/// A place where a chapter names claims.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mark {
    /// The claims, as written.
    pub claims: Vec<String>,
    /// Line of the opening fence or of the comment, counted from 1.
    pub line: usize,
    /// Whether code proves the claims, or prose discusses them.
    pub kind: MarkKind,
}

/// Whether code proves the claims of a mark, or prose discusses them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MarkKind {
    /// A comment in a Rust block.
    Block,
    /// An HTML comment.
    Comment,
}

/// Where a test names a claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestUse {
    /// The claim.
    pub claim: String,
    /// The file, from the root of the workspace.
    pub file: String,
    /// The test function.
    pub function: String,
}

/// The claims and every place that names one.
#[derive(Debug, Clone)]
pub struct Ledger {
    /// The claims in the order of the tutorial.
    pub claims: Vec<Claim>,
    /// The marks of the chapters, each with the name of its chapter.
    pub chapters: Vec<(&'static str, Mark)>,
    /// Where the tests name claims.
    pub tests: Vec<TestUse>,
}

impl Ledger {
    /// Reads the register (as compiled in), and the chapters and tests under `root`. A chapter that is not there names no claims.
    pub fn read(root: &Path) -> Result<Ledger> {
        #[derive(Deserialize)]
        struct Register {
            claim: Vec<Claim>,
        }
        let register: Register = toml::from_str(REGISTER)
            .map_err(|error| Error::Input(format!("book/claims.toml: {error}")))?;
        let mut claims = register.claim;
        claims.sort_by_key(|claim| order(&claim.id));
        let mut marked = Vec::new();
        for &chapter in CHAPTERS {
            match chapters::source(root, chapter) {
                Err(Error::File(_, error)) if error.kind() == ErrorKind::NotFound => {}
                read => marked.extend(marks(&read?).map(|mark| (chapter, mark))),
            }
        }
        let mut tests = Vec::new();
        for path in files_below(&root.join("tests"))? {
            if path.extension().is_some_and(|ending| ending == "rs") {
                let source = std::fs::read_to_string(&path).map_err(Error::file(&path))?;
                let file = path.strip_prefix(root).unwrap_or(&path).to_string_lossy();
                tests.extend(uses(&file.replace('\\', "/"), &source));
            }
        }
        Ok(Ledger {
            claims,
            chapters: marked,
            tests,
        })
    }

    /// The claim of this name.
    pub fn claim(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// Where the chapters name a claim.
    pub fn in_chapters(&self, id: &str) -> impl Iterator<Item = &(&'static str, Mark)> {
        let names = move |mark: &Mark| mark.claims.iter().any(|claim| claim == id);
        self.chapters.iter().filter(move |(_, mark)| names(mark))
    }

    /// Where the tests name a claim.
    pub fn in_tests(&self, id: &str) -> impl Iterator<Item = &TestUse> {
        self.tests.iter().filter(move |place| place.claim == id)
    }

    /// What a claim still lacks of what its verdict requires: a test and a block, or a mention.
    pub fn missing(&self, claim: &Claim) -> Vec<&'static str> {
        let is_tested = self.in_tests(&claim.id).next().is_some();
        let mut marks = self.in_chapters(&claim.id).map(|(_, mark)| mark.kind);
        let wanted = match claim.verdict.is_computed() {
            true => {
                let is_shown = marks.any(|kind| kind == MarkKind::Block);
                vec![("a test", is_tested), ("a block in a chapter", is_shown)]
            }
            false => vec![("a mention in a chapter", marks.next().is_some())],
        };
        let missing = wanted.into_iter().filter(|(_, there)| !there);
        missing.map(|(what, _)| what).collect()
    }
}

/// The numbers in a claim's name, so that `C4.10-2` comes after `C4.9-1`.
fn order(id: &str) -> Vec<u32> {
    id.split(|c: char| !c.is_ascii_digit())
        .filter_map(|number| number.parse().ok())
        .collect()
}

/// The claims named by a comment `claim: A, B`.
fn named(comment: &str) -> Option<Vec<String>> {
    let list = comment.trim().strip_prefix("claim:")?;
    let ids = list.split(|c: char| c == ',' || c.is_whitespace());
    let ids = ids.filter(|id| !id.is_empty());
    Some(ids.map(str::to_owned).collect())
}

/// The claims named by a line of Rust.
fn named_in_rust(line: &str) -> Option<Vec<String>> {
    // A block may be quoted.
    let line = line.trim_start_matches([' ', '>']);
    let line = line.strip_prefix("# ").unwrap_or(line).trim_start();
    named(line.strip_prefix("//")?.trim_start_matches('/'))
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

impl Mark {
    /// The mark that stands in this place of a chapter, if there is one.
    pub fn of(event: &Event<'_>, span: Range<usize>, chapter: &str) -> Option<Self> {
        let (claims, kind) = match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if is_rust(info) => {
                let lines = chapter[span.clone()].lines();
                let claims: Vec<_> = lines.filter_map(named_in_rust).flatten().collect();
                (claims, MarkKind::Block)
            }
            Event::Html(html) | Event::InlineHtml(html) => {
                let comment = html.trim().strip_prefix("<!--")?.strip_suffix("-->")?;
                (named(comment)?, MarkKind::Comment)
            }
            _ => return None,
        };
        let line = chapter[..span.start].matches('\n').count() + 1;
        (!claims.is_empty()).then_some(Self { claims, line, kind })
    }
}

/// The marks of a chapter, in its order.
fn marks(chapter: &str) -> impl Iterator<Item = Mark> {
    let events = Parser::new_ext(chapter, markdown_options()).into_offset_iter();
    events.filter_map(move |(event, span)| Mark::of(&event, span, chapter))
}

/// The blocks of code of a chapter: whether `cargo test` runs it, and where it stands.
pub fn code_blocks(chapter: &str) -> impl Iterator<Item = (bool, Range<usize>)> {
    let events = Parser::new_ext(chapter, markdown_options()).into_offset_iter();
    events.filter_map(|(event, span)| match event {
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => Some((is_rust(&info), span)),
        Event::Start(Tag::CodeBlock(_)) => Some((false, span)),
        _ => None,
    })
}

/// Whether a fence opens a block that `cargo test` runs.
pub fn is_rust(info: &str) -> bool {
    info.split([',', ' ']).next() == Some("rust")
}

/// Claims and the functions of a file that name them: the function a mark stands directly above, else the one it stands in.
fn uses(file: &str, source: &str) -> Vec<TestUse> {
    let (mut found, mut named, mut inside) = (Vec::new(), Vec::new(), "");
    for line in source.lines().map(str::trim_start) {
        named.extend(named_in_rust(line).into_iter().flatten());
        if line.is_empty() || line.starts_with("//") || line.starts_with("#[") {
            continue;
        }
        inside = function_name(line).unwrap_or(inside);
        found.extend(named.drain(..).map(|claim| TestUse {
            claim,
            file: file.to_owned(),
            function: inside.to_owned(),
        }));
    }
    found
}

/// `name` of a line such as `fn name(…`.
fn function_name(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub ").unwrap_or(line);
    let rest = rest.strip_prefix("fn ")?;
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    Some(rest.split(|c| !is_letter(c)).next()?).filter(|name| !name.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_of_a_chapter() {
        let source = "# A\n\n<!-- claim: C3.1-1 -->\nProse.\n\n```rust\n# // claim: C2.7-2, C2.7-3\nlet x = 1;\n// claim: C2.1-1\n```\n\n```rust\nlet no = \"claim: C1.1-1\";\n```\n\n```text\n// claim: C9.9-9\n```\n";
        let found: Vec<Mark> = marks(source).collect();
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].line, found[0].kind), (3, MarkKind::Comment));
        assert_eq!(found[0].claims, ["C3.1-1"]);
        assert_eq!((found[1].line, found[1].kind), (6, MarkKind::Block));
        assert_eq!(found[1].claims, ["C2.7-2", "C2.7-3", "C2.1-1"]);
    }

    #[test]
    fn marks_of_a_test_above_and_inside_its_function() {
        let source = "// claim: C1.1-1\n#[test]\nfn above() {}\n\n#[test]\nfn inside() {\n    // claim: C1.1-2, C1.1-3\n    let x = 1;\n}\n";
        let found = uses("", source).into_iter();
        let found: Vec<_> = found
            .map(|found| format!("{} {}", found.claim, found.function))
            .collect();
        assert_eq!(found, ["C1.1-1 above", "C1.1-2 inside", "C1.1-3 inside"]);
    }
}
