//! `twinedge draw`.

use crate::support::{complaint, data, twinedge};
use std::path::PathBuf;

/// A file of this test, deleted on drop.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        Self(std::env::temp_dir().join(format!("twinedge-{}-{name}", std::process::id())))
    }

    fn path(&self) -> &str {
        self.0.to_str().unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn the_built_in_map_is_drawn_to_a_file_and_to_standard_output() {
    let file = Scratch::new("world.svg");
    let output = twinedge(&["draw", "-o", file.path()]);
    assert_eq!((output.status.code(), output.stdout.len(), output.stderr.len()), (Some(0), 0, 0));
    let picture = std::fs::read_to_string(&file.0).unwrap();
    assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
    // Every bounded face, and once more the two that are claimed twice.
    assert_eq!((picture.matches("fill-rule").count(), picture.matches("class=\"hatch\"").count()), (287 + 2, 2));
    assert!(picture.contains(">Brazil</text>") && picture.contains("<title>f2: Fiji</title>"));
    for arguments in [&["draw"][..], &["draw", "-o", "-"]] {
        assert_eq!(String::from_utf8(twinedge(arguments).stdout).unwrap(), picture);
    }
}

#[test]
fn crossings_are_marked() {
    let output = twinedge(&["draw", &data("world-110m-crossing.geojson")]);
    assert_eq!(output.status.code(), Some(1));
    let picture = String::from_utf8(output.stdout).unwrap();
    // Each row of the legend has the whole sentence, and the part of it that fits.
    assert_eq!(picture.matches("  G4 half-edges ").count(), 4);
    assert_eq!(picture.matches("<text class=\"legend\"").count(), 3);
    assert_eq!(picture.matches("<circle class=\"bad\"").count(), 3);
}

#[test]
fn details_of_a_large_map_are_refused_without_force() {
    let output = twinedge(&["draw", "--detail"]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    let complaint = complaint(&output);
    assert!(complaint.contains("15,310 half-edges") && complaint.contains("--force"), "{complaint}");
    let halves = |arguments: &[&str]| {
        let output = twinedge(arguments);
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).unwrap().matches("class=\"half\"").count()
    };
    assert_eq!(halves(&["draw", "--detail", "--force"]), 15_310);
    let part = halves(&["draw", "--detail", "--window", "5.5", "45.5", "11", "48"]);
    assert!((50..500).contains(&part), "{part}");
    assert!(halves(&["draw", "--detail", "--window", "-80", "-5", "-75", "0"]) > 0);
}

#[test]
fn what_cannot_be_drawn_is_said_in_one_line() {
    let output = twinedge(&["draw", "-o", "/no/such/folder/map.svg"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("/no/such/folder/map.svg"));
    for window in [["1", "1", "1", "2"], ["0", "0", "NaN", "1"], ["0", "0", "inf", "1"]] {
        let output = twinedge(&[&["draw", "--window"][..], &window].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(complaint(&output).contains("--window"));
    }
    for arguments in [&["draw", "--size", "10"][..], &["draw", "--window", "1", "2"], &["draw", "no-such-file.geojson"]]
    {
        assert_eq!(twinedge(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn a_window_outside_the_map_is_refused() {
    let output = twinedge(&["draw", "--window", "1000", "1000", "1001", "1001"]);
    assert_eq!(output.status.code(), Some(2));
    let words = complaint(&output);
    assert!(words.contains("--window lies outside the map, which spans (-181.27441274412743, "), "{words}");
    // No edge is visible inside one country, but the country is.
    assert_eq!(twinedge(&["draw", "--window", "28.2", "-29.6", "28.3", "-29.5"]).status.code(), Some(0));
}
