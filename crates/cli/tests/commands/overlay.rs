//! `twinedge overlay` and `twinedge query FILE overlay`.

use crate::support::{complaint, json as run, twinedge};
use serde_json::{Value, json};
use std::fs;
use tempfile::TempDir;

/// ```text
///   2 +-------+
///     |   f   |        the first layer: the field f, and the garden g inside it;
///   1 |  +---+|----+   the second: the zone z, from x = 2 to 4 and y = 0 to 1
///     |  | g :|: z |
///   0 +--+---+-----+
/// ```
fn layers(folder: &TempDir) -> [String; 2] {
    let feature = |id: Value, name: &str, [x0, y0, x1, y1]: [f64; 4]| {
        let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]];
        let geometry = json!({"type": "Polygon", "coordinates": [ring]});
        json!({"type": "Feature", "id": id, "properties": {"name": name}, "geometry": geometry})
    };
    let write = |name: &str, features: Vec<Value>| {
        let path = folder.path().join(name);
        fs::write(&path, json!({"type": "FeatureCollection", "features": features}).to_string()).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let first =
        vec![feature(json!("f"), "field", [0.0, 0.0, 3.0, 2.0]), feature(json!("g"), "garden", [1.0, 0.0, 2.5, 1.0])];
    [write("first.geojson", first), write("second.geojson", vec![feature(json!(7), "zone", [2.0, 0.0, 4.0, 1.0])])]
}

/// Returns the id and the name in the first and in the second layer, and the area by the shoelace formula.
fn pieces(text: &[u8]) -> Vec<(Value, f64)> {
    let layer: Value = serde_json::from_slice(text).unwrap();
    let area = |ring: &Value| {
        let at = |p: &Value| [p[0].as_f64().unwrap(), p[1].as_f64().unwrap()];
        let points: Vec<_> = ring.as_array().unwrap().iter().map(at).collect();
        points.windows(2).map(|e| e[0][0] * e[1][1] - e[1][0] * e[0][1]).sum::<f64>() / 2.0
    };
    let of = |feature: &Value| {
        let [geometry, values] = [&feature["geometry"], &feature["properties"]];
        assert_eq!(geometry["type"], "Polygon");
        let rings = geometry["coordinates"].as_array().unwrap().iter().map(area).sum();
        (json!([values["id"], values["name"], values["id_1"], values["name_1"]]), rings)
    };
    layer["features"].as_array().unwrap().iter().map(of).collect()
}

#[test]
fn pieces_have_the_attributes_of_both_layers() {
    let folder = TempDir::new().unwrap();
    let [first, second] = layers(&folder);
    let all = [
        (json!(["f", "field", "7", "zone"]), 1.0),
        (json!(["f", "field", null, null]), 5.0),
        (json!(["g", "garden", "7", "zone"]), 0.5),
        (json!(["g", "garden", null, null]), 1.0),
        (json!([null, null, "7", "zone"]), 1.0),
    ];
    for (keep, kept) in
        [("either", &[0, 1, 2, 3, 4][..]), ("both", &[0, 2]), ("first", &[0, 1, 2, 3]), ("first-only", &[1, 3])]
    {
        let output = twinedge(&["overlay", &first, &second, "--keep", keep, "-o", "-"]);
        assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
        assert_eq!(pieces(&output.stdout), kept.iter().map(|one| all[*one].clone()).collect::<Vec<_>>(), "{keep}");
    }
    let pairs = ["f", "g", ""].map(|one| ["7", ""].map(|other| format!("{one},{other}"))).concat();
    let csv = String::from_utf8(twinedge(&["query", &first, "overlay", &second, "--format", "csv"]).stdout).unwrap();
    let areas = ["1.0", "5.0", "0.5", "1.0", "1.0"];
    let lines: Vec<String> = pairs.iter().zip(areas).map(|(pair, area)| format!("{pair},{area}")).collect();
    assert_eq!(csv.lines().skip(1).collect::<Vec<_>>(), lines);
    let (status, found) =
        run(&["query", &first, "overlay", &second, "--sort", "area", "--limit", "1", "--format", "json"]);
    let field = json!({"number": 0, "id": "f", "name": "field"});
    assert_eq!((status, &found["pairs"]), (Some(0), &json!([{"first": field, "second": null, "area": 5.0}])));
    let text = String::from_utf8(twinedge(&["query", &first, "overlay", &second]).stdout).unwrap();
    assert!(text.starts_with("          1.0000  field (id f), zone (id 7)\n"), "{text}");
}

#[test]
fn layers_that_do_not_fit_are_refused() {
    let folder = TempDir::new().unwrap();
    let [first, second] = layers(&folder);
    let crs = json!({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}});
    let empty = |name: &str, crs: Value| {
        let path = folder.path().join(name);
        fs::write(&path, json!({"type": "FeatureCollection", "crs": crs, "features": []}).to_string()).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let swiss = empty("swiss.geojson", crs);
    let french = empty("french.geojson", json!({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2154"}}));
    for (arguments, why) in [
        (&["overlay", &first, &second][..], "no file to write was given"),
        (&["overlay", &first, &second, "-o", &second], "this is an input, and is not overwritten"),
        (&["overlay", &first, &second, "-o", &first], "this is the input, and is not overwritten"),
        (
            &["overlay", &swiss, &french, "-o", "-"],
            "the layers are in different coordinate reference systems: EPSG:2056 and EPSG:2154",
        ),
        (
            &["query", &first, "overlay", &swiss],
            "swiss.geojson: a map is made of lines and polygons, and this file has no features",
        ),
    ] {
        let output = twinedge(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(complaint(&output).contains(why), "{arguments:?}: {}", complaint(&output));
    }
}
