//! Loops and upward imports that were planted are found, and nothing else is.

use std::path::Path;

use twinedge_sources::{Crate, Imports, LAYERS, Unreadable, crates, crates_of, imports, missing_paths, upward};

/// The imports of one library, `src/lib.rs` and these files.
fn of(files: &[(&str, &str)]) -> Imports {
    try_of(files).unwrap_or_else(|error| panic!("{error}"))
}

fn try_of(files: &[(&str, &str)]) -> Result<Imports, Unreadable> {
    let library = Crate { name: "lib".to_owned(), root: "src/lib.rs".into(), is_library: true };
    let read = |path: &Path| files.iter().find(|(name, _)| Path::new(name) == path).map(|(_, text)| (*text).to_owned());
    imports(&[library], read)
}

#[track_caller]
fn assert_loop(files: &[(&str, &str)], expected: &[&str]) {
    let loops = of(files).loops();
    assert_eq!(loops.len(), 1, "{loops:?}");
    let found: Vec<String> = loops[0].imports.iter().map(ToString::to_string).collect();
    assert_eq!(found, expected);
}

#[track_caller]
fn assert_no_loop(files: &[(&str, &str)]) {
    let loops = of(files).loops();
    assert!(loops.is_empty(), "{}", loops[0]);
}

#[test]
fn two_files_that_import_each_other() {
    assert_loop(
        &[
            ("src/lib.rs", "mod a; mod b;"),
            ("src/a.rs", "\nuse crate::b::B;\npub struct A;"),
            ("src/b.rs", "pub struct B(crate::a::A);"),
        ],
        &["src/a.rs:2 imports B from src/b.rs", "src/b.rs:1 imports A from src/a.rs"],
    );
}

#[test]
fn three_files_in_a_ring_and_one_beside_it() {
    let imports = of(&[
        ("src/lib.rs", "mod a; mod b; mod c; mod beside;"),
        ("src/a.rs", "use crate::{b::B, beside::Beside}; pub struct A;"),
        ("src/b.rs", "use super::c::C; pub struct B;"),
        ("src/c.rs", "use crate::a as first; pub struct C; fn c() -> first::A { first::A }"),
        ("src/beside.rs", "pub struct Beside;"),
    ]);
    let loops = imports.loops();
    assert_eq!(loops.len(), 1);
    assert_eq!(loops[0].files, ["src/a.rs", "src/b.rs", "src/c.rs"].map(Path::new));
    assert_eq!(loops[0].imports.len(), 3);
    assert!(loops[0].to_string().starts_with("3 files import each other:\n  src/a.rs:1 imports B from src/b.rs\n"));
}

#[test]
fn two_loops_are_two() {
    let imports = of(&[
        ("src/lib.rs", "mod a; mod b; mod c; mod d;"),
        ("src/a.rs", "use crate::b::B; pub struct A;"),
        ("src/b.rs", "use crate::{a::A, c::C}; pub struct B;"),
        ("src/c.rs", "use crate::d::D; pub struct C;"),
        ("src/d.rs", "use crate::c::C; pub struct D;"),
    ]);
    assert_eq!(imports.loops().len(), 2);
}

#[test]
fn a_name_that_is_exported_again_comes_from_the_file_that_defines_it() {
    assert_loop(
        &[
            ("src/lib.rs", "mod m;"),
            ("src/m/mod.rs", "mod a; mod b; pub use a::A as Renamed; pub(crate) use b::B;"),
            ("src/m/a.rs", "use super::B; pub struct A;"),
            ("src/m/b.rs", "use crate::m::Renamed; pub struct B;"),
        ],
        &["src/m/a.rs:1 imports B from src/m/b.rs", "src/m/b.rs:1 imports A from src/m/a.rs"],
    );
}

#[test]
fn what_mod_rs_itself_defines_comes_from_mod_rs() {
    assert_loop(
        &[
            ("src/lib.rs", "pub mod m;"),
            ("src/m/mod.rs", "mod a; pub use a::A; pub struct Whole { part: A }"),
            ("src/m/a.rs", "use super::Whole; pub struct A;"),
        ],
        &["src/m/a.rs:1 imports Whole from src/m/mod.rs", "src/m/mod.rs:1 imports A from src/m/a.rs"],
    );
}

#[test]
fn a_private_use_in_mod_rs_is_an_import_even_if_only_its_methods_are_used() {
    assert_loop(
        &[
            ("src/lib.rs", "pub mod m;"),
            ("src/m/mod.rs", "mod a; use a::Walk as _; pub struct Whole;"),
            ("src/m/a.rs", "pub trait Walk {} impl Walk for super::Whole {}"),
        ],
        &["src/m/a.rs:1 imports Whole from src/m/mod.rs", "src/m/mod.rs:1 imports Walk from src/m/a.rs"],
    );
}

#[test]
fn a_loop_through_a_glob() {
    assert_loop(
        &[
            ("src/lib.rs", "pub mod m;"),
            ("src/m.rs", "mod a; pub use a::*; pub fn whole() -> A { A }"),
            ("src/m/a.rs", "use super::*; pub struct A; fn a() { whole(); }"),
        ],
        &["src/m/a.rs:1 imports whole from src/m.rs", "src/m.rs:1 imports A from src/m/a.rs"],
    );
}

