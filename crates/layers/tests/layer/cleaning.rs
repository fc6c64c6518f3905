//! Cleaning: planted faults disappear, valid features stay unchanged, and cleaning twice equals cleaning once.

use crate::support::{from_text, through, to_geojson, world};
use quickcheck::{TestResult, quickcheck};
use twinedge_coverage::clean::{ChangeKind, Options, Winner};
use twinedge_coverage::{CoverageRule, DefectKind};
use twinedge_geometry::noding::Snap;
use twinedge_layers::clean::{CleanError, CleanOptions, CleanReport, clean};
use twinedge_layers::{Feature, Format, Layer, Position, Shape};

fn cleaned(layer: &Layer, options: &CleanOptions) -> (Layer, CleanReport) {
    let mut layer = layer.clone();
    let report = clean(&mut layer, options).unwrap();
    (layer, report)
}

/// Cleans a layer with these rules of assignment.
fn assigned(layer: &Layer, assign: Options) -> (Layer, CleanReport) {
    cleaned(layer, &CleanOptions { assign, ..CleanOptions::default() })
}

fn rings(feature: &Feature) -> Vec<&Vec<Position>> {
    match feature.geometry.as_ref().map(|geometry| &geometry.shape) {
        Some(Shape::Polygon(rings)) => rings.iter().collect(),
        Some(Shape::MultiPolygon(polygons)) => polygons.iter().flatten().collect(),
        _ => Vec::new(),
    }
}

/// The area of polygons with rings of any orientation, since unchanged features keep theirs.
fn area(feature: &Feature) -> f64 {
    let of_ring = |ring: &Vec<Position>| {
        twinedge_algorithm::area::ring_area(ring.iter().map(|p| twinedge_geometry::Point::new(p.x, p.y))).abs()
    };
    let of_polygon = |rings: &Vec<Vec<Position>>| {
        let areas: Vec<f64> = rings.iter().map(of_ring).collect();
        areas.split_first().map_or(0.0, |(outer, holes)| outer - holes.iter().sum::<f64>())
    };
    match feature.geometry.as_ref().map(|geometry| &geometry.shape) {
        Some(Shape::Polygon(rings)) => of_polygon(rings),
        Some(Shape::MultiPolygon(polygons)) => polygons.iter().map(of_polygon).sum(),
        _ => 0.0,
    }
}

/// Returns adjacent squares of side 10 as WKT, given their left ends.
fn squares(lefts: &[f64]) -> String {
    let square = |x: &f64| format!("POLYGON(({x} 0,{r} 0,{r} 10,{x} 10,{x} 0))\n", r = x + 10.0);
    lefts.iter().map(square).collect()
}

