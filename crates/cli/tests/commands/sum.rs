//! `twinedge sum` reports what `twinedge audit` does.

use crate::shared::{FAULTY, has, members};
use crate::support::{Folder, crossing, root};
use crate::tile::tiles;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Two fields whose common border has a vertex only in the west.
const UNMATCHED: &str = "POLYGON((0 0,2 0,2 2,2 4,0 4,0 0))\nPOLYGON((2 0,4 0,4 4,2 4,2 0))\n";

/// Three fields with narrow strips between them.
const NEAR: &str = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((10.001 0,20 0,20 10,10.001 10,10.001 0))
POLYGON((0 10.001,10 10.001,10 20,0 20,0 10.001))\n";

/// Squares with holes that are images of each other: their areas are equal, but not their rounded areas.
fn mirrored() -> String {
    let mut lines = String::new();
    for number in 0..24 {
        let [x, y] = [number % 6, number / 6].map(|i| f64::from(i) * 32.0 + 16.0);
        let [w, h, k] = [0.1, 1.3, 0.7].map(|part| f64::from(number + 1) * part / 9.0);
        for side in [1.0, -1.0] {
            let ring = |points: &[[f64; 2]]| {
                let at = |p: &[f64; 2]| format!("{} {}", x + side * p[0], y + p[1]);
                points.iter().chain(&points[..1]).map(at).collect::<Vec<_>>().join(",")
            };
            let square = ring(&[[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]]);
            let hole = ring(&[
                [4.0, 4.0],
                [w + 4.0, k + 4.0],
                [2.0 * w + k + 4.0, h + 4.0],
                [k + 4.0, h + w + 4.0],
                [4.0 - w, h / 2.0 + 4.0],
            ]);
            writeln!(lines, "POLYGON(({square}),({hole}))").unwrap();
        }
    }
    lines
}

/// A file of polygons as GeoJSON, with ids and names.
fn named(polygons: &str) -> String {
    let position = |pair: &str| pair.split(' ').map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>();
    let ring = |ring: &str| ring.split(',').map(position).collect::<Vec<_>>();
    let feature = |(number, line): (usize, &str)| {
        let rings = line.trim_start_matches("POLYGON((").trim_end_matches("))").split("),(");
        let geometry = json!({"type": "Polygon", "coordinates": rings.map(ring).collect::<Vec<_>>()});
        json!({"type": "Feature", "id": format!("P-{number}"), "properties": {"name": format!("lot {}", number / 2)}, "geometry": geometry})
    };
    json!({"type": "FeatureCollection", "features": polygons.lines().enumerate().map(feature).collect::<Vec<_>>()})
        .to_string()
}

/// Removes the members in which a report by tiles differs from the report on the whole map, and rounds numbers to nine digits.
fn compared(mut report: Value, has_consequences: bool) -> Value {
    let without = |one: &mut Value, names: &[&str]| {
        one.as_object_mut().unwrap().retain(|name, _| !names.contains(&name.as_str()));
    };
    without(&mut report, &["elapsed_ms", "tiles"]);
    if has_consequences {
        // Findings of tiles have no shapes, so which of them touch is not known.
        without(&mut report, &["headline", "causes", "consequences", "first"]);
    }
    let consequence = |one: &mut Value| {
        if has_consequences {
            without(one, &["follows_from", "follows_from_id"]);
        }
    };
    report["coverage"]["findings"].as_array_mut().unwrap().iter_mut().for_each(consequence);
    for violation in report["violations"].as_array_mut().unwrap() {
        consequence(violation);
        // Tiles do not number records.
        without(violation, &["message", "records"]);
        if violation["rule"] == "T3" {
            // The features around the least vertex of the component.
            without(violation, &["features", "feature_numbers"]);
            without(&mut violation["fields"], &["vertex"]);
        } else {
            without(violation, &["fields"]);
            // The whole map names the edge first that it has first.
            violation["at"].as_array_mut().unwrap().sort_by_key(ToString::to_string);
        }
    }
    round(&mut report);
    report
}

#[track_caller]
fn same(one: &Value, other: &Value) {
    has(one, other);
    has(other, one);
}

fn round(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            *value = format!("{:.9e}", number.as_f64().unwrap()).parse::<f64>().unwrap().into();
        }
        Value::Array(items) => items.iter_mut().for_each(round),
        Value::Object(members) => members.values_mut().for_each(round),
        _ => {}
    }
}