#[test]
fn a_loop_through_the_arguments_of_a_macro_and_a_use_inside_a_function() {
    assert_loop(
        &[
            ("src/lib.rs", "mod a; mod b;"),
            ("src/a.rs", "pub fn a() { assert_eq!(crate::b::b(), 1); }"),
            ("src/b.rs", "pub fn b() -> u8 { use crate::{a::{a, self}, b}; 1 }"),
        ],
        &["src/a.rs:1 imports b from src/b.rs", "src/b.rs:1 imports a from src/a.rs"],
    );
}

#[test]
fn a_loop_through_the_body_of_a_macro_and_through_what_a_macro_defines() {
    assert_loop(
        &[
            ("src/lib.rs", "mod a; mod b;"),
            ("src/a.rs", "macro_rules! key { ($name:ident) => { pub struct $name($crate::b::B); } } key!(Key);"),
            ("src/b.rs", "use crate::a::Key; pub struct B;"),
        ],
        &["src/a.rs:1 imports B from src/b.rs", "src/b.rs:1 imports Key from src/a.rs"],
    );
}

#[test]
fn a_loop_through_an_inline_module_and_a_path_attribute() {
    assert_loop(
        &[
            ("src/lib.rs", "#[path = \"../shared/a.rs\"] mod first; mod b;"),
            ("shared/a.rs", "mod inner { use crate::b::B; pub struct In; } pub use inner::In; mod deep;"),
            ("shared/deep.rs", ""),
            ("src/b.rs", "mod c { fn f(_: super::super::first::In) {} } pub struct B;"),
        ],
        &["shared/a.rs:1 imports B from src/b.rs", "src/b.rs:1 imports In from shared/a.rs"],
    );
}

#[test]
fn an_exported_macro_comes_from_its_own_file() {
    assert_loop(
        &[
            ("src/lib.rs", "mod a; mod b; pub struct Root;"),
            ("src/a.rs", "#[macro_export] macro_rules! go { () => { $crate::go!() } } pub fn a() { crate::b::b(); }"),
            ("src/b.rs", "pub fn b() { crate::go!(); }"),
        ],
        &["src/a.rs:1 imports b from src/b.rs", "src/b.rs:1 imports go from src/a.rs"],
    );
}

#[test]
fn a_variant_a_constant_and_a_function_of_a_type_come_from_the_file_of_the_type() {
    let imports = of(&[
        ("src/lib.rs", "mod a; mod b;"),
        ("src/a.rs", "use crate::b::Kind; fn f() { Kind::One; crate::b::Kind::new(); }"),
        ("src/b.rs", "pub enum Kind { One }"),
    ]);
    let found: Vec<String> = imports.iter().map(|import| import.to_string()).collect();
    assert_eq!(found, ["src/a.rs:1 imports Kind from src/b.rs"]);
}

#[test]
fn a_module_and_a_function_of_one_name_are_told_apart() {
    assert_no_loop(&[
        ("src/lib.rs", "pub mod m;"),
        ("src/m/mod.rs", "pub mod walk; mod user; pub use walk::walk;"),
        ("src/m/walk.rs", "pub fn walk() {} pub struct Walker;"),
        ("src/m/user.rs", "use super::walk; fn f() { walk(); walk::Walker; }"),
    ]);
    assert_no_loop(&[
        ("src/lib.rs", "pub mod m;"),
        ("src/m/mod.rs", "mod judge; mod outcome; use judge::Judge; fn outcome(_: Judge) {}"),
        ("src/m/judge.rs", "use super::outcome::Outcome; pub struct Judge(Outcome);"),
        ("src/m/outcome.rs", "pub struct Outcome;"),
    ]);
}

#[test]
fn what_is_no_import_makes_no_loop() {
    assert_no_loop(&[
        ("src/lib.rs", "pub mod m; pub use m::A;"),
        // A re-export, a declaration, documentation, text, fields, methods and variables.
        (
            "src/m/mod.rs",
            "//! See [`a::A`].\nmod a; pub use a::{A, helper};\n/// [`A`]\npub struct Whole { a: u8 }\n\
             fn f(whole: &Whole) { let helper = whole.a; whole.helper(); whole.a(\"A\"); let _ = helper; }",
        ),
        ("src/m/a.rs", "use super::Whole; pub struct A; pub fn helper() {}"),
    ]);
}

#[test]
fn an_import_from_another_crate_is_followed_to_the_file() {
    let library = Crate { name: "lib".to_owned(), root: "src/lib.rs".into(), is_library: true };
    let program = Crate { name: "lib".to_owned(), root: "src/main.rs".into(), is_library: false };
    let read = |path: &Path| {
        let text = match path.to_str()? {
            "src/lib.rs" => "mod a; pub use a::A;",
            "src/a.rs" => "pub struct A;",
            "src/main.rs" => "use lib::A; fn main() { ::lib::A; std::fmt::Display; }",
            _ => return None,
        };
        Some(text.to_owned())
    };
    let found: Vec<String> =
        imports(&[library, program], read).unwrap().iter().map(|import| import.to_string()).collect();
    assert_eq!(found, ["src/main.rs:1 imports A from src/a.rs"]);
}