/// <https://github.com/libgeos/geos/issues/1525>, with both rings clockwise, and a height that rises along the side without the vertex.
#[test]
fn a_missing_vertex_is_added_and_nothing_else_changes() {
    let ring = |points: &str| format!(r#"{{"type":"Polygon","coordinates":[[{points}]]}}"#);
    let feature = |geometry: &str| format!(r#"{{"type":"Feature","properties":{{}},"geometry":{geometry}}}"#);
    let text = |lacking: &str| {
        let having = feature(&ring("[1,0,0],[1,1,1],[1,3,3],[4,0,0],[1,0,0]"));
        let lacking = feature(&ring(lacking));
        format!("{{\"type\":\"FeatureCollection\",\n\"features\":[\n{having},\n{lacking}\n]}}\n")
    };
    let (layer, report) = cleaned(&from_text(&text("[0,4,0],[1,3,3],[1,0,0],[0,4,0]")), &CleanOptions::default());
    assert_eq!(to_geojson(&layer), text("[0,4,0],[1,3,3],[1,1,1],[1,0,0],[0,4,0]"));
    assert!(report.changes.is_empty() && report.left.is_none());
    let [added] = report.added[..] else { panic!("{:?}", report.added) };
    assert_eq!((added.at.x, added.at.y, added.to, added.of), (1.0, 1.0, 1, 0));
    assert_eq!(report.features.iter().map(|change| change.feature).collect::<Vec<_>>(), [1]);
    let (again, report) = cleaned(&layer, &CleanOptions::default());
    assert_eq!((again, report.added, report.features), (layer, vec![], vec![]));
}

/// The order of parts, a clockwise ring that starts in the middle of a side, two vertices on one side, and a hole.
#[test]
fn rings_keep_their_order_and_turn_when_vertices_are_added() {
    let wall = "[[5,0],[0,0],[0,9],[9,9],[9,0],[5,0]],[[2,2],[6,2],[6,6],[2,6],[2,2]]";
    let text = |wall: &str| {
        let parts = format!(r#"{{"type":"MultiPolygon","coordinates":[[[[30,0],[31,0],[31,1],[30,0]]],[{wall}]]}}"#);
        let east = r#"{"type":"Polygon","coordinates":[[[9,0],[20,0],[20,9],[9,9],[9,7],[9,5],[9,0]]]}"#;
        let inside = r#"{"type":"Polygon","coordinates":[[[2,2],[6,2],[6,6],[4,6],[2,6],[2,2]]]}"#;
        let all = [&*parts, east, inside]
            .map(|geometry| format!(r#"{{"type":"Feature","properties":{{}},"geometry":{geometry}}}"#));
        format!("{{\"type\":\"FeatureCollection\",\n\"features\":[\n{}\n]}}\n", all.join(",\n"))
    };
    let (layer, report) = cleaned(&from_text(&text(wall)), &CleanOptions::default());
    let expected = "[[5,0],[0,0],[0,9],[9,9],[9,7],[9,5],[9,0],[5,0]],[[2,2],[6,2],[6,6],[4,6],[2,6],[2,2]]";
    assert_eq!(to_geojson(&layer), text(expected));
    assert_eq!((report.added.len(), report.features.len(), report.left), (3, 1, None));
}

#[test]
fn a_coverage_stays_as_it_is_to_the_byte() {
    // Outer rings clockwise, a start in the middle of a side, a measure, foreign members.
    let text = r#"{"type":"FeatureCollection",
"note":"x",
"features":[
{"type":"Feature","id":1,"bbox":[0,0,10,10],"rights":2,"properties":{"b":1,"a":2.0},"geometry":{"type":"Polygon","coordinates":[[[5,0,1],[0,0],[0,10],[10,10],[10,0],[5,0,1]]]}},
{"type":"Feature","id":2,"properties":{},"geometry":{"type":"MultiPolygon","coordinates":[[[[10,0],[10,10],[20,10],[20,0],[10,0]]]]}}
]}
"#;
    let (layer, report) = cleaned(&from_text(text), &CleanOptions::default());
    assert_eq!(to_geojson(&layer).replace("\"crs\"", ""), text);
    assert!(report.changes.is_empty() && report.features.is_empty() && report.left.is_none());
}

#[test]
fn an_overlap_goes_to_whom_is_asked() {
    // The right square is larger; its part of the overlap is 5.
    let text = format!("{}POLYGON((9.5 0,25 0,25 10,9.5 10,9.5 0))\n", squares(&[0.0]));
    let areas = |winner| {
        let assign = Options { winner, ..Options::default() };
        let (_, report) = assigned(&from_text(&text), assign);
        assert_eq!((report.changes.len(), report.changes[0].kind), (1, ChangeKind::Overlap));
        assert!(report.left.is_none());
        report.features.iter().map(|feature| feature.area_after).collect::<Vec<_>>()
    };
    assert_eq!(areas(Winner::Larger), [95.0, 155.0]);
    assert_eq!(areas(Winner::Smaller), [100.0, 150.0]);
    assert_eq!(areas(Winner::First), [100.0, 150.0]);
    assert_eq!(areas(Winner::Last), [95.0, 155.0]);
}

/// The first outer ring and its hole are clockwise, the other outer ring is counter-clockwise.
#[test]
fn rings_that_are_made_anew_turn_as_those_before() {
    let text = "POLYGON((0 0,0 10,10 10,10 0,0 0),(2 2,2 4,4 4,4 2,2 2))\nPOLYGON((9.5 0,25 0,25 10,9.5 10,9.5 0))\n";
    let turns = |layer: &Layer| {
        let is_clockwise = |ring: &Vec<Position>| {
            twinedge_algorithm::area::ring_area(ring.iter().map(|p| twinedge_geometry::Point::new(p.x, p.y))) < 0.0
        };
        layer.features.iter().map(|feature| rings(feature).into_iter().map(is_clockwise).collect()).collect()
    };
    for winner in [Winner::First, Winner::Last] {
        let assign = Options { winner, ..Options::default() };
        let (layer, report) = assigned(&from_text(text), assign);
        assert!(!report.features.is_empty());
        let found: Vec<Vec<bool>> = turns(&layer);
        assert_eq!(found, [vec![true, true], vec![false]]);
    }
}

#[test]
fn an_accepted_place_without_a_gap_is_reported() {
    let places = [[5.0, 5.0], [10.5, 5.0]].map(twinedge_geometry::Point::from);
    let assign = Options { accepted_gaps: places.to_vec(), ..Options::default() };
    let text = format!(
        "{}POLYGON((0 10,21 10,21 20,0 20,0 10))\nPOLYGON((0 -9,21 -9,21 0,0 0,0 -9))\n",
        squares(&[0.0, 11.0])
    );
    let (_, report) = assigned(&from_text(&text), assign);
    assert_eq!((report.accepted_gaps.len(), report.unmet), (1, vec![places[0]]));
}

/// A feature inside another one keeps its place, even if it sticks out a little; a feature that is not inside loses to the larger one.
#[test]
fn a_nested_feature_is_not_emptied() {
    let within = "POLYGON((0 0,30 0,30 30,0 30,0 0))\nPOLYGON((10 10,20 10,20 20,10 20,10 10))\nPOLYGON((12 12,14 12,14 14,12 14,12 12))\n\
POLYGON((29.05 0,29.05 10,39.05 10,39.05 0,29.05 0))\nPOLYGON((20.5 20,30.5 20,30.5 30,20.5 30,20.5 20))\n";
    let areas = |winner| {
        let assign = Options { winner, ..Options::default() };
        let (layer, report) = assigned(&from_text(within), assign);
        assert!(report.left.is_none(), "{:?}", report.left);
        layer.features.iter().map(|feature| (area(feature) * 100.0).round() / 100.0).collect::<Vec<_>>()
    };
    assert_eq!(areas(Options::default().winner), [705.0, 96.0, 4.0, 90.5, 100.0]);
    assert_eq!(areas(Winner::Larger), [900.0, 0.0, 0.0, 90.5, 5.0]);
}

#[test]
fn of_two_features_at_the_same_place_the_first_stays() {
    let (layer, report) = cleaned(&from_text(&squares(&[0.0, 0.0])), &CleanOptions::default());
    assert!(layer.features[0].geometry.is_some() && layer.features[1].geometry.is_none());
    assert_eq!(report.features.len(), 1);
    assert!(report.left.is_none());
}

#[test]
fn gaps_go_to_the_neighbour_with_the_longest_border() {
    // Between the three features, a gap of 0.01 by 10 whose long sides belong to the first and the second.
    let text = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((10.01 0,20 0,20 10,10.01 10,10.01 5,10.01 0))\n\
POLYGON((0 10,10 10,10.01 10,20 10,20 20,0 20,0 10))\nPOLYGON((0 0,0 -9,20 -9,20 0,10.01 0,10 0,0 0))\n";
    let (_, report) = with_width_of(&from_text(text), 0.02);
    let [gap] = &report.changes[..] else { panic!("{:?}", report.changes) };
    assert_eq!((gap.kind, gap.to), (ChangeKind::Gap, Some(0)));
    assert!((gap.width - 0.01).abs() < 1e-4 && (gap.area - 0.1).abs() < 1e-9);
    assert!(report.left.is_none(), "{:?}", report.left);
}

#[test]
fn wide_gaps_stay_and_are_counted() {
    let ring = "POLYGON((0 0,10 0,10 10,0 10,0 0),(4 4,4 6,6 6,6 4,4 4))\n";
    let (layer, report) = cleaned(&from_text(ring), &CleanOptions::default());
    assert_eq!(rings(&layer.features[0]).len(), 2);
    assert_eq!(report.left.map(|left| left.gaps), Some(1));
    let [gap] = &report.remaining[..] else { panic!("{:?}", report.remaining) };
    assert_eq!((gap.rule, gap.features.as_slice(), gap.area), (CoverageRule::Gap, &[0][..], 4.0));
    let assign = Options { gap_width: Some(1.0), ..Options::default() };
    let (layer, report) = assigned(&from_text(ring), assign);
    assert_eq!((rings(&layer.features[0]).len(), report.left), (1, None));
}

#[test]
fn a_gap_that_is_open_to_the_outside_is_closed_up_to_a_width() {
    // A strip of 0.05 along both sides of the upper square, and a strip of 1.
    let text = "POLYGON((0 0,30 0,30 10,0 10,0 0))\nPOLYGON((0 10.05,30 10.05,30 20,0 20,0 10.05))\nPOLYGON((31 0,40 0,40 20,31 20,31 0))\n";
    let (_, report) = cleaned(&from_text(text), &CleanOptions::default());
    assert_eq!((report.changes.len(), report.left.map(|left| left.near_misses)), (0, Some(1)));
    let (layer, report) = with_width_of(&from_text(text), 0.1);
    assert_eq!((report.left, report.changes.len(), report.features.len()), (None, 1, 1));
    assert_eq!((report.changes[0].kind, report.changes[0].to), (ChangeKind::Gap, Some(0)));
    assert!((report.features[0].area_after - 301.5).abs() < 1e-9);
    assert_eq!(layer.features[2], from_text(text).features[2]);
    let (again, report) = with_width_of(&layer, 0.1);
    assert!(report.features.is_empty());
    assert_eq!(to_geojson(&again), to_geojson(&layer));
}

/// A crack from the outside to a lake between five features.
#[test]
fn a_crack_that_opens_into_a_lake_is_filled_and_the_lake_stays() {
    let text = "POLYGON((0 0,30 0,30 10,20 10,10 10,0 10,0 0))\nPOLYGON((0 20,10 20,20 20,30 20,30 30,0 30,0 20))\n\
POLYGON((0 10,10 10,10 14.99,0 15,0 10))\nPOLYGON((0 15,10 15.01,10 20,0 20,0 15))\nPOLYGON((20 10,30 10,30 20,20 20,20 10))\n";
    let (_, report) = with_width_of(&from_text(text), 0.1);
    let [filled] = &report.changes[..] else { panic!("{:?}", report.changes) };
    assert_eq!((filled.kind, report.left), (ChangeKind::Gap, None));
    assert!((filled.area - 0.1).abs() < 1e-6, "{filled:?}");
    let [lake] = &report.wider_gaps[..] else { panic!("{:?}", report.wider_gaps) };
    assert!((lake.area - 100.0).abs() < 1e-6, "{lake:?}");
    // A notch is not a crack.
    let notch = "POLYGON((0 0,50 0,50 50,46 100,0 100,0 0))\nPOLYGON((50 0,100 0,100 100,54 100,50 50,50 0))\n";
    let (after, report) = with_width_of(&from_text(notch), 1.0);
    assert_eq!((to_geojson(&after), report.left), (to_geojson(&from_text(notch)), None));
}

/// A spindle-shaped gap, 10 wide in the middle, with a point at both ends.
#[test]
fn a_gap_that_is_too_wide_is_left_whole_and_counted() {
    let text = "POLYGON((0 -20,100 -20,100 0,90 0,50 -5,10 0,0 0,0 -20))\nPOLYGON((0 0,10 0,50 5,90 0,100 0,100 20,0 20,0 0))\n";
    let layer = from_text(text);
    let (after, report) = with_width_of(&layer, 1.0);
    assert_eq!((to_geojson(&after), report.changes, report.left), (to_geojson(&layer), vec![], None));
    let [gap] = &report.wider_gaps[..] else { panic!("{:?}", report.wider_gaps) };
    assert_eq!((gap.features.as_slice(), gap.area.round()), (&[0, 1][..], 400.0));
}

#[test]
fn the_area_before_is_what_was_covered_and_the_area_of_nothing_is_zero() {
    let text = "POLYGON((0 0,10 10,10 0,0 10,0 0))\nPOLYGON((20 0,30 0,30 10,20 10,20 0))\nPOLYGON((20 0,30 0,30 10,20 10,20 0))\n";
    let (_, report) = cleaned(&from_text(text), &CleanOptions::default());
    let [bowtie, duplicate] = &report.features[..] else { panic!("{:?}", report.features) };
    assert_eq!((bowtie.area_before, bowtie.area_after), (50.0, 50.0));
    assert_eq!(bowtie.defects, [DefectKind::SelfIntersection]);
    assert_eq!((duplicate.area_after, duplicate.area_after.is_sign_negative()), (0.0, false));
}

fn with_width_of(layer: &Layer, width: f64) -> (Layer, CleanReport) {
    let assign = Options { gap_width: Some(width), ..Options::default() };
    assigned(layer, assign)
}

#[test]
fn slivers_go_to_neighbours_or_vanish_but_nothing_vanishes_with_them() {
    // The first feature has a sliver inside the second's side, and one far away; the third feature is only a sliver.
    let text = "MULTIPOLYGON(((0 0,10 0,10 10,0 10,0 0)),((20 0,20.001 0,20.001 10,20 10,20 0)),((50 0,50.001 0,50.001 10,50 10,50 0)))\n\
POLYGON((10 0,20 0,20 10,10 10,10 0))\nPOLYGON((70 0,70.001 0,70.001 10,70 10,70 0))\n";
    let assign = Options { sliver_area: Some(0.1), ..Options::default() };
    let (layer, report) = assigned(&from_text(text), assign);
    let slivers: Vec<_> = report.changes.iter().map(|change| (change.kind, change.from[0], change.to)).collect();
    assert_eq!(slivers.len(), 2);
    assert!(slivers.contains(&(ChangeKind::Sliver, 0, Some(1))) && slivers.contains(&(ChangeKind::Sliver, 0, None)));
    assert!(layer.features[2].geometry.is_some());
    assert_eq!(report.left.map(|left| left.slivers), Some(1));
}

#[test]
fn spikes_repeated_points_and_open_rings_are_mended() {
    let text = "POLYGON((0 0,5 0,5 0,10 0,15 0,10 0,10 10,0 10))\n";
    let (layer, report) = cleaned(&from_text(text), &CleanOptions::default());
    let ring: Vec<(f64, f64)> = rings(&layer.features[0])[0].iter().map(|p| (p.x, p.y)).collect();
    assert_eq!(ring, [(0.0, 0.0), (5.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)]);
    assert!(report.left.is_none());
}

#[test]
fn vertices_keep_their_heights_and_new_ones_lie_between() {
    // The crossing of the second feature with the upper side of the first is new.
    let text = "POLYGON Z((0 0 0,10 0 10,10 10 20,0 10 10,0 0 0))\nPOLYGON Z((4 5 1,6 5 1,6 15 3,4 15 3,4 5 1))\n";
    let (layer, report) = cleaned(&from_text(text), &CleanOptions::default());
    assert!(report.left.is_none());
    let heights: Vec<(f64, f64, f64)> = rings(&layer.features[0])[0].iter().map(|p| (p.x, p.y, p.more[0])).collect();
    assert!(heights.contains(&(10.0, 10.0, 20.0)) && heights.contains(&(4.0, 10.0, 14.0)), "{heights:?}");
    let of_second = rings(&layer.features[1]);
    assert!(of_second[0].iter().all(|p| p.more.len() == 1));
}

#[test]
fn borders_that_cross_are_cut_and_other_points_stay_where_they_were() {
    // 0.1 lies on no grid of powers of two.
    let text = "POLYGON((0.1 0.1,10.1 0.3,10.1 10.7,0.1 10.3,0.1 0.1))\nPOLYGON((9.3 3.3,20.7 3.1,20.9 7.7,9.3 6.1,9.3 3.3))\n\
POLYGON((30.1 0.1,40.3 0.1,40.3 10.7,30.1 0.1))\n";
    let before = from_text(text);
    let (after, report) = cleaned(&before, &CleanOptions::default());
    assert!(report.left.is_none());
    assert_eq!(after.features[2], before.features[2]);
    assert_eq!(report.features.len(), 2);
    let of_first = rings(&after.features[0]);
    assert!(rings(&before.features[0])[0].iter().all(|p| of_first[0].contains(p)));
}

/// Two squares cross and one lies apart, at negative coordinates; all coordinates are halfway between two points of the grid.
#[test]
fn points_halfway_between_two_points_of_the_grid_stay_where_they_were() {
    let half = f64::exp2(-44.0);
    let [low, high] = [-60.0 - half, -50.0 + half];
    let text = format!(
        "POLYGON((0 0,60 0,60 60,0 60,0 0))\nPOLYGON((50 -30,90 30,50 90,45 30,50 -30))\n\
POLYGON(({low} {low},{high} {low},{high} {high},{low} {high},{low} {low}))\n"
    );
    let layer = from_text(&text);
    let (after, report) = cleaned(&layer, &CleanOptions::default());
    let cell = report.noding.map(|noding| noding.cell).unwrap();
    assert_eq!(cell.to_bits(), (2.0 * half).to_bits(), "the middle of a cell of the grid on which borders were cut");
    assert!(!report.changes.is_empty() && report.left.is_none());
    assert_eq!(after.features[2], layer.features[2]);
    assert_eq!(report.features.iter().map(|feature| feature.feature).collect::<Vec<_>>(), [0, 1]);
}

#[test]
fn a_grid_joins_what_is_within_a_cell() {
    let text = format!("{}POLYGON((10.1 0.1,20 0,20 10,10.1 9.9,10.1 0.1))\n", squares(&[0.0]));
    let snap = CleanOptions { snap: Some(Snap::Size(0.5)), ..CleanOptions::default() };
    let (layer, report) = cleaned(&from_text(&text), &snap);
    assert!(report.left.is_none(), "{:?}", report.left);
    assert!(rings(&layer.features[1])[0].iter().any(|p| (p.x, p.y) == (10.0, 0.0)));
}

#[test]
fn lines_and_points_beside_polygons_stay() {
    let text = format!(
        "{}GEOMETRYCOLLECTION(POINT(1 1),POLYGON((9 0,19 0,19 10,9 10,9 0)),LINESTRING(0 0,5 5))\nPOINT(3 3)\n",
        squares(&[0.0])
    );
    let (layer, _) = cleaned(&from_text(&text), &CleanOptions::default());
    let Some(Shape::Collection(parts)) = layer.features[1].geometry.as_ref().map(|geometry| &geometry.shape) else {
        panic!("a collection")
    };
    let names: Vec<&str> = parts.iter().map(|part| part.shape.name()).collect();
    assert_eq!(names, ["Polygon", "Point", "LineString"]);
    assert_eq!(layer.features[2], from_text("POINT(3 3)\n").features[0]);
    assert!(matches!(clean(&mut from_text("POINT(3 3)\n"), &CleanOptions::default()), Err(CleanError::NoPolygons)));
}

#[test]
fn the_box_of_a_feature_that_changed_is_its_box() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}},
        {"type":"Feature","bbox":[8,0,12,10],"properties":{},"geometry":{"type":"Polygon","coordinates":[[[8,0],[12,0],[12,10],[8,10],[8,0]]]}}]}"#;
    let (layer, _) = cleaned(&from_text(text), &CleanOptions::default());
    assert_eq!(layer.features[1].members.get("bbox"), Some(&serde_json::json!([10, 0, 12, 10])));
}

