//! Every function that takes a key refuses invalid keys (of removed records, of another structure, of nothing at all),
//! and changes nothing. Issued keys work as slotmap keys.

use crate::support::tracked::{Keys, Tracked};
use std::collections::BTreeSet;
use twinedge::dcel::{BoundaryKey, Dcel, FaceKey, HalfEdgeKey, Side, Split, StaleKey, Turn, VertexKey};

const LEFT: Split<'_> = Split { new_face: Side::Left, inner: &[] };

/// Calls every function that takes a key with a bad key, and valid keys for the other arguments.
fn refused_by_every_function(t: &mut Tracked, good: &Keys, bad: &Keys) {
    let b = *bad.boundaries.first().unwrap();
    let f = *bad.faces.first().unwrap();
    let h = *bad.half_edges.first().unwrap();
    let v = *bad.vertices.first().unwrap();
    let (stale_b, stale_f) = (StaleKey::Boundary(b), StaleKey::Face(f));
    let (stale_h, stale_v) = (StaleKey::HalfEdge(h), StaleKey::Vertex(v));
    assert_eq!(t.map.vertex(v).unwrap_err(), stale_v);
    assert_eq!(t.map.half_edge(h).unwrap_err(), stale_h);
    assert_eq!(t.map.boundary(b).unwrap_err(), stale_b);
    assert_eq!(t.map.face(f).unwrap_err(), stale_f);

    let good_h = *good.half_edges.first().unwrap();
    let good_b = *good.boundaries.iter().find(|b| !t.map.boundary(**b).unwrap().is_outer()).unwrap();
    let good_f = t.outside();
    assert_eq!(t.refuses(|map| map.add_isolated_vertex(f)), stale_f.into());
    assert_eq!(t.refuses(|map| map.remove_isolated_vertex(v)), stale_v.into());
    assert_eq!(t.refuses(|map| map.connect(h, good_h, LEFT)), stale_h.into());
    assert_eq!(t.refuses(|map| map.connect(good_h, h, LEFT)), stale_h.into());
    assert_eq!(t.refuses(|map| map.connect(v, good_h, LEFT)), stale_v.into());
    assert_eq!(t.refuses(|map| map.connect(good_h, v, LEFT)), stale_v.into());
    assert_eq!(t.refuses(|map| map.split_vertex(h, good_h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.split_vertex(good_h, h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.split_vertex(v, v)), stale_v.into());
    assert_eq!(t.refuses(|map| map.remove_edge(h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.split_edge(h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.join_edges(h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.contract_edge(h)), stale_h.into());
    assert_eq!(t.refuses(|map| map.flip_edge(h, Turn::Clockwise)), stale_h.into());
    assert_eq!(t.refuses(|map| map.move_inner(b, good_f)), stale_b.into());
    assert_eq!(t.refuses(|map| map.move_inner(good_b, f)), stale_f.into());
    // For an edge that splits a face, and for a bridge, which needs no list.
    let split = Split { inner: &[good_b, b], ..LEFT };
    assert_eq!(t.refuses(|map| map.connect(good_h, good_h, split)), stale_b.into());
    let lone = *good.vertices.iter().find(|v| t.map.vertex(**v).unwrap().isolated().is_some()).unwrap();
    let beside = t.map.vertex(lone).unwrap().isolated().unwrap().face().outer().unwrap().start().unwrap().key();
    assert_eq!(t.refuses(|map| map.connect(beside, lone, Split { inner: &[b], ..LEFT })), stale_b.into());
}

/// A structure with all kinds of elements, always with the same history.
fn sample() -> Tracked {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let inside = t.face(sides[0]);
    t.add(inside);
    t
}

#[test]
fn keys_of_what_is_gone_are_refused_by_every_function() {
    let mut t = sample();
    let outside = t.outside();
    let before = Keys::of(&t.map);
    let sides = t.polygon(outside, 2);
    let gone = Keys::of(&t.map);
    let (a, b) = (t.origin(sides[0]), t.origin(sides[1]));
    t.remove_edge(sides[0]);
    t.remove_edge(sides[1]);
    t.remove(a);
    t.remove(b);
    let bad = gone.without(&before);
    assert_eq!(Keys::of(&t.map), before);
    refused_by_every_function(&mut t, &before, &bad);
    // Nor if other records have taken their slots.
    t.polygon(outside, 2);
    assert!(bad.are_stale(&t.map));
    refused_by_every_function(&mut t, &before, &bad);
}

#[test]
fn keys_of_another_structure_are_refused_by_every_function() {
    let (mut t, other) = (sample(), sample());
    let (good, bad) = (Keys::of(&t.map), Keys::of(&other.map));
    assert!(bad.are_stale(&t.map));
    refused_by_every_function(&mut t, &good, &bad);
    let unbounded = other.map.unbounded_face().key();
    assert_eq!(t.refuses(|map| map.add_isolated_vertex(unbounded)), StaleKey::Face(unbounded).into());
}

#[test]
fn null_keys_are_refused_by_every_function() {
    let mut t = sample();
    let good = Keys::of(&t.map);
    let bad = Keys {
        vertices: BTreeSet::from([VertexKey::default()]),
        half_edges: BTreeSet::from([HalfEdgeKey::default()]),
        boundaries: BTreeSet::from([BoundaryKey::default()]),
        faces: BTreeSet::from([FaceKey::default()]),
    };
    refused_by_every_function(&mut t, &good, &bad);
}

/// `Dcel::at` panics on a key of another structure.
macro_rules! at_panics {
    ($($name:ident $keys:ident $expected:literal;)*) => {$(
        #[test]
        #[should_panic(expected = $expected)]
        fn $name() {
            let stale = *Keys::of(&sample().map).$keys.first().unwrap();
            let _ = sample().map.at(stale);
        }
    )*};
}

at_panics! {
    at_panics_at_a_stale_vertex vertices "names no vertex of this structure (any more)";
    at_panics_at_a_stale_half_edge half_edges "names no half-edge of this structure (any more)";
    at_panics_at_a_stale_boundary_component boundaries "names no boundary component of this structure (any more)";
    at_panics_at_a_stale_face faces "names no face of this structure (any more)";
}

#[test]
fn errors_name_the_keys() {
    let mut map = Dcel::new();
    let f = map.unbounded_face().key();
    let v = map.add_isolated_vertex(f).unwrap().vertex;
    let h = map.connect(v, v, LEFT).unwrap().half_edge;
    let error = map.contract_edge(h).unwrap_err();
    assert_eq!(error.to_string(), format!("{h:?} is a loop"));
    let error = map.remove_isolated_vertex(v).unwrap_err();
    assert_eq!(error.to_string(), format!("{v:?} is not isolated"));
    let null = FaceKey::default();
    let error = map.add_isolated_vertex(null).unwrap_err();
    assert_eq!(error.to_string(), format!("{null:?} names no face of this structure (any more)"));
}

/// A key made of arbitrary bits names a record only if it is the record's key.
#[test]
fn only_keys_that_were_issued_are_accepted() {
    let dcel = sample().map;
    let Keys { vertices, half_edges, boundaries, faces } = Keys::of(&dcel);
    let generation = slotmap::Key::data(half_edges.first().unwrap()).as_ffi() >> 32;
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
    let Keys { vertices, half_edges, boundaries, faces } = Keys::of(&sample().map);
    let of_vertices: slotmap::SecondaryMap<VertexKey, ()> = vertices.iter().map(|v| (*v, ())).collect();
    let of_half_edges: slotmap::SecondaryMap<HalfEdgeKey, ()> = half_edges.iter().map(|h| (*h, ())).collect();
    let of_boundaries: slotmap::SecondaryMap<BoundaryKey, ()> = boundaries.iter().map(|b| (*b, ())).collect();
    let of_faces: slotmap::SecondaryMap<FaceKey, ()> = faces.iter().map(|f| (*f, ())).collect();
    assert_eq!(of_vertices.keys().collect::<BTreeSet<_>>(), vertices);
    assert_eq!(of_half_edges.keys().collect::<BTreeSet<_>>(), half_edges);
    assert_eq!(of_boundaries.keys().collect::<BTreeSet<_>>(), boundaries);
    assert_eq!(of_faces.keys().collect::<BTreeSet<_>>(), faces);
}

#[test]
fn slots_are_used_again() {
    let mut t = sample();
    let outside = t.outside();
    let slots = |map: &Dcel| [map.vertex_slots(), map.half_edge_slots(), map.boundary_slots(), map.face_slots()];
    let mut after = vec![];
    for _ in 0..50 {
        let v = t.add(outside).vertex;
        let h = t.connect(v, v, LEFT).half_edge;
        t.remove_edge(h);
        t.remove(v);
        after.push(slots(&t.map));
    }
    assert!(after.iter().all(|slots| *slots == after[0]));
}
