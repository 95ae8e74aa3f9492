//! Where the workspace is.

use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// The root of the workspace: the nearest folder upwards from the current one that holds `book/book.toml`;
/// failing that, the one this program was compiled in.
pub fn workspace_root() -> Result<PathBuf> {
    let compiled_in = Path::new(env!("CARGO_MANIFEST_DIR"));
    let here = std::env::current_dir().unwrap_or_default();
    here.ancestors()
        .chain(compiled_in.ancestors())
        .find(|folder| folder.join("book/book.toml").is_file())
        .map(Path::to_owned)
        .ok_or_else(|| {
            Error::Input(format!(
                "no book/book.toml in {} or above it: run this inside the repository",
                here.display()
            ))
        })
}
