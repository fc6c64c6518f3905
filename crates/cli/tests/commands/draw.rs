//! `twinedge draw`, and completions.

use crate::support::{Folder, crossing};

#[test]
fn the_built_in_map_is_drawn_to_a_file_and_to_standard_output() {
    let folder = Folder::new(&[]);
    let ran = folder.run("draw -o world.svg");
    assert_eq!((ran.status, &*ran.out, &*ran.err), (Some(0), "", ""));
    let picture = folder.text("world.svg");
    assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
    // Every bounded face, and once more the two that are claimed twice.
    assert_eq!((picture.matches("fill-rule").count(), picture.matches("class=\"hatch\"").count()), (287 + 2, 2));
    assert!(picture.contains(">Brazil</text>") && picture.contains("<title>f2: Fiji</title>"));
    for line in ["draw", "draw -o -"] {
        assert_eq!(folder.ok(line), picture);
    }
}

#[test]
fn crossings_are_marked_and_said() {
    let ran = Folder::new(&[]).run(&format!("draw {}", crossing()));
    // Each row of the legend has the whole sentence, and the part of it that fits.
    let count = |what: &str| ran.out.matches(what).count();
    let counts = ["  G4 half-edges ", "<text class=\"legend\"", "<circle class=\"bad\""].map(count);
    assert_eq!((ran.status, counts), (Some(1), [4, 3, 3]));
    assert!(ran.err.lines().count() == 1 && ran.err.contains("not valid"), "{}", ran.err);
}

#[test]
fn details_are_drawn_in_a_window_or_by_force() {
    let folder = Folder::new(&[]);
    let halves = |words: &str| folder.ok(&format!("draw --detail {words}")).matches("class=\"half\"").count();
    assert_eq!(halves("--force"), 15_310);
    assert!((50..500).contains(&halves("--window 5.5 45.5 11 48")));
    assert!(halves("--window -80 -5 -75 0") > 0);
}

#[test]
fn what_cannot_be_drawn_is_said() {
    Folder::new(&[]).transcript(
        "
draw --detail => 2 15,310 half-edges ++ --force
draw -o /no/such/folder/map.svg => 2 /no/such/folder/map.svg
draw --window 1 1 1 2 => 2 --window
draw --window 0 0 NaN 1 => 2 --window
draw --window 0 0 inf 1 => 2 --window
draw --window 1 2 => 2 --window
draw --size 10 => 2 --size
draw missing.geojson => 2 missing.geojson
draw --window 1000 1000 1001 1001 => 2 --window lies outside the map, which spans (-181.27441274412743,
# No edge is visible inside one country, but the country is.
draw --window 28.2 -29.6 28.3 -29.5 => 0 <svg
completions bash => 0 audit ++ certify ++ sum
completions zsh => 0 audit ++ certify ++ sum
completions fish => 0 audit ++ certify ++ sum
completions powershell => 0 audit ++ certify ++ sum
completions elvish => 0 audit ++ certify ++ sum
",
    );
}
