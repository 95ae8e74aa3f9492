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

/// Writes a file whole or not at all, and only if its bytes change. Returns whether they did.
pub fn write_if_changed(path: &Path, contents: &[u8]) -> Result<bool> {
    if std::fs::read(path).is_ok_and(|old| old == contents) {
        return Ok(false);
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(Error::file(folder))?;
    let mut beside = tempfile::Builder::new()
        .prefix(".new-")
        .tempfile_in(folder)
        .map_err(Error::file(folder))?;
    std::io::Write::write_all(&mut beside, contents).map_err(Error::file(path))?;
    readable_by_all(beside.path()).map_err(Error::file(path))?;
    beside
        .persist(path)
        .map_err(|failed| Error::file(path)(failed.error))?;
    Ok(true)
}

/// Temporary files and folders are private to their owner; printed ones are not.
#[cfg(unix)]
pub(crate) fn readable_by_all(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let mode = if path.is_dir() { 0o755 } else { 0o644 };
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
pub(crate) fn readable_by_all(_: &Path) -> std::io::Result<()> {
    Ok(())
}
