//! Splitting faces by a line and merging them again, and dropping vertices between two edges.

use quickcheck::{Arbitrary as _, Gen};
use twinedge::dcel::{FaceKey, Faces, History, OperatorError, Policy, Vertex};
use twinedge::program::choose::{Choose, Random};
use twinedge_algorithm::area::face_area;
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;
use twinedge_map::edit::EditError;
use twinedge_map::program::{EditProgram, EditRunner};

fn ring(map: &mut PlanarMap, points: &[[f64; 2]]) -> FaceKey {
    map.insert_ring(points.iter().copied()).unwrap().faces_split[0].1
}

/// The ends of all edges, in order.
fn drawn(map: &PlanarMap) -> Vec<[[u64; 2]; 2]> {
    let at = |v: Vertex<'_>| [map[v.key()].x.to_bits(), map[v.key()].y.to_bits()];
    let mut all: Vec<_> = map.dcel().half_edges().map(|h| [h.origin(), h.target()].map(at)).collect();
    all.sort_unstable();
    all
}

/// A number from 0 to 1.
fn part(random: &mut Random) -> f64 {
    random.choose(1 << 20) as f64 / f64::from(1 << 20)
}

#[test]
fn a_line_of_any_slant_splits_a_parcel_and_merging_gives_it_back() {
    let mut random = Random::seeded(1);
    for (round, scale) in (0..400).zip([1.0, 1e-3, 1e6, 30.0].into_iter().cycle()) {
        let at = |x: f64, y: f64| [500_000.0 + scale * x, 5_400_000.0 + scale * y];
        let mut corner = |x: f64, y: f64| at(x + part(&mut random), y + part(&mut random));
        let corners = [corner(0.0, 0.0), corner(4.0, 0.0), corner(4.0, 4.0), corner(0.0, 4.0)];
        let mut map = PlanarMap::new();
        let parcel = ring(&mut map, &corners);
        let tax = map.add_attribute(Policy::<Faces, f64>::of_faces().split_share().merge_sum());
        map.set_value(tax, parcel, 100.0).unwrap();
        let (before, area) = (map.clone(), face_area(&map, parcel).unwrap());
        let mut history = History::new(map);
        let [from, through] = [at(2.0 + part(&mut random), 2.0), at(2.5, 1.0 + part(&mut random))];
        let cut = history.change("split", |map| map.split_face(parcel, from, through)).unwrap();
        let (kept, made) = cut.faces_split[0];
        let map = history.get();
        assert!(map.validate().is_valid(), "{round}");
        assert_eq!((kept, cut.faces_split.len(), map.dcel().face_count()), (parcel, 1, 3), "{round}");
        let [one, other] = [kept, made].map(|face| face_area(map, face).unwrap());
        assert!((one + other - area).abs() < 1e-6 * area, "{round}: {one} and {other} of {area}");
        let shares = [kept, made].map(|face| map.value(tax, face).unwrap());
        assert!((shares[0] / shares[1] - one / other).abs() < 1e-6 * one / other);
        history
            .change("merge", |map| -> Result<(), EditError> {
                let merged = map.merge_faces(kept, made)?;
                assert_eq!(merged.faces_merged, [(kept, made)]);
                merged.vertices.into_iter().try_for_each(|v| map.join_edges(v).map(drop))
            })
            .unwrap();
        assert_eq!(drawn(history.get()), drawn(&before), "{round}");
        assert!((history.get().value(tax, parcel).unwrap() - 100.0).abs() < 1e-9);
        assert!(history.undo() && history.get().validate().is_valid() && history.undo());
        assert_eq!(history.get(), &before, "{round}");
    }
}

/// For every map and line, the result is valid or nothing has changed; likewise for merging and joining.
#[test]
fn cuts_keep_every_rule_or_are_refused() {
    let mut programs = Gen::from_size_and_seed(14, 2026);
    let mut random = Random::seeded(2);
    let mut done = [0; 3];
    for _ in 0..300 {
        let mut runner = EditRunner::new(PlanarMap::new());
        for edit in EditProgram::arbitrary(&mut programs).0 {
            let _ = runner.step(&edit);
        }
        let mut map = runner.map().clone();
        for _ in 0..4 {
            let before = map.clone();
            let faces: Vec<FaceKey> = map.dcel().faces().map(|f| f.key()).collect();
            let [face, other] = [(); 2].map(|()| faces[random.choose(faces.len())]);
            let mut point = || Point::new(random.choose(900) as f64 / 100.0, random.choose(900) as f64 / 100.0);
            let (from, through) = (point(), point());
            let vertices: Vec<_> = map.dcel().vertices().map(|v| v.key()).collect();
            let vertex = vertices.get(random.choose(vertices.len().max(1))).copied().unwrap_or_default();
            let results = [map.split_face(face, from, through), map.merge_faces(face, other), map.join_edges(vertex)];
            assert!(map.validate().is_valid(), "{before:?} {face:?} {from:?} {through:?}");
            for (done, result) in done.iter_mut().zip(&results) {
                *done += usize::from(result.is_ok());
            }
            if results.iter().all(Result::is_err) {
                assert_eq!(map, before);
            }
        }
    }
    assert!(done.iter().all(|done| *done > 30), "{done:?}");
}