/// Ids depended on whether names were known, and the order of findings on the rounding of their areas.
#[test]
fn the_report_of_a_sum_is_the_report_of_the_audit() {
    let files = [
        ("faulty.geojson", FAULTY),
        ("unmatched.geojson", UNMATCHED),
        ("near.geojson", NEAR),
        ("mirrored.geojson", &mirrored()),
    ];
    let folder = Folder::new(&[("faulty.wkt", FAULTY)]);
    for (name, polygons) in files {
        folder.write(name, named(polygons));
    }
    let (crossing, large) = (crossing(), root("tests/data/world-50m.geojson"));
    for (file, has_consequences, rules) in [
        ("faulty.geojson", false, &["C1", "C2", "C4", "C5", "C6"][..]),
        ("faulty.wkt", false, &["C1", "C2", "C4", "C5", "C6"]),
        ("unmatched.geojson", false, &["C7"]),
        ("near.geojson", false, &["C3"]),
        ("mirrored.geojson", false, &["C2"]),
        (&crossing, true, &["C1", "C2", "C4", "C6"]),
        (&large, false, &["C2"]),
    ] {
        let of_tiles = tiles(&folder, file, "2x2", &["0", "1", "2", "3"]);
        let options = "--coverage --list 100000 --format json";
        let (status, sum) = folder.json(&format!("sum {of_tiles} --of {file} {options}"));
        let (of_whole, whole) = folder.json(&format!("audit {file} {options}"));
        let (_, mut by_tiles) = folder.json(&format!("audit {file} {options} --tiles 2"));
        by_tiles["elapsed_ms"] = sum["elapsed_ms"].clone();
        assert_eq!(status, of_whole, "{file}");
        same(&sum, &by_tiles);
        same(&compared(sum, has_consequences), &compared(whole.clone(), has_consequences));
        let mut found = members(&whole["coverage"]["findings"], &["rule"]).as_array().unwrap().clone();
        found.dedup();
        assert_eq!(json!(found), json!(rules), "{file}");
    }
}

#[test]
fn a_sum_takes_what_the_audit_takes_of_a_report() {
    let folder = Folder::new(&[("parcels.geojson", &named(FAULTY))]);
    let of_tiles = tiles(&folder, "parcels.geojson", "2x2", &["0", "1", "2", "3"]);
    let sum = format!("sum {of_tiles} --of parcels.geojson --coverage");
    for format in ["sarif", "geojson", "junit"] {
        // Junit has the time, in seconds.
        let untimed = |text: &str| {
            text.split("time=").map(|part| part.trim_start_matches(|c| c != ' ').to_owned()).collect::<Vec<_>>()
        };
        let [one, other] = [&sum, "audit parcels.geojson --coverage --tiles 2"]
            .map(|line| folder.run(&format!("{line} --format {format}")));
        assert_eq!((one.status, untimed(&one.out), one.err), (other.status, untimed(&other.out), other.err));
    }
    folder.transcript(&format!(
        "
{sum} => 1 C1 overlap ++ (id P-0)
{sum} --list 0 => 1 not valid
{sum} --explain => 1 cause
{sum} -o findings.geojson => 1 written to findings.geojson
{sum} -o sum.json => 1
audit parcels.geojson --coverage -o audit.json => 1
diff audit.json sum.json => 0
audit parcels.geojson --coverage --accept-all accepted.json => 1
{sum} --accept accepted.json => 0 5 findings accepted
audit parcels.geojson --coverage --tiles 2 --accept accepted.json => 0 5 findings accepted
{sum} --accept-all again.json --reason meant => 1
audit parcels.geojson --coverage --accept again.json => 0 5 findings accepted
# Findings of features without names have other ids.
sum {of_tiles} --coverage --accept accepted.json => 1 known by their numbers: --of FILE ++ 0 findings accepted ++ no longer occurs
{sum} --accept parcels.geojson => 2 parcels.geojson: no list of accepted findings
{sum} --format html => 2 the format html is for whole maps
{sum} -o parcels.geojson => 2 this is the input, and is not overwritten
{sum} -o 0.summary => 2 this command writes .txt
"
    ));
    assert!(folder.text("findings.geojson").contains("P-0"));
    has(&serde_json::from_str(&folder.text("again.json")).unwrap(), &json!({"schema": "twinedge-accepted/1"}));
}

#[test]
fn a_layer_that_is_not_that_of_the_tiles_is_refused() {
    let parcels = named(FAULTY);
    let folder = Folder::new(&[
        ("parcels.geojson", &parcels),
        ("renamed.geojson", &parcels.replace("lot 1", "lot one")),
        ("fewer.geojson", &named("POLYGON((0 0,15 0,15 8,0 8,0 0))")),
        ("other.geojson", &named("POLYGON((0 0,15 0,15 9,0 9,0 0))")),
    ]);
    folder.transcript(
        "
tile parcels.geojson --grid 1x1 --tile 0 -o one => 0
sum one --of renamed.geojson => 2 renamed.geojson: the tiles were made of another file: sha256 is
sum one --of nowhere.geojson => 2 nowhere.geojson: No such file
sum one --name-from name => 2 --of <FILE>
sum one --of parcels.geojson --name-from owner => 2 parcels.geojson: no feature has a value in the column owner
tile parcels.geojson --grid 1x1 --tile 0 --source 2026 -o two => 0
sum two --of renamed.geojson => 0 lot one
sum two --of other.geojson => 2 the tiles were made of another layer: the box around theirs is (0, 0)-(15, 8), and that of this one (0, 0)-(15, 9)
sum two --of fewer.geojson => 2 the tiles were made of another layer: theirs has a feature 7, and this one has 1 feature
",
    );
}