/// The countries of the world with planted faults: two overlaps, a gap, slivers.
#[test]
fn what_is_planted_on_the_world_is_mended_and_the_rest_stays() {
    let mut world = world();
    // Three regions: near misses are looked for between all borders.
    let some = |name: &str| {
        let europe =
            ["Poland", "Germany", "Czechia", "Slovakia", "Ukraine", "Belarus", "Lithuania", "Austria", "Hungary"];
        let others =
            ["Spain", "Portugal", "France", "Mongolia", "China", "Kazakhstan", "Kyrgyzstan", "Lesotho", "South Africa"];
        europe.contains(&name) || others.contains(&name)
    };
    world.features.retain(|feature| feature.name().as_deref().is_some_and(some));
    assert!(world.features.len() > 15);
    let world = with_width_of(&world, 1e9).0;
    let mut planted = world.clone();
    let number = |name: &str| world.features.iter().position(|f| f.name().as_deref() == Some(name)).unwrap();
    // A corner that only Poland has is moved outwards, over its neighbour, and a corner of Spain inwards.
    let mut moved = Vec::new();
    for (name, factor) in [("Poland", 1.05), ("Spain", 0.98), ("Mongolia", 1.02)] {
        let number = number(name);
        moved.push(number);
        let Some(Shape::Polygon(rings)) =
            planted.features[number].geometry.as_mut().map(|geometry| &mut geometry.shape)
        else {
            continue;
        };
        let count = rings[0].len();
        rings[0][count / 2].x *= factor;
    }
    let (mended, report) = with_width_of(&planted, 1e9);
    let left = report.left.unwrap_or_default();
    assert_eq!((left.overlaps, left.gaps, left.slivers, left.invalid), (0, 0, 0, 0), "{left:?}");
    assert!(report.changes.iter().any(|change| change.kind == ChangeKind::Overlap));
    let changed: Vec<usize> = report.features.iter().map(|feature| feature.feature).collect();
    for (i, (before, after)) in planted.features.iter().zip(&mended.features).enumerate() {
        assert_eq!((&before.id, &before.attributes, &before.members), (&after.id, &after.attributes, &after.members));
        assert!(changed.contains(&i) || before == after);
    }
    // Only neighbours of three countries changed.
    assert!(changed.len() < world.features.len() - 2, "{changed:?}");
    assert_eq!(to_geojson(&with_width_of(&mended, 1e9).0), to_geojson(&mended));
}