/// A comb with three teeth, a hole, and an edge that hangs into it.
#[test]
fn every_stretch_of_the_line_in_the_face_is_cut() {
    let mut map = PlanarMap::new();
    let comb = [[0.0, 0.0], [9.0, 0.0], [9.0, 5.0], [7.0, 5.0], [7.0, 2.0], [5.0, 2.0], [5.0, 5.0], [0.0, 5.0]];
    let face = ring(&mut map, &comb);
    let hole = ring(&mut map, &[[1.0, 3.0], [2.0, 3.0], [2.0, 4.0], [1.0, 4.0]]);
    let hanging = map.insert_segment([8.0, 0.0], [8.0, 4.5]).unwrap().way[0];
    let cut = map.split_face(face, [0.0, 3.1], [9.0, 3.7]).unwrap();
    // Left of the hole, right of it, and both sides of the hanging edge.
    assert_eq!((cut.vertices.len(), cut.edges_made.len(), cut.faces_split.len()), (8, 4, 3));
    assert!(map.validate().is_valid());
    let hanging = map.dcel().half_edge(hanging).unwrap();
    assert!([hanging.origin(), hanging.target()].iter().any(|v| v.degree() == 4));
    assert!(map.dcel().face(hole).is_ok());
    assert_eq!(map.split_face(hole, [0.0, 9.0], [1.0, 9.0]), Err(EditError::NotThrough(hole)));
}

/// The line passes through a corner, and along an axis, where the new vertex is exactly on the line.
#[test]
fn corners_and_lines_along_an_axis_are_met_exactly() {
    let mut map = PlanarMap::new();
    let face = ring(&mut map, &[[0.0, 0.0], [3.0, 0.1], [2.9, 3.3], [0.2, 3.1]]);
    let cut = map.split_face(face, [0.0, 0.0], [1.0, 1.0]).unwrap();
    assert_eq!(cut.vertices_made.len(), 1);
    let (kept, made) = cut.faces_split[0];
    for part in [kept, made] {
        let cut = map.split_face(part, [1.3, 0.0], [1.3, 7.0]).unwrap();
        assert!(cut.vertices.iter().all(|v| map[*v].x.to_bits() == 1.3_f64.to_bits()));
    }
    assert!(map.validate().is_valid());
}

#[test]
fn edits_that_would_pass_over_something_are_refused() {
    let mut map = PlanarMap::new();
    let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    let (outside, square) = ring.faces_split[0];
    let corner = ring.vertices[0];
    let stone = map.insert_point([1.0, 1.0]).unwrap().vertices[0];
    let far = map.insert_ring([[9.0, 0.0], [12.0, 0.0], [12.0, 1.0]]).unwrap();
    let before = map.clone();
    assert_eq!(map.join_edges(corner), Err(EditError::VertexInTheWay(stone)));
    // The third side exists.
    assert!(matches!(map.join_edges(far.vertices[0]), Err(EditError::EdgeInTheWay(_))));
    assert!(matches!(map.join_edges(stone), Err(EditError::Operator(OperatorError::DegreeNotTwo(_)))));
    let far = far.faces_split[0].1;
    assert_eq!(map.merge_faces(square, far), Err(EditError::NoEdgeBetween(square, far)));
    assert_eq!(map.merge_faces(square, square), Err(EditError::NoEdgeBetween(square, square)));
    assert_eq!(map.split_face(square, [1.0, 1.0], [1.0, 1.0]), Err(EditError::NoLength { x: 1.0, y: 1.0 }));
    assert_eq!(map, before);
    map.remove_vertex(stone).unwrap();
    let opened = map.merge_faces(square, outside).unwrap();
    assert_eq!((opened.faces_merged, opened.vertices_dropped.len()), (vec![(outside, square)], 4));
}

/// Half of the border of two joined edges belonged to a feature: it is no border afterwards.
#[test]
fn a_joined_edge_has_the_features_of_both() {
    let mut map = PlanarMap::new();
    let way = map.insert_segment([0.0, 0.0], [4.0, 0.0]).unwrap().way[0];
    let [road, river] = ["road", "river"].map(|name| map.add_feature(Some(name.into())));
    map.set_features_along(way, [road, river]).unwrap();
    let post = map.insert_point([1.0, 0.0]).unwrap();
    map.set_features_along(post.edges_split[0].1, [road]).unwrap();
    let joined = map.join_edges(post.vertices[0]).unwrap();
    assert!(map.features_along(joined.way[0]).unwrap().eq([road]));
}
