//! A first map: a triangle with a hole, an edge removed, and data kept beside the structure by key.

use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, OperatorError, RemovedEdge, SecondaryMap, Side, Split, VertexKey};

/// Adds a triangle in a face. Gives the half-edge that has the new face to its left, and the new face.
fn triangle(map: &mut Dcel, face: FaceKey) -> Result<(HalfEdgeKey, FaceKey), OperatorError> {
    let [a, b, c]: [VertexKey; 3] = [
        map.add_isolated_vertex(face)?.vertex,
        map.add_isolated_vertex(face)?.vertex,
        map.add_isolated_vertex(face)?.vertex,
    ];
    // An edge to an isolated vertex is a bridge: it splits nothing.
    let ab = map.connect(a, b, Split::default())?.half_edge;
    let ba = map.at(ab).twin().key();
    let bc = map.connect(ba, c, Split::default())?.half_edge;
    let cb = map.at(bc).twin().key();
    // The third edge joins two corners of one cycle. It splits the face, and the new face is to its left.
    let ca = map.connect(cb, ab, Split { new_face: Side::Left, inner: &[] })?;
    Ok((ca.half_edge, map.at(ca.half_edge).face().key()))
}

fn main() -> Result<(), OperatorError> {
    let mut map = Dcel::new();
    let mut names: SecondaryMap<FaceKey, String> = SecondaryMap::new();
    let outside = map.unbounded_face().key();
    names.insert(outside, "sea".to_owned());

    let (_, land) = triangle(&mut map, outside)?;
    names.insert(land, "land".to_owned());
    // A second triangle inside the first: its outer side is a hole in the land.
    let (shore, lake) = triangle(&mut map, land)?;
    names.insert(lake, "lake".to_owned());

    println!("{} vertices, {} edges", map.vertex_count(), map.edge_count());
    for face in map.faces() {
        let outer = face.outer().map_or(0, |boundary| boundary.half_edges().count());
        println!("  {}: {outer} half-edges around it, {} hole(s) in it", names[face.key()], face.inner_count());
    }
    let h = map.at(shore);
    println!("on this shore: {} to the left, {} to the right", names[h.face().key()], names[h.twin().face().key()]);
    assert_eq!((h.face().key(), h.twin().face().key()), (lake, land));

    // Without one of its edges, the lake and the land are one face. The operator says which key is gone.
    if let RemovedEdge::Merged { kept_face, dropped_face, .. } = map.remove_edge(shore)? {
        let gone = names.remove(dropped_face).unwrap_or_default();
        println!("the {gone} is now part of the {}", names[kept_face]);
        assert_eq!((kept_face, dropped_face), (land, lake));
    }
    // Keys are generational: the one of the lake is an error from now on, and never another face.
    println!("{}", map.face(lake).map(|face| face.key()).unwrap_err());

    let report = map.validate();
    println!("{report}");
    assert!(report.is_valid());
    Ok(())
}
