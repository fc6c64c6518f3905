//! The homework of the tutorials on DCELs: every vertex, edge and neighbour of a given face; no leaks; structures are values.

use petgraph::visit::IntoNeighbors;
use std::collections::BTreeSet;
use twinedge::dcel::{Dcel, Face, FaceKey};
use twinedge_algorithm::convex::decompose;
use twinedge_algorithm::dual::Dual;
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;

/// Two triangles side by side, and a triangle in a hole of the first, without contact:
///
/// ```text
///   3 ─────── 2
///   │  f   ╱  │
///   │ △ ╱  g  │
///   0 ─────── 1
/// ```
fn two_triangles() -> (PlanarMap, Vec<FaceKey>) {
    let mut map = PlanarMap::new();
    map.insert_ring([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]]).unwrap();
    map.insert_segment([0.0, 0.0], [9.0, 9.0]).unwrap();
    map.insert_ring([[1.0, 4.0], [2.0, 4.0], [1.0, 5.0]]).unwrap();
    let faces = map.dcel().faces().map(Face::key).collect();
    (map, faces)
}

fn corners(map: &PlanarMap, face: FaceKey) -> BTreeSet<(i32, i32)> {
    let face = map.dcel().face(face).unwrap();
    let at = |p: Point| (p.x as i32, p.y as i32);
    face.half_edges().map(|h| at(map.position(h.origin().key()).unwrap())).collect()
}

#[test]
fn every_vertex_edge_and_neighbour_of_a_face() {
    let (map, faces) = two_triangles();
    let hole = BTreeSet::from([(1, 4), (2, 4), (1, 5)]);
    let upper = BTreeSet::from([(0, 0), (9, 9), (0, 9)]);
    let has_hole = |face: &&FaceKey| {
        let face = map.dcel().face(**face).unwrap();
        !face.is_unbounded() && face.inner_count() == 1
    };
    let with_hole = *faces.iter().find(has_hole).unwrap();
    // Vertices: on the outer boundary and on the hole.
    assert_eq!(corners(&map, with_hole), upper.union(&hole).copied().collect());
    // Edges: six half-edges have the face to their left, each of another edge.
    let face = map.dcel().face(with_hole).unwrap();
    let edges: BTreeSet<usize> = face.half_edges().map(|h| h.index() / 2).collect();
    assert_eq!((face.half_edges().count(), edges.len()), (6, 6));
    assert!(face.half_edges().all(|h| h.face() == face && h.twin().face() != face));
    // Neighbours: the other triangle, the one in the hole, the outside; confirmed by the dual.
    let neighbours: BTreeSet<FaceKey> = face.neighbours().map(Face::key).collect();
    assert_eq!(neighbours, faces.iter().copied().filter(|other| *other != with_hole).collect());
    assert_eq!(Dual::new(&map).neighbors(with_hole).collect::<BTreeSet<_>>(), neighbours);
}

/// After drawing and removing, no record is left.
#[test]
fn nothing_leaks() {
    let mut map = PlanarMap::new();
    let counts = |dcel: &Dcel| {
        [dcel.vertex_count(), dcel.edge_count(), dcel.boundary_count(), dcel.face_count(), dcel.half_edges().count()]
    };
    for round in 0..50 {
        let side = f64::from(round % 7 + 2);
        let ring = [[0.0, 0.0], [side, 0.0], [side, side], [1.0, 1.0], [0.0, side]];
        let face = map.insert_ring(ring).unwrap().faces_split[0].1;
        decompose(&mut map, [face]).unwrap();
        let vertices: Vec<_> = map.dcel().vertices().map(|v| v.key()).collect();
        for vertex in vertices {
            map.remove_vertex(vertex).unwrap();
        }
        assert_eq!(counts(map.dcel()), [0, 0, 0, 1, 0]);
        assert!(map.validate().is_valid());
    }
    // Slots are reused: the columns have not grown with the rounds.
    assert!(map.dcel().vertex_at(64).is_none() && map.insert_point([1.0, 1.0]).is_ok());
    assert!(map.dcel().vertices().all(|v| v.index() < 64));
}

/// A clone is another structure; a structure moves and drops like a number.
#[test]
fn structures_are_values() {
    fn is_value<T: Clone + Send + Sync + Default + std::fmt::Debug + 'static>() {}
    is_value::<PlanarMap>();
    is_value::<Dcel>();
    let (map, faces) = two_triangles();
    let mut other = map.clone();
    decompose(&mut other, faces.iter().copied().filter(|face| *face != map.dcel().unbounded_face().key())).unwrap();
    assert!(other.dcel().edge_count() > map.dcel().edge_count());
    assert_eq!((map.dcel().edge_count(), map.dcel().face_count()), (8, 4));
    let moved = std::thread::spawn(move || (other.validate().is_valid(), other)).join().unwrap();
    assert!(moved.0 && map.validate().is_valid());
}
