//! Cleaning: the features that receive gaps, and the width up to which gaps are filled.

use crate::support::{from_text, to_geojson};
use twinedge_coverage::clean::{ChangeKind, Options};
use twinedge_geometry::Point;
use twinedge_layers::clean::{CleanOptions, CleanReport, GapsTo, GapsToError, clean};
use twinedge_layers::{Dimensions, Layer, Shape, Value};

/// Two parcels with a crack between them, a third with a lake in it, and features without polygons.
fn parcels(right: &str) -> Layer {
    let feature = |kind: &str, geometry: &str| {
        format!(r#"{{"type":"Feature","properties":{{"kind":"{kind}","lot":7}},"geometry":{geometry}}}"#)
    };
    let polygon = |rings: &str| format!(r#"{{"type":"Polygon","coordinates":[{rings}]}}"#);
    let all = [
        feature("field", &polygon("[[0,0,1],[10,0,1],[10,10,1],[0,10,1],[0,0,1]]")),
        feature("road", &polygon("[[10.02,0,2],[20,0,2],[20,10,2],[10.02,10,2],[10.02,0,2]]")),
        feature(
            "field",
            &polygon(
                "[[0,10,3],[10,10,3],[10.02,10,3],[20,10,3],[20,20,3],[0,20,3],[0,10,3]],[[4,14,3],[4,17,3],[7,17,3],[7,14,3],[4,14,3]]",
            ),
        ),
        feature("field", &polygon("[[0,0,1],[0,-9,1],[20,-9,1],[20,0,1],[10.02,0,1],[10,0,1],[0,0,1]]")),
        feature("wood", &polygon("[[50,0,1],[60,0,1],[60,10,1],[50,10,1],[50,0,1]]")),
        feature("wood", "null"),
        feature("well", r#"{"type":"Point","coordinates":[1,1,9]}"#),
        feature("none", "null"),
    ];
    let text = format!("{{\"type\":\"FeatureCollection\",\n\"features\":[\n{}\n]}}\n", all.join(",\n"));
    from_text(&text.replace("10.02", right))
}

fn cleaned(layer: &Layer, gaps_to: Option<GapsTo>) -> (Layer, CleanReport) {
    let mut layer = layer.clone();
    let options = CleanOptions { chooses_width: true, gaps_to, ..CleanOptions::default() };
    let report = clean(&mut layer, &options).unwrap();
    (layer, report)
}

fn to(layer: &Layer, kind: &str) -> GapsTo {
    GapsTo::with_value(layer, "kind", kind).unwrap()
}

/// The first parcel has the longer border with the crack.
#[test]
fn gaps_go_to_the_neighbour_that_has_the_value_or_else_to_the_first_that_has_it() {
    let layer = parcels("10.005");
    for (kind, expected) in [(None, 0), (Some("road"), 1), (Some("field"), 0), (Some("wood"), 4), (Some("none"), 7)] {
        let gaps_to = kind.map(|kind| to(&layer, kind));
        let (after, report) = cleaned(&layer, gaps_to.clone());
        let [gap] = &report.changes[..] else { panic!("{:?}", report.changes) };
        assert_eq!((gap.kind, gap.to, report.made), (ChangeKind::Gap, Some(expected), None), "{kind:?}");
        let changed: Vec<usize> = report.features.iter().map(|change| change.feature).collect();
        assert_eq!(changed, [expected], "{kind:?}");
        assert!((report.features[0].area_after - report.features[0].area_before - 0.05).abs() < 1e-9, "{kind:?}");
        // A part as narrow as a gap stays with the feature that was to receive it.
        let (again, report) = cleaned(&after, gaps_to);
        assert_eq!((again, report.changes, report.features), (after, vec![], vec![]), "{kind:?}");
    }
}

#[test]
fn gaps_go_to_a_new_feature_if_none_has_the_value_and_without_gaps_none_is_made() {
    let layer = parcels("10.02");
    let (after, report) = cleaned(&layer, Some(to(&layer, "unknown")));
    assert_eq!((report.made, after.features.len()), (Some(8), 9));
    assert_eq!(after.features[8].attributes, [("kind".into(), Value::Text("unknown".into()))]);
    assert_eq!(after.features[..8], layer.features);
    let geometry = after.features[8].geometry.as_ref().unwrap();
    assert_eq!(geometry.dimensions, Dimensions::Xyz);
    let Shape::MultiPolygon(polygons) = &geometry.shape else { panic!("{geometry:?}") };
    assert_eq!((polygons.len(), polygons[0][0].len()), (1, 5));
    let (again, report) = cleaned(&after, Some(to(&after, "unknown")));
    assert_eq!((again, report.changes), (after, vec![]));

    let mut whole = parcels("10.02");
    whole.features.drain(..4);
    let (same, report) = cleaned(&whole, Some(to(&whole, "unknown")));
    assert_eq!((to_geojson(&same), report.made), (to_geojson(&whole), None));
}

#[test]
fn a_column_that_is_unknown_or_of_another_type_gets_no_gaps() {
    let layer = parcels("10.02");
    let refused = |column, value| GapsTo::with_value(&layer, column, value).unwrap_err();
    assert_eq!(refused("sort", "road"), GapsToError::NoColumn("sort".into()));
    assert_eq!(refused("lot", "x"), GapsToError::OtherType { column: "lot".into(), value: "x".into() });
    assert_eq!(GapsTo::with_value(&layer, "lot", "8"), Ok(GapsTo::New(vec![("lot".into(), Value::Integer(8))])));
    assert!(matches!(GapsTo::with_value(&layer, "kind", "well"), Ok(GapsTo::New(_))));
}

/// The lake is 1.5 wide: less than ten times narrower than the median part, and more than ten times wider than the
/// crack.
#[test]
fn the_width_is_that_of_the_widest_gap_below_a_step_of_ten() {
    let layer = parcels("10.02");
    let (after, report) = cleaned(&layer, None);
    let chosen = report.chosen.unwrap();
    assert_eq!((chosen.width, chosen.gaps, chosen.next), (0.02, 1, 1.5));
    assert_eq!((report.gap_width, report.wider_gaps.len(), report.left), (Some(0.02), 1, None));
    // The chosen width has the effect of a given number.
    let mut same = layer.clone();
    let assign = Options { gap_width: Some(0.02), ..Options::default() };
    let asked = clean(&mut same, &CleanOptions { assign, ..CleanOptions::default() }).unwrap();
    assert_eq!((&same, &asked.features), (&after, &report.features));
    // There is no further step, and the remaining gaps are reported.
    let (_, again) = cleaned(&after, None);
    assert_eq!((again.chosen, again.gap_width, again.left.map(|left| left.gaps)), (None, None, Some(1)));
}

/// A parcel with three holes of 1 × 1 in a row, and next to it three slivers of another feature.
#[test]
fn gaps_and_slivers_that_reach_out_of_the_window_stay() {
    let hole = |x: u8| format!("({x} 4, {x} 5, {r} 5, {r} 4, {x} 4)", r = x + 1);
    let sliver = |x: u8| format!("(({x} 9, {r} 9, {r} 9.01, {x} 9.01, {x} 9))", r = x + 1);
    let [holes, slivers] = [[2, 5, 8].map(hole).join(","), [2, 5, 8].map(sliver).join(",")];
    let text = format!(
        "POLYGON((0 0, 11 0, 11 9, 9 9, 8 9, 6 9, 5 9, 3 9, 2 9, 0 9, 0 0), {holes})\nMULTIPOLYGON(((30 0, 40 0, 40 9, 30 9, 30 0)), {slivers})\n"
    );
    let taken = |window: Option<[Point; 2]>| {
        let mut layer = from_text(&text);
        let assign = Options { sliver_area: Some(2.0), window, ..Options::default() };
        let report = clean(&mut layer, &CleanOptions { assign, ..CleanOptions::default() }).unwrap();
        let mut places: Vec<(ChangeKind, f64)> = report.changes.iter().map(|one| (one.kind, one.at.x)).collect();
        places.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        places
    };
    let all = [ChangeKind::Gap, ChangeKind::Sliver].map(|kind| [2.5, 5.5, 8.5].map(|x| (kind, x))).concat();
    assert_eq!(taken(None), all);
    // The window is closed: it includes features that touch it from inside.
    let window = [Point::new(5.0, 4.0), Point::new(8.5, 9.01)];
    assert_eq!(taken(Some(window)), [(ChangeKind::Gap, 5.5), (ChangeKind::Sliver, 5.5)]);
    assert_eq!(taken(Some([Point::new(5.0, 4.5), Point::new(8.5, 9.0)])), []);
}
