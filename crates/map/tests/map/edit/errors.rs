//! Each refusal names its cause and changes nothing.

use crate::edit::describe::{dump, grid};
use crate::support::drawn::crossing;
use twinedge::dcel::{HalfEdgeKey, OperatorError, StaleKey, VertexKey};
use twinedge_geometry::noding::Snap;
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;

/// A square with a vertex in it: its half-edges from (0, 0) on, counter-clockwise, and the vertex.
fn square() -> (PlanarMap, Vec<HalfEdgeKey>, VertexKey) {
    let mut map = PlanarMap::new();
    let ring = map.insert_ring([[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]).expect("it crosses nothing");
    let vertex = map.insert_point([4.0, 4.0]).expect("it lies in the square").vertices[0];
    (map, ring.way, vertex)
}

/// Checks that an edit is refused with this error and leaves the map unchanged.
#[track_caller]
fn refused<T: std::fmt::Debug>(
    map: &mut PlanarMap,
    expected: EditError,
    edit: impl FnOnce(&mut PlanarMap) -> Result<T, EditError>,
) {
    let before = dump(map);
    assert_eq!(edit(map).expect_err("it is to be refused"), expected);
    assert_eq!(dump(map), before);
}

#[test]
fn keys_of_what_is_gone() {
    let (mut map, way, vertex) = square();
    let edge = map.insert_segment([8.0, 8.0], [9.0, 9.0]).expect("it crosses nothing").way[0];
    map.remove_edge(edge).expect("it is there");
    map.remove_vertex(vertex).expect("it is there");
    let face = map.dcel().half_edge(way[0]).expect("it is there").face().key();
    map.remove_edge(way[0]).expect("it is there");
    let stale = |key: StaleKey| EditError::Operator(OperatorError::Stale(key));
    let (no_vertex, no_edge) = (stale(StaleKey::Vertex(vertex)), stale(StaleKey::HalfEdge(edge)));
    refused(&mut map, no_edge, |map| map.remove_edge(edge));
    refused(&mut map, no_edge, |map| map.insert_point(([1.0, 1.0], edge)));
    refused(&mut map, no_edge, |map| map.set_features_along(edge, []));
    refused(&mut map, no_vertex, |map| map.remove_vertex(vertex));
    refused(&mut map, no_vertex, |map| map.insert_segment(vertex, [1.0, 1.0]));
    refused(&mut map, no_vertex, |map| map.insert_segment_snapped(vertex, [1.0, 1.0], Snap::Auto));
    refused(&mut map, no_vertex, |map| map.move_vertex(vertex, [1.0, 1.0]));
    refused(&mut map, stale(StaleKey::Face(face)), |map| map.set_features_of(face, []));
}

#[test]
fn a_map_that_is_not_plane() {
    let mut map = crossing();
    let vertex = map.dcel().vertices().next().expect("it has vertices").key();
    let edge = map.dcel().half_edges().next().expect("it has edges").key();
    let why = EditError::NotPlane(map.not_plane().unwrap());
    refused(&mut map, why, |map| map.insert_point([5.0, 5.0]));
    refused(&mut map, why, |map| map.insert_segment([5.0, 5.0], [6.0, 6.0]));
    refused(&mut map, why, |map| map.insert_segment_snapped([5.0, 5.0], [6.0, 6.0], Snap::Auto));
    refused(&mut map, why, |map| map.insert_ring([[5.0, 5.0], [6.0, 5.0], [5.0, 6.0]]));
    refused(&mut map, why, |map| map.remove_edge(edge));
    refused(&mut map, why, |map| map.remove_vertex(vertex));
    refused(&mut map, why, |map| map.move_vertex(vertex, [5.0, 5.0]));
}

#[test]
fn coordinates_out_of_range() {
    let (mut map, _, vertex) = square();
    let infinite = EditError::NotFinite { x: 1.0, y: f64::INFINITY };
    refused(&mut map, infinite, |map| map.insert_point([1.0, f64::INFINITY]));
    refused(&mut map, infinite, |map| map.insert_segment([1.0, 1.0], [1.0, f64::INFINITY]));
    refused(&mut map, infinite, |map| map.insert_segment_snapped([1.0, 1.0], [1.0, f64::INFINITY], Snap::Auto));
    refused(&mut map, infinite, |map| map.move_vertex(vertex, [1.0, f64::INFINITY]));
    let tiny = EditError::OutOfRange { x: 1e-200, y: 1.0 };
    refused(&mut map, tiny, |map| map.insert_point([1e-200, 1.0]));
    refused(&mut map, tiny, |map| map.insert_ring([[1.0, 1.0], [2.0, 1.0], [1e-200, 1.0]]));
    refused(&mut map, tiny, |map| map.move_vertex(vertex, [1e-200, 1.0]));
    assert!(matches!(map.insert_point([f64::NAN, 0.0]), Err(EditError::NotFinite { x, .. }) if x.is_nan()));
    // A grid so wide that the nearest point is out of range.
    let far = 2_f64.powi(500);
    let mut empty = PlanarMap::new();
    refused(&mut empty, EditError::OutOfRange { x: 2.0 * far, y: 0.0 }, |map| {
        map.insert_segment_snapped([0.0, 0.0], [far, 0.0], Snap::Size(2.0 * far))
    });
}

#[test]
fn segments_without_length() {
    let (mut map, _, vertex) = square();
    let none = EditError::NoLength { x: 4.0, y: 4.0 };
    refused(&mut map, none, |map| map.insert_segment([4.0, 4.0], vertex));
    refused(&mut map, none, |map| map.insert_segment_snapped([4.0, 4.0], vertex, Snap::Auto));
    let zero = EditError::NoLength { x: 0.0, y: 0.0 };
    refused(&mut map, zero, |map| map.insert_ring([[0.0, 0.0], [-0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]));
}

#[test]
fn crossing_an_edge() {
    let (mut map, way, _) = square();
    // From inside, the edge is met from its left, and from outside, from its right.
    refused(&mut map, EditError::Crosses(way[1]), |map| map.insert_segment([5.0, 5.0], [9.0, 5.0]));
    let twin = map.dcel().half_edge(way[1]).expect("it is there").twin().key();
    refused(&mut map, EditError::Crosses(twin), |map| map.insert_segment([9.0, 5.0], [5.0, 5.0]));
    // The last segment of the ring crosses it.
    refused(&mut map, EditError::Crosses(twin), |map| {
        map.insert_ring([[7.0, 3.0], [7.0, 1.0], [8.0, 0.0], [12.0, 5.0]])
    });
}

#[test]
fn rings_of_few_points_or_that_cross_themselves() {
    let (mut map, ..) = square();
    refused(&mut map, EditError::NotARing { points: 0 }, |map| map.insert_ring([[0.0; 2]; 0]));
    refused(&mut map, EditError::NotARing { points: 2 }, |map| map.insert_ring([[0.0, 0.0], [1.0, 1.0], [0.0, 0.0]]));
    refused(&mut map, EditError::SelfCrossing { first: 0, second: 2 }, |map| {
        map.insert_ring([[1.0, 1.0], [3.0, 3.0], [3.0, 1.0], [1.0, 3.0]])
    });
}

#[test]
fn things_in_the_way_of_a_vertex() {
    let (mut map, way, vertex) = square();
    let twin = map.dcel().half_edge(way[1]).expect("it is there").key();
    refused(&mut map, EditError::EdgeInTheWay(twin), |map| map.move_vertex(vertex, [9.0, 4.0]));
    // Stopping on an edge also counts as running into it.
    refused(&mut map, EditError::EdgeInTheWay(twin), |map| map.move_vertex(vertex, [8.0, 4.0]));
    let corner = map.dcel().half_edge(way[0]).expect("it is there").origin().key();
    refused(&mut map, EditError::VertexInTheWay(vertex), |map| map.move_vertex(corner, [6.0, 6.0]));
    refused(&mut map, EditError::VertexInTheWay(corner), |map| map.move_vertex(vertex, [0.0, 0.0]));
    assert_eq!(grid(&map, map.dcel().vertex(corner).expect("it is there")), (0, 0));
}

#[test]
fn grids_that_do_not_fit() {
    let (mut map, _, vertex) = square();
    map.move_vertex(vertex, [4.5, 4.0]).expect("nothing is in the way");
    refused(&mut map, EditError::NotOnGrid(vertex), |map| {
        map.insert_segment_snapped([1.0, 1.0], [2.0, 2.0], Snap::Size(1.0))
    });
    let corner = map.dcel().vertices().find(|v| grid_is(&map, v.key(), [8.0, 8.0])).expect("it is there").key();
    map.move_vertex(corner, [8.5, 8.0]).expect("nothing is in the way");
    refused(&mut map, EditError::NotOnGrid(corner), |map| {
        map.insert_segment_snapped([9.0, 9.0], [10.0, 10.0], Snap::Size(1.0))
    });
    // Edges far away are not examined.
    assert!(map.insert_segment_snapped([-20.0, 0.0], [-20.0, 5.0], Snap::Size(1.0)).is_ok());
    refused(&mut map, EditError::CellSize, |map| map.insert_segment_snapped([1.0, 1.0], [2.0, 2.0], Snap::Size(0.0)));
    let mut empty = PlanarMap::new();
    refused(&mut empty, EditError::OutOfReach { x: 1.0, y: 1.0 }, |map| {
        map.insert_segment_snapped([0.0, 0.0], [1.0, 1.0], Snap::Size(1e-20))
    });
}

fn grid_is(map: &PlanarMap, v: VertexKey, p: [f64; 2]) -> bool {
    map.position(v).expect("it is there") == p.into()
}

#[test]
fn features_of_another_map() {
    let (mut map, way, _) = square();
    let mut other = PlanarMap::new();
    let known = map.add_feature(Some("known".to_owned()));
    other.add_feature(None);
    let unknown = other.add_feature(None);
    let face = map.dcel().half_edge(way[0]).expect("it is there").face().key();
    refused(&mut map, EditError::NoSuchFeature(unknown), |map| map.set_features_of(face, [known, unknown]));
    refused(&mut map, EditError::NoSuchFeature(unknown), |map| map.set_features_along(way[0], [unknown]));
    map.set_features_of(face, [known, known]).expect("it is known");
    map.set_features_along(way[0], [known]).expect("it is known");
    assert!(map.features_of(face).expect("it is there").eq([known]));
    let twin = map.dcel().half_edge(way[0]).expect("it is there").twin().key();
    assert!(map.features_along(twin).expect("it is there").eq([known]));
    assert_eq!(map.name(known), Some("known"));
}