/// One file per layer, and these; what runs against the layers.
fn layered(more: &[(&str, &str)]) -> Vec<String> {
    let mut files = Vec::new();
    let mut root = Vec::new();
    for (layer, _) in LAYERS {
        root.push(format!("pub mod {layer};"));
        let file = format!("src/{layer}/mod.rs");
        if !more.iter().any(|(name, _)| **name == file) {
            files.push((file, "pub struct Thing;".to_owned()));
        }
    }
    files.extend(more.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())));
    files.push(("src/lib.rs".to_owned(), root.concat()));
    let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (&**name, &**text)).collect();
    upward(&of(&files), Path::new("src")).iter().map(ToString::to_string).collect()
}

#[test]
fn every_import_that_the_layers_do_not_allow_is_found_and_no_other() {
    for (from, allowed) in LAYERS {
        for (to, _) in LAYERS.iter().filter(|(to, _)| to != from) {
            let file = format!("src/{from}/mod.rs");
            let found = layered(&[(&file, &format!("use crate::{to}::Thing as _; pub struct Thing;"))]);
            if allowed.contains(to) {
                assert!(found.is_empty(), "{found:?}");
            } else {
                let import = format!("src/{from}/mod.rs:1 imports Thing from src/{to}/mod.rs");
                assert_eq!(found, [format!("{from} may not import {to}: {import}")]);
            }
        }
    }
}

#[test]
fn the_layers_have_no_loop_themselves() {
    let mut known: Vec<&str> = Vec::new();
    while known.len() < LAYERS.len() {
        let next = LAYERS
            .iter()
            .find(|(layer, allowed)| !known.contains(layer) && allowed.iter().all(|below| known.contains(below)));
        known.push(next.unwrap_or_else(|| panic!("after {known:?}, no layer builds on these alone")).0);
    }
}

#[test]
fn a_file_of_no_layer_is_found_from_either_side() {
    let found = |code: &str, other: &str| -> Vec<String> {
        let imports = of(&[("src/lib.rs", "mod dcel; mod other;"), ("src/dcel.rs", code), ("src/other.rs", other)]);
        upward(&imports, Path::new("src")).iter().map(ToString::to_string).collect()
    };
    assert_eq!(
        found("use crate::other::Other;", "pub struct Other;"),
        ["dcel may not import src/other.rs: src/dcel.rs:1 imports Other from src/other.rs"]
    );
    assert_eq!(
        found("pub struct Dcel;", "use crate::dcel::Dcel;"),
        ["a file of no layer may not import dcel: src/other.rs:1 imports Dcel from src/dcel.rs"]
    );
}

#[test]
fn a_missing_file_and_one_that_is_not_rust_are_named() {
    let missing = try_of(&[("src/lib.rs", "mod gone;")]).unwrap_err();
    assert_eq!(missing.to_string(), "src/lib.rs: no file for module gone");
    let absent = try_of(&[]).unwrap_err();
    assert_eq!(absent.to_string(), "src/lib.rs: no file for module crate");
    let broken = try_of(&[("src/lib.rs", "\nfn () {}")]).unwrap_err();
    assert!(broken.to_string().starts_with("src/lib.rs:2: expected identifier"), "{broken}");
}

#[test]
fn what_cargo_lists_is_read_and_what_it_does_not_list_is_refused() {
    assert!(crates_of("{}").is_none());
    assert!(crates_of("nonsense").is_none());
    assert!(crates(Path::new("no/such/Cargo.toml")).is_err());
    let listed = crates_of(
        r#"{"packages": [{"targets": [{"name": "two-words", "src_path": "/src/lib.rs", "kind": ["lib"]},
            {"name": "run", "src_path": "/src/main.rs", "kind": ["bin"]}]}]}"#,
    )
    .unwrap();
    assert_eq!((listed[0].name.as_str(), listed[0].is_library), ("two_words", true));
    assert_eq!((listed[1].name.as_str(), listed[1].is_library), ("run", false));
}

#[test]
fn paths_that_are_not_there_are_found_in_each_line_by_themselves() {
    let there = ["src/a/one.rs", "src/a", "src/a/mod.rs", "src", "src/b/", "src/b", "src/b/two.rs", "README.md"];
    let page = "| `src/a/one.rs`, `mod.rs`, `three.rs` | `Names`, `cargo run`, `any(…)` |
        | `src/b/`, `two.rs`; `src/a/NAME.rs`, `mod.rs` | `README.md`, `src/c/NAME.rs` |
        | `mod.rs` | a `.` and a `/nowhere` |";
    let missing = missing_paths(page, |path| there.contains(&path.to_str().unwrap()));
    let found: Vec<(usize, &str)> = missing.iter().map(|missing| (missing.line, missing.path.as_str())).collect();
    assert_eq!(found, [(1, "three.rs"), (2, "src/c/NAME.rs"), (3, "mod.rs"), (3, "/nowhere")]);
}
