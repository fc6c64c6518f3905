//! Importing structures with coordinates: equal maps with points at the correct vertices, and nothing that is not plane.

use crate::support::drawn::{Drawn, points_of};
use crate::support::tables::textbook_map;
use quickcheck::{Gen, QuickCheck};
use twinedge::dcel::{ImportError, Outside};
use twinedge::validate::{Expectation, Part, Parts, Rule, Start, Table, View};
use twinedge::view_answers;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Embedding, Feature, MapImportError, Noding, PlanarMap, Shape};
use twinedge_trials::canonical::isomorphic;

/// Two triangles that share an edge: half-edges `3f`, `3f + 1`, `3f + 2` around triangle `f`, and no twins outside.
///
/// ```text
///     3 ─────── 2
///     │  1   ╱  │
///     │   ╱  0  │
///     0 ─────── 1
/// ```
struct Triangles;

impl View for Triangles {
    view_answers! { |_mesh|
        parts => Parts::NONE.with(Part::Faces),
        vertex_slots => 4,
        half_edge_slots => 6,
        face_slots => 2,
        origin(h) => Some([0, 1, 2, 0, 2, 3][h]),
        twin(h) => [None, None, Some(3), Some(2), None, None][h],
        next(h) => Some(h - h % 3 + (h + 1) % 3),
        face(h) => Some(h / 3),
        outer_half_edge(f) => Some(3 * f),
    }
}

/// A closed tetrahedron, with the numbering of `Triangles`.
struct Tetrahedron;

impl View for Tetrahedron {
    view_answers! { |_mesh|
        parts => Parts::NONE.with(Part::Faces),
        vertex_slots => 4,
        half_edge_slots => 12,
        face_slots => 4,
        origin(h) => Some([0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0][h]),
        twin(h) => Some([5, 8, 11, 10, 6, 0, 4, 9, 1, 7, 3, 2][h]),
        next(h) => Some(h - h % 3 + (h + 1) % 3),
        face(h) => Some(h / 3),
        outer_half_edge(f) => Some(3 * f),
    }
}

const MESH: Expectation = Expectation::surface();

fn points(all: &[[f64; 2]]) -> Vec<Point> {
    all.iter().copied().map(Point::from).collect()
}

/// A map drawn from small numbers, with islands, lines and isolated vertices.
fn drawn(segments: &[(i8, i8, i8, i8)], alone: &[(i8, i8)]) -> PlanarMap {
    let mut builder = Builder::new();
    for (a, b, c, d) in segments {
        builder.segment([f64::from(*a), f64::from(*b)], [f64::from(*c), f64::from(*d)]).unwrap();
    }
    let shapes = alone.iter().map(|(x, y)| Shape::Point(Point::new(f64::from(*x), f64::from(*y)))).collect();
    builder.feature(&Feature { shapes, ..Feature::default() }).unwrap();
    builder.build_with(Noding::Snap(Snap::Size(1.0))).unwrap()
}

#[test]
fn a_map_comes_in_as_the_same_map() {
    fn law(segments: Vec<(i8, i8, i8, i8)>, alone: Vec<(i8, i8)>) -> bool {
        let map = drawn(&segments, &alone);
        let (copy, keys) = PlanarMap::from_view(&map, &Expectation::plane(), Outside::Given).unwrap();
        let at_the_same_point = map.dcel().vertices().all(|v| {
            let new = keys.vertex(v.index()).unwrap();
            map.position(v.key()).unwrap() == copy.position(new).unwrap()
        });
        let with_the_same_face = map.dcel().half_edges().all(|h| {
            let new = copy.dcel().half_edge(keys.half_edge(h.index()).unwrap()).unwrap();
            Some(new.face().key()) == keys.face(h.face().index())
        });
        at_the_same_point
            && with_the_same_face
            && isomorphic(map.dcel(), copy.dcel())
            && copy.validate().is_valid()
            && copy.is_plane()
            && copy.features().count() == 0
    }
    QuickCheck::new()
        .rng(Gen::from_size_and_seed(30, 2026))
        .tests(200)
        .quickcheck(law as fn(Vec<(i8, i8, i8, i8)>, Vec<(i8, i8)>) -> bool);
}

#[test]
fn what_came_in_can_be_edited() {
    let map = drawn(&[(0, 0, 4, 0), (4, 0, 0, 4), (0, 4, 0, 0)], &[(1, 1)]);
    let (mut copy, keys) = PlanarMap::from_view(&map, &Expectation::plane(), Outside::Given).unwrap();
    let bounded = map.dcel().faces().find(|f| !f.is_unbounded()).unwrap();
    let land = copy.add_feature(Some("land".into()));
    copy.set_features_of(keys.face(bounded.index()).unwrap(), [land]).unwrap();
    let edited = copy.insert_segment([0.0, 0.0], [2.0, 2.0]).unwrap();
    // It passes through the isolated vertex, and both parts belong to the feature.
    assert_eq!((edited.way.len(), edited.faces_split.len()), (2, 1));
    assert!((twinedge_algorithm::area::feature_area(&copy, land) - 8.0).abs() < f64::EPSILON);
    assert!(copy.validate().is_valid());
}

