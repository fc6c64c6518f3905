//! `twinedge clean`: outputs, patches that undo it, cleaning by tiles, and refused options.

use crate::shared::{PARCELS, has, members};
use crate::support::Folder;
use serde_json::{Value, json};

#[test]
fn an_auditor_finds_and_mends_what_is_wrong_with_a_shapefile() {
    let folder = Folder::new(&[("parcels.geojson", PARCELS)]);
    folder.ok("convert parcels.geojson -o parcels.shp --lossy");
    let (_, found) = folder.json("audit --coverage --snap auto --format json parcels.shp");
    has(&found, &json!({"verdict": "invalid", "coverage": {"overlaps": 1, "gaps": 1}}));
    let (status, done) = folder.json("clean parcels.shp -o clean.shp --gap-width 0.1 --format json");
    has(&done, &json!({"clean": true, "features": 3, "changes": [{"kind": "overlap"}, {"kind": "gap"}]}));
    assert_eq!(status, Some(0));
    folder.ok("audit --coverage clean.shp");
    let text = folder.ok("convert clean.shp -o - --to geojson");
    assert!(text.contains(r#""owner":"Müller","since":null"#) && text.contains(r#""since":"2020-01-31""#), "{text}");
    // A second run changes nothing.
    folder.ok("clean clean.shp -o again.shp --gap-width 0.1");
    for extension in ["shp", "shx", "dbf", "cpg"] {
        assert!(
            folder.read(&format!("clean.{extension}")) == folder.read(&format!("again.{extension}")),
            "{extension}"
        );
    }
}

#[test]
fn what_cannot_be_cleaned_is_refused_before_anything_is_written() {
    let folder = Folder::new(&[
        ("parcels.geojson", PARCELS),
        ("lots.geojson", CRACKED),
        // Cleaning would find the coordinates out of range.
        ("far.geojson", &PARCELS.replace("[20,20]", "[1e300,20]")),
        ("point.geojson", r#"{"type":"Point","coordinates":[1,2]}"#),
        ("square.wkt", "POLYGON((0 0,1 0,1 1,0 0))\n"),
    ]);
    let before = folder.names("");
    folder.transcript(
        "
clean parcels.geojson => 2 --dry-run
clean far.geojson --dry-run => 2 1e300
clean far.geojson -o far.shp => 2 the ids of 3 features
clean parcels.geojson --dry-run --name-from nothing => 2 no feature has a value in the column nothing; there are owner, since
clean parcels.geojson --dry-run --gaps-to sort=road => 2 --gaps-to: there is no column sort
clean lots.geojson --dry-run --gaps-to lot=x => 2 no feature has \"x\" as its lot
clean parcels.geojson --dry-run --gaps-to road => 2 not of the form COLUMN=VALUE
clean parcels.geojson --dry-run --gap-width wide => 2 neither `auto` nor a positive number
clean parcels.geojson --dry-run --snap -1 => 2 neither `auto` nor a positive number
clean parcels.geojson --dry-run --patch p.json => 2 cannot be used with
clean parcels.geojson --undo p.json -o x.geojson --snap auto => 2 cannot be used with
clean parcels.geojson -o x.geojson --patch x.geojson => 2 this is another file of the same command
clean parcels.geojson -o x.geojson --patch parcels.geojson => 2 this is another file of the same command
clean parcels.geojson --undo parcels.geojson -o x.geojson => 2 unknown field
clean parcels.geojson -o - --layer roads => 2 there is no layer \"roads\"
clean --tiles 2 square.wkt -o x.geojson => 2 only files of GeoJSON and newline-delimited GeoJSON
clean --tiles 2 - -o x.geojson => 2 and not standard input
clean --tiles 2 parcels.geojson -o x.geojson --to geojsonl => 2 in the format of the input, which is GeoJSON
clean --tiles 2 parcels.geojson -o x.geojson --gap-width auto => 2 looks at all gaps at once
clean --tiles 2 parcels.geojson -o parcels.geojson => 2 is not overwritten
clean --tiles 2 parcels.geojson -o x.geojson --name-from tenant => 2 no feature has a value in the column tenant; there are owner
clean --tiles 2 point.geojson -o x.geojson => 2 there is no polygon to clean
clean parcels.geojson --dry-run => 1 overlap of A-1, A-2 to A-2
",
    );
    assert_eq!((folder.names(""), &*folder.text("parcels.geojson")), (before, PARCELS));
}

#[test]
fn a_layer_on_standard_output_stands_there_alone() {
    let folder = Folder::new(&[("parcels.geojson", PARCELS)]);
    let ran = folder.run("clean - -o - --gap-width 0.1 < parcels.geojson");
    assert!(ran.status == Some(0) && ran.err.contains("overlap of A-1, A-2 to A-2"), "{ran:?}");
    let layer: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!((&layer["source"], &layer["features"][0]["id"]), (&json!("survey"), &json!("A-1")));
    let ran = folder.run("clean parcels.geojson -o - --gap-width 0.1 --format json");
    assert!(serde_json::from_str::<Value>(&ran.err).is_ok_and(|report| report["clean"] == true), "{ran:?}");
}

/// Valid features are equal byte by byte, here with unusual numbers and spaces.
#[test]
fn where_nothing_is_wrong_the_output_is_the_input() {
    let touch = "POLYGON((0 0,10 0,10 10,0 10,0 0),(0 5,3 4,3 6,0 5))\n\
                 MULTIPOLYGON(((20 0,30 0,30 10,20 10,20 0)),((30 5,33 4,33 6,30 5)))\n";
    let millimetres = "POLYGON((2600000.123 1200000.001,2600010.457 1200000.333,2600010.999 1200010.777,2600000.123 1200000.001))\n\
                       POLYGON((2600010.457 1200000.333,2600020.813 1200001.219,2600010.999 1200010.777,2600010.457 1200000.333))\n";
    let spaces = r#"{"type":"FeatureCollection" ,"features":[ {"type": "Feature", "id": "A-5", "properties": {"note": "caf\u00e9"}, "geometry": {"type":"Polygon", "coordinates": [[[50,0],[60,0.000],[6e1,10],[50,10],[50,0]]]}} ]}"#;
    for (input, words) in [(touch, "--to wkt --gap-width 0.1"), (millimetres, "--to wkt --snap 0.001"), (spaces, "")] {
        assert_eq!(Folder::new(&[("in", input)]).ok(&format!("clean - -o - {words} < in")), input);
    }
}

/// The box of a changed geometry is computed from the new geometry.
#[test]
fn members_of_geometries_survive_cleaning() {
    let member = r#""geometry":{"accuracy":0.1,"bbox":[0,0,99,99],"type":"Polygon""#;
    let folder = Folder::new(&[("in", &PARCELS.replace(r#""geometry":{"type":"Polygon""#, member))]);
    let cleaned: Value = serde_json::from_str(&folder.ok("clean - -o - --gap-width 0.1 < in")).unwrap();
    for feature in cleaned["features"].as_array().unwrap() {
        assert_eq!(feature["geometry"]["accuracy"], json!(0.1), "{feature}");
    }
    assert_eq!(cleaned["features"][1]["geometry"]["bbox"][2], json!(20));
    folder.transcript("convert - -o - --to wkt < in => 2 foreign members (source, accuracy)");
}

/// Four parcels around a crack of 0.02 by 10, and a fifth far away, with unusual numbers and spaces. The fourth parcel reaches into the first.
const CRACKED: &str = r#"{"type": "FeatureCollection", "features": [
 {"type": "Feature", "id": "A-1", "properties": {"use": "field", "lot": 1.0}, "geometry": {"type":"Polygon", "coordinates": [[[0,0.0],[10,0],[10,10],[0,10],[0,0.0]]]}},
 {"type": "Feature", "id": "A-2", "properties": {"use": "road"}, "geometry": {"type":"Polygon", "coordinates": [[[10.02,0],[20,0],[20,10],[10.02,10],[10.02,0]]]}},
 {"type": "Feature", "id": "A-3", "properties": {"use": "field"}, "geometry": {"type":"Polygon", "coordinates": [[[0,10],[10,10],[10.02,10],[20,10],[20,20],[0,20],[0,10]]]}},
 {"type": "Feature", "id": "A-4", "properties": {"use": "field"}, "geometry": {"type":"Polygon", "coordinates": [[[0,0],[0,-9],[20,-9],[20,0],[10.02,0],[10,0],[5,1],[0,0]]]}},
 {"type": "Feature", "id": "A-5", "properties": {"use": "wood", "note": "caf\u00e9"}, "geometry": {"type":"Polygon", "coordinates": [[[50,0],[60,0.000],[6e1,10],[50,10],[50,0]]]}}
]}"#;

#[test]
fn a_patch_says_what_changed_and_gives_the_bytes_of_the_input_back() {
    let folder = Folder::new(&[("parcels.geojson", CRACKED)]);
    folder.transcript(
        "
clean parcels.geojson -o clean.geojson --gap-width auto --gaps-to use=unknown --patch patch.json => 0 \
up to the width 0.02, chosen: 1 gap, and none from there to \
++ feature 5: area 0.0000 → 0.2000, points 0 → 5; gap filled; made for gaps ++ what takes it back is in patch.json
clean --undo patch.json clean.geojson -o back.geojson => 0
",
    );
    let text = folder.text("clean.geojson");
    for line in CRACKED.lines().filter(|line| ["A-2", "A-3", "A-4", "A-5"].iter().any(|id| line.contains(id))) {
        assert!(text.contains(line.trim_end_matches(',')), "{line}");
    }
    let document: Value = serde_json::from_slice(&folder.read("patch.json")).unwrap();
    let changes = &document["changes"]["text"];
    assert_eq!(members(changes, &["feature", "id"]), json!([[0, "A-1"], [5, null]]));
    for change in changes.as_array().unwrap() {
        let at = usize::try_from(change["at"].as_u64().unwrap()).unwrap();
        assert!(text[at..].starts_with(change["after"].as_str().unwrap()));
        assert!(CRACKED.contains(change["before"].as_str().unwrap()));
    }
    assert_eq!(folder.text("back.geojson"), CRACKED);
    assert_eq!(folder.ok("clean --undo patch.json - -o - < clean.geojson"), CRACKED);
    // Another file or another patch is refused.
    folder.write("other.geojson", text.replace("A-5", "A-6"));
    let other = folder.text("patch.json").replace("[[0,0.0]", "[[0,0.5]").replace("[[[0,0.0]", "[[[0,0.5]");
    folder.write("other.json", other);
    folder.transcript(
        "
clean --undo patch.json other.geojson -o new.geojson => 2 the patch belongs to a file of
clean --undo other.json clean.geojson -o new.geojson => 2 does not lead back
",
    );
    assert!(!folder.path("new.geojson").exists());
}

#[test]
fn a_patch_of_other_formats_gives_the_geometries_back() {
    let folder = Folder::new(&[("parcels.geojson", CRACKED)]);
    folder.ok("convert parcels.geojson -o parcels.shp --lossy");
    folder.ok("clean parcels.shp -o clean.gpkg --gap-width 0.1 --gaps-to use=unknown --patch patch.json");
    let document: Value = serde_json::from_slice(&folder.read("patch.json")).unwrap();
    let changes = &document["changes"]["geometries"];
    assert!(changes[1]["made"] == true && changes[0]["before"].as_str().unwrap().starts_with("POLYGON"), "{document}");
    folder.ok("clean --undo patch.json clean.gpkg -o back.shp --lossy");
    for extension in ["shp", "dbf"] {
        assert!(
            folder.read(&format!("parcels.{extension}")) == folder.read(&format!("back.{extension}")),
            "{extension}"
        );
    }
    folder.transcript("clean --undo patch.json parcels.shp -o back.shp => 2 the patch belongs to a file of");
}

/// An object that is a single feature has no room for a second one.
#[test]
fn a_text_that_has_no_room_is_written_anew_and_comes_back() {
    let ring = "[[0,0],[9,0],[9,9],[0,9],[0,0]],[[2,2.0],[2,7],[2.01,7],[2.01,2],[2,2]]";
    let one = format!(
        r#"{{"type":"Feature","properties":{{"use":"field"}},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
    );
    let folder = Folder::new(&[("one.geojson", &one)]);
    folder.transcript("clean one.geojson -o clean.geojson --gaps-to use=none --patch patch.json => 1");
    let (_, layer) = folder.json("convert clean.geojson -o -");
    assert_eq!(layer["features"][1]["properties"], json!({"use": "none"}));
    folder.ok("clean --undo patch.json clean.geojson -o back.geojson");
    assert_eq!(folder.text("back.geojson"), one);
}

#[test]
fn tiles_in_memory_and_on_disk_clean_as_the_whole() {
    let square = |i: usize| {
        let (x, y) = ((i % 8) as f64 * 10.0, (i / 8) as f64 * 10.0);
        // One square reaches half a unit into its right neighbour, far from a slit between two others.
        let right = x + [10.0, 10.5, 9.9][usize::from(i == 9) + 2 * usize::from(i == 52)];
        let ring = json!([[[x, y], [right, y], [right, y + 10.0], [x, y + 10.0], [x, y]]]);
        json!({"type": "Feature", "id": i, "properties": {"lot": format!("L{i}")}, "geometry": {"type": "Polygon", "coordinates": ring}})
    };
    let all: Vec<String> = (0..64).map(|i| square(i).to_string()).collect();
    let head = "{\"type\": \"FeatureCollection\", \"bbox\": [0, 0, 80, 80],\n\"features\": [";
    let folder = Folder::new(&[("in.geojson", &format!("{head}\n{}\n]}}\n", all.join(",\n")))]);
    let run = |words: &str| {
        let line = format!("clean in.geojson -o out.geojson --format json --sliver 1.5 --name-from lot {words}");
        let (status, report) = folder.json(&line);
        let changes = members(&report["changes"], &["kind", "from", "to"]);
        let of = members(&report["changed"], &["name", "points_before", "points_after", "reasons"]);
        ((status, changes, of, folder.text("out.geojson")), report["tiles"].clone())
    };
    let (whole, _) = run("");
    assert_eq!((whole.0, whole.1.as_array().unwrap().len()), (Some(0), 2));
    for (words, count) in [("--tiles 1", 1), ("--tiles 3", 9), ("--memory 1G", 1), ("--memory 300K", 3)] {
        let (by_tiles, tiles) = run(words);
        has(&tiles, &json!({"neighbourhoods": 2, "not_cleaned": [], "count": count}));
        assert!(by_tiles == whole, "{words}: {by_tiles:?} {whole:?}");
    }
}
