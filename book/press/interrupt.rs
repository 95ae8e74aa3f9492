//! Removes half-written files when the command is interrupted.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::TempDir;

/// Temporary folders, also those that are gone; a signal removes them, and holds the lock to the end, so that no new one is made.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A folder for half-written output, beside its final place; it is removed with everything in it.
#[derive(Debug)]
pub struct Unfinished(TempDir);

impl Unfinished {
    /// A new folder in this one.
    pub fn within(folder: &Path) -> io::Result<Self> {
        let mut unfinished = unfinished();
        let new = tempfile::Builder::new().prefix(".new-").tempdir_in(folder);
        // Its own words would name the new folder, which nobody asked for.
        let new = new.map_err(|error| io::Error::from(error.kind()))?;
        unfinished.push(new.path().to_owned());
        Ok(Self(new))
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// The path for the new file or folder, which [`take`](Self::take) will put in its place.
    pub fn new_one(&self) -> PathBuf {
        self.path().join("new")
    }

    /// Puts the new file or folder in place of whatever is there.
    pub fn take(self, place: &Path) -> io::Result<()> {
        let _held = unfinished();
        if !place.is_dir() {
            return std::fs::rename(self.new_one(), place);
        }
        // Between these two renamings the place is empty.
        let old = self.path().join("old");
        std::fs::rename(place, &old)?;
        std::fs::rename(self.new_one(), place).inspect_err(|_| {
            // The error to report is the first.
            let _ = std::fs::rename(&old, place);
        })
    }
}

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From here on a signal that ends the command removes what is unfinished first. The exit status is the shell's: 128 and the signal.
#[cfg(unix)]
pub fn tidy_up_when_interrupted() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let mut signals = vec![SIGINT, SIGTERM];
    if !ignored(SIGHUP) {
        signals.push(SIGHUP);
    }
    // If signals cannot be caught, they have their default effect.
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else {
        return;
    };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            let unfinished = unfinished();
            for folder in unfinished.iter() {
                // Somebody may still be writing into it.
                let _ =
                    (0..100).find(|_| std::fs::remove_dir_all(folder).is_ok() || !folder.exists());
            }
            std::process::exit(128 + signal);
        }
    });
}

#[cfg(not(unix))]
pub fn tidy_up_when_interrupted() {}

/// Whether the process was started to outlive this signal, as `nohup` does.
#[cfg(unix)]
fn ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}
