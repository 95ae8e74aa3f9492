//! The root of the workspace, and the files in a folder.

use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// The root of the workspace: the nearest folder upwards from the current one that holds `book/book.toml`;
/// failing that, the one this program was compiled in.
pub fn workspace_root() -> Result<PathBuf> {
    let compiled_in = Path::new(env!("CARGO_MANIFEST_DIR"));
    let here = std::env::current_dir().unwrap_or_default();
    let mut folders = here.ancestors().chain(compiled_in.ancestors());
    let root = folders.find(|folder| folder.join("book/book.toml").is_file());
    root.map(Path::to_owned).ok_or_else(|| {
        let here = here.display();
        Error::Input(format!(
            "no book/book.toml in {here} or above it: run this inside the repository"
        ))
    })
}

/// Every file in a folder and below, sorted by name; for a file, itself; an empty list if there is neither.
pub fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
    if !folder.is_dir() {
        return Ok(Vec::from_iter(folder.exists().then(|| folder.to_owned())));
    }
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(Error::file(folder))? {
        let path = entry.map_err(Error::file(folder))?.path();
        files.extend(files_below(&path)?);
    }
    files.sort();
    Ok(files)
}
