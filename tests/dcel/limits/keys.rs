//! Invalid keys are refused, and issued keys work as slotmap keys.

use super::an_edge;
use std::collections::HashSet;
use twinedge::dcel::{BoundaryKey, Dcel, FaceKey, HalfEdgeKey, RemovedEdge, Split, StaleKey, VertexKey};
use twinedge::validate::Table;

/// All current keys of a structure.
fn all_keys(dcel: &Dcel) -> (Vec<VertexKey>, Vec<HalfEdgeKey>, Vec<BoundaryKey>, Vec<FaceKey>) {
    (
        dcel.vertices().map(twinedge::dcel::Vertex::key).collect(),
        dcel.half_edges().map(twinedge::dcel::HalfEdge::key).collect(),
        dcel.boundaries().map(twinedge::dcel::Boundary::key).collect(),
        dcel.faces().map(twinedge::dcel::Face::key).collect(),
    )
}

/// Two identically built structures share no key, and each refuses the other's keys by name.
#[test]
fn foreign_keys_are_refused() {
    let make = || {
        let mut dcel = Dcel::default();
        let h = an_edge(&mut dcel);
        dcel.connect(h, h, Split::default()).unwrap();
        dcel
    };
    let (mut one, other) = (make(), make());
    let before = Table::copy_of(&one);
    let (vertices, half_edges, boundaries, faces) = all_keys(&other);
    for v in vertices {
        assert_eq!(one.vertex(v).unwrap_err(), StaleKey::Vertex(v));
        assert_eq!(one.remove_isolated_vertex(v), Err(StaleKey::Vertex(v).into()));
    }
    for h in half_edges {
        assert_eq!(one.half_edge(h).unwrap_err(), StaleKey::HalfEdge(h));
        assert_eq!(one.remove_edge(h), Err(StaleKey::HalfEdge(h).into()));
        assert_eq!(one.connect(h, h, Split::default()), Err(StaleKey::HalfEdge(h).into()));
    }
    for b in boundaries {
        assert_eq!(one.boundary(b).unwrap_err(), StaleKey::Boundary(b));
        assert_eq!(one.move_inner(b, one.unbounded_face().key()), Err(StaleKey::Boundary(b).into()));
    }
    for f in faces {
        assert_eq!(one.face(f).unwrap_err(), StaleKey::Face(f));
        assert_eq!(one.add_isolated_vertex(f), Err(StaleKey::Face(f).into()));
    }
    assert_eq!(Table::copy_of(&one), before);
}

/// A reused slot gets a new key, and all old keys stay refused.
#[test]
fn used_slots_get_new_keys() {
    let mut dcel = Dcel::default();
    let outside = dcel.unbounded_face().key();
    let kept = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let (mut vertices, mut half_edges, mut boundaries, mut faces) =
        (HashSet::new(), HashSet::new(), HashSet::new(), HashSet::new());
    let mut slots = HashSet::new();
    for _ in 0..50 {
        let h = dcel.connect(kept, kept, Split::default()).unwrap();
        let (a, t) = (dcel.half_edge(h.half_edge).unwrap(), dcel.half_edge(h.half_edge).unwrap().twin());
        let face = dcel.face(h.new_face().unwrap()).unwrap();
        slots.insert((a.index().min(t.index()), face.index()));
        assert!(half_edges.insert(a.key()) && half_edges.insert(t.key()) && faces.insert(face.key()));
        let Ok(RemovedEdge::Merged { dropped, .. }) = dcel.remove_edge(h.half_edge) else { panic!() };
        assert!(boundaries.insert(dropped));
        let added = dcel.add_isolated_vertex(outside).unwrap();
        assert!(vertices.insert(added.vertex) && boundaries.insert(added.boundary));
        dcel.remove_isolated_vertex(added.vertex).unwrap();
        assert!(vertices.iter().all(|v| dcel.vertex(*v).is_err()));
        assert!(half_edges.iter().all(|h| dcel.half_edge(*h).is_err()));
        assert!(boundaries.iter().all(|b| dcel.boundary(*b).is_err()));
        assert!(faces.iter().all(|f| dcel.face(*f).is_err()));
    }
    assert_eq!(slots.len(), 1, "the memory is used again");
    assert!(dcel.vertex(kept).is_ok() && dcel.face(outside).is_ok());
}

/// A key made of arbitrary bits names a record only if it is the record's key.
#[test]
fn only_keys_that_were_issued_are_accepted() {
    let mut dcel = Dcel::default();
    let h = an_edge(&mut dcel);
    dcel.connect(h, h, Split::default()).unwrap();
    let (vertices, half_edges, boundaries, faces) = all_keys(&dcel);
    let generation = slotmap::Key::data(&h).as_ffi() >> 32;
    let slots = (0..300).chain([u64::from(u32::MAX) - 1, u64::from(u32::MAX)]);
    let generations =
        [generation, 1, generation.wrapping_add(2) & 0xFFFF_FFFF, generation ^ 0x8000_0000, 0, 0xFFFF_FFFF];
    for bits in slots.flat_map(|slot| generations.map(|generation| generation << 32 | slot)) {
        let data = slotmap::KeyData::from_ffi(bits);
        assert_eq!(dcel.vertex(data.into()).is_ok(), vertices.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.half_edge(data.into()).is_ok(), half_edges.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.boundary(data.into()).is_ok(), boundaries.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.face(data.into()).is_ok(), faces.contains(&data.into()), "{data:?}");
    }
}

/// Data stored by key is found, and iteration returns all of it.
#[test]
fn secondary_maps_take_the_keys() {
    let mut dcel = Dcel::default();
    an_edge(&mut dcel);
    let (vertices, half_edges, boundaries, faces) = all_keys(&dcel);
    let of_vertices: slotmap::SecondaryMap<VertexKey, ()> = vertices.iter().map(|v| (*v, ())).collect();
    let of_half_edges: slotmap::SecondaryMap<HalfEdgeKey, ()> = half_edges.iter().map(|h| (*h, ())).collect();
    let of_boundaries: slotmap::SecondaryMap<BoundaryKey, ()> = boundaries.iter().map(|b| (*b, ())).collect();
    let of_faces: slotmap::SecondaryMap<FaceKey, ()> = faces.iter().map(|f| (*f, ())).collect();
    assert_eq!(of_vertices.keys().collect::<Vec<_>>(), vertices);
    assert_eq!(of_half_edges.keys().collect::<Vec<_>>(), half_edges);
    assert_eq!(of_boundaries.keys().collect::<Vec<_>>(), boundaries);
    assert_eq!(of_faces.keys().collect::<Vec<_>>(), faces);
}

/// Changes of a copy and of the original are independent.
#[test]
fn copies_are_apart() {
    let mut dcel = Dcel::default();
    let h = an_edge(&mut dcel);
    dcel.connect(h, h, Split::default()).unwrap();
    let gone = dcel.split_edge(h).unwrap().half_edge;
    dcel.join_edges(h).unwrap();
    let before = Table::copy_of(&dcel);
    let mut copy = dcel.clone();
    assert_eq!(Table::copy_of(&copy), before);
    assert_eq!(all_keys(&copy), all_keys(&dcel));
    assert!(copy.half_edge(gone).is_err());
    copy.split_edge(h).unwrap();
    copy.contract_edge(h).unwrap();
    assert_eq!(Table::copy_of(&dcel), before);
    let after = Table::copy_of(&copy);
    drop(dcel);
    assert_eq!(Table::copy_of(&copy), after);
    assert!(copy.validate().is_valid());
}
