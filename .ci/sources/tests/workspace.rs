//! The sources of this workspace.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use twinedge_sources::{Crate, Imports, crates, imports, missing_paths, upward};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders up").to_path_buf()
}

/// Of the workspace, of the library for C, of the fuzz targets, of the Python module, of that for JavaScript and of the audit of other structures, with paths from the root.
static IMPORTS: LazyLock<Imports> = LazyLock::new(|| {
    let root = root();
    let mut all: Vec<Crate> = Vec::new();
    for manifest in [
        "Cargo.toml",
        "bindings/c/Cargo.toml",
        "fuzz/Cargo.toml",
        "bindings/python/Cargo.toml",
        "extras/peers/Cargo.toml",
        "bindings/web/Cargo.toml",
    ] {
        all.extend(crates(&root.join(manifest)).expect("Cargo lists the crates"));
    }
    for each in &mut all {
        each.root = each.root.strip_prefix(&root).expect("inside the workspace").to_path_buf();
    }
    assert!(all.iter().any(|each| each.name == "twinedge" && each.is_library), "{all:?}");
    imports(&all, |path| std::fs::read_to_string(root.join(path)).ok()).expect("every source is Rust")
});

#[test]
fn no_files_import_each_other_in_a_loop() {
    let loops = IMPORTS.loops();
    let report = loops.iter().fold(String::new(), |mut report, each| {
        let _ = write!(report, "{each}");
        report
    });
    assert!(loops.is_empty(), "{} loops:\n{report}", loops.len());
}

#[test]
fn no_import_runs_against_the_layers() {
    let from_library = IMPORTS.iter().filter(|import| import.from.starts_with("src")).count();
    assert!(from_library > 300, "only {from_library} imports were found in the library");
    let upward = upward(&IMPORTS, Path::new("src"));
    let report = upward.iter().fold(String::new(), |mut report, each| {
        let _ = writeln!(report, "{each}");
        report
    });
    assert!(upward.is_empty(), "{} imports run against the layers:\n{report}", upward.len());
}

#[test]
fn every_path_of_the_guide_for_contributors_exists() {
    let root = root();
    let page = std::fs::read_to_string(root.join("CONTRIBUTING.md")).expect("the file can be read");
    let missing = missing_paths(&page, |path| root.join(path).exists());
    assert!(missing.is_empty(), "paths of CONTRIBUTING.md that are not there: {missing:#?}");
}
