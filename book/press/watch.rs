//! Prints the book again whenever one of its files is saved.

use crate::binding::bind;
use crate::chapters::CHAPTERS;
use crate::drawings::Drawing;
use crate::ledger::{is_rust, markdown_options};
use crate::writer::{say, tell};
use crate::{Error, Result};
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// How often the files are looked at. Where the system tells of changes by itself, editors that write beside and rename, network
/// folders and virtual machines each need care of their own.
const PAUSE: Duration = Duration::from_millis(200);

/// Files that have not changed for so long are saved.
const SETTLED: Duration = Duration::from_millis(40);

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
        std::thread::sleep(PAUSE);
        let mut now = files(root);
        // A file may be seen half-saved: empty first, then full.
        while now != printed {
            std::thread::sleep(SETTLED);
            let later = files(root);
            let settled = later == now;
            now = later;
            if settled {
                break;
            }
        }
        let all = now.keys().chain(printed.keys());
        let changed = all.filter(|file| now.get(*file) != printed.get(*file));
        let changed: Vec<PathBuf> = changed.cloned().collect();
        printed = now;
        let name = |file: &Path| {
            let file = file.strip_prefix(root).unwrap_or(file);
            file.display().to_string()
        };
        let Some(first) = changed.first().map(|file| name(file)) else {
            continue;
        };
        let stale = changed.iter().find(|file| is_compiled_in(root, file));

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

fn is_compiled_in(root: &Path, file: &Path) -> bool {
    let mut sources = SOURCES.iter().filter(|(_, compiled_in)| *compiled_in);
    sources.any(|(source, _)| file.starts_with(root.join(source)))
}

/// Every file that pages are made of, with its time and length.
fn files(root: &Path) -> BTreeMap<PathBuf, (SystemTime, u64)> {
    fn collect(path: PathBuf, found: &mut BTreeMap<PathBuf, (SystemTime, u64)>) {
        // What is not there, or not any more, is no file.
        if let Ok(entries) = std::fs::read_dir(&path) {
            entries
                .flatten()
                .for_each(|entry| collect(entry.path(), found));
        } else if let Ok(data) = path.metadata() {
            let time = data.modified().unwrap_or(SystemTime::UNIX_EPOCH);
            found.insert(path, (time, data.len()));
        }
    }
    let mut found = BTreeMap::new();
    for (source, _) in SOURCES {
        collect(root.join(source), &mut found);
    }
    found
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
