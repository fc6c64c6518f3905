//! TopoJSON: the examples of its specification, a file written by `geo2topo`, and every error.

use crate::support::{from_bytes, from_text, scratch, to_geojson, world};
use twinedge_layers::topojson::{audit, read as read_arcs};
use twinedge_layers::{
    Cause, Format, Geometry, Id, Layer, Line, Loss, Place, Position, ReadError, ReadOptions, Shape, Value, WriteError,
    losses, read_layer, read_path, refuse_losses, to_map, write_path,
};
use twinedge_map::{Builder, PlanarMap};

/// The example of the specification, section 1.1.
pub(crate) const EXAMPLE: &str = r#"{"type": "Topology", "objects": {"example": {"type": "GeometryCollection", "geometries": [
    {"type": "Point", "properties": {"prop0": "value0"}, "coordinates": [102, 0.5]},
    {"type": "LineString", "properties": {"prop0": "value0", "prop1": 0}, "arcs": [0]},
    {"type": "Polygon", "properties": {"prop0": "value0", "prop1": {"this": "that"}}, "arcs": [[-2]]}]}},
  "arcs": [
    [[102, 0], [103, 1], [104, 0], [105, 1]],
    [[100, 0], [101, 0], [101, 1], [100, 1], [100, 0]]]}"#;

/// The quantised example of the specification.
const QUANTISED: &str = r#"{"type": "Topology", "objects": {"example": {"type": "GeometryCollection", "geometries": [
    {"type": "Point", "properties": {"prop0": "value0"}, "coordinates": [4000, 5000]},
    {"type": "LineString", "properties": {"prop0": "value0", "prop1": 0}, "arcs": [0]},
    {"type": "Polygon", "properties": {"prop0": "value0", "prop1": {"this": "that"}}, "arcs": [[1]]}]}},
  "arcs": [
    [[4000, 0], [1999, 9999], [2000, -9999], [2000, 9999]],
    [[0, 0], [1999, 0], [0, 9999], [-1999, 0], [0, -9999]]],
  "transform": {"scale": [0.0005000500050005, 0.00010001000100010001], "translate": [100, 0]}}"#;

fn xy(layer: &Layer, feature: usize) -> Vec<[f64; 2]> {
    let mut all = Vec::new();
    layer.features[feature].geometry.as_ref().unwrap().shape.visit(&mut |p| all.push([p.x, p.y]));
    all
}

#[test]
fn the_example_of_the_specification_is_read() {
    let layer = from_text(EXAMPLE);
    assert_eq!(layer.header.name.as_deref(), Some("example"));
    assert_eq!(xy(&layer, 0), [[102.0, 0.5]]);
    assert_eq!(xy(&layer, 1), [[102.0, 0.0], [103.0, 1.0], [104.0, 0.0], [105.0, 1.0]]);
    // Index −2 is arc 1 backwards.
    assert_eq!(xy(&layer, 2), [[100.0, 0.0], [100.0, 1.0], [101.0, 1.0], [101.0, 0.0], [100.0, 0.0]]);
    assert_eq!(layer.features[1].get("prop1"), Some(&Value::Integer(0)));
    assert_eq!(layer.features[2].get("prop1"), Some(&Value::Json(serde_json::json!({"this": "that"}))));
}

#[test]
fn the_quantised_example_of_the_specification_is_read() {
    let layer = from_text(QUANTISED);
    let near = |found: &[[f64; 2]], wanted: &[[f64; 2]]| {
        assert_eq!(found.len(), wanted.len());
        for (a, b) in found.iter().flatten().zip(wanted.iter().flatten()) {
            // Half of the 9999 steps of one and five units.
            assert!((a - b).abs() < 0.000_5, "{a} {b}");
        }
    };
    near(&xy(&layer, 0), &[[102.0, 0.5]]);
    near(&xy(&layer, 1), &[[102.0, 0.0], [103.0, 1.0], [104.0, 0.0], [105.0, 1.0]]);
    near(&xy(&layer, 2), &[[100.0, 0.0], [101.0, 0.0], [101.0, 1.0], [100.0, 1.0], [100.0, 0.0]]);
    // 4000 steps of 0.0005000500050005 from 100, to the last digit.
    assert_eq!(xy(&layer, 0)[0][0].to_bits(), (4000.0 * 0.000_500_050_005_000_5 + 100.0_f64).to_bits());
}

