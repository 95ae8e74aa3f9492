//! Typesets one chapter: formulas, figures and claim tags become HTML, or placeholders for it.

use crate::appendix;
use crate::chapters::{self, CHAPTERS, COVER};
use crate::drawings::{Drawing, unknown_figure};
use crate::formulas;
use crate::ledger::{Kind, Ledger, claims_of, line_after, markdown_options};
use crate::pieces::{Pieces, inert, options, unbroken};
use crate::{Error, Result, live};
use katex::Settings;
use pulldown_cmark::{Event, Parser, Tag};
use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;

/// The typesetter, with what all chapters share: the drawings and their numbers, the ledger, the pieces.
pub struct Typesetter<'a> {
    root: &'a Path,
    drawings: &'a [Drawing],
    /// The figures shown so far: the first is Figure 1.
    shown: Vec<&'static str>,
    ledger: Ledger,
    /// The pieces kept so far, to fill into the pages.
    pub pieces: Pieces,
    medium: Medium,
}

/// The medium in which the chapters will be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Medium {
    /// A browser: formulas in its fonts, pictures in the page, where themes and sliders can change them.
    Pages,
    /// An e-reader: formulas as MathML, pictures as files.
    Ebook,
}

/// The control that stops a moving figure, by finger, mouse or key.
const PAUSE: &str = "<label class=\"pause\"><input type=\"checkbox\"> Pause</label>";

/// The ids of pictures in the gallery.
const SMALL: &str = "small";

/// The result, or the message of what is wrong.
type Told<T> = std::result::Result<T, String>;

impl<'a> Typesetter<'a> {
    /// A typesetter for one book, with the ledger of the workspace at `root`.
    pub fn new(root: &'a Path, drawings: &'a [Drawing], medium: Medium) -> Result<Self> {
        Ok(Typesetter {
            root,
            drawings,
            shown: Vec::new(),
            ledger: Ledger::read(root)?,
            pieces: Pieces::default(),
            medium,
        })
    }

    /// The chapter in the form that mdBook reads; `file` is its name in `book/src`. Chapters must come in the order of the book, in which figures are numbered.
    pub fn set(&mut self, file: &str, source: &str) -> Result<String> {
        let fault = |before: &str, why: String| {
            let line = line_after(before);
            Error::Input(format!("book/src/{file}:{line}: {why}"))
        };
        let source = self.with_values(source, fault)?;
        let chapter = file.trim_end_matches(".md");
        // The end of the last heading, and the end of the text already done.
        let (mut heading, mut done) = (0, 0);
        let mut seen = HashSet::new();
        let mut edits: Vec<(Range<usize>, String)> = Vec::new();
        for (event, span) in Parser::new_ext(&source, markdown_options()).into_offset_iter() {
            if span.start < done {
                continue;
            }
            let fault = |why| fault(&source[..span.start], why);
            let text = &source[span.clone()];
            if let Some((kind, claims)) = claims_of(&event, text) {
                let tags = self.tags(chapter, claims, &mut seen).map_err(fault)?;
                if !source[..span.start].ends_with('\n') && span.start > 0 {
                    let why = "a block or comment that names claims must start at the left margin, not in a list or within a line";
                    return Err(fault(why.into()));
                }
                edits.push(match kind {
                    Kind::Comment => (span.clone(), tags),
                    // The blank line before lets the tags follow a paragraph directly.
                    _ => (span.start..span.start, format!("\n{tags}")),
                });
            }
            let told: Told<Option<String>> = match event {
                Event::Start(Tag::Heading { .. }) => {
                    heading = span.end;
                    Ok(None)
                }
                Event::Start(Tag::CodeBlock(_)) => {
                    done = span.end;
                    Ok(None)
                }
                Event::Start(Tag::Paragraph) => self.directive(chapter, text.trim()),
                Event::InlineMath(latex) | Event::DisplayMath(latex) if span.start < heading => {
                    Err(format!(
                        "a heading has the formula ${latex}$, but headings must have none"
                    ))
                }
                Event::InlineMath(latex) => self.formula(&latex, &Settings::default()).map(Some),
                Event::DisplayMath(latex) => {
                    let display = Settings::builder().display_mode(true).build();
                    self.formula(&latex, &display).map(Some)
                }
                Event::Text(_) if text.contains("{{") => {
                    Err("a directive must be on a line of its own, between blank lines".into())
                }
                Event::Text(_) if text.contains('$') => {
                    Err("this dollar sign neither opens nor closes a formula".into())
                }
                Event::Text(_) => Ok(Some(unbroken(text))),
                Event::Code(code) if code.contains(" -") || code.starts_with("--") => {
                    Ok(Some(format!("<code>{}</code>", options(&code))))
                }
                Event::Start(Tag::Link { dest_url, .. }) => {
                    let page = dest_url.split('#').next().unwrap_or_default();
                    match page.strip_suffix(".md") {
                        Some(chapter) if !CHAPTERS.contains(&chapter) => {
                            Err(format!("the link leads to '{page}', which is no chapter"))
                        }
                        _ => Ok(None),
                    }
                }
                _ => Ok(None),
            };
            if let Some(html) = told.map_err(fault)? {
                done = span.end;
                edits.push((span, html));
            }
        }
        Ok(edited(&source, edits))
    }

