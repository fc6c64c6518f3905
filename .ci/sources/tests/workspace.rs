//! The sources of this workspace.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use twinedge_sources::{Crate, Imports, crates, imports, let_chains, missing_paths, questions, upward};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders up").to_path_buf()
}

/// Of the workspace, of the library for C, of the fuzz targets, of the Python module, of that for JavaScript and of the audit of other structures, with paths from the root.
static IMPORTS: LazyLock<Imports> = LazyLock::new(|| {
    let root = root();
    let mut all: Vec<Crate> = Vec::new();
    for manifest in [
        "Cargo.toml",
        "capi/Cargo.toml",
        "fuzz/Cargo.toml",
        "python/Cargo.toml",
        "tests/peers/Cargo.toml",
        "web/Cargo.toml",
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

/// The files below a folder with one of these extensions, with their texts, but for those that are built or fetched.
fn sources(folder: &Path, extensions: &[&str]) -> Vec<(PathBuf, String)> {
    let mut waiting = vec![folder.to_path_buf()];
    let mut found = Vec::new();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            let entries = std::fs::read_dir(&path).expect("the folder can be read");
            let paths = entries.map(|entry| entry.expect("the folder can be read").path());
            waiting.extend(
                paths.filter(|path| {
                    !["target", "node_modules", "build", ".git"].iter().any(|name| path.ends_with(name))
                }),
            );
        } else if path.extension().is_some_and(|found| extensions.iter().any(|extension| found == *extension)) {
            let text = std::fs::read_to_string(&path).expect("the file can be read");
            found.push((path, text));
        }
    }
    found
}

#[test]
fn every_path_of_the_guide_for_contributors_exists() {
    let root = root();
    let page = std::fs::read_to_string(root.join("CONTRIBUTING.md")).expect("the file can be read");
    let missing = missing_paths(&page, |path| root.join(path).exists());
    assert!(missing.is_empty(), "paths of CONTRIBUTING.md that are not there: {missing:#?}");
}

#[test]
fn the_library_and_its_columns_have_no_let_chains() {
    let files = ["src", "columns/src"].map(|folder| sources(&root().join(folder), &["rs"])).concat();
    assert!(files.len() > 100, "only {} files were found", files.len());
    let mut found = String::new();
    for (path, text) in files {
        for line in let_chains(&text).expect("every source is Rust") {
            let _ = writeln!(found, "{}:{line}", path.display());
        }
    }
    assert!(found.is_empty(), "Rust before 1.88 does not know these:\n{found}");
}

#[test]
fn no_comment_begins_with_a_question_word() {
    let files = sources(&root(), &["rs", "js", "mjs", "ts", "py", "v", "ml", "toml", "sh"]);
    assert!(files.len() > 900, "only {} files were found", files.len());
    let mut found = String::new();
    for (path, text) in files {
        for line in questions(&text) {
            let _ = writeln!(found, "  {}:{line}", path.display());
        }
    }
    assert!(found.is_empty(), "comments begin with What, Which, How, Where or Whether:\n{found}");
}
