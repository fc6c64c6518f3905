//! `coq/README.md` has a row for every Rust file, and every file that it names exists.

use std::collections::BTreeMap;
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

/// Returns the names in the first cells of each table, by the folder in its head.
fn tables(text: &str) -> BTreeMap<String, Vec<String>> {
    let (mut tables, mut folder): (BTreeMap<String, Vec<String>>, _) = (BTreeMap::new(), String::new());
    for line in text.lines().skip_while(|line| *line != "## File by file") {
        let cell = line.split('|').nth(1).unwrap_or_default();
        let mut names = cell.split('`').skip(1).step_by(2).map(str::to_owned);
        if cell.trim_start().starts_with("files") {
            folder = names.next().map(|name| name + "/").unwrap_or_default();
        } else {
            let names = names.map(|name| format!("{folder}{name}"));
            tables.entry(folder.clone()).or_default().extend(names);
        }
    }
    tables
}

#[test]
fn each_file_has_a_row_and_each_name_a_file() {
    let mut files = Vec::new();
    add_files(Path::new(ROOT), &mut files);
    let tables = tables(&fs::read_to_string(Path::new(ROOT).join("proofs/coq/README.md")).unwrap());
    assert_eq!(tables.keys().collect::<Vec<_>>(), ["", "src/dcel/", "src/validate/"]);
    let mut unused: Vec<&String> = tables.values().flatten().collect();
    unused.sort();
    assert!(unused.windows(2).all(|two| two[0] != two[1]), "a name is in two rows");
    for file in files {
        // In the table of the innermost folder, the row with the longest matching name.
        let (_, rows) = tables.iter().rfind(|(folder, _)| file.starts_with(folder.as_str())).unwrap();
        let fitting = rows.iter().filter(|row| **row == file || row.ends_with('/') && file.starts_with(row.as_str()));
        let row = fitting.max_by_key(|row| row.len()).unwrap_or_else(|| panic!("{file}.rs is in no row"));
        unused.retain(|name| *name != row);
    }
    assert!(unused.is_empty(), "no file is left for {unused:?}");
}
