//! Builds the book, whole or not at all: for the command, and as a renderer for mdBook itself.

use crate::drawings::{self, Drawing};
use crate::typesetter::{Medium, Typesetter, without_code};
use crate::writer::{folder_of, followed, whole};
use crate::{Error, Result};
use figures::on_your_table::Paper;
use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use mdbook_driver::config::Config;
use mdbook_renderer::RenderContext;
use serde_json::json;
use std::fmt::Debug;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use toml::Table;
use tracing::field::Field;
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber};

/// Builds the book of the workspace at `root` into `folder` and returns the path of its first page. The book is
/// built in a temporary folder beside and takes its place by renaming, so that a failure leaves the old one. A link is followed.
pub fn bind(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let settings = Config::from_disk(root.join("book/book.toml"));
    bind_as(settings.map_err(wrong)?, root, folder, drawings)
}

/// Builds the book for mdBook, which passes folder and options on the standard input: in that folder and with these options.
///
/// # Errors
/// [`Error::Input`] if the input is anything else; those of drawing and binding.
pub fn render(input: impl Read, draw: impl FnOnce() -> Result<Vec<Drawing>>) -> Result<()> {
    let told = RenderContext::from_json(input).map_err(|error| {
        let who = "`render` is called by mdBook, which passes it a book";
        Error::Input(format!("{who}: {error:#}"))
    })?;
    let root = folder_of(&told.root);
    bind_as(told.config, root, &told.destination, &draw()?).map(drop)
}

fn bind_as(settings: Config, root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let folder = &followed(folder).map_err(Error::file(folder))?;
    whole(folder, |new| {
        let warnings = Arc::new(Warnings::default());
        let build = || build(settings, root, new, drawings);
        tracing::subscriber::with_default(Arc::clone(&warnings), build)?;
        match warnings.told().join("; ") {
            none if none.is_empty() => Ok(()),
            warnings => Err(Error::Input(format!("mdBook warns: {warnings}"))),
        }
    })?;
    Ok(folder.join("index.html"))
}

/// The warnings of mdBook, which reports a missing include in no other way.
#[derive(Default)]
struct Warnings(Mutex<Vec<String>>);

impl Warnings {
    fn told(&self) -> MutexGuard<'_, Vec<String>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Subscriber for Warnings {
    fn enabled(&self, about: &Metadata<'_>) -> bool {
        *about.level() <= Level::WARN && about.is_event()
    }

    fn event(&self, event: &Event<'_>) {
        event.record(&mut |_: &Field, value: &dyn Debug| self.told().push(format!("{value:?}")));
    }

    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }

    fn record(&self, _: &Id, _: &Record<'_>) {}
    fn record_follows_from(&self, _: &Id, _: &Id) {}
    fn enter(&self, _: &Id) {}
    fn exit(&self, _: &Id) {}
}

/// The book with its chapters typeset; the typesetter keeps their pieces.
pub(crate) fn typeset(
    settings: Config,
    root: &Path,
    typesetter: &mut Typesetter<'_>,
) -> Result<MDBook> {
    let book = as_html(settings).and_then(|html| MDBook::load_with_config(root.join("book"), html));
    let mut book = book.map_err(wrong)?;
    set(&mut book.book.items, typesetter)?;
    Ok(book)
}

/// Typesets chapters in the order of reading, in which figures are numbered.
fn set(items: &mut [BookItem], typesetter: &mut Typesetter<'_>) -> Result<()> {
    for item in items {
        if let BookItem::Chapter(chapter) = item {
            if let Some(file) = &chapter.source_path {
                chapter.content = typesetter.set(&file.to_string_lossy(), &chapter.content)?;
            }
            set(&mut chapter.sub_items, typesetter)?;
        }
    }
    Ok(())
}

fn build(settings: Config, root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<()> {
    let mut typesetter = Typesetter::new(root, drawings, Medium::Pages)?;
    let mut book = typeset(settings, root, &mut typesetter)?;
    book.config.build.build_dir = folder.to_owned();
    let searched = book.config.clone();
    let nothing = json!({ "": { "enable": false } });
    let indexed = book.config.set("output.html.search.chapter", nothing);
    indexed.map_err(wrong)?;
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    typesetter.pieces.fill_folder(folder)?;
    // On paper, and in a PDF that is passed on, a link to a file beside the pages leads nowhere.
    let printed = folder.join("print.html");
    let page = std::fs::read_to_string(&printed).map_err(Error::file(&printed))?;
    let page = page.replace("<a href=\"sheets/", "<a data-href=\"sheets/");
    std::fs::write(&printed, page).map_err(Error::file(&printed))?;
    for paper in Paper::ALL {
        drawings::sheets(paper, &folder.join("sheets"))?;
    }

    // Once more without code, for the search index, which would otherwise contain every hidden line.
    book.book
        .for_each_chapter_mut(|chapter| chapter.content = without_code(&chapter.content));
    let aside = folder.with_extension("prose");
    book.config = searched;
    book.config.build.build_dir = aside.clone();
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    let (fat, index) = (aside.join("searchindex.js"), folder.join("searchindex.js"));
    let words = std::fs::read_to_string(&fat).map_err(Error::file(&fat))?;
    // The tree of letters states at every node that no word ends there; the reader of the index assumes so anyway.
    let words = words.replace(r#""docs":{},"df":0,"#, "");
    std::fs::write(&index, words).map_err(Error::file(&index))
}

/// The settings for mdBook's own renderer of pages. In `book/book.toml` they stand under the name of the press, which mdBook therefore
/// calls in its place; what stands under `html` is added, for `mdbook serve` puts it there.
fn as_html(mut settings: Config) -> anyhow::Result<Config> {
    let mut html: Table = settings.get("output.spinning-bodies")?.unwrap_or_default();
    html.remove("command");
    html.extend(settings.get::<Table>("output.html")?.unwrap_or_default());
    let alone = Table::from_iter([("html".to_owned(), html.into())]);
    settings.set("output", alone)?;
    Ok(settings)
}

pub(crate) fn wrong(error: anyhow::Error) -> Error {
    Error::Input(format!("{error:#}"))
}
