//! Prints the book again whenever one of its files is saved.

use crate::binding::bind;
use crate::chapters::CHAPTERS;
use crate::drawings::Drawing;
use crate::paths::files_below;
use crate::writer::{say, tell};
use crate::{Error, Result};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// Interval at which the files are checked; a file that is the same twice in succession counts as saved. Change notifications of the system are not used,
/// because editors that rename, network folders and virtual machines would each need care of their own.
const PAUSE: Duration = Duration::from_millis(120);

/// The sources of the pages.
const SOURCES: [&str; 5] = [
    "book/src",
    "book/scenes",
    "book/theme",
    "book/book.toml",
    "tests",
];
/// Sources that are compiled in, so that only another run shows their changes.
const COMPILED_IN: [&str; 5] = [
    "book/claims.toml",
    "book/press",
    "figures/src",
    "lab/src",
    "src",
];

/// Prints the book of the workspace at `root` into `folder` again, with the same drawings, whenever one of its files changes, until a
/// signal ends the command. Errors are reported, and the next change can mend them.
///
/// # Errors
/// [`Error::OutputClosed`].
pub fn watch(root: &Path, folder: &Path, drawings: &[Drawing]) -> Result<()> {
    let mut printed = files(root);
    say("watching; Ctrl-C ends it\n")?;
    loop {
        let now = changed(root, &printed);
        let all = now.keys().chain(printed.keys());
        let changed = all.filter(|file| now.get(*file) != printed.get(*file));
        let changed: Vec<PathBuf> = changed.cloned().collect();
        printed = now;
        let start = Instant::now();
        let outcome = bind(root, folder, drawings).and_then(|_| {
            if let Some(first) = changed.first() {
                let (first, seconds) = (first.display(), start.elapsed().as_secs_f64());
                say(&format!("{first}: printed again in {seconds:.1} s\n"))?;
            }
            changed
                .iter()
                .filter_map(|file| advice(file))
                .try_for_each(|told| say(&told))
        });
        match outcome {
            Err(Error::OutputClosed) => return Err(Error::OutputClosed),
            Err(error) => tell(format_args!("error: {error}")),
            Ok(()) => {}
        }
    }
}

/// What else is to be done after a change of this file, if anything.
fn advice(file: &Path) -> Option<String> {
    let told = file.display();
    if COMPILED_IN.iter().any(|source| file.starts_with(source)) {
        let told = format!("{told}: is compiled in; run the command again to see its change\n");
        return Some(told);
    }
    let chapter = file.strip_prefix("book/src").ok()?.to_str()?;
    let chapter = chapter.strip_suffix(".md")?;
    let runs = format!("{told}: `cargo test -p book --doc -- {chapter}` runs its examples\n");
    CHAPTERS.contains(&chapter).then_some(runs)
}

/// Files with their times and lengths.
type Files = BTreeMap<PathBuf, (Option<SystemTime>, u64)>;

/// The files, as soon as they differ from these and have been saved completely.
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

/// Every source file of the pages, relative to the root. Files that do not exist are left out.
fn files(root: &Path) -> Files {
    let sources = SOURCES.iter().chain(&COMPILED_IN);
    let files = sources.flat_map(|source| files_below(&root.join(source)).unwrap_or_default());
    let files = files.filter_map(|path| {
        let data = path.metadata().ok()?;
        let file = path.strip_prefix(root).ok()?.to_owned();
        Some((file, (data.modified().ok(), data.len())))
    });
    files.collect()
}
