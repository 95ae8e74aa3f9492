//! Sets one chapter: formulas, figures and claim tags become HTML or placeholders for it.

use crate::appendix;
use crate::chapters::Chapter;
use crate::drawings::{Drawing, unknown_figure};
use crate::formulas::{Formulas, Style};
use crate::ledger::{Ledger, MarkKind, markdown_options, marks};
use crate::pieces::{Pieces, inert};
use crate::{Error, Result, live};
use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::path::Path;

/// What all chapters share: the drawings and their numbers, the ledger, the pieces.
#[derive(Debug)]
pub struct Typesetter<'a> {
    drawings: HashMap<&'a str, &'a Drawing>,
    numbers: HashMap<String, usize>,
    ledger: &'a Ledger,
    formulas: Formulas,
    pieces: Pieces,
    medium: Medium,
}

/// Where the chapters will be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Medium {
    /// In a browser: formulas by its fonts, pictures in the page, which themes and the hand can change.
    Pages,
    /// On a device that reads: formulas as MathML, pictures as files.
    Ebook,
}

/// The cover may show a figure that belongs to a chapter; there it has no number.
pub const COVER: &str = "index";

/// What stops a figure that moves: for a finger, a mouse or a key.
const PAUSE: &str = "<label class=\"pause\"><input type=\"checkbox\"> Pause</label>";

/// What is set, or what is wrong with it.
type Told<T> = std::result::Result<T, String>;

/// Replacements in a chapter's source.
type Edits = Vec<(Range<usize>, String)>;

impl<'a> Typesetter<'a> {
    /// A typesetter for one book.
    pub fn new(drawings: &'a [Drawing], ledger: &'a Ledger, medium: Medium) -> Self {
        Typesetter {
            drawings: drawings.iter().map(|d| (d.entry.name, d)).collect(),
            numbers: HashMap::new(),
            ledger,
            formulas: Formulas::default(),
            pieces: Pieces::default(),
            medium,
        }
    }

    /// The pieces kept so far, to fill into the pages.
    pub fn into_pieces(self) -> Pieces {
        self.pieces
    }

    /// The chapter as mdBook is to read it. `file` is its name in error messages, `folder` where its tables are, `pages` the
    /// Markdown files of the book. Chapters must come in the order of the book, which numbers the figures.
    pub fn set(
        &mut self,
        file: &str,
        source: &str,
        folder: &Path,
        pages: &HashSet<String>,
    ) -> Result<String> {
        let (source, origin) = self.expanded(file, source, folder)?;
        let fault = |offset: usize, message: String| {
            let line = source[..offset].matches('\n').count();
            let line = origin.get(line).copied().unwrap_or(line + 1);
            Error::Input(format!("book/src/{file}:{line}: {message}"))
        };

        let chapter = file.trim_end_matches(".md");
        let mut edits = self.tags(chapter, &source, &fault)?;
        let (mut in_heading, mut in_code) = (false, false);
        let mut done_to = 0;
        for (event, span) in Parser::new_ext(&source, markdown_options()).into_offset_iter() {
            if span.start < done_to {
                continue;
            }
            let text = &source[span.clone()];
            let told: Told<Option<String>> = match event {
                Event::Start(Tag::Heading { .. }) | Event::End(TagEnd::Heading(_)) => {
                    in_heading = matches!(event, Event::Start(_));
                    Ok(None)
                }
                Event::Start(Tag::CodeBlock(_)) | Event::End(TagEnd::CodeBlock) => {
                    in_code = matches!(event, Event::Start(_));
                    Ok(None)
                }
                Event::Start(Tag::Paragraph) => self.directive(chapter, text.trim()),
                Event::InlineMath(latex) | Event::DisplayMath(latex) if in_heading => Err(format!(
                    "a heading holds the formula ${latex}$; headings have none"
                )),
                Event::InlineMath(latex) => self.formula(&latex, Style::Inline).map(Some),
                Event::DisplayMath(latex) => self.formula(&latex, Style::Display).map(Some),
                Event::Text(_) if !in_code && text.contains("{{") => {
                    Err("a directive stands on a line of its own, between blank lines".into())
                }
                Event::Text(_) if !in_code && text.contains('$') => {
                    Err("a dollar that neither opens nor closes a formula".into())
                }
                Event::Start(Tag::Link { dest_url, .. }) => {
                    let page = dest_url.split('#').next().unwrap_or_default();
                    match page.ends_with(".md") && !pages.contains(page) {
                        true => Err(format!("the link leads to '{page}', which is no chapter")),
                        false => Ok(None),
                    }
                }
                _ => Ok(None),
            };
            if let Some(html) = told.map_err(|why| fault(span.start, why))? {
                done_to = span.end;
                edits.push((span, html));
            }
        }
        let mut set = apply(&source, edits);
        if let Some(foot) = Chapter::of(file).and_then(Chapter::foot) {
            set.push_str(&format!("\n{foot}\n"));
        }
        Ok(set)
    }