#[test]
fn arcs_are_joined_and_every_member_is_kept() {
    let layer = from_text(
        r#"{"type": "Topology", "bbox": [0, 0, 2, 1], "source": "survey", "arcs": [[[0, 0, 7], [1, 0, 8]], [[1, 1, 9], [1, 0, 8]], [[1, 1, 9], [0, 0, 7]]],
        "objects": {"only": {"type": "GeometryCollection", "edition": 3, "geometries": [
          {"type": "Polygon", "id": "A-1", "rights": "none", "bbox": [0, 0, 1, 1], "arcs": [[0, -2, 2]]},
          {"type": null, "id": 7, "properties": {"empty": null}},
          {"type": "MultiPolygon", "arcs": [[[0, -2, 2]], [[-3, 1, -1]]]},
          {"type": "MultiLineString", "arcs": [[0], [1, -2]]},
          {"type": "GeometryCollection", "geometries": [{"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]], "id": "part"}]}]}}}"#,
    );
    assert_eq!(xy(&layer, 0), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
    let mut heights: Vec<f64> = Vec::new();
    layer.features[0].geometry.as_ref().unwrap().shape.visit(&mut |p| heights.extend(&p.more));
    assert_eq!(heights, [7.0, 8.0, 9.0, 7.0]);
    assert_eq!(layer.features[0].id, Some(Id::Text("A-1".into())));
    assert_eq!(layer.features[0].members.keys().collect::<Vec<_>>(), ["rights", "bbox"]);
    assert_eq!(layer.header.members.keys().collect::<Vec<_>>(), ["bbox", "source", "edition"]);
    assert_eq!((&layer.features[1].id, &layer.features[1].geometry), (&Some(Id::Number(7.into())), &None));
    assert!(matches!(&layer.features[2].geometry.as_ref().unwrap().shape, Shape::MultiPolygon(all) if all.len() == 2));
    assert_eq!(xy(&layer, 3), [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 0.0], [1.0, 1.0]]);
    let Some(Geometry { shape: Shape::Collection(parts), .. }) = &layer.features[4].geometry else { panic!() };
    assert_eq!(parts[0].members.get("id"), Some(&"part".into()));
    // GeoJSON can hold everything.
    assert!(losses(&layer, Format::GeoJson).is_empty());
    assert!(to_geojson(&layer).contains(r#""coordinates":[[1,2],[3,4]],"id":"part""#));
}

#[test]
fn of_several_objects_one_must_be_chosen() {
    let text = r#"{"type": "Topology", "arcs": [], "objects": {
        "towns": {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2]}]},
        "summit": {"type": "Point", "coordinates": [3, 4]}}}"#;
    let read = |layer: Option<&str>| {
        let options = ReadOptions { layer: layer.map(str::to_owned), ..ReadOptions::default() };
        read_layer(&mut text.as_bytes(), None, &options)
    };
    assert!(matches!(read(None), Err(ReadError::Layers { wanted: None, layers }) if layers == ["towns", "summit"]));
    assert!(matches!(read(Some("rivers")), Err(ReadError::Layers { wanted: Some(_), .. })));
    assert_eq!(xy(&read(Some("towns")).unwrap(), 0), [[1.0, 2.0]]);
    // An object that is not a collection is one feature.
    assert_eq!(xy(&read(Some("summit")).unwrap(), 0), [[3.0, 4.0]]);
}

fn built(layer: &Layer) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in &layer.features {
        builder.feature(&to_map(feature, &mut twinedge_layers::io::ReadSummary::default())).unwrap();
    }
    builder.build().unwrap()
}

/// Written by `geo2topo countries=FILE` of topojson-server 3.0.1, from 13 countries of the world map.
#[test]
fn what_geo2topo_wrote_is_the_map_that_it_read() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/layer/data/south-america.topojson");
    let found = read_path(path, &ReadOptions::default()).unwrap();
    let mut original = world();
    original.features.retain(|one| found.features.iter().any(|other| other.id == one.id));
    assert_eq!(found.features.len(), 13);
    assert_eq!(found.features, original.features);
    for layer in [&found, &original] {
        let map = built(layer);
        let dcel = map.dcel();
        // V − E + F = 1 + C: the mainland, the island of Tierra del Fuego, the Falkland Islands.
        assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (590, 602, 16));
    }
}

