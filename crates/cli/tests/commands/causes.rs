//! Layers with planted faults: the number of causes equals the number of faults.

use crate::support::{json, twinedge};
use serde_json::{Value, json as value};
use std::fs;
use tempfile::TempDir;

type Ring = Vec<[f64; 2]>;

/// A corner of a grid of parcels, 100 by 80, in the coordinates of a national grid. No side is parallel to an axis.
fn corner(column: usize, row: usize) -> [f64; 2] {
    let (x, y) = (column as f64, row as f64);
    [2_683_000.0 + 100.0 * x + 7.0 * (y % 3.0), 1_247_000.0 + 80.0 * y + 5.0 * (x % 2.0)]
}

fn parcels() -> Vec<([usize; 2], Ring)> {
    let around =
        |[c, r]: [usize; 2]| [[c, r], [c + 1, r], [c + 1, r + 1], [c, r + 1]].map(|[c, r]| corner(c, r)).to_vec();
    let places = (0..6).flat_map(|column| (0..6).map(move |row| [column, row]));
    places.map(|place| (place, around(place))).collect()
}

fn ring(parcels: &mut [([usize; 2], Ring)], place: [usize; 2]) -> &mut Ring {
    let found = parcels.iter_mut().find(|(other, _)| *other == place);
    &mut found.expect("it is on the grid").1
}

/// A fault: its rule, and a function that plants it.
type Fault = (&'static str, fn(&mut Vec<([usize; 2], Ring)>));

const FAULTS: [Fault; 5] = [
    ("C1", |all| {
        // A side is moved into the neighbour.
        let ring = ring(all, [1, 1]);
        ring[1][0] += 3.0;
        ring[2][0] += 3.0;
    }),
    ("C2", |all| ring(all, [4, 1])[1][0] -= 2.0),
    ("C6", |all| ring(all, [1, 4]).swap(2, 3)),
    ("C5", |all| {
        let copy = ring(all, [4, 4]).clone();
        all.push(([9, 9], copy));
    }),
    ("C7", |all| {
        let ring = ring(all, [3, 3]);
        let middle = [0, 1].map(|axis| f64::midpoint(ring[0][axis], ring[1][axis]));
        ring.insert(1, middle);
    }),
];

/// A Shapefile of the parcels with these faults.
fn planted(folder: &TempDir, faults: &[Fault]) -> String {
    let mut all = parcels();
    for (_, plant) in faults {
        plant(&mut all);
    }
    let feature = |(place, ring): &([usize; 2], Ring)| {
        let closed: Ring = ring.iter().chain(&ring[..1]).copied().collect();
        value!({
            "type": "Feature",
            "properties": { "name": format!("P{}-{}", place[0], place[1]) },
            "geometry": { "type": "Polygon", "coordinates": [closed] },
        })
    };
    let features: Vec<Value> = all.iter().map(feature).collect();
    let [text, shapefile] =
        ["parcels.geojson", "parcels.shp"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    fs::write(&text, value!({ "type": "FeatureCollection", "features": features }).to_string()).unwrap();
    let written = twinedge(&["convert", &text, "--lossy", "-o", &shapefile]);
    assert!(written.status.success(), "{written:?}");
    shapefile
}

#[test]
fn a_layer_with_n_faults_has_n_causes() {
    let folder = TempDir::new().unwrap();
    for count in 0..=FAULTS.len() {
        let file = planted(&folder, &FAULTS[..count]);
        let (_, found) = json(&["audit", &file, "--format", "json", "--coverage"]);
        assert_eq!(found["causes"], count, "{found}");
        let findings = found["coverage"]["findings"].as_array().unwrap();
        let mut causes: Vec<&str> = findings
            .iter()
            .filter(|one| one.get("follows_from").is_none())
            .map(|one| one["rule"].as_str().unwrap())
            .collect();
        let mut rules: Vec<&str> = FAULTS[..count].iter().map(|(rule, _)| *rule).collect();
        rules.sort_unstable();
        causes.sort_unstable();
        assert_eq!(causes, rules, "{found}");
        assert!(
            found["violations"].as_array().unwrap().iter().all(|one| one["follows_from_id"].is_string()),
            "{found}"
        );
    }
}

#[test]
fn each_form_of_a_report_counts_causes() {
    let folder = TempDir::new().unwrap();
    let file = planted(&folder, &FAULTS);
    let output = |format: &str| {
        let output = twinedge(&["audit", &file, "--coverage", "--format", format]);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8(output.stdout).unwrap()
    };
    assert!(output("text").contains("\nnot valid: 5 findings, from which "), "{}", output("text"));
    let headline = output("html").split_once("<p id=\"verdict\">").unwrap().1.to_owned();
    assert!(headline.starts_with("not valid: 5 findings, from which "));
    let cases = output("junit").matches("<failure ").count();
    assert_eq!(cases, 5, "{}", output("junit"));
    let sarif: Value = serde_json::from_str(&output("sarif")).unwrap();
    let errors = sarif["runs"][0]["results"].as_array().unwrap().iter().filter(|one| one["level"] == "error").count();
    assert_eq!(errors, 5, "{sarif}");
}

#[test]
fn a_headline_has_the_structure_and_the_coverage() {
    let folder = TempDir::new().unwrap();
    // Neither a missing parcel nor a copy makes borders cross.
    let file = planted(&folder, &[("C2", |all| all.retain(|(place, _)| *place != [3, 3])), FAULTS[3]]);
    let (status, found) = json(&["audit", &file, "--format", "json"]);
    let verdicts = [&found["verdict"], &found["coverage"]["verdict"]];
    assert_eq!((status, verdicts), (Some(0), [&value!("valid"), &value!("invalid")]));
    assert_eq!(found["headline"], "structure valid · coverage: 1 gap, 1 set of duplicates");
}

/// A gap of three millimetres in the coordinates of a national grid.
const CRACK: &str = "POLYGON((2683000 1247000,2683100 1247000,2683100 1247080,2683000 1247080,2683000 1247000))
POLYGON((2683100.003 1247000,2683200 1247000,2683200 1247080,2683100.003 1247080,2683100.003 1247000))
POLYGON((2683000 1247080,2683100 1247080,2683100.003 1247080,2683200 1247080,2683200 1247100,2683000 1247100,2683000 1247080))
POLYGON((2683000 1246980,2683200 1246980,2683200 1247000,2683100.003 1247000,2683100 1247000,2683000 1247000,2683000 1246980))
";

#[test]
fn a_printed_place_can_be_pasted_back() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("crack.wkt").to_str().unwrap().to_owned();
    fs::write(&file, CRACK).unwrap();
    let text = String::from_utf8(twinedge(&["audit", &file]).stdout).unwrap();
    let line = text.lines().find(|line| line.starts_with("C2 gap")).expect("there is a gap");
    let (_, place) = line.rsplit_once("at ").unwrap();
    let (status, found) = json(&["audit", &file, "--coverage", "--format", "json", "--accept-gap", place]);
    let coverage = &found["coverage"];
    assert_eq!((status, &coverage["gaps"], &coverage["accepted_gaps"]), (Some(0), &value!(0), &value!(1)), "{line}");
    assert_eq!(found["warnings"], value!([]));
}

#[test]
fn an_accepted_place_in_which_there_is_no_gap_is_a_warning() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("crack.wkt").to_str().unwrap().to_owned();
    fs::write(&file, CRACK).unwrap();
    let (_, found) = json(&["audit", &file, "--format", "json", "--accept-gap", "2683050,1247040"]);
    assert_eq!(found["warnings"], value!(["there is no gap at the accepted place (2683050, 1247040)"]));
}

