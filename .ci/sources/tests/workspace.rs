//! The sources of this workspace.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use twinedge_sources::{Crate, Imports, Openings, crates, imports, let_chains, missing_paths, openings, upward};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("two folders up").to_path_buf()
}

/// Of the workspace, of the library for C, of the fuzz targets, of the Python module, of that for JavaScript and of the audit of other structures, with paths from the root.
fn all_imports() -> Imports {
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
}

#[test]
fn no_files_import_each_other_in_a_loop() {
    let loops = all_imports().loops();
    let report = loops.iter().fold(String::new(), |mut report, each| {
        let _ = write!(report, "{each}");
        report
    });
    assert!(loops.is_empty(), "{} loops:\n{report}", loops.len());
}

#[test]
fn no_import_runs_against_the_layers() {
    let imports = all_imports();
    let from_library = imports.iter().filter(|import| import.from.starts_with("src")).count();
    assert!(from_library > 300, "only {from_library} imports were found in the library");
    let upward = upward(&imports, Path::new("src"));
    let report = upward.iter().fold(String::new(), |mut report, each| {
        let _ = writeln!(report, "{each}");
        report
    });
    assert!(upward.is_empty(), "{} imports run against the layers:\n{report}", upward.len());
}

/// The sources below a folder, with their texts, but for what is built or fetched.
fn sources(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut waiting = vec![folder.to_path_buf()];
    let mut found = Vec::new();
    while let Some(path) = waiting.pop() {
        if path.is_dir() {
            let entries = std::fs::read_dir(&path).expect("the folder can be read");
            let paths = entries.map(|entry| entry.expect("the folder can be read").path());
            waiting.extend(
                paths.filter(|path| !["target", "node_modules", ".git"].iter().any(|name| path.ends_with(name))),
            );
        } else if path.extension().is_some_and(|extension| extension == "rs") {
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
    let files = ["src", "columns/src"].map(|folder| sources(&root().join(folder))).concat();
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
fn at_most_two_comments_in_a_hundred_begin_with_a_question_word() {
    let folders =
        std::fs::read_dir(root()).expect("the folder can be read").map(|entry| entry.expect("an entry").path());
    let mut found = String::new();
    for folder in folders.filter(|path| path.is_dir() && !["target", ".git"].iter().any(|name| path.ends_with(name))) {
        let (mut comments, mut questions) = (0, String::new());
        let mut count = 0;
        for (path, text) in sources(&folder) {
            let Openings { comments: more, questions: lines } = openings(&text);
            comments += more;
            count += lines.len();
            for line in lines {
                let _ = writeln!(questions, "  {}:{line}", path.display());
            }
        }
        if count * 50 > comments {
            let _ = writeln!(found, "{}: {count} of {comments}\n{questions}", folder.display());
        }
    }
    assert!(found.is_empty(), "too many comments begin with What, Which, How, Where or Whether:\n{found}");
}