/// Quadrangles with corners on a small grid, so that every kind of contact occurs.
fn quadrangles(corners: &[(u8, u8)], scale: f64) -> Option<Layer> {
    let polygons: Vec<String> = corners
        .chunks_exact(4)
        .take(12)
        .map(|corners| {
            let at = |(x, y): &(u8, u8)| format!("{} {}", f64::from(x % 8) * scale, f64::from(y % 8) * scale);
            let points: Vec<String> = corners.iter().chain(&corners[..1]).map(at).collect();
            format!("POLYGON(({}))\n", points.join(","))
        })
        .collect();
    (!polygons.is_empty()).then(|| from_text(&polygons.concat()))
}

#[test]
fn the_area_of_a_ring_that_stays_clockwise_counts() {
    let layer = from_text("POLYGON((0 0,0 1,1 1,1 0,0 0))\nPOLYGON((0 2,0 0,0 0,2 0,0 2))\n");
    let assign = Options { winner: Winner::Smaller, ..Options::default() };
    let (clean, _) = assigned(&layer, assign);
    assert_eq!(clean.features.iter().map(area).collect::<Vec<_>>(), [1.0, 1.0]);
}

quickcheck! {
    fn cleaning_twice_is_cleaning_once(corners: Vec<(u8, u8)>, odd_scale: bool, coarse: bool) -> TestResult {
        let Some(layer) = quadrangles(&corners, if odd_scale { 0.7 } else { 1.0 }) else { return TestResult::discard() };
        let snap = coarse.then_some(Snap::Size(0.5));
        let options = CleanOptions { snap, ..CleanOptions::default() };
        let (once, report) = cleaned(&layer, &options);
        // Rings that enclose nothing are removed, which may leave no polygon to clean.
        if once.features.iter().all(|feature| feature.geometry.is_none()) {
            return TestResult::discard();
        }
        let (twice, again) = cleaned(&once, &options);
        let left = report.left.unwrap_or_default();
        TestResult::from_bool(
            to_geojson(&twice) == to_geojson(&once)
                && again.changes.is_empty()
                && again.features.is_empty()
                && (report.left.is_none() || left.is_plane)
                && (left.overlaps, left.invalid) == (0, 0),
        )
    }

    fn closing_gaps_twice_is_closing_them_once(corners: Vec<(u8, u8)>, width: bool) -> TestResult {
        let Some(layer) = quadrangles(&corners, 0.7) else { return TestResult::discard() };
        let width = if width { 0.2 } else { 0.8 };
        let once = with_width_of(&layer, width).0;
        // Rings that enclose nothing are removed, which may leave no polygon to clean.
        if once.features.iter().all(|feature| feature.geometry.is_none()) {
            return TestResult::discard();
        }
        TestResult::from_bool(to_geojson(&with_width_of(&once, width).0) == to_geojson(&once))
    }

    fn the_area_that_is_covered_stays(corners: Vec<(u8, u8)>) -> TestResult {
        let Some(layer) = quadrangles(&corners, 1.0) else { return TestResult::discard() };
        // No part is below this limit: only overlaps are resolved.
        let assign = Options { sliver_area: Some(1e-12), ..Options::default() };
        let winners = [Winner::Inner, Winner::Larger, Winner::Smaller, Winner::First, Winner::Last];
        let covered = winners.map(|winner| {
            let assign = Options { winner, ..assign.clone() };
            let mut layer = layer.clone();
            clean(&mut layer, &CleanOptions { assign, ..CleanOptions::default() }).unwrap();
            layer.features.iter().map(area).sum::<f64>()
        });
        TestResult::from_bool(covered.iter().all(|area| (area - covered[0]).abs() < 1e-6))
    }
}

