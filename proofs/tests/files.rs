//! `files.tsv` has a row for every Rust file, and every file that it names exists.

use std::fs;
use std::path::Path;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Collects the Rust files in a folder, without `.rs`, except Cargo's own.
fn add_files(folder: &Path, files: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_name().unwrap().to_str().unwrap();
        if entry.is_dir() && !["target", "node_modules", ".git"].contains(&name) && !entry.is_symlink() {
            add_files(&entry, files);
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            files.push(entry.strip_prefix(ROOT).unwrap().with_extension("").to_str().unwrap().to_owned());
        }
    }
}

#[test]
fn each_file_has_a_row_and_each_name_a_file() {
    let mut files = Vec::new();
    add_files(Path::new(ROOT), &mut files);
    let table = fs::read_to_string(Path::new(ROOT).join("proofs/files.tsv")).unwrap();
    let rows = table.lines().skip(1).map(|row| row.split('\t').next().unwrap());
    let mut names: Vec<&str> = rows.flat_map(|names| names.split(' ')).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|two| two[0] != two[1]), "a name is in two rows");
    let mut unused = names.clone();
    for file in files {
        let fits = |name: &&&str| **name == file || name.ends_with('/') && file.starts_with(**name);
        // The longest name decides.
        let name = names.iter().filter(fits).max_by_key(|name| name.len());
        let name = name.unwrap_or_else(|| panic!("{file}.rs is in no row"));
        unused.retain(|other| other != name);
    }
    assert!(unused.is_empty(), "no file is left for {unused:?}");
}