    /// Expands lines `{{#include tables/NAME.md}}`, generated tables, so that their formulas are set as well, and `{{value FIGURE.NAME}}`,
    /// a number that the figure computed; for each line of the result, the line of the chapter it comes from. Includes in code are left
    /// to mdBook.
    fn expanded(&self, file: &str, source: &str, folder: &Path) -> Result<(String, Vec<usize>)> {
        let (mut out, mut origin) = (String::with_capacity(source.len()), Vec::new());
        for (i, line) in source.lines().enumerate() {
            let fault = |why: String| Error::Input(format!("book/src/{file}:{}: {why}", i + 1));
            let table = line.strip_prefix("{{#include tables/");
            let table = table.and_then(|rest| rest.strip_suffix(".md}}"));
            let text = match table {
                None => self.with_values(line).map_err(fault)?,
                Some(name) => {
                    let path = folder.join("tables").join(format!("{name}.md"));
                    let told = |error| fault(format!("{}: {error}", path.display()));
                    std::fs::read_to_string(&path).map_err(told)?
                }
            };
            origin.resize(origin.len() + text.lines().count().max(1), i + 1);
            out.push_str(text.trim_end_matches('\n'));
            out.push('\n');
        }
        Ok((out, origin))
    }

    fn with_values(&self, line: &str) -> Told<String> {
        let mut parts = line.split("{{value ");
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (name, after) = part.split_once("}}").unwrap_or((part, ""));
            let (figure, key) = name.trim().split_once('.').unwrap_or((name, ""));
            let values = &self.drawing(figure)?.figure.values;
            let Some((_, text)) = values.iter().find(|(known, _)| *known == key) else {
                let known: Vec<_> = values.iter().map(|(known, _)| *known).collect();
                let known = known.join(", ");
                return Err(format!(
                    "figure '{figure}' has no value '{key}': expected one of [{known}]"
                ));
            };
            out.push_str(text);
            out.push_str(after);
        }
        Ok(out)
    }

    fn formula(&mut self, latex: &str, style: Style) -> Told<String> {
        let told = |error| format!("in the formula ${}$: {error}", latex.trim());
        let html = self.formulas.set(latex, style).map_err(told)?;
        // A letter with its index can be searched for, LaTeX cannot.
        let plain = match latex.contains('\\') {
            true => "…",
            false => latex.trim(),
        };
        let html = match (self.medium, html.find("<math"), html.find("</math>")) {
            (Medium::Ebook, Some(from), Some(to)) => html[from..to].to_owned() + "</math>",
            _ => html,
        };
        Ok(self.pieces.keep(html, plain))
    }

    /// The HTML of a paragraph that is a directive; `None` if it is a paragraph.
    fn directive(&mut self, chapter: &str, text: &str) -> Told<Option<String>> {
        let Some(words) = text.strip_prefix("{{").and_then(|t| t.strip_suffix("}}")) else {
            return Ok(None);
        };
        match words.split_whitespace().collect::<Vec<_>>()[..] {
            ["claims"] => Ok(Some(appendix::page(self.ledger) + "\n")),
            ["figure", name] => self.figure(chapter, name).map(Some),
            ["gallery"] => self.gallery().map(Some),
            _ => Ok(None),
        }
    }

    fn drawing(&self, name: &str) -> Told<&'a Drawing> {
        let drawing = self.drawings.get(name).copied();
        drawing.ok_or_else(|| unknown_figure(name).to_string())
    }

    fn figure(&mut self, chapter: &str, name: &str) -> Told<String> {
        let drawing = self.drawing(name)?;
        if chapter == COVER {
            let picture = self.picture(drawing, "cover", PAUSE);
            let claim = self.caption(&drawing.figure.claim)?;
            return Ok(format!(
                "<figure id=\"cover-{name}\">{picture}<figcaption>{claim}</figcaption></figure>\n\n"
            ));
        }
        let next = self.numbers.len() + 1;
        if self.numbers.insert(name.to_owned(), next).is_some() {
            return Err(format!("figure '{name}' is shown a second time"));
        }
        let picture = self.picture(drawing, "fig", PAUSE);
        let claim = self.caption(&drawing.figure.claim)?;
        let details = self.caption(&drawing.figure.details)?;
        let live = match (self.medium, drawing.entry.parameters) {
            (Medium::Ebook, _) | (_, []) => String::new(),
            _ => format!(
                " data-live=\"{}\"",
                inert(&live::parameters(&drawing.entry).to_string())
            ),
        };
        Ok(format!(
            "<figure id=\"fig-{name}\"{live}>{picture}<figcaption><span class=\"figure-number\">Figure {next}.</span> \
             <strong>{claim}</strong> {details}</figcaption></figure>\n\n"
        ))
    }

    /// A figure without its frame; before one that moves, `pause`. The print page shows all chapters: where a figure is shown again, its ids begin
    /// otherwise.
    fn picture(&mut self, Drawing { entry, figure }: &Drawing, ids: &str, pause: &str) -> String {
        let name = entry.name;
        let html = match self.medium {
            Medium::Pages => {
                let [old, new] = ["fig", ids].map(|ids| format!("{ids}-{name}"));
                let svg = figure.svg().trim_end().replace(&old, &new);
                match svg.contains("@keyframes") {
                    true => pause.to_owned() + &svg,
                    false => svg,
                }
            }
            Medium::Ebook => format!(
                "<img src=\"figures/{name}.svg\" alt=\"{}\"/>",
                inert(&figure.alt)
            ),
        };
        self.pieces.keep(html, "")
    }

    /// Every figure, small: its number, its claim, and the command that draws it.
    fn gallery(&mut self) -> Told<String> {
        let mut out = String::from("<div class=\"gallery\">\n");
        let numbered = |entry: &figures::Entry| match self.numbers.get(entry.name) {
            Some(&number) => Ok((number, self.drawing(entry.name)?)),
            None => Err(format!("figure '{}' is in no chapter", entry.name)),
        };
        let shown = figures::all().iter().map(numbered);
        let mut shown = shown.collect::<Told<Vec<_>>>()?;
        shown.sort_unstable_by_key(|&(number, _)| number);
        for (number, drawing) in shown {
            let (name, chapter) = (drawing.entry.name, drawing.entry.chapter);
            let picture = self.picture(drawing, "small", "");
            let claim = self.caption(&drawing.figure.claim)?;
            let keys = drawing.entry.parameters.iter().map(|one| one.key);
            let keys = match keys.collect::<Vec<_>>()[..] {
                [] => String::new(),
                ref keys => format!(" --set {}=…", keys.join("=… --set ")),
            };
            out += &format!(
                "<figure id=\"small-{name}\"><a href=\"{chapter}.html#fig-{name}\">{picture}</a><figcaption>{number}. {claim} \
                 <code>cargo run -- figures {name}{keys}</code></figcaption></figure>\n"
            );
        }
        Ok(out + "</div>\n\n")
    }

    /// Plain text with `$…$` formulas.
    fn caption(&mut self, text: &str) -> Told<String> {
        let mut out = String::new();
        for (i, part) in text.split('$').enumerate() {
            if i % 2 == 0 {
                // A typewriter's apostrophe is none; mdBook sets those of the chapters.
                out.push_str(&inert(&part.replace('\'', "’")));
            } else {
                out.push_str(&self.formula(part, Style::Inline)?);
            }
        }
        Ok(out)
    }

    /// Links to the claims appendix, above each block and in place of each comment that names claims.
    fn tags(
        &self,
        chapter: &str,
        source: &str,
        fault: &dyn Fn(usize, String) -> Error,
    ) -> Result<Edits> {
        let mut seen = HashSet::new();
        let mut edits = Edits::new();
        for mark in marks(source) {
            let at = mark.span.start;
            let mut links = Vec::new();
            for id in &mark.claims {
                let unknown = || fault(at, format!("'{id}' is no claim of book/claims.toml"));
                let claim = self.ledger.claim(id).ok_or_else(unknown)?;
                let anchor = match seen.insert(id.clone()) {
                    true => format!(" id=\"{}\"", appendix::place_id(chapter, id)),
                    false => String::new(),
                };
                links.push(format!(
                    "<a class=\"claim-tag\"{anchor} href=\"claims.html#{id}\" title=\"A claim of the tutorial: {}\">{id}</a>",
                    inert(&claim.title)
                ));
            }
            let tags = format!("<p class=\"claim-tags\">{}</p>\n\n", links.join(" "));
            if at > 0 && !source[..at].ends_with('\n') {
                let why = "what names claims stands at the left margin, not in a list or a line";
                return Err(fault(at, why.into()));
            }
            match mark.kind {
                // The blank line before lets the tags follow a paragraph directly.
                MarkKind::Block => edits.push((at..at, format!("\n{tags}"))),
                MarkKind::Comment => edits.push((mark.span, tags)),
            }
        }
        Ok(edits)
    }
}

