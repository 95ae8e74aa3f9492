//! The live pages: the parameters of a figure as its page gets them, and the module that redraws it when they change.

use crate::writer::write_if_changed;
use crate::{Error, Result, drawings};
use base64::prelude::{BASE64_STANDARD, Engine};
use figures::{Entry, Values};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";

/// The parameters of a figure as its page reads them, in JSON; for one that can be dragged, with the position of its point, units of the design.
pub fn parameters(entry: &Entry) -> Value {
    let each = entry.parameters.iter().map(|parameter| {
        let mut told = drawings::parameter(parameter);
        if let Some(place) = parameter.handle {
            told["place"] = json!(place(&Values::default()));
        }
        told
    });
    each.collect()
}

/// Builds the module and writes it where the book keeps it, as a script, the only thing that a page opened from disk may load. Returns
/// its path, and the number of bytes of the module.
///
/// # Errors
/// [`Error::Failed`] if cargo cannot build it, and has said why; those of writing.
pub fn build(root: &Path) -> Result<(PathBuf, usize)> {
    let target = root.join("target");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let how = "build --locked --package live --profile live --target";
    let status = Command::new(cargo)
        .current_dir(root)
        .args(how.split(' '))
        .args([TARGET, "--target-dir"])
        .arg(&target)
        // A panic names the path of its source: it should be that within the crate, not on this machine.
        .env("CARGO_ENCODED_RUSTFLAGS", remapped().join("\x1f"))
        .status();
    let status = status.map_err(|error| Error::Failed(format!("cargo: {error}")))?;
    if !status.success() {
        let cure = format!("`rustup target add {TARGET}` installs what it may lack");
        return Err(Error::Failed(format!("cargo built no module: {cure}")));
    }
    let built = target.join(TARGET).join("live/live.wasm");
    let module = std::fs::read(&built).map_err(Error::file(&built))?;
    let letters = BASE64_STANDARD.encode(&module);
    let script = format!("window.liveModule = '{letters}';\n");
    let committed = root.join("book/src/assets/live-module.js");
    write_if_changed(&committed, script.as_bytes())?;
    Ok((committed, module.len()))
}

/// Flags that remove the folders of this machine from the paths of sources.
fn remapped() -> Vec<String> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let registries = home.and_then(|home| std::fs::read_dir(home.join("registry/src")).ok());
    let folders = registries.into_iter().flatten().flatten();
    let flag = |path: PathBuf| format!("--remap-path-prefix={}=crates", path.display());
    folders.map(|folder| flag(folder.path())).collect()
}
