//! Builds the book, whole or not at all: for the command, and as a renderer for mdBook's own.

use crate::drawings::{self, Drawing};
use crate::error::one_line;
use crate::interrupt::{Unfinished, without_interruption};
use crate::ledger::Ledger;
use crate::typesetter::{Medium, Typesetter, without_code};
use crate::writer::{folder_of, followed};
use crate::{Error, Result};
use figures::on_your_table::Paper;
use mdbook_driver::MDBook;
use mdbook_driver::book::Chapter;
use mdbook_driver::config::Config;
use mdbook_renderer::RenderContext;
use serde_json::json;
use std::collections::{HashMap, HashSet};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use toml::Table;

/// Builds the book of the workspace at `root` into `folder` and returns the path of its first page. The book is
/// built in a temporary folder beside and takes its place by renaming, so that a failure leaves the old one. A link is followed.
pub fn bind(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let settings = Config::from_disk(root.join("book/book.toml"));
    bind_as(settings.map_err(wrong)?, root, folder, drawings)
}

/// What mdBook tells a renderer on its standard input.
///
/// # Errors
/// [`Error::Input`] if it is no such thing.
pub fn told_by_mdbook(input: impl Read) -> Result<RenderContext> {
    RenderContext::from_json(input).map_err(|error| {
        let error = one_line(&format!("{error:#}"));
        Error::Input(format!(
            "`render` is for mdBook, which tells it of a book: {error}"
        ))
    })
}

/// Builds the book for mdBook, where it wants it and as it was told to on its own command line.
pub fn render(told: &RenderContext, drawings: &[Drawing]) -> Result<()> {
    let settings = told.config.clone();
    bind_as(settings, folder_of(&told.root), &told.destination, drawings).map(drop)
}

fn bind_as(settings: Config, root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let folder = &followed(folder).map_err(Error::file(folder))?;
    let parent = folder_of(folder);
    std::fs::create_dir_all(parent).map_err(Error::file(parent))?;
    let beside = Unfinished::folder(parent).map_err(Error::file(parent))?;
    let fresh = beside.path().join("new");

    let (built, warnings) = listening(|| build(settings, root, &fresh, drawings));
    built?;
    if !warnings.is_empty() {
        return Err(Error::Input(format!(
            "mdBook warns: {}",
            warnings.join("; ")
        )));
    }

    let old = beside.path().join("old");
    let had_old = folder.exists();
    // Between the two there is no book.
    without_interruption(|| {
        if had_old {
            std::fs::rename(folder, &old)?;
        }
        std::fs::rename(&fresh, folder).inspect_err(|_| {
            if had_old {
                // The error to tell is the first.
                let _ = std::fs::rename(&old, folder);
            }
        })
    })
    .map_err(Error::file(folder))?;
    Ok(folder.join("index.html"))
}

/// The book with its chapters set, their pieces left with the typesetter.
pub fn typeset(settings: Config, root: &Path, typesetter: &mut Typesetter<'_>) -> Result<MDBook> {
    let book = as_html(settings).and_then(|html| MDBook::load_with_config(root.join("book"), html));
    let mut book = book.map_err(wrong)?;

    let source_folder = book.source_dir();
    let pages: HashSet<String> = book.book.chapters().filter_map(file_of).collect();
    let mut set = HashMap::new();
    for chapter in book.book.chapters() {
        if let Some(file) = file_of(chapter) {
            let page = typesetter.set(&file, &chapter.content, &source_folder, &pages)?;
            set.insert(file, page);
        }
    }
    book.book.for_each_chapter_mut(|chapter| {
        if let Some(page) = file_of(chapter).and_then(|file| set.remove(&file)) {
            chapter.content = page;
        }
    });
    Ok(book)
}

fn build(settings: Config, root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<()> {
    let ledger = Ledger::read(root)?;
    let mut typesetter = Typesetter::new(drawings, &ledger, Medium::Pages);
    let mut book = typeset(settings, root, &mut typesetter)?;
    book.config.build.build_dir = folder.to_owned();
    let searched = book.config.clone();
    let nothing = json!({ "": { "enable": false } });
    let indexed = book.config.set("output.html.search.chapter", nothing);
    indexed.map_err(wrong)?;
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    typesetter.into_pieces().fill_folder(folder)?;
    for paper in Paper::ALL {
        drawings::sheets(paper, &folder.join("sheets"))?;
    }

    // Once more without code, for the search index: it would hold every hidden line.
    book.book
        .for_each_chapter_mut(|chapter| chapter.content = without_code(&chapter.content));
    let aside = folder.with_extension("prose");
    book.config = searched;
    book.config.build.build_dir = aside.clone();
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    let (fat, index) = (aside.join("searchindex.js"), folder.join("searchindex.js"));
    let words = std::fs::read_to_string(&fat).map_err(Error::file(&fat))?;
    // The tree of letters says at every node that no word ends there; the reader of the index takes silence for that.
    let words = words.replace(r#""docs":{},"df":0,"#, "");
    std::fs::write(&index, words).map_err(Error::file(&index))
}

/// The settings for mdBook's own renderer of pages. In `book/book.toml` they stand under the name of the press, which mdBook therefore
/// calls in its place; what stands under `html` is added, for `mdbook serve` puts it there.
fn as_html(mut settings: Config) -> anyhow::Result<Config> {
    let mut html: Table = settings.get("output.spinning-bodies")?.unwrap_or_default();
    html.remove("command");
    html.extend(settings.get::<Table>("output.html")?.unwrap_or_default());
    settings.set(
        "output",
        Table::from_iter([("html".to_owned(), html.into())]),
    )?;
    Ok(settings)
}

pub(crate) fn wrong(error: anyhow::Error) -> Error {
    Error::Input(format!("{error:#}"))
}

/// The Markdown file of a chapter.
fn file_of(chapter: &Chapter) -> Option<String> {
    let path = chapter.source_path.as_ref()?;
    Some(path.to_string_lossy().into_owned())
}

/// Runs `work` and collects what it logs as a warning or an error: mdBook reports a missing include in no other way.
fn listening<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    let log = Log::default();
    let ear = log.clone();
    let subscriber = tracing_subscriber::fmt()
        .with_max_level(tracing::Level::WARN)
        .without_time()
        .with_ansi(false)
        .with_target(false)
        .with_writer(move || ear.clone())
        .finish();
    let result = tracing::subscriber::with_default(subscriber, work);
    let bytes = log.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let lines = String::from_utf8_lossy(&bytes);
    (
        result,
        lines.lines().map(|line| line.trim().to_owned()).collect(),
    )
}

/// A log kept in memory.
#[derive(Clone, Default)]
struct Log(Arc<Mutex<Vec<u8>>>);

impl Write for Log {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let mut log = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        log.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_mdbook_serve_asks_for_is_added_to_the_settings() {
        let told = "[output.spinning-bodies]\ncommand = \"x\"\nno-section-label = true\n";
        let mut settings: Config = told.parse().unwrap();
        let endpoint = "output.html.live-reload-endpoint";
        settings.set(endpoint, "__livereload").unwrap();
        let html = as_html(settings).unwrap();
        assert_eq!(html.outputs::<Table>().unwrap().len(), 1);
        let html = html.html_config().unwrap();
        assert!(html.no_section_label);
        assert_eq!(html.live_reload_endpoint.as_deref(), Some("__livereload"));
    }
}