/// Overlapping parcels with these ids.
fn overlapping(ids: [&str; 2]) -> Layer {
    let parcel = |id: &str, x: f64| {
        let [x0, x1] = [x, x + 10.0];
        format!(
            r#"{{"type":"Feature","id":{id},"properties":{{"x":{x:?}}},"geometry":{{"type":"Polygon","coordinates":[[[{x0},0],[{x1},0],[{x1},9],[{x0},9],[{x0},0]]]}}}}"#
        )
    };
    from_text(&format!("{}\n{}\n", parcel(ids[0], 0.0), parcel(ids[1], 9.5)))
}

#[test]
fn ids_outlive_cleaning_and_every_format_that_has_some() {
    const ANY: [Format; 3] = [Format::GeoJson, Format::GeoJsonSeq, Format::GeoParquet];
    const WHOLE: [Format; 4] = [Format::GeoJson, Format::GeoJsonSeq, Format::GeoParquet, Format::GeoPackage];
    for (ids, formats) in [(["\"A-1\"", "\"B\""], &ANY[..]), (["7", "40"], &WHOLE)] {
        let layer = overlapping(ids);
        for format in formats {
            let ids = |layer: &Layer| -> Vec<_> {
                layer.features.iter().map(|feature| (feature.id.clone(), feature.get("x").cloned())).collect()
            };
            let read = through(&layer, *format);
            let (clean, report) = cleaned(&read, &CleanOptions::default());
            assert_eq!(report.changes.len(), 1);
            assert_eq!(ids(&through(&clean, *format)), ids(&layer), "{format}");
        }
    }
}

/// Triangles whose vertices lie within a cell of the grid for cutting crossings, found by a search of random layers.
#[test]
fn vertices_within_a_cell_of_a_border_are_clean_after_once() {
    let layers = [
        "POLYGON((0 3.2,1 2.9,0 0,0 3.2))\nPOLYGON((0 3.2,0 0,0.2 0,0 3.2))\nPOLYGON((4.55 0.89,4.49 1.03,4.43 1.17,4.55 0.89))\n",
        "POLYGON((0 2.1,0.2 1.9,0.5 1.6,0 2.1))\nPOLYGON((7 0,7 3,10 3,7 0))\nPOLYGON((7 3,7 0,10 0,7 3))\n",
    ];
    let assign = Options { sliver_area: Some(0.001), gap_width: Some(0.6), ..Options::default() };
    let options = CleanOptions { assign, ..CleanOptions::default() };
    for text in layers {
        let (once, report) = cleaned(&from_text(text), &options);
        let (twice, again) = cleaned(&once, &options);
        assert_eq!((to_geojson(&twice), again.features), (to_geojson(&once), vec![]));
        assert_eq!(report.left, again.left);
    }
}