/// Converts a layer of polygons to TopoJSON with an arc for each segment, shared by all rings along it.
fn by_segments(layer: &Layer) -> serde_json::Value {
    use serde_json::json;
    let (mut arcs, mut known) = (Vec::new(), std::collections::HashMap::<_, i64>::new());
    let mut ring = |ring: &Line| -> Vec<i64> {
        let index = |pair: &[Position]| {
            let [a, b] = [&pair[0], &pair[1]].map(|p| [p.x.to_bits(), p.y.to_bits()]);
            if let Some(arc) = known.get(&(b, a)) {
                return !*arc;
            }
            *known.entry((a, b)).or_insert_with(|| {
                arcs.push(json!([[pair[0].x, pair[0].y], [pair[1].x, pair[1].y]]));
                i64::try_from(arcs.len()).unwrap() - 1
            })
        };
        ring.windows(2).map(index).collect()
    };
    let mut polygon = |rings: &Vec<Line>| rings.iter().map(&mut ring).collect::<Vec<_>>();
    let geometries: Vec<serde_json::Value> = layer
        .features
        .iter()
        .map(|feature| match &feature.geometry.as_ref().unwrap().shape {
            Shape::Polygon(rings) => json!({"type": "Polygon", "arcs": polygon(rings)}),
            Shape::MultiPolygon(all) => {
                json!({"type": "MultiPolygon", "arcs": all.iter().map(&mut polygon).collect::<Vec<_>>()})
            }
            other => panic!("{}", other.name()),
        })
        .collect();
    json!({"type": "Topology", "arcs": arcs, "objects": {"world": {"type": "GeometryCollection", "geometries": geometries}}})
}

/// 7,493 − 7,655 + 288 = 1 + 125, as counted by `twinedge audit` and stated in the documentation.
#[test]
fn the_world_in_arcs_is_the_world() {
    let world = world();
    let text = by_segments(&world).to_string();
    let found = from_text(&text);
    assert_eq!(found.features.len(), 177);
    for (before, after) in world.features.iter().zip(&found.features) {
        assert_eq!(before.geometry, after.geometry);
    }
    let map = built(&found);
    let dcel = map.dcel();
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.face_count()), (7493, 7655, 288));
    // The arcs themselves.
    let arcs = audit(&read_arcs(&mut text.as_bytes(), None, 100).unwrap(), 100);
    assert_eq!((arcs.counts().nodes, arcs.counts().edges), (7493, 7655));
    assert_eq!(arcs.counts().components, Some(125));
}

