//! Rules between layers, and between parts and their parents.

use crate::shared::has;
use crate::support::{Asked, layer, parsed, uncoloured};
use serde_json::{Value, json};
use twinedge_report::{Audited, Compared};

/// A rectangle by least x, least y, greatest x, greatest y.
fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Value {
    json!({"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]]})
}

fn point(x: f64) -> Value {
    json!({"type": "Point", "coordinates": [x, 10]})
}

/// A layer whose features have a name, a value in the column STATE, and a geometry.
fn of(features: &[(&str, Value, Value)]) -> String {
    let feature = |(name, state, geometry): &(&str, Value, Value)| json!({"type": "Feature", "properties": {"name": name, "STATE": state}, "geometry": geometry});
    json!({"type": "FeatureCollection", "features": features.iter().map(feature).collect::<Vec<_>>()}).to_string()
}

/// Two adjacent states of 20 by 20, named in the column STATE.
fn states() -> String {
    let of_state = |name: &'static str, x: f64| (name, json!(name), rectangle([x, 0.0, x + 20.0, 20.0]));
    of(&[of_state("Iowa", 100.0), of_state("Ohio", 120.0)])
}

/// Two counties in each state. Cedar has this width and names this state.
fn counties(width: f64, state: &str) -> String {
    let county = |name: &'static str, state: &str, x: f64, width: f64| {
        (name, json!(state), rectangle([x, 0.0, x + width, 20.0]))
    };
    of(&[
        county("Adair", "Iowa", 100.0, 10.0),
        county("Cedar", state, 110.0, width),
        county("Darke", "Ohio", 120.0, 10.0),
        county("Erie", "Ohio", 130.0, 10.0),
    ])
}

fn judged(layer: &str, words: &str) -> Audited {
    Asked::new(words).against(layer, &states()).unwrap()
}

fn audited(layer: &str, words: &str) -> Value {
    parsed(&judged(layer, words))
}

const BY_STATE: &str = "--parent-column STATE";

/// Asserts the verdict, and the rule, kind, features and others of each finding.
#[track_caller]
fn finds(report: &Value, expected: &[&str]) {
    let names = |of: &Value| -> Vec<String> {
        of.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap().to_owned()).collect()
    };
    let line = |one: &Value| {
        let [rule, kind] = ["rule", "kind"].map(|key| one[key].as_str().unwrap());
        format!("{rule} {kind}: {} / {}", names(&one["features"]).join(" "), names(&one["others"]).join(" "))
    };
    let found: Vec<String> = report["findings"].as_array().unwrap().iter().map(line).collect();
    assert_eq!(found, expected, "{report}");
    assert_eq!(report["verdict"], if expected.is_empty() { "valid" } else { "invalid" });
}

#[test]
fn parts_that_make_up_their_parents_are_accepted() {
    let report = audited(&counties(10.0, "Iowa"), BY_STATE);
    finds(&report, &[]);
    let rules: Vec<_> =
        report["rules"].as_array().unwrap().iter().filter(|rule| rule["id"].as_str() > Some("X")).collect();
    let brief = |id: &str, checked: u64| json!({"id": id, "checked": checked, "violations": 0, "unchecked": null});
    assert_eq!(rules, [&brief("X1", 4), &brief("X2", 5), &brief("X3", 13), &brief("X4", 4)]);
    has(&report, &json!({"against": {"input": "other", "features": 2}, "options": {"parent_column": "STATE"}}));
}

#[test]
fn each_deviation_is_found_with_the_features_of_both_layers() {
    let report = audited(&counties(10.0, "Ohio"), BY_STATE);
    finds(&report, &["X4 outside_parent: Cedar / Ohio", "X4 parent_not_covered:  / Iowa"]);
    has(&report["findings"][0], &json!({"area": 200, "length": 60, "at": [115, 10]}));
    assert_eq!(report["finding_count"], 2);
    let unknown = &audited(&counties(10.0, "Utah"), BY_STATE)["findings"][1];
    has(unknown, &json!({"rule": "X4", "kind": "unknown_parent", "features": [{"name": "Cedar"}], "others": []}));
    assert!(unknown["message"].as_str().unwrap().starts_with("its parent Utah is not known"));
    // A part without area lies outside of nothing, but has a place.
    let whole = ("Whole", json!("Iowa"), rectangle([100.0, 0.0, 120.0, 20.0]));
    let report = audited(&of(&[("Post", json!("Utah"), point(105.0)), whole]), BY_STATE);
    has(
        report["findings"].as_array().unwrap().last().unwrap(),
        &json!({"kind": "unknown_parent", "at": [105, 10], "area": null}),
    );
}

