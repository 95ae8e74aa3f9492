//! The errors of the press, and their exit statuses.

use std::path::{Path, PathBuf};

use spinning_bodies::scene::{UnknownColumn, files::Mistakes};

/// An error, reported in one line; for a scene file in one line for each mistake.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The command line or a source of the book is wrong: exit status 2.
    #[error("{}", one_line(.0))]
    Input(String),
    /// A scene file is wrong, a line for each mistake: exit status 2.
    #[error(transparent)]
    Scene(#[from] Mistakes),
    /// An unknown column is asked for: exit status 2.
    #[error(transparent)]
    Column(#[from] UnknownColumn),
    /// A file could not be read or written: exit status 1.
    #[error("{}", one_line(&format!("{}: {}", .0.display(), .1)))]
    File(PathBuf, #[source] std::io::Error),
    /// Anything else: exit status 1.
    #[error("{}", one_line(.0))]
    Failed(String),
    /// The reader of our output has closed it. Not a failure: exit status 0.
    #[error("the output was closed")]
    OutputClosed,
}

/// The result of anything the press does.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// Wraps a system error with the file it is about.
    pub fn file(path: &Path) -> impl FnOnce(std::io::Error) -> Error + '_ {
        |source| Error::File(path.to_owned(), source)
    }

    /// The exit status that reports this error.
    pub fn status(&self) -> u8 {
        match self {
            Error::Input(_) | Error::Scene(_) | Error::Column(_) => 2,
            Error::File(..) | Error::Failed(_) => 1,
            Error::OutputClosed => 0,
        }
    }
}

/// The words of a message on a single line, without anything that a terminal would obey.
pub fn one_line(message: &str) -> String {
    let told = message.replace(char::is_control, " ");
    told.split_whitespace().collect::<Vec<_>>().join(" ")
}
