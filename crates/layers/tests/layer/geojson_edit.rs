//! GeoJSON changed in place: valid features stay equal byte by byte, and binary formats keep coordinates to the bit.

use crate::support::{from_text, through, to_geojson};
use serde_json::{Value, json};
use twinedge_coverage::clean::Options;
use twinedge_layers::clean::{CleanOptions, GapsTo, clean};
use twinedge_layers::{Format, Layer, ReadOptions, edited, edits, read_layer};

/// Four squares in a row, the second of which reaches half a unit into the first; the others are valid. Numbers, white space and the order of members
/// are unusual.
const SQUARES: &str = r#" {"features" : [
  { "geometry": {"coordinates":[ [[0.0,0],[1e1,0],[10,10],[0,10],[0.0,0]] ], "type":"Polygon"},"type":"Feature", "properties" : {"a":1.50, "b":"\u00fc"}},
  { "type":"Feature","bbox":[9.5,0,20,10],"properties":null,
     "geometry": {"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}  },{"type":"Feature","properties":{"c": [ ]},"geometry":{"type":"Polygon","coordinates":[[[20,0],[3.0e+1,0.00],[30,10],[20,10],[20,0]]]}}
, {"id": 7.0, "type":"Feature","geometry": null ,"properties":{}}
], "bbox" : [0.0,0,30,10],
 "type":"FeatureCollection", "more": {"x":1.0} }

"#;

/// Returns the text after cleaning, its layer, and the numbers of the changed features.
fn cleaned(text: &str, format: Format, gaps_to: Option<GapsTo>) -> (Option<String>, Layer, Vec<usize>) {
    let options = ReadOptions { format: Some(format), ..ReadOptions::default() };
    let mut layer = read_layer(&mut text.as_bytes(), None, &options).unwrap();
    let count = layer.features.len();
    let assign = Options { gap_width: Some(0.5), ..Options::default() };
    let report = clean(&mut layer, &CleanOptions { assign, gaps_to, ..CleanOptions::default() }).unwrap();
    let changed: Vec<usize> = report.features.iter().map(|change| change.feature).collect();
    let after = edits(text, format, count, &layer, &changed).map(|edits| edited(text, &edits));
    (after, layer, changed)
}