    /// The chapter with numbers that figures computed in place of `{{value FIGURE.NAME}}`.
    fn with_values(&self, source: &str, fault: impl Fn(&str, String) -> Error) -> Result<String> {
        let mut parts = source.split("{{value ");
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (name, after) = part.split_once("}}").unwrap_or((part, ""));
            out += self.value(name.trim()).map_err(|why| fault(&out, why))?;
            out += after;
        }
        Ok(out)
    }

    fn value(&self, name: &str) -> Told<&'a str> {
        let (figure, key) = name.split_once('.').unwrap_or((name, ""));
        let values = &self.drawing(figure)?.figure.values;
        let found = values.iter().find(|(known, _)| *known == key);
        found.map(|(_, text)| text.as_str()).ok_or_else(|| {
            let known: Vec<_> = values.iter().map(|(known, _)| *known).collect();
            let known = known.join(", ");
            format!("figure '{figure}' has no value '{key}': expected one of [{known}]")
        })
    }

    fn formula(&mut self, latex: &str, settings: &Settings) -> Told<String> {
        let told = |error| format!("in the formula ${}$: {error}", latex.trim());
        let html = formulas::html(latex, settings).map_err(told)?;
        // A letter with its index can be searched for, but not LaTeX.
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
            ["claims"] => Ok(Some(appendix::page(&self.ledger) + "\n")),
            ["figure", name] => self.figure(chapter, name).map(Some),
            ["gallery"] => self.gallery().map(Some),
            ["foot", ref beside @ ..] => chapters::foot(self.root, chapter, beside).map(Some),
            // Other includes are left to mdBook.
            ["#include", file] if file.starts_with("tables/") => self.table(file).map(Some),
            _ => Ok(None),
        }
    }

    /// A generated table, with its formulas typeset.
    fn table(&mut self, file: &str) -> Told<String> {
        let path = self.root.join("book/src").join(file);
        let table = std::fs::read_to_string(&path);
        let table = table.map_err(|error| format!("{}: {error}", path.display()))?;
        let set = self.set(file, &table).map_err(|error| error.to_string())?;
        Ok(set.trim_end_matches('\n').to_owned() + "\n")
    }

    fn drawing(&self, name: &str) -> Told<&'a Drawing> {
        let drawing = self.drawings.iter().find(|one| one.entry.name == name);
        drawing.ok_or_else(|| unknown_figure(name).to_string())
    }

    fn figure(&mut self, chapter: &str, name: &str) -> Told<String> {
        let drawing = self.drawing(name)?;
        let claim = self.caption(&drawing.figure.claim)?;
        if chapter == COVER {
            let picture = self.picture(drawing, "cover");
            return Ok(format!(
                "<figure id=\"cover-{name}\">{picture}<figcaption>{claim}</figcaption></figure>\n\n"
            ));
        }
        if self.shown.contains(&name) {
            return Err(format!("figure '{name}' is shown a second time"));
        }
        self.shown.push(drawing.entry.name);
        let number = self.shown.len();
        let picture = self.picture(drawing, "fig");
        let details = self.caption(&drawing.figure.details)?;
        let numbers = inert(&live::parameters(&drawing.entry).to_string());
        let live = match (self.medium, drawing.entry.parameters) {
            (Medium::Ebook, _) | (_, []) => String::new(),
            _ => format!(" data-live=\"{numbers}\""),
        };
        Ok(format!(
            "<figure id=\"fig-{name}\"{live}>{picture}<figcaption><span class=\"figure-number\">Figure {number}.</span> \
             <strong>{claim}</strong> {details}</figcaption></figure>\n\n"
        ))
    }

    /// A figure without its frame; one that moves can be stopped, unless it is small. The print page shows all chapters, so where a figure is shown again
    /// its ids have another prefix.
    fn picture(&mut self, Drawing { entry, figure }: &Drawing, ids: &str) -> String {
        let name = entry.name;
        let html = match self.medium {
            Medium::Pages => {
                let [old, new] = ["fig", ids].map(|ids| format!("{ids}-{name}"));
                let svg = figure.svg().trim_end().replace(&old, &new);
                match svg.contains("@keyframes") && ids != SMALL {
                    true => PAUSE.to_owned() + &svg,
                    false => svg,
                }
            }
            Medium::Ebook => {
                let alt = inert(&figure.alt);
                format!("<img src=\"figures/{name}.svg\" alt=\"{alt}\"/>")
            }
        };
        self.pieces.keep(html, "")
    }

    /// Every figure, small: its number, its claim, and the command that draws it.
    fn gallery(&mut self) -> Told<String> {
        let mut out = String::from("<div class=\"gallery\">\n");
        let idle = |entry: &&figures::Entry| !self.shown.contains(&entry.name);
        if let Some(idle) = figures::all().iter().find(idle) {
            return Err(format!("figure '{}' is in no chapter", idle.name));
        }
        for (number, name) in (1..).zip(self.shown.clone()) {
            let drawing = self.drawing(name)?;
            let chapter = drawing.entry.chapter;
            let picture = self.picture(drawing, SMALL);
            let claim = self.caption(&drawing.figure.claim)?;
            let set = |key| format!(" <span class=\"unbroken\">--set {key}=…</span>");
            let keys = drawing.entry.parameters.iter().map(|one| set(one.key));
            let keys: String = keys.collect();
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
            out += &match i % 2 {
                // A straight apostrophe becomes a curved one, as mdBook does in the chapters.
                0 => inert(&unbroken(&part.replace('\'', "’"))),
                _ => self.formula(part, &Settings::default())?,
            };
        }
        Ok(out)
    }

    /// Links to the claims appendix for the claims that a block or a comment names; `seen` are those that the chapter has named before.
    fn tags(&self, chapter: &str, claims: Vec<String>, seen: &mut HashSet<String>) -> Told<String> {
        let mut links = Vec::new();
        for id in claims {
            let unknown = || format!("'{id}' is no claim of book/claims.toml");
            let claim = self.ledger.claim(&id).ok_or_else(unknown)?;
            let anchor = match seen.contains(&id) {
                false => format!(" id=\"{}\"", appendix::place_id(chapter, &id)),
                true => String::new(),
            };
            links.push(format!(
                "<a class=\"claim-tag\"{anchor} href=\"claims.html#{id}\" title=\"A claim of the tutorial: {}\">{id}</a>",
                inert(&claim.title)
            ));
            seen.insert(id);
        }
        let links = links.join(" ");
        Ok(format!("{TAGS}{links}</p>\n\n"))
    }
}

/// How the line with the claims of a block begins.
const TAGS: &str = "<p class=\"claim-tags\">";

/// The chapter without its blocks of code and the names of claims above them.
pub fn without_code(chapter: &str) -> String {
    let events = Parser::new_ext(chapter, markdown_options()).into_offset_iter();
    let is_code = |event: &Event<'_>| matches!(event, Event::Start(Tag::CodeBlock(_)));
    let blocks = events.filter(|(event, _)| is_code(event));
    let prose = edited(chapter, blocks.map(|(_, span)| (span, "\n".into())));
    let lines = prose.split_inclusive('\n');
    lines.filter(|line| !line.starts_with(TAGS)).collect()
}

/// The text with replacements at these places, given in order.
fn edited(source: &str, edits: impl IntoIterator<Item = (Range<usize>, String)>) -> String {
    let mut out = String::with_capacity(2 * source.len());
    let mut at = 0;
    for (span, text) in edits {
        out.push_str(&source[at..span.start]);
        out.push_str(&text);
        at = span.end;
    }
    out + &source[at..]
}