/// The chapter without its blocks of code.
pub fn without_code(chapter: &str) -> String {
    let blocks = Parser::new_ext(chapter, markdown_options()).into_offset_iter();
    let blocks = blocks.filter(|(event, _)| matches!(event, Event::Start(Tag::CodeBlock(_))));
    apply(
        chapter,
        blocks.map(|(_, span)| (span, "\n".into())).collect(),
    )
}

fn apply(source: &str, mut edits: Edits) -> String {
    edits.sort_by_key(|(span, _)| (span.start, span.end));
    let mut out = String::with_capacity(2 * source.len());
    let mut at = 0;
    for (span, text) in edits {
        if span.start < at {
            continue;
        }
        out.push_str(&source[at..span.start]);
        out.push_str(&text);
        at = span.end;
    }
    out.push_str(&source[at..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(source: &str) -> Result<String> {
        let ledger = Ledger::read(Path::new("/nowhere"))?;
        let [claim, details, alt] = [const { String::new() }; 3];
        let words = figures::style::Words {
            claim,
            details,
            alt,
        };
        let top = Drawing {
            entry: figures::all()[0],
            figure: figures::style::figure("cat-animated", 10.0, words, |_| ())
                .value("tilt", "2.92"),
        };
        Typesetter::new(&[top], &ledger, Medium::Pages).set(
            "x.md",
            source,
            Path::new("/nowhere"),
            &HashSet::new(),
        )
    }

    #[test]
    fn dollars_in_code_are_left_alone() {
        let source = "`$x$`\n\n```text\n$y$ {{figure}}\n```\n";
        assert_eq!(set(source).unwrap(), source);
    }

    #[test]
    fn formulas_become_placeholders_that_markdown_leaves_alone() {
        let set = set("Let $a_1 * b_1$ and $c_1 * d_1$.\n\n$$\\omega < 1$$\n").unwrap();
        assert_eq!(set.matches("data-piece").count(), 3);
        assert!(!set.contains('*') && !set.contains('\\'), "{set}");
    }

    #[test]
    fn a_number_of_a_figure_stands_in_text_and_formula() {
        let set =
            set("By {{value cat-animated.tilt}}\u{b0}, or $x={{value cat-animated.tilt}}$.\n")
                .unwrap();
        assert!(set.starts_with("By 2.92\u{b0}, or <span"), "{set}");
        assert!(set.contains("2&#46;92"), "{set}");
    }

    #[test]
    fn faults_name_chapter_and_line() {
        for (source, place, word) in [
            ("a\n\n$\\frac{1}$\n", "book/src/x.md:3", "formula"),
            ("a\n\n$\\frac{1}{$\n", "book/src/x.md:3", "dollar"),
            ("a\n\nb\n\n{{figure nope}}\n", "book/src/x.md:5", "'nope'"),
            ("a\n\n## b $x$\n", "book/src/x.md:3", "heading"),
            ("[a](b.md)\n", "book/src/x.md:1", "'b.md'"),
            ("a\n{{figure b}}\n", "book/src/x.md:2", "own"),
            ("a\n{{value b.c}}\n", "book/src/x.md:2", "'b'"),
            (
                "a\n{{value cat-animated.c}}\n",
                "book/src/x.md:2",
                "'c': expected one of [tilt]",
            ),
            ("<!-- claim: C0.0-0 -->\n", "book/src/x.md:1", "C0.0-0"),
        ] {
            let message = match set(source) {
                Err(Error::Input(message)) => message,
                other => panic!("{source:?} gave {other:?}"),
            };
            assert!(
                message.starts_with(place) && message.contains(word),
                "{message}"
            );
        }
    }

    #[test]
    fn a_block_that_names_claims_gets_its_tag() {
        let set = set("Text\n```rust\n# // claim: C2.1-1\n```\n").unwrap();
        assert!(
            set.contains("id=\"x-C2.1-1\" href=\"claims.html#C2.1-1\""),
            "{set}"
        );
        assert!(set.contains("</p>\n\n```rust"), "{set}");
    }
}
