//! A real map: drawing and erasing lines across it.

use crate::location::maps::features;
use crate::support::drawn::area;
use std::collections::BTreeMap;
use twinedge::dcel::HalfEdge;
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_map::{Builder, Feature, PlanarMap, Shape};

/// The world, rounded to a grid of the returned size.
fn world() -> (PlanarMap, Snap) {
    let mut features = features(include_bytes!("../../../../cli/data/world-110m.geojson"));
    let mut segments = Vec::new();
    let rings = |feature: &Feature| -> Vec<Vec<Point>> {
        let polygon = |shape: &Shape| match shape {
            Shape::Polygon(rings) => rings.clone(),
            Shape::Line(_) | Shape::Point(_) => Vec::new(),
        };
        feature.shapes.iter().flat_map(polygon).collect()
    };
    for ring in features.iter().flat_map(rings) {
        segments.extend(ring.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    let noded = node(&segments, &[], Snap::Auto).expect("longitudes and latitudes are in reach");
    let mut chains = (0..segments.len()).map(|i| noded.chain(i).expect("it was given"));
    let mut builder = Builder::new();
    for feature in &mut features {
        for shape in &mut feature.shapes {
            let Shape::Polygon(rings) = shape else { continue };
            for ring in rings {
                let mut through = Vec::new();
                for _ in 1..ring.len() {
                    through.extend(chains.next().into_iter().flatten().map(|v| noded.points[v as usize]));
                }
                through.dedup();
                *ring = through;
            }
        }
        builder.feature(feature).expect("longitudes and latitudes are in range");
    }
    (builder.build().expect("the world fits"), Snap::Size(noded.summary.cell))
}

/// The area of each feature, in square degrees.
fn areas(map: &PlanarMap) -> BTreeMap<usize, f64> {
    let mut areas = BTreeMap::new();
    for face in map.dcel().faces() {
        for feature in map.features_of(face.key()).expect("it is of this map") {
            *areas.entry(feature.index()).or_default() += area(map, face);
        }
    }
    areas
}

#[test]
fn lines_across_the_world_split_countries_and_are_erased_again() {
    let (mut map, grid) = world();
    let report = map.validate();
    assert!(report.is_valid(), "{report}");
    let (vertices, edges, faces) = (map.dcel().vertex_count(), map.dcel().edge_count(), map.dcel().face_count());
    let before = areas(&map);
    let same_areas = |map: &PlanarMap| {
        let after = areas(map);
        assert!(after.keys().eq(before.keys()));
        for (feature, area) in &before {
            assert!((after[feature] - area).abs() < 1e-6, "feature {feature}: {area} became {}", after[feature]);
        }
    };
    let lines = [
        ([-179.0, 0.05], [179.0, 0.03]),
        ([-170.0, 66.56], [170.0, 66.56]),
        ([-120.0, -50.0], [140.0, 70.0]),
        ([10.0, 80.0], [30.0, -80.0]),
    ];
    let mut drawn = Vec::new();
    let mut ends = Vec::new();
    let mut split = 0;
    for (from, to) in lines {
        let edited = map.insert_segment_snapped(from, to, grid).expect("the world is on the grid");
        assert!(edited.edges_split.len() > 10, "it crosses many borders");
        split += edited.edges_split.len();
        drawn.extend(edited.way);
        ends.extend(edited.vertices);
        let report = map.validate();
        assert!(report.is_valid(), "{report}");
        same_areas(&map);
    }
    assert!(map.dcel().face_count() > faces + 50);
    // Each line cuts the earlier ones: their current way equals their old way, up to the joints.
    let is_new = |h: HalfEdge<'_>| {
        let along = map.features_along(h.key()).expect("it is of this map");
        along.count() == 0
    };
    let erased: Vec<_> = map.dcel().edges().filter(|h| is_new(*h)).map(|h| h.key()).collect();
    assert!(drawn.iter().all(|h| map.features_along(*h).expect("none was dropped").count() == 0));
    for h in erased {
        let edited = map.remove_edge(h).expect("it is there");
        assert_eq!(edited.features_dropped, []);
    }
    for v in ends {
        map.remove_vertex(v).expect("it is there");
    }
    let isolated: Vec<_> = map.dcel().vertices().filter(|v| v.leaving().is_none()).map(|v| v.key()).collect();
    for v in &isolated {
        map.remove_vertex(*v).expect("it is there");
    }
    let report = map.validate();
    assert!(report.is_valid(), "{report}");
    same_areas(&map);
    assert_eq!(map.dcel().face_count(), faces);
    // On the borders the crossings stay.
    let crossings = map.dcel().vertex_count() - vertices;
    assert_eq!(map.dcel().edge_count() - edges, crossings);
    assert!(crossings > 50 && crossings <= split);
}
