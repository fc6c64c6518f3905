//! The pictures in the documentation of the operators: each operator is applied to a small map, and the states before and after
//! are drawn from the structure and from the records that the operator reports as made and dropped.
//!
//! `UPDATE_PICTURES=1 cargo test --test pictures` draws them again.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::float_cmp, reason = "the places are small whole numbers")]

mod draw;
mod operators;
mod scene;

use std::path::Path;

#[test]
fn the_pictures_of_the_operators_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src/dcel/pictures");
    let update = std::env::var_os("UPDATE_PICTURES").is_some();
    let pictures = operators::all();
    for (name, picture) in &pictures {
        let file = folder.join(format!("{name}.svg"));
        if update {
            std::fs::write(&file, picture).expect("the picture can be written");
        }
        let kept = std::fs::read_to_string(&file).unwrap_or_default();
        assert!(kept == *picture, "{name}.svg is not current: UPDATE_PICTURES=1 cargo test --test pictures");
    }
    let files = std::fs::read_dir(&folder).expect("the folder can be read").count();
    assert_eq!(files, pictures.len(), "a picture of no operator");
}

#[test]
fn each_picture_fits_into_a_documentation_comment() {
    for (name, picture) in operators::all() {
        // Markdown ends a block of HTML at an empty line, and begins it at a line with a single tag.
        assert!(picture.lines().all(|line| !line.trim().is_empty()), "{name}");
        assert!(picture.lines().next().is_some_and(|line| line.starts_with("<svg ") && line.ends_with('>')), "{name}");
        // Styles and names would apply to the whole page.
        assert!(!picture.contains("<style") && !picture.contains(" id="), "{name}");
        assert!(picture.len() < 12_000, "{name}: {} bytes", picture.len());
    }
}
