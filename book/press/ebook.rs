//! The book as one file: an EPUB for e-readers, a PDF printed by a browser.

use crate::appendix::mdbook_anchor;
use crate::binding::{self, wrong};
use crate::drawings::Drawing;
use crate::interrupt::Unfinished;
use crate::ledger::markdown_options;
use crate::pieces::{Pieces, flush_left};
use crate::typesetter::{Medium, Typesetter};
use crate::writer::{folder_of, write_if_changed};
use crate::{Error, Result};
use figures::Look;
use figures::on_your_table::{self, Paper};
use mdbook_driver::book::{Book, Chapter};
use mdbook_driver::builtin_renderers::MarkdownRenderer;
use mdbook_driver::config::Config;
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag, TagEnd, html::push_html};
use std::io::{Cursor, Write};
use std::path::Path;
use std::process::Command;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// The first entry of every EPUB.
const CONTAINER: &str = include_str!("epub/container.xml");
/// Its time is fixed, so that equal chapters give equal bytes.
const PACKAGE: &str = include_str!("epub/book.opf");
const PAGE: &str = include_str!("epub/page.xhtml");
const STYLE: &str = include_str!("epub/book.css");

/// Browsers that print without a window, by the names under which they are installed.
const BROWSERS: [&str; 6] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
];

/// An installed browser that prints without a window.
///
/// # Errors
/// [`Error::Failed`] if there is none.
pub fn browser() -> Result<&'static str> {
    let is_there = |name: &&str| Command::new(name).arg("--version").output().is_ok();
    BROWSERS.into_iter().find(is_there).ok_or_else(|| {
        Error::Failed(format!(
            "--pdf: a browser prints it, and none of these is installed: {}; any other can print book/build/print.html",
            BROWSERS[..5].join(", ")
        ))
    })
}

/// Has this browser print all chapters, `print.html` in the folder of the pages, to a PDF.
///
/// # Errors
/// [`Error::Failed`] if it prints nothing.
pub fn pdf(browser: &str, pages: &Path, file: &Path) -> Result<()> {
    let beside = Unfinished::within(folder_of(file)).map_err(Error::file(file))?;
    let printed = beside.path().join("book.pdf");
    let mut command = Command::new(browser);
    // Only these pages are opened, which allow no script but their own; a sandbox would need privileges of the system.
    command.args(["--headless", "--disable-gpu", "--no-sandbox"]);
    command.args(["--no-pdf-header-footer", "--generate-pdf-document-outline"]);
    command.arg(format!("--user-data-dir={}", beside.path().display()));
    command.arg(format!("--print-to-pdf={}", printed.display()));
    command.arg(pages.join("print.html"));
    // Its output is about itself; the file shows whether it has printed.
    let _ = command.output();
    let bytes = std::fs::read(&printed)
        .map_err(|error| Error::Failed(format!("{browser} printed no PDF: {error}")))?;
    write_if_changed(file, &bytes).map(drop)
}

/// Writes the book as an EPUB 3: formulas as MathML, figures as SVG, nothing that runs.
///
/// # Errors
/// Those of binding and writing.
pub fn epub(root: &Path, drawings: &[Drawing], file: &Path) -> Result<()> {
    let settings = Config::from_disk(root.join("book/book.toml")).map_err(wrong)?;
    let mut typesetter = Typesetter::new(root, drawings, Medium::Ebook)?;
    let book = binding::typeset(settings, root, &mut typesetter)?;
    let processed = book.preprocess_book(&MarkdownRenderer::new());
    let (processed, _) = processed.map_err(wrong)?;
    let bytes = packed(drawings, &processed, &typesetter.pieces)
        .map_err(|error| Error::Failed(format!("the EPUB: {error}")))?;
    write_if_changed(file, &bytes).map(drop)
}