#[test]
fn an_open_mesh_comes_in_by_its_border() {
    let mesh = Drawn::new(Triangles, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-0.0, 1.0]]);
    let (map, keys) = PlanarMap::from_view(&mesh, &MESH.open(), Outside::Border).unwrap();
    assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count(), map.dcel().face_count()), (4, 5, 3));
    for v in 0..4 {
        assert_eq!(map.position(keys.vertex(v).unwrap()).unwrap(), mesh.point(v));
    }
    // −0 becomes 0, as in the builder.
    assert!(map.position(keys.vertex(3).unwrap()).unwrap().x.is_sign_positive());
}

#[test]
fn a_closed_mesh_comes_in_by_the_face_around_it() {
    // Seen through face 3, of the vertices 2, 3 and 0, with vertex 1 in the middle; from above or from below.
    let from_above = points(&[[0.0, 0.0], [1.0, 1.0], [3.0, 0.0], [0.0, 3.0]]);
    let from_below: Vec<Point> = from_above.iter().map(|p| Point::new(p.y, p.x)).collect();
    let outcomes = [from_above, from_below].map(|points| {
        let mesh = Drawn::new(Tetrahedron, points);
        PlanarMap::from_view(&mesh, &MESH, Outside::Face(3))
    });
    let (taken, refused): (Vec<_>, Vec<_>) = outcomes.into_iter().partition(Result::is_ok);
    let (map, keys) = taken.into_iter().next().unwrap().unwrap();
    assert_eq!(keys.face(3), Some(map.dcel().unbounded_face().key()));
    assert!(map.validate().is_valid());
    // Its rotations have the reverse order.
    let error = refused.into_iter().next().unwrap().unwrap_err();
    assert!(matches!(error, MapImportError::NotDrawn(_)), "{error}");
    assert_eq!(error.report().unwrap().first().unwrap().rule(), Rule::G2);
}

// ------------------------------------------------------------------------------------------------- refusals

fn square() -> PlanarMap {
    drawn(&[(0, 0, 4, 0), (4, 0, 4, 4), (4, 4, 0, 4), (0, 4, 0, 0)], &[(1, 1)])
}

#[test]
fn coordinates_that_do_not_draw_it() {
    let map = square();
    let moved = |from: [f64; 2], to: [f64; 2]| {
        let points = points_of(&map).into_iter().map(|p| if p == from.into() { to.into() } else { p });
        let drawn = Drawn::new(map.clone(), points);
        PlanarMap::from_view(&drawn, &Expectation::plane(), Outside::Given)
    };
    assert!(moved([1.0, 1.0], [3.0, 3.0]).is_ok());
    for (from, to, rule) in [
        ([1.0, 1.0], [f64::NAN, 1.0], Rule::G1),
        ([0.0, 0.0], [4.0, 0.0], Rule::G1),
        ([0.0, 0.0], [1e300, 0.0], Rule::G1),
        ([0.0, 0.0], [5.0, 2.0], Rule::G4),
        ([0.0, 0.0], [5.0, 5.0], Rule::G3),
        ([1.0, 1.0], [4.0, 2.0], Rule::G4),
        ([1.0, 1.0], [9.0, 1.0], Rule::G5),
    ] {
        let error = moved(from, to).unwrap_err();
        assert!(matches!(error, MapImportError::Invalid(_)), "{rule:?}: {error}");
        assert_eq!(format!("{error:?}"), error.to_string());
        assert_eq!(error.report().unwrap().first().unwrap().rule(), rule, "{error}");
    }
}

#[test]
fn broken_links() {
    let map = square();
    let mut table = Table::copy_of(&map).unwrap();
    table.half_edges[2].as_mut().unwrap().twin = Some(2);
    let broken = Drawn::new(table, points_of(&map));
    let error = PlanarMap::from_view(&broken, &Expectation::plane(), Outside::Given).unwrap_err();
    assert!(matches!(error, MapImportError::Invalid(_)), "{error}");
    assert_eq!(error.report().unwrap().first().unwrap().rule(), Rule::L1);
}

#[test]
fn topology_without_an_outside() {
    let mesh = Drawn::new(Tetrahedron, [[0.0, 0.0], [1.0, 1.0], [3.0, 0.0], [0.0, 3.0]]);
    let error = PlanarMap::from_view(&mesh, &MESH, Outside::Face(7)).unwrap_err();
    assert_eq!(error, MapImportError::Topology(ImportError::NoSuchFace(7)));
    assert_eq!((error.report(), error.to_string().as_str()), (None, "there is no face 7 to become the unbounded one"));
}

/// Faces that keep half-edges, as in textbooks, one triangle inside the other.
#[test]
fn a_textbook_table_comes_in() {
    let triangle = [(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)];
    let mut half_edges = triangle.to_vec();
    half_edges.extend(triangle.map(|(origin, next)| (origin + 3, next + 6)));
    let faces: [(Option<usize>, &[Start]); 3] =
        [(None, &[Start::HalfEdge(1)]), (Some(0), &[Start::HalfEdge(7)]), (Some(6), &[])];
    let table = textbook_map(6, &half_edges, &faces);
    let outer_and_inner = [[0.0, 0.0], [10.0, 0.0], [0.0, 10.0], [1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
    let drawn = Drawn::new(table, outer_and_inner);
    let (map, keys) = PlanarMap::from_view(&drawn, &Expectation::plane(), Outside::Given).unwrap();
    let inside = map.dcel().half_edge(keys.half_edge(7).unwrap()).unwrap();
    assert_eq!(keys.face(1), Some(inside.face().key()));
    assert!(map.validate().is_valid());
}