#[test]
fn the_extension_or_the_content_tells_it() {
    assert_eq!(Format::of_path("a/World.TopoJSON"), Some(Format::TopoJson));
    for name in ["map.topojson", "map.json", "map.geojson"] {
        let (_folder, path) = scratch(name);
        std::fs::write(&path, EXAMPLE).unwrap();
        assert_eq!(read_path(&path, &ReadOptions::default()).unwrap().features.len(), 3, "{name}");
    }
    let (_folder, path) = scratch("map.topojson");
    std::fs::write(&path, r#"{"type": "FeatureCollection", "features": []}"#).unwrap();
    let error = read_path(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert_eq!(error, r#"TopoJSON: line 1, column 45: the type is "FeatureCollection", and must be Topology"#);
}

#[test]
fn it_is_not_written_and_says_so() {
    let layer = from_text(EXAMPLE);
    assert!(matches!(refuse_losses(&layer, Format::TopoJson), Err(WriteError::ReadOnly(Format::TopoJson))));
    let (_folder, path) = scratch("map.topojson");
    let error = write_path(&layer, &path, Format::TopoJson).unwrap_err();
    assert_eq!(error.to_string(), "TopoJSON is read here, but not written");
    assert!(!path.exists());
}

#[test]
fn members_of_parts_that_geojson_forbids_are_reported() {
    let layer = from_text(
        r#"{"type": "Topology", "arcs": [], "objects": {"a": {"type": "GeometryCollection", "geometries": [
        {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2], "properties": {"a": 1}}]}]}}}"#,
    );
    assert_eq!(losses(&layer, Format::GeoJson), [Loss::Members(vec!["properties".into()])]);
    assert!(!to_geojson(&layer).contains(r#""a":1"#));
}

/// Returns the error for a file with this geometry and two arcs, from (0, 0) to (1, 0) and from (1, 1) to (0, 0).
fn refused(geometry: &str) -> (Place, Cause) {
    let text = format!(
        r#"{{"type": "Topology", "arcs": [[[0, 0], [1, 0]], [[1, 1], [0, 0]]],
           "objects": {{"a": {{"type": "GeometryCollection", "geometries": [{{"type": null}}, {geometry}]}}}}}}"#
    );
    match from_bytes(text.as_bytes()) {
        Err(ReadError::Content { format: Format::TopoJson, place, cause }) => (place, cause),
        other => panic!("{geometry}: {other:?}"),
    }
}