#[test]
fn each_form_of_a_report_has_findings_between_layers() {
    // Cedar ends before the border of its state.
    let narrow = judged(&counties(9.0, "Iowa"), BY_STATE);
    finds(
        &parsed(&narrow),
        &["X2 only_there:  / Iowa", "X3 no_border:  / Iowa", "X3 no_border:  / Iowa", "X4 parent_not_covered:  / Iowa"],
    );
    let text = uncoloured(&narrow.text().unwrap());
    for line in [
        "X2 only_there; only Iowa of other covers this; area 20.0000, width 0.9524, borders of 42.0000; at (119.5, 10)",
        "\n  X3  border     BROKEN  2 violations in 16 edges\n",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let sarif: Value = serde_json::from_slice(&narrow.sarif().unwrap()).unwrap();
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    let of_layers: Vec<_> = results.iter().filter(|one| one["ruleId"].as_str() > Some("X")).collect();
    assert_eq!((of_layers.len(), &of_layers[0]["level"]), (4, &json!("error")));
    let junit = narrow.junit().unwrap();
    assert!(
        junit.contains("name=\"X1 within\" time=\"0\"/>") && junit.contains("name=\"X2 cover\" time=\"0\"><failure"),
        "{junit}"
    );
    let cover = json!({"properties": {"rule": "X2", "others": ["Iowa"]}, "geometry": {"type": "Polygon"}});
    has(&layer(&narrow)["features"][0], &cover);
    let page = narrow.page().unwrap();
    assert!(page.contains("\"id\":\"X4\"") && page.contains("none of its parts covers this of Iowa"), "{page}");
}

#[test]
fn findings_between_layers_are_accepted_and_compared() {
    let list = judged(&counties(9.0, "Iowa"), "").accept_all(None, "", "").unwrap();
    let accepting =
        |width: f64| parsed(&Asked::new("").accepting(&list).against(&counties(width, "Iowa"), &states()).unwrap());
    has(&accepting(9.0), &json!({"verdict": "valid", "accepted": {"count": 3}}));
    assert_eq!(accepting(8.0)["verdict"], "invalid");
    let compared = |width: f64| Compared::new(&audited(&counties(width, "Iowa"), "")).unwrap();
    assert_eq!(compared(10.0).difference(&compared(9.0)).new.len(), 3);
}

/// Levels in one file: a county names its state, which has no parent.
#[test]
fn levels_of_one_layer_are_judged_by_the_column_of_their_parents() {
    for column in ["STATE", "STATE=name"] {
        for (width, expected) in [(10.0, &[][..]), (9.0, &["X4 parent_not_covered:  / Iowa"])] {
            let part = |name: &'static str, state: Value, x: f64, width: f64| {
                (name, state, rectangle([x, 0.0, x + width, 20.0]))
            };
            let levels = of(&[
                part("Iowa", Value::Null, 100.0, 20.0),
                part("Adair", json!("Iowa"), 100.0, 10.0),
                part("Cedar", json!("Iowa"), 110.0, width),
                part("Ohio", json!(""), 120.0, 20.0),
            ]);
            let asked = Asked::new(&format!("--snap auto --parent-column {column}"));
            finds(&parsed(&asked.audit("levels", levels).unwrap()), expected);
        }
    }
}

#[test]
fn lines_and_points_are_judged_by_the_areas_of_the_other_layer() {
    let places = [("in", 105.0), ("on", 120.0), ("out", 90.0)].map(|(name, x)| (name, json!(1), point(x)));
    finds(&audited(&of(&places), ""), &["X6 not_inside: on / Iowa Ohio", "X6 not_inside: out / "]);
    let line = |y: f64| json!({"type": "LineString", "coordinates": [[120.0, y], [120.0, 20.0]]});
    let borders = of(&[("short", json!(1), line(5.0)), ("long", json!(1), line(-3.0))]);
    let report = audited(&borders, "");
    has(report["findings"].as_array().unwrap().last().unwrap(), &json!({"rule": "X5", "length": 3, "at": [120, -1.5]}));
}

/// Borders that coincide within a cell coincide for both layers.
#[test]
fn snapping_applies_to_both_layers() {
    let near = counties(9.99, "Iowa");
    assert_eq!(audited(&near, "")["verdict"], "invalid");
    finds(&audited(&near, "--snap 0.25"), &[]);
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let counties = counties(10.0, "Iowa");
    let places = of(&[("in", json!(1), point(1.0))]);
    let square = |name, x| (name, json!("Iowa"), rectangle([x, 0.0, x + 1.0, 1.0]));
    let double = of(&[square("a", 0.0), square("b", 1.0)]);
    let columns = "no feature has a value in the column ST; there are STATE, name";
    for (other, words, why) in [
        (&places, "", "other: a map is made of lines and polygons"),
        (&places, "--allow-empty", "other has no polygons"),
        (&states(), "--parent-column ST", columns),
        (&states(), "--parent-column STATE=ST", columns),
        (&double, BY_STATE, "two features have the STATE Iowa, by which"),
    ] {
        let error = Asked::new(words).against(&counties, other).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
    let error = Asked::new(BY_STATE).audit("counties", &*counties).unwrap_err().to_string();
    assert!(error.contains("no feature has one of the values of STATE as its name"), "{error}");
}
