//! The crates of a workspace, as Cargo lists them.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// A crate whose sources are read.
#[derive(Clone, Debug)]
pub struct Crate {
    /// The name by which other crates import it.
    pub name: String,
    /// Its root file.
    pub root: PathBuf,
    /// True if other crates can import it.
    pub is_library: bool,
}

/// Every library, program, test, benchmark and example of the workspace with this manifest, with paths from its folder.
///
/// # Errors
/// If Cargo cannot be run, or refuses the manifest.
pub fn crates(manifest: &Path) -> Result<Vec<Crate>, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["metadata", "--no-deps", "--offline", "--format-version", "1", "--manifest-path"])
        .arg(manifest)
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let text = String::from_utf8_lossy(&output.stdout);
    crates_of(&text).ok_or_else(|| "cargo metadata has another form than expected".to_owned())
}

/// The crates in the output of `cargo metadata`, or nothing if it has another form.
#[must_use]
pub fn crates_of(metadata: &str) -> Option<Vec<Crate>> {
    let metadata: Value = serde_json::from_str(metadata).ok()?;
    let mut crates = Vec::new();
    for package in metadata["packages"].as_array()? {
        for target in package["targets"].as_array()? {
            let kinds = target["kind"].as_array()?;
            crates.push(Crate {
                name: target["name"].as_str()?.replace('-', "_"),
                root: target["src_path"].as_str()?.into(),
                is_library: kinds.iter().any(|kind| kind == "lib"),
            });
        }
    }
    Some(crates)
}
