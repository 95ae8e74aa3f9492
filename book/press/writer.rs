//! All writing by the press: files whole or not at all, devices and pipes directly.

use clap::ValueEnum;
use std::fmt::Display;
use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf, is_separator};

use crate::interrupt::Unfinished;
use crate::{Error, Result};

/// The destination of some output, checked before any work is done for it.
///
/// A regular file is written under another name beside it and renamed, so that it is there whole or not at all; links are followed to it, and it keeps its
/// permissions, or gets those that the process gives to new files. Devices and pipes are opened and written directly.
pub struct Target {
    /// The name given by the user.
    name: PathBuf,
    to: Box<dyn Write>,
    /// What is written to a file, and where it will be.
    whole: Option<(Unfinished, PathBuf)>,
}

impl Target {
    /// This file, or the standard output if none is given or for `-`. It must not be the file `input`, where `-` stands for the standard input.
    ///
    /// # Errors
    /// [`Error::Input`] for a folder, a file in a folder that is not there, and the input itself; [`Error::File`].
    pub fn new(path: Option<&Path>, input: Option<&Path>) -> Result<Self> {
        let Some(path) = path.filter(|path| !is_standard_output(path)) else {
            return Ok(Self {
                name: "standard output".into(),
                to: Box::new(io::stdout()),
                whole: None,
            });
        };
        let refused = |told: &str| Err(Error::Input(format!("{}: {told}", path.display())));
        let ends_in_slash = path.to_string_lossy().ends_with(is_separator);
        if path.is_dir() || !path.exists() && (ends_in_slash || path.file_name().is_none()) {
            return refused("expected a file, this is a folder");
        }
        let is_input = |input: &Path| match input == Path::new("-") {
            true => are_one(path, Path::new("/dev/stdin")),
            false => are_one(path, input),
        };
        if path.is_file() && input.is_some_and(is_input) {
            return refused("this is the input file; the output needs another name");
        }
        let place = followed(path).map_err(Error::file(path))?;
        if !folder_of(&place).is_dir() {
            return refused("the folder of this file does not exist");
        }
        Self::begun(path, place).map_err(Error::file(path))
    }

    /// For the device or pipe of this name, or for a file whose name leads to `place`.
    fn begun(path: &Path, place: PathBuf) -> io::Result<Self> {
        let name = path.to_owned();
        // A file that may not be written must not be replaced either.
        let there = path
            .exists()
            .then(|| OpenOptions::new().write(true).open(path));
        let there = there.transpose()?;
        let (to, whole) = match there {
            Some(stream) if !path.is_file() => (stream, None),
            there => {
                let unfinished = Unfinished::within(folder_of(&place))?;
                let new = File::create(unfinished.new_one())?;
                if let Some(there) = there {
                    new.set_permissions(there.metadata()?.permissions())?;
                }
                (new, Some((unfinished, place)))
            }
        };
        let to = Box::new(to);
        Ok(Self { name, to, whole })
    }

    /// Writes these bytes.
    ///
    /// # Errors
    /// As for [`write`](Self::write).
    pub fn put(self, contents: impl AsRef<[u8]>) -> Result<()> {
        self.write(|to| to.write_all(contents.as_ref()))
    }

    /// Writes it.
    ///
    /// # Errors
    /// [`Error::File`]; [`Error::OutputClosed`] if the reader of a pipe has closed it.
    pub fn write(self, contents: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
        let mut to = BufWriter::with_capacity(1 << 16, self.to);
        let written = contents(&mut to).and_then(|()| to.flush());
        drop(to);
        let written = written.and_then(|()| match self.whole {
            Some((unfinished, place)) => unfinished.take(&place),
            None => Ok(()),
        });
        written.map_err(|error| match error.downcast::<Error>() {
            // The contents could not be computed.
            Ok(refused) => refused,
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Error::OutputClosed,
            Err(error) => Error::file(&self.name)(error),
        })
    }
}

/// Prints to standard output.
///
/// # Errors
/// As for [`Target::write`].
pub fn say(text: &str) -> Result<()> {
    Target::new(None, None)?.put(text)
}

/// Prints something beside a document: to standard error if the document is on standard output.
///
/// # Errors
/// As for [`say`].
pub fn say_beside(document: Option<&Path>, text: &str) -> Result<()> {
    if document.is_some_and(is_standard_output) {
        tell(text.trim_end());
        return Ok(());
    }
    say(text)
}

