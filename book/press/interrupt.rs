//! What is half-written goes when the command is interrupted.

use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Files and folders that nobody has asked for: a signal removes them, holding the lock to the end, so that no other one begins.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Something half-written, beside the place where it will stand; removed unless it gets there.
#[derive(Debug)]
pub struct Unfinished(PathBuf);

impl Unfinished {
    /// A new file in this folder, with the rights that the process gives to new files.
    pub fn file(folder: &Path) -> io::Result<(Self, File)> {
        Self::make(folder, ".new", |path| {
            OpenOptions::new().write(true).create_new(true).open(path)
        })
    }

    /// A new folder in this one.
    pub fn folder(folder: &Path) -> io::Result<Self> {
        Self::make(folder, ".build", |path| std::fs::create_dir(path)).map(|(made, ())| made)
    }

    fn make<T>(
        folder: &Path,
        name: &str,
        create: impl Fn(&Path) -> io::Result<T>,
    ) -> io::Result<(Self, T)> {
        let process = std::process::id();
        let mut number = 0_u32;
        loop {
            let path = folder.join(format!("{name}-{process}-{number}"));
            let mut unfinished = unfinished();
            match create(&path) {
                Ok(made) => {
                    unfinished.push(path.clone());
                    return Ok((Self(path), made));
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
                Err(error) => return Err(error),
            }
        }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Takes the place of whatever stands there.
    pub fn become_file(self, path: &Path) -> io::Result<()> {
        without_interruption(|| std::fs::rename(&self.0, path))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        remove(&self.0);
        unfinished.retain(|path| *path != self.0);
    }
}

/// No signal is obeyed before this is done.
pub fn without_interruption<T>(work: impl FnOnce() -> T) -> T {
    let _held = unfinished();
    work()
}

fn unfinished() -> std::sync::MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

fn remove(path: &Path) {
    // Somebody may still be writing into a folder while it is removed.
    for _ in 0..100 {
        let removed = match path.is_dir() {
            true => std::fs::remove_dir_all(path),
            false => std::fs::remove_file(path),
        };
        if removed.is_ok() || !path.exists() {
            return;
        }
    }
}

/// From here on a signal that ends the command removes what is unfinished first. The exit status is the shell's: 128 and the signal.
#[cfg(unix)]
pub fn tidy_up_when_interrupted() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let mut signals = vec![SIGINT, SIGTERM];
    if !ignored(SIGHUP) {
        signals.push(SIGHUP);
    }
    // Where signals cannot be heard, they do what they always do.
    let Ok(mut signals) = signal_hook::iterator::Signals::new(signals) else {
        return;
    };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            let unfinished = unfinished();
            unfinished.iter().for_each(|path| remove(path));
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
