//! Prints the book again whenever one of its files is saved.

use crate::binding::bind;
use crate::chapters::CHAPTERS;
use crate::drawings::Drawing;
use crate::ledger::{is_rust, markdown_options};
use crate::paths::files_below;
use crate::writer::{say, tell};
use crate::{Error, Result};
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// How often the files are looked at; what is alike twice is saved. Where the system tells of changes by itself, editors that write beside and
/// rename, network folders and virtual machines each need care of their own.
const PAUSE: Duration = Duration::from_millis(120);

/// What pages are made of, and whether it is compiled in, so that only another run has it.
const SOURCES: [(&str, bool); 10] = [
    ("book/src", false),
    ("book/scenes", false),
    ("book/theme", false),
    ("book/book.toml", false),
    ("tests", false),
    ("book/claims.toml", true),
    ("book/press", true),
    ("figures/src", true),
    ("lab/src", true),
    ("src", true),
];

/// Prints the book of the workspace at `root` into `folder` again, with the same drawings, whenever one of its files changes, until a
/// signal ends the command. What went wrong is told, and mended by the next change.
///
/// # Errors
/// [`Error::File`] if the chapters cannot be read at the start, [`Error::OutputClosed`].
pub fn watch(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<()> {
    let (mut printed, mut examples) = (files(root), examples_of_all(root)?);
    say("watching; Ctrl-C ends it\n")?;
    loop {
        let now = changed(root, &printed);
        let all = now.keys().chain(printed.keys());
        let changed = all.filter(|file| now.get(*file) != printed.get(*file));
        let changed: Vec<PathBuf> = changed.cloned().collect();
        printed = now;
        let name = |file: &PathBuf| {
            let file = file.strip_prefix(root).unwrap_or(file);
            file.display().to_string()
        };
        let first = changed.iter().map(name).next().unwrap_or_default();
        let stale = |file: &&PathBuf| {
            let mut sources = SOURCES.iter().filter(|(_, compiled_in)| *compiled_in);
            sources.any(|(source, _)| file.starts_with(root.join(source)))
        };
        let stale = changed.iter().find(stale);

        let start = Instant::now();
        // Read before the pages: what is told of an example is on its page, even if the file is saved again meanwhile.
        let fresh = examples_of_all(root);
        let outcome = bind(root, folder, drawings).and_then(|_| {
            say(&format!(
                "{first}: printed again in {:.1} s\n",
                start.elapsed().as_secs_f64()
            ))?;
            if let Some(file) = stale {
                let file = name(file);
                say(&format!("{file}: is compiled in; run again for what it draws and computes\n"))?;
            }
            let fresh = fresh?;
            for (chapter, _) in fresh.iter().filter(|(name, code)| examples[*name] != **code) {
                say(&format!(
                    "book/src/{chapter}.md: an example changed; `cargo test -p book --doc -- {chapter}` computes it\n"
                ))?;
            }
            examples = fresh;
            Ok(())
        });
        match outcome {
            Err(Error::OutputClosed) => return Err(Error::OutputClosed),
            Err(error) => tell(format_args!("error: {error}")),
            Ok(()) => {}
        }
    }
}

/// Files with their times and lengths.
type Files = BTreeMap<PathBuf, (Option<SystemTime>, u64)>;

/// The files, as soon as they are others than these and are saved: one that is may be seen half-written.
fn changed(root: &Path, printed: &Files) -> Files {
    let mut before = files(root);
    loop {
        std::thread::sleep(PAUSE);
        let now = files(root);
        if now == before && now != *printed {
            return now;
        }
        before = now;
    }
}

/// Every file that pages are made of. What is not there, or not any more, is no file.
fn files(root: &Path) -> Files {
    let below = |(source, _): &(&str, bool)| files_below(&root.join(source)).unwrap_or_default();
    let files = SOURCES.iter().flat_map(below);
    let files = files.filter_map(|path| {
        let data = path.metadata().ok()?;
        Some((path, (data.modified().ok(), data.len())))
    });
    files.collect()
}

/// The Rust blocks of each chapter.
fn examples_of_all(root: &Path) -> Result<BTreeMap<&'static str, Vec<String>>> {
    let chapters = CHAPTERS.iter();
    chapters
        .map(|chapter| Ok((chapter.name, examples(&chapter.source(root)?))))
        .collect()
}

fn examples(chapter: &str) -> Vec<String> {
    Parser::new_ext(chapter, markdown_options())
        .into_offset_iter()
        .filter_map(|(event, span)| match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if is_rust(&info) => {
                Some(chapter[span].to_owned())
            }
            _ => None,
        })
        .collect()
}