/// `1 figure`, `2 figures`.
pub fn several(count: usize, what: &str) -> String {
    let s = if count == 1 { "" } else { "s" };
    format!("{count} {what}{s}")
}

/// Whether a file of this name is the standard output, as it is for `-`.
pub fn is_standard_output(path: &Path) -> bool {
    path == Path::new("-") || are_one(path, Path::new("/dev/stdout"))
}

/// Prints a line to standard error. If that is closed as well, nothing can be done.
pub fn tell(line: impl Display) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// Writes a file, and the folder it is in, only if its bytes change. Returns whether they did.
///
/// # Errors
/// As for [`Target`].
pub fn write_if_changed(path: &Path, contents: &[u8]) -> Result<bool> {
    if path.is_file() && std::fs::read(path).is_ok_and(|old| old == contents) {
        return Ok(false);
    }
    let folder = folder_of(path);
    std::fs::create_dir_all(folder).map_err(Error::file(folder))?;
    Target::new(Some(path), None)?.put(contents)?;
    Ok(true)
}

/// Makes a folder and its parents: `written` fills it elsewhere, so that it appears whole or not at all.
///
/// # Errors
/// [`Error::File`]; those of `written`.
pub fn whole(folder: &Path, written: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
    let parent = folder_of(folder);
    std::fs::create_dir_all(parent).map_err(Error::file(parent))?;
    let beside = Unfinished::within(parent).map_err(Error::file(parent))?;
    written(&beside.new_one())?;
    beside.take(folder).map_err(Error::file(folder))
}

/// Checks that files can be written into this folder, which need not exist yet; the trial leaves no trace.
///
/// # Errors
/// [`Error::Input`] for what is no folder, or would be in one that is none; [`Error::File`].
pub fn can_be_written_into(folder: &Path) -> Result<()> {
    let there = folder.ancestors().find(|folder| folder.exists());
    let there = there.unwrap_or(Path::new("."));
    if !there.is_dir() {
        let (folder, there) = (folder.display(), there.display());
        let told = format!("{folder}: expected a folder, {there} is a file");
        return Err(Error::Input(told));
    }
    let tried = Unfinished::within(there);
    tried.map(drop).map_err(Error::file(folder))
}

/// The form whose ending the name of a file has; the first form if there is no name, or if it is that of a device or a pipe.
///
/// # Errors
/// [`Error::Input`] for a name with another ending; `what` names the output.
pub fn by_ending<T: ValueEnum>(path: Option<&Path>, what: &str, known: &[T]) -> Result<T> {
    let is_a_file = |path: &&Path| *path != Path::new("-") && (path.is_file() || !path.exists());
    let Some(file) = path.filter(is_a_file) else {
        return Ok(known[0].clone());
    };
    let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
    let found = known.iter().find(|one| extension == *ending(*one));
    found.cloned().ok_or_else(|| {
        let endings = known.iter().map(|one| format!("`.{}`", ending(one)));
        let (file, endings) = (file.display(), endings.collect::<Vec<_>>().join(" or "));
        let told = format!("{file}: the output is {what}, so its name must end with {endings}");
        Error::Input(told)
    })
}

/// How the name of a file of this form ends.
pub fn ending(form: &impl ValueEnum) -> String {
    let value = form.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// The folder that a path is in.
pub fn folder_of(path: &Path) -> &Path {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    folder.unwrap_or(Path::new("."))
}

/// The file to which symbolic links lead; it need not exist yet.
///
/// # Errors
/// If the links form a circle, or cannot be read.
pub fn followed(path: &Path) -> io::Result<PathBuf> {
    // Without the slash at its end, behind which no link is seen.
    let mut path: PathBuf = path.iter().collect();
    for _ in 0..40 {
        if !path.is_symlink() {
            return Ok(path);
        }
        path = folder_of(&path).join(std::fs::read_link(&path)?);
    }
    Err(io::Error::other("the symbolic links form a circle"))
}

/// Whether these names lead to one file, device or pipe.
#[cfg(unix)]
fn are_one(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |path: &Path| std::fs::metadata(path).map(|data| (data.dev(), data.ino()));
    place(a).is_ok_and(|a| place(b).is_ok_and(|b| a == b))
}

#[cfg(not(unix))]
fn are_one(a: &Path, b: &Path) -> bool {
    let place = std::fs::canonicalize;
    place(a).is_ok_and(|a| place(b).is_ok_and(|b| a == b))
}
