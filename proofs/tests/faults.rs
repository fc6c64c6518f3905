//! The faults can be planted: each text occurs once.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use twinedge_proofs::faults::{Fault, FaultError, parse, plant};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn all() -> Vec<Fault> {
    let mut files: Vec<_> = fs::read_dir(root().join("proofs/faults")).unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "txt"));
    files.sort();
    files.iter().flat_map(|file| parse(&fs::read_to_string(file).unwrap()).unwrap()).collect()
}

#[test]
fn every_fault_can_be_planted() {
    let faults = all();
    let named: BTreeSet<&str> = faults.iter().map(|fault| fault.what.as_str()).collect();
    assert_eq!(named.len(), faults.len(), "two faults have one name");
    let files: BTreeSet<&str> = faults.iter().map(|fault| fault.file.as_str()).collect();
    for file in files {
        let source = fs::read_to_string(root().join(file)).unwrap();
        let of_file: Vec<_> = faults.iter().enumerate().filter(|(_, fault)| fault.file == file).collect();
        let planted = plant(&source, &of_file).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!(planted.matches("crate::planted_fault(").count(), of_file.len(), "{file}");
    }
}

/// Both the text and its replacement are expressions: otherwise the planted sources do not compile.
#[test]
fn faults_are_expressions() {
    for Fault { what, text, wrong, .. } in all() {
        for text in [text, wrong] {
            let is_expression = syn::parse_str::<syn::Expr>(&text).is_ok();
            assert!(is_expression, "{what}: {text}");
        }
    }
}

/// Each check of the validator's rules and of a coverage's, each operator and the store has a fault.
#[test]
fn every_part_has_a_fault() {
    let faults = all();
    let listed = |folder: &str| {
        let entries = fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap());
        let files = entries.filter(|entry| entry.path().is_file());
        files.map(|file| format!("{folder}/{}", file.file_name().to_str().unwrap())).collect::<Vec<_>>()
    };
    // Files that check nothing themselves.
    let without = [
        "adapt/mod.rs",
        "corner.rs",
        "near/mod.rs",
        "coverage/src/lib.rs",
        "coverage/src/finding.rs",
        "region.rs",
        "coverage/src/check.rs",
        "layers/mod.rs",
    ];
    let folders = ["fast_path", "rules", "adapt"].map(|folder| format!("src/validate/{folder}"));
    for folder in folders.iter().map(String::as_str).chain([
        "src/dcel/operators",
        "src/validate/near",
        "crates/map/src/near",
        "crates/coverage/src",
        "crates/coverage/src/layers",
    ]) {
        for file in listed(folder) {
            let is_wanted = !without.iter().any(|name| file.ends_with(name));
            assert_eq!(faults.iter().any(|fault| fault.file == file), is_wanted, "{file}");
        }
    }
}

#[test]
fn what_cannot_be_planted_is_an_error() {
    let fault = "fault  a\nfile   f\ntext   x == y\nwrong  true\n";
    let read = parse(&format!("# comment\n\n{fault}")).unwrap();
    assert_eq!(read[0].place("if x == y {"), Ok(3));
    for (source, found) in [("if x != y {", 0), ("x == y && x == y", 2)] {
        assert_eq!(read[0].place(source), Err(FaultError::Stale { what: "a".to_owned(), found }));
    }
    let in_line = parse(&format!("{fault}in     x == y && z\n")).unwrap();
    assert_eq!(in_line[0].place("x == y; x == y && z"), Ok(8));
    let other = parse("fault  b\nfile   f\ntext   y {\nwrong  z {\n").unwrap();
    let both = [(0, &read[0]), (1, &other[0])];
    assert_eq!(plant("if x == y {", &both), Err(FaultError::Overlap("b".to_owned())));
    let twice = [(0, &read[0]), (1, &read[0])];
    let planted = "if (if crate::planted_fault(0) { true } else if crate::planted_fault(1) { true } else { x == y }) {";
    assert_eq!(plant("if x == y {", &twice), Ok(planted.to_owned()));
    assert!(matches!(parse("falt  a\n"), Err(FaultError::Line(_))));
    assert!(matches!(parse("fault  a\nfile   f\n"), Err(FaultError::Incomplete(_))));
}