/// Accepts all findings of one layer, and judges another layer by that list. Without `--coverage`, only the structure counts.
fn judged_by_the_list_of(before: &str, after: &str) -> (Option<i32>, Value) {
    let folder = TempDir::new().unwrap();
    let [file, list] = ["layer.wkt", "accepted.json"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    fs::write(&file, before).unwrap();
    json(&["audit", &file, "--format", "json", "--accept-all", &list]);
    let (status, same) = json(&["audit", &file, "--format", "json", "--accept", &list]);
    assert_eq!((status, &same["verdict"], &same["causes"]), (Some(0), &value!("valid"), &value!(0)), "{same}");
    fs::write(&file, after).unwrap();
    json(&["audit", &file, "--format", "json", "--accept", &list])
}

#[test]
fn an_accepted_lake_does_not_accept_what_crosses_elsewhere() {
    let lake = "POLYGON((0 0,100 0,100 10,95 20,100 30,100 100,0 100,0 0))
POLYGON((100 0,200 0,200 100,100 100,100 30,100 10,100 0))
";
    let (status, found) = judged_by_the_list_of(lake, &format!("{lake}LINESTRING(50 70,150 72)\n"));
    assert_eq!((status, &found["causes"]), (Some(1), &value!(1)), "{found}");
}

#[test]
fn an_accepted_spike_does_not_accept_that_its_feature_crosses_itself_or_others() {
    let spike = "POLYGON((0 0,50 0,50 12,50 0,100 0,100 80,0 80,0 0))\n";
    let crossing = "POLYGON((0 0,50 0,50 12,50 0,100 80,100 0,0 80,0 0))\n";
    for after in [crossing.to_owned(), format!("{spike}LINESTRING(-20 40,150 45)\n")] {
        let (status, found) = judged_by_the_list_of(spike, &after);
        assert_eq!((status, &found["verdict"]), (Some(1), &value!("invalid")), "{found}");
    }
    let row = |tip: u32| {
        let others = (1..6).map(|i| format!("POLYGON(({0} 0,{1} 0,{1} 100,{0} 100,{0} 0))\n", 100 * i, 100 * i + 100));
        let first = format!("POLYGON((0 0,100 0,100 50,{tip} 50,100 50,100 100,0 100,0 0))\n");
        std::iter::once(first).chain(others).collect::<String>()
    };
    let (status, found) = judged_by_the_list_of(&row(105), &row(550));
    assert_eq!((status, &found["verdict"]), (Some(1), &value!("invalid")), "{found}");
}

#[test]
fn an_accepted_missing_vertex_is_accepted_at_its_place_only() {
    let layer = |west: &str, east: &str| {
        format!(
            "POLYGON((0 0,100 0,{west}100 1000,0 1000,0 0))\nPOLYGON((100 0,200 0,200 1000,100 1000,{east}100 0))\n"
        )
    };
    let (status, found) = judged_by_the_list_of(&layer("100 100,", ""), &layer("", "100 900,"));
    assert_eq!((status, &found["coverage"]["mismatches"]), (Some(1), &value!(1)), "{found}");
    assert_eq!(found["accepted"]["grown"].as_array().unwrap().len(), 1);
}