fn packed(drawings: &[Drawing], book: &Book, pieces: &Pieces) -> anyhow::Result<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    let small = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    zip.start_file("mimetype", stored)?;
    zip.write_all(b"application/epub+zip")?;
    let mut add = |name: &str, text: &str| {
        zip.start_file(name, small)?;
        zip.write_all(text.as_bytes()).map_err(anyhow::Error::from)
    };
    add("META-INF/container.xml", CONTAINER)?;
    add("book.css", STYLE)?;
    add("contents.xhtml", &page("Contents", &contents(book)))?;
    let (mut manifest, mut spine) = (String::new(), String::new());
    for chapter in book.chapters() {
        let Some(path) = &chapter.path else { continue };
        let name = path.with_extension("xhtml").display().to_string();
        let body = flush_left(&pieces.fill(&xhtml(&chapter.content))?);
        let id = name.replace('.', "-");
        let mathml = body.contains("<math").then_some(" properties=\"mathml\"");
        let mathml = mathml.unwrap_or_default();
        manifest += &format!(
            "<item id=\"{id}\" href=\"{name}\" media-type=\"application/xhtml+xml\"{mathml}/>\n"
        );
        spine += &format!("<itemref idref=\"{id}\"/>\n");
        add(&name, &page(&chapter.name, &body))?;
    }
    let mut picture = |name: &str, svg: &str| {
        let id = name.replace(['/', '.'], "-");
        manifest += &format!("<item id=\"{id}\" href=\"{name}\" media-type=\"image/svg+xml\"/>\n");
        add(name, svg)
    };
    for Drawing { entry, figure } in drawings {
        let name = format!("figures/{}.svg", entry.name);
        let svg = figure.file(Look::default());
        // As a property it is allowed where the attribute is not.
        let svg = svg.replace(
            " vector-effect=\"non-scaling-stroke\" style=\"",
            " style=\"vector-effect:non-scaling-stroke;",
        );
        picture(&name, &svg)?;
    }
    for sheet in on_your_table::sheets(Paper::A4)? {
        if sheet.name.ends_with(".svg") {
            let name = format!("sheets/{}", sheet.name);
            picture(&name, &String::from_utf8_lossy(&sheet.contents))?;
        }
    }
    let package = PACKAGE
        .replace("MANIFEST", &manifest)
        .replace("SPINE", &spine)
        .replace("VERSION", env!("CARGO_PKG_VERSION"));
    add("book.opf", &package)?;
    Ok(zip.finish()?.into_inner())
}

/// A chapter as its reader sees it: without hidden lines, headings with the ids for links, links to chapters and to the web.
fn xhtml(chapter: &str) -> String {
    let mut events: Vec<Event<'_>> = Vec::new();
    let (mut in_rust, mut leads) = (false, false);
    for (mut event, span) in Parser::new_ext(chapter, markdown_options()).into_offset_iter() {
        match &mut event {
            Event::Start(Tag::Heading { id, .. }) => {
                let words = chapter[span].trim_matches(['#', ' ', '\n']);
                *id = Some(mdbook_anchor(words).into());
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                in_rust = language.starts_with("rust");
            }
            Event::End(TagEnd::CodeBlock) => in_rust = false,
            Event::Text(code) if in_rust => *code = shown(code).into(),
            Event::Html(html) | Event::InlineHtml(html) => {
                // That of the press has links among the chapters.
                let elsewhere = html.replace(".html#", ".xhtml#");
                *html = elsewhere.replace(".html\"", ".xhtml\"").into();
            }
            Event::Start(Tag::Link { dest_url, .. }) => {
                let page = dest_url.split('#').next().unwrap_or_default();
                let in_the_book = page.is_empty() || page.ends_with(".md");
                // Else to a file beside the pages; here there is none.
                leads = in_the_book || page.contains("://");
                if in_the_book {
                    *dest_url = dest_url.replacen(".md", ".xhtml", 1).into();
                }
            }
            _ => {}
        }
        match event {
            Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) if !leads => {}
            event => events.push(event),
        }
    }
    let mut out = String::new();
    push_html(&mut out, events.into_iter());
    out
}

/// The lines of an example that are not hidden: a hash and a blank hide a line, two hashes stand for one.
fn shown(code: &str) -> String {
    let line = |line: &str| {
        let text = line.trim_start();
        match text.strip_prefix('#') {
            Some(rest) if rest.starts_with('#') => Some(line.replacen("##", "#", 1)),
            Some(rest) if rest.trim_end().is_empty() || rest.starts_with(' ') => None,
            _ => Some(line.to_owned()),
        }
    };
    code.split_inclusive('\n').filter_map(line).collect()
}

fn page(title: &str, body: &str) -> String {
    PAGE.replace("TITLE", &title.replace('&', "&amp;"))
        .replace("BODY", body)
}

/// The chapters as a list, those of a chapter below it.
fn contents(book: &Book) -> String {
    let line = |chapter: &Chapter| {
        let path = chapter.path.as_ref()?.display();
        let indent = "   ".repeat(chapter.parent_names.len());
        Some(format!("{indent}1. [{}]({path})\n", chapter.name))
    };
    let list: String = book.chapters().filter_map(line).collect();
    let list = xhtml(&list);
    format!("<nav epub:type=\"toc\"><h1>Contents</h1>\n{list}</nav>\n")
}
