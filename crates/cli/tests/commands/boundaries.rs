//! `twinedge audit --boundaries` and `twinedge convert --boundaries`: boundaries of OpenStreetMap.

use crate::shared::{has, members};
use crate::support::Folder;
use pbf::File;
use serde_json::{Value, json};

#[path = "../../../../extras/osm/tests/osm/pbf.rs"]
mod pbf;

/// Two adjacent squares.
fn squares() -> File {
    let mut file = File::default();
    for (id, x, y) in [(1, 0, 0), (2, 1, 0), (3, 1, 1), (4, 0, 1), (5, 2, 0), (6, 2, 1)] {
        file.node(id, x, y);
    }
    file.way(10, &[2, 3]);
    file.way(11, &[3, 4, 1, 2]);
    file.way(12, &[2, 5, 6, 3]);
    file.relation(100, "6", "West", &[(10, "outer"), (11, "outer")]);
    file.relation(200, "6", "East", &[(12, ""), (10, "")]);
    file
}

fn folder(file: &File) -> Folder {
    let folder = Folder::new(&[]);
    folder.write("map.osm.pbf", std::fs::read(file.written().path()).unwrap());
    folder
}

#[test]
fn relations_and_the_coverage_that_they_make_are_judged() {
    let audited = |file: &File| {
        folder(file).json("audit map.osm.pbf --boundaries admin_level=6 --coverage --format json --explain").1
    };
    let report = audited(&squares());
    has(&report, &json!({"verdict": "valid", "counts": {"faces": 3}, "options": {"boundaries": "admin_level=6"}}));
    let ids = members(&report["rules"], &["id"]);
    assert_eq!(ids.as_array().unwrap()[..6], ["O1", "O2", "O3", "O4", "O5", "R1"]);

    let mut file = squares();
    file.relation(300, "6", "West again", &[(10, ""), (11, "")]);
    let report = audited(&file);
    has(&report, &json!({"verdict": "invalid", "first": {"rule": "O4"}}));
    let message = "West (relation/100) and West again (relation/300) lie on the same side of 2 ways";
    has(&report["findings"][0], &json!({"kind": "same_side", "records": ["way 10", "way 11"], "message": message}));
    assert_eq!(report["coverage"]["findings"][0]["rule"], "C5", "{report}");
    // A layer without polygons would be refused; here, the reason is a finding.
    let mut file = squares();
    file.ways.clear();
    has(&audited(&file), &json!({"verdict": "invalid", "finding_count": 4, "first": {"rule": "O1"}}));
}

#[test]
fn boundaries_are_converted_with_a_warning_of_faults() {
    let line = "convert map.osm.pbf --boundaries admin_level -o - --to geojson";
    let ran = folder(&squares()).run(line);
    let layer: Value = serde_json::from_str(&ran.out).unwrap();
    has(&layer["features"][1], &json!({"id": "relation/200", "properties": {"name": "East"}}));
    assert_eq!(ran.err, "");
    let mut open = squares();
    open.ways.pop();
    folder(&open).transcript(&format!("{line} => 0 the relations have 2 faults"));
}

#[test]
fn a_file_without_tags_to_look_for_says_how_to_ask() {
    folder(&squares()).transcript(
        "
audit map.osm.pbf => 2 --boundaries admin_level=6
audit map.osm.pbf --boundaries admin_level=2 => 2 admin_level=2
audit - --boundaries admin_level=2 => 2 a file .osm.pbf is needed
audit map.osm.pbf --boundaries =2 => 2 KEY=VALUE or KEY
",
    );
}
