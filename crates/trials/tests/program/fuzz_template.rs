//! `fuzz-template`. `fuzz/tests/template.rs` tests that its project builds and finds a bug.

use super::{scratch_folder, trials};
use std::fs;
use std::path::{Path, PathBuf};

/// A folder of this test, with a package in it.
fn package(name: &str, manifest: &str) -> PathBuf {
    let folder = scratch_folder(name);
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    folder
}

fn said(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn the_target_is_written_for_the_package_around_it() {
    let folder = package(
        "mesh",
        "[workspace]\n\n[package]\nversion = \"1.0.0\"\nname = \"my-mesh\" # mine\n\n[[bin]]\nname = \"x\"\n",
    );
    let fuzz = folder.join("fuzz");
    let output = trials(&["fuzz-template", fuzz.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output.stderr));
    let text = said(&output.stdout);
    assert!(
        text.contains("in the place of `todo!(\"your structure\")`") && text.contains("fuzz run --fuzz-dir"),
        "{text}"
    );

    let manifest = fs::read_to_string(fuzz.join("Cargo.toml")).unwrap();
    assert!(manifest.contains("name = \"my-mesh-fuzz\"\n") && manifest.contains("my-mesh = { path = \"..\" }\n"));
    // The library is not in the registry.
    let line = manifest.lines().find(|line| line.starts_with("twinedge = ")).unwrap();
    let library = line.strip_prefix("twinedge = { path = \"").and_then(|rest| rest.split('"').next()).unwrap();
    let of_library = fs::read_to_string(Path::new(library).join("Cargo.toml")).unwrap();
    assert!(of_library.contains("\nname = \"twinedge\"\n"), "{line}");
    let target = fs::read_to_string(fuzz.join("fuzz_targets/conforms.rs")).unwrap();
    assert!(target.contains("asked.run_and_shrink(&program, || todo!(\"your structure\"))"), "{target}");
    assert!(
        ![&manifest, &target].iter().any(|text| ["{package}", "{path}", "{twinedge}", "{crate}", "{subject}"]
            .iter()
            .any(|place| text.contains(place))),
        "every place is filled"
    );
    assert!(fs::read_dir(fuzz.join("corpus/conforms")).unwrap().count() > 10);

    let again = trials(&["fuzz-template", fuzz.to_str().unwrap()]);
    assert_eq!(again.status.code(), Some(2));
    assert!(said(&again.stderr).contains("exists already"));
    assert_eq!(fs::read_to_string(fuzz.join("fuzz_targets/conforms.rs")).unwrap(), target);
}

#[test]
fn a_subject_leaves_nothing_to_be_replaced() {
    let folder = package("subject", "[package]\nname = \"mesh\"\n");
    let fuzz = folder.join("fuzz");
    let output = trials(&["fuzz-template", fuzz.to_str().unwrap(), "--subject", "mesh::Dcel::empty()"]);
    assert!(!said(&output.stdout).contains("in the place of"));
    let target = fs::read_to_string(fuzz.join("fuzz_targets/conforms.rs")).unwrap();
    assert!(target.contains("asked.run_and_shrink(&program, || mesh::Dcel::empty())"), "{target}");
}

#[test]
fn without_a_package_nothing_is_written() {
    let folder = package("virtual", "[workspace]\nmembers = []\n");
    for (fuzz, message) in [(folder.join("fuzz"), "names no package"), (folder.join("none/fuzz"), "Cargo.toml: ")] {
        let output = trials(&["fuzz-template", fuzz.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output.stderr).contains(message), "{}", said(&output.stderr));
        assert!(!fuzz.exists());
    }
}
