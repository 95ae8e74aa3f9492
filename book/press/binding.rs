//! Builds the book, whole or not at all.

use crate::drawings::Drawing;
use crate::interrupt::{Unfinished, without_interruption};
use crate::ledger::Ledger;
use crate::typesetter::{Typesetter, without_code};
use crate::writer::{folder_of, followed};
use crate::{Error, Result};
use mdbook_driver::MDBook;
use mdbook_driver::book::{BookItem, Chapter};
use std::collections::{HashMap, HashSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Builds the book of the workspace at `root` into `folder` and returns the path of its first page. The book is
/// built in a temporary folder beside and takes its place by renaming, so that a failure leaves the old one. A link is followed.
pub fn bind(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let folder = &followed(folder).map_err(Error::file(folder))?;
    let parent = folder_of(folder);
    std::fs::create_dir_all(parent).map_err(Error::file(parent))?;
    let beside = Unfinished::folder(parent).map_err(Error::file(parent))?;
    let fresh = beside.path().join("new");

    let (built, warnings) = listening(|| build(root, &fresh, drawings));
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

fn build(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<()> {
    let book_root = root.join("book");
    let ledger = Ledger::read(root)?;
    let mut book = MDBook::load(&book_root).map_err(|e| Error::Input(format!("{e:#}")))?;
    book.config.build.build_dir = folder.to_owned();

    let source_folder = book.source_dir();
    let chapters: Vec<(String, String)> = book
        .iter()
        .filter_map(|item| match item {
            BookItem::Chapter(chapter) => Some((file_of(chapter)?, chapter.content.clone())),
            _ => None,
        })
        .collect();
    let pages: HashSet<String> = chapters.iter().map(|(file, _)| file.clone()).collect();
    let mut typesetter = Typesetter::new(drawings, &ledger);
    let mut set = HashMap::new();
    for (file, source) in chapters {
        let page = typesetter.set(&file, &source, &source_folder, &pages)?;
        set.insert(file, page);
    }
    book.book.for_each_chapter_mut(|chapter| {
        if let Some(page) = file_of(chapter).and_then(|file| set.remove(&file)) {
            chapter.content = page;
        }
    });
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    typesetter.into_pieces().fill_folder(folder)?;

    // Once more without code, for the search index: it would hold every hidden line.
    book.book
        .for_each_chapter_mut(|chapter| chapter.content = without_code(&chapter.content));
    let aside = folder.with_extension("prose");
    book.config.build.build_dir = aside.clone();
    book.build().map_err(|e| Error::Failed(format!("{e:#}")))?;
    let (fat, index) = (aside.join("searchindex.js"), folder.join("searchindex.js"));
    let words = std::fs::read_to_string(&fat).map_err(Error::file(&fat))?;
    // The tree of letters says at every node that no word ends there; the reader of the index takes silence for that.
    let words = words.replace(r#""docs":{},"df":0,"#, "");
    std::fs::write(&index, words).map_err(Error::file(&index))
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