#[test]
fn indices_out_of_range_are_refused() {
    for index in ["2", "-3", "9223372036854775807", "-9223372036854775808"] {
        let (place, cause) = refused(&format!(r#"{{"type": "LineString", "arcs": [{index}]}}"#));
        assert_eq!(place, Place::Feature(1));
        assert_eq!(cause, Cause::NoSuchArc { index: index.parse().unwrap(), arcs: 2 });
    }
    for index in ["0.5", "\"0\"", "18446744073709551615", "null"] {
        let (_, cause) = refused(&format!(r#"{{"type": "LineString", "arcs": [{index}]}}"#));
        assert!(cause.to_string().contains("is no index"), "{cause}");
    }
}

#[test]
fn arcs_that_do_not_join_are_refused() {
    let (_, cause) = refused(r#"{"type": "LineString", "arcs": [0, 1]}"#);
    assert_eq!(
        cause.to_string(),
        "arc 1, number 1 of a line, begins at (1.0, 1.0), and the one before it ends at (1.0, 0.0)"
    );
}

#[test]
fn what_is_no_geometry_is_refused() {
    for (geometry, what) in [
        ("7", "no object"),
        ("{}", "without a type"),
        (r#"{"type": "Circle"}"#, "no type of geometries"),
        (r#"{"type": "Point"}"#, "without coordinates"),
        (r#"{"type": "Polygon"}"#, "without arcs"),
        (r#"{"type": "Polygon", "arcs": [0]}"#, "a list should be"),
        (r#"{"type": "MultiPolygon", "arcs": [[0]]}"#, "a list should be"),
        (r#"{"type": "LineString", "arcs": 0}"#, "a list should be"),
        (r#"{"type": "Point", "coordinates": [1]}"#, "two numbers"),
        (r#"{"type": "Point", "coordinates": ["1", 2]}"#, "two numbers"),
        (r#"{"type": "Point", "coordinates": [1, 2], "id": []}"#, "an id"),
        (r#"{"type": "Point", "coordinates": [1, 2], "properties": []}"#, "properties"),
        (r#"{"type": "GeometryCollection", "geometries": {}}"#, "a list should be"),
    ] {
        let (place, cause) = refused(geometry);
        assert!(cause.to_string().contains(what), "{geometry}: {cause}");
        assert_eq!(place, Place::Feature(1), "{geometry}");
    }
}

#[test]
fn the_outermost_object_is_checked() {
    for (text, what) in [
        (r#"{"type": "Topology", "objects": {}}"#, "missing field `arcs`"),
        (r#"{"type": "Topology", "arcs": []}"#, "missing field `objects`"),
        (r#"{"type": "Topology", "arcs": [], "arcs": [], "objects": {}}"#, "repeated"),
        (r#"{"type": "Topology", "arcs": [[[1]]], "objects": {}}"#, "two numbers or more"),
        (r#"{"type": "Topology", "arcs": [[["1", 2]]], "objects": {}}"#, "invalid type"),
        (r#"{"type": "Topology", "arcs": [[[1e999, 2]]], "objects": {}}"#, "number out of range"),
        (r#"{"type": "Topology", "arcs": [], "objects": {}, "transform": {"scale": [1]}}"#, "an array of length 2"),
        (r#"{"type": "Topology", "arcs": [], "objects": {}}"#, "no layers of features"),
        (r#"{"type": "Topology", "arcs": [], "objects": {"a": {"type": "GeometryCollection"}}}"#, "without geometries"),
        // The large numbers are finite, but not their sum.
        (
            r#"{"type": "Topology", "transform": {"scale": [1, 1], "translate": [0, 0]}, "arcs": [[[0, 0], [1e308, 0], [1e308, 0]]], "objects": {}}"#,
            "arc 0: the coordinates (inf, 0) are not finite",
        ),
    ] {
        let error = from_bytes(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(what), "{text}: {error}");
    }
}

#[test]
fn errors_of_syntax_have_a_line_and_a_column() {
    let error = from_bytes(b"{\"type\": \"Topology\",\n  \"arcs\": [[[1, 2], [3, x]]]}").unwrap_err();
    let ReadError::Content { place: Place::Text(at), .. } = &error else { panic!("{error}") };
    assert_eq!((at.line, at.column), (2, Some(25)));
}

#[test]
fn an_arc_that_is_repeated_ends_at_a_limit_and_not_in_memory() {
    // A thousand positions, referenced ten thousand times: ten million positions from 160 kilobytes.
    let arc = vec!["[0,0]"; 1000].join(",");
    let file = |times: usize| {
        let indices = vec!["0"; times].join(",");
        format!(
            r#"{{"type": "Topology", "arcs": [[{arc}]], "objects": {{"a": {{"type": "LineString", "arcs": [{indices}]}}}}}}"#
        )
    };
    let error = from_bytes(file(10_000).as_bytes()).unwrap_err();
    let limit = (1 << 20) + 16 * 1000;
    assert!(
        matches!(error, ReadError::Content { cause: Cause::Expanded { limit: found }, .. } if found == limit),
        "{error}"
    );
    // The limit applies to all features together: 1064 features of a thousand positions each fit.
    let lines = |count: usize| {
        let lines = vec![r#"{"type":"LineString","arcs":[0]}"#; count].join(",");
        let text = format!(
            r#"{{"type":"Topology","arcs":[[{arc}]],"objects":{{"a":{{"type":"GeometryCollection","geometries":[{lines}]}}}}}}"#
        );
        from_bytes(text.as_bytes()).map(|layer| layer.features.len())
    };
    assert!(matches!(lines(1064), Ok(1064)));
    assert!(matches!(lines(1065), Err(ReadError::Content { place: Place::Feature(1064), .. })));
}