#[test]
fn features_that_are_right_stay_to_the_byte() {
    let (after, layer, changed) = cleaned(SQUARES, Format::GeoJson, None);
    let after = after.unwrap();
    assert_eq!(changed, [0, 1]);
    let (new, old): (Vec<&str>, Vec<&str>) =
        (after.split("coordinates").collect(), SQUARES.split("coordinates").collect());
    assert_eq!((new[0].split("{\"type").next(), new[3]), (old[0].strip_suffix("{\""), old[3]));
    assert!(
        after.contains(r#""properties" : {"a":1.50, "b":"\u00fc"}}"#) && after.ends_with("\"more\": {\"x\":1.0} }\n\n")
    );
    assert_eq!(from_text(&after).features, layer.features);
    // It has no faults any more.
    let (again, _, changed) = cleaned(&after, Format::GeoJson, None);
    assert_eq!((again, changed), (Some(after), vec![]));
}

#[test]
fn a_byte_order_mark_and_separators_of_records_stay() {
    let line = |x0: f64, x1: f64| {
        format!(
            r#"{{"type":"Feature","properties":{{"x":1.0}},"geometry":{{"type":"Polygon","coordinates":[[[{x0},0],[{x1},0.0],[{x1},9],[{x0},9],[{x0},0]]]}}}}"#
        )
    };
    let lines = [line(0.0, 10.0), line(9.75, 20.0), line(20.0, 30.0)];
    let sequence = format!("\u{1e}{}\n", lines.join("\n\u{1e}"));
    let (after, layer, changed) = cleaned(&sequence, Format::GeoJsonSeq, None);
    let after = after.unwrap();
    assert_eq!((changed, after.matches('\u{1e}').count()), (vec![0, 1], 3));
    assert!(after.ends_with(&format!("\u{1e}{}\n", lines[2])), "{after}");
    let marked = format!("\u{feff}{SQUARES}");
    let (after, ..) = cleaned(&marked, Format::GeoJson, None);
    assert_eq!(after.unwrap().strip_prefix('\u{feff}'), cleaned(SQUARES, Format::GeoJson, None).0.as_deref());
    assert_eq!(layer.features.len(), 3);
}

#[test]
fn new_features_come_behind_the_others_and_boxes_are_brought_up_to_date() {
    let walled = SQUARES.replace("9.5", "10.25").replace(
        "\n, {\"id\": 7.0",
        r#",{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,10],[10,10],[10.25,10],[20,10],[20,30],[0,30],[0,10]]]}}
,{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[0,-9],[20,-9],[20,0],[10.25,0],[10,0],[0,0]]]}}, {"id": 7.0"#,
    );
    let (after, layer, changed) = cleaned(&walled, Format::GeoJson, Some(GapsTo::New(vec![])));
    let after = after.unwrap();
    assert_eq!((changed, layer.features.len()), (vec![6], 7));
    let document: Value = serde_json::from_str(&after).unwrap();
    assert_eq!(document["bbox"], json!([0, -9, 30, 30]));
    assert_eq!(from_text(&after), layer);
    assert!(after.contains(r#"{"id": 7.0, "type":"Feature","geometry": null ,"properties":{}},"#), "{after}");
}

#[test]
fn a_text_without_room_for_a_change_is_not_changed_in_place() {
    let layer = from_text(SQUARES);
    let one = r#"{"type":"Feature","properties":{},"geometry":null}"#;
    assert_eq!(edits(one, Format::GeoJson, 1, &layer, &[]), None, "a second feature");
    assert_eq!(edits(SQUARES, Format::GeoJson, 3, &layer, &[]), None, "another number of features");
    assert_eq!(edits(SQUARES, Format::Wkt, 4, &layer, &[]), None);
    assert_eq!(edits("{", Format::GeoJson, 4, &layer, &[]), None);
    // Dropping a box only drops its feature.
    let mut gone = layer.clone();
    gone.features[1].geometry = None;
    gone.features[1].members.clear();
    let after = edited(SQUARES, &edits(SQUARES, Format::GeoJson, 4, &gone, &[1]).unwrap());
    assert_eq!(from_text(&after), gone);
}

/// Squares in a row whose borders are not short fractions; the second reaches into the first.
#[test]
fn binary_formats_keep_the_coordinates_of_what_is_right_to_the_bit() {
    let square = |i: u32| {
        let (x, r) = (f64::from(i) / 3.0 - if i == 1 { 0.07 } else { 0.0 }, f64::from(i + 1) / 3.0);
        format!("POLYGON(({x} 0,{r} 0,{r} 10.7,{x} 10.7,{x} 0))\n")
    };
    let before = from_text(&(0..4).map(square).collect::<String>());
    for format in [Format::Wkb, Format::FlatGeobuf, Format::GeoParquet, Format::GeoPackage, Format::Shapefile] {
        // The conversion's own changes, such as the order of rings, come first.
        let before = through(&before, format);
        let mut after = before.clone();
        let report = clean(&mut after, &CleanOptions::default()).unwrap();
        let changed: Vec<usize> = report.features.iter().map(|change| change.feature).collect();
        assert_eq!(changed, [0, 1], "{format}");
        let after = through(&after, format);
        let bits = |layer: &Layer, number: usize| {
            let mut bits = Vec::new();
            let geometry = layer.features[number].geometry.as_ref().unwrap();
            geometry.shape.visit(&mut |p| bits.extend([p.x.to_bits(), p.y.to_bits()]));
            bits
        };
        for number in 2..4 {
            assert_eq!(bits(&before, number), bits(&after, number), "{format}");
        }
    }
}

#[test]
fn what_is_written_anew_is_the_same_layer() {
    let (after, layer, _) = cleaned(SQUARES, Format::GeoJson, None);
    assert_eq!(from_text(&after.unwrap()).features, from_text(&to_geojson(&layer)).features);
}
