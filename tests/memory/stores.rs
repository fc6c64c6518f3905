//! Memory requests of a structure: all memory is freed on drop, memory of removed records is reused, and with reserved
//! room nothing is requested.

use crate::counting::{LIVE, LIVE_BYTES, REQUESTS};
use twinedge::dcel::{Dcel, Split};

/// A wheel of `n` spokes around a vertex, a hole with an island in each sector, taken apart halfway.
fn wheel(n: usize) -> Dcel {
    let mut dcel: Dcel = Dcel::default();
    let outside = dcel.unbounded_face().key();
    let hub = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let first = dcel.connect(hub, hub, Split::default()).unwrap().half_edge;
    for i in 0..n {
        let spoke = dcel.split_vertex(first, first).unwrap().half_edge;
        let made = dcel.connect(first, first, Split::default()).unwrap();
        for _ in 0..i % 5 {
            dcel.add_isolated_vertex(made.new_face().unwrap()).unwrap();
        }
        if i % 3 == 0 {
            dcel.remove_edge(made.half_edge).unwrap();
        }
        if i % 4 == 0 {
            dcel.contract_edge(spoke).unwrap();
        }
    }
    assert!(dcel.validate().is_valid());
    dcel
}

#[test]
fn all_that_is_allocated_is_freed() {
    let before = (LIVE.get(), LIVE_BYTES.get());
    let dcel = wheel(200);
    let copy = dcel.clone();
    let held = LIVE_BYTES.get() - before.1;
    let records = dcel.vertex_count() + dcel.half_edge_count() + dcel.boundary_count() + dcel.face_count();
    assert!(held > 2 * 4 * records.cast_signed(), "{held} bytes are held for twice {records} records");
    drop(dcel);
    assert!(copy.validate().is_valid());
    drop(copy);
    assert_eq!((LIVE.get(), LIVE_BYTES.get()), before);
}

#[test]
fn records_that_were_removed_are_used_again() {
    let mut dcel = wheel(20);
    let outside = dcel.unbounded_face().key();
    let churn = |dcel: &mut Dcel| {
        let v = dcel.add_isolated_vertex(outside).unwrap().vertex;
        let h = dcel.connect(v, v, Split::default()).unwrap().half_edge;
        dcel.split_edge(h).unwrap();
        dcel.join_edges(h).unwrap();
        dcel.remove_edge(h).unwrap();
        dcel.remove_isolated_vertex(v).unwrap();
    };
    churn(&mut dcel);
    let before = LIVE_BYTES.get();
    for _ in 0..1000 {
        churn(&mut dcel);
    }
    assert_eq!(LIVE_BYTES.get(), before);
}

/// Makes a ring of `vertices` vertices and then loops, up to `edges` edges, and counts the memory requests.
fn grow(dcel: &mut Dcel, vertices: usize, edges: usize) -> usize {
    let outside = dcel.unbounded_face().key();
    let root = dcel.add_isolated_vertex(outside).unwrap().vertex;
    // Counting starts here, as the list of a face's inner boundary components is not a column.
    let before = REQUESTS.get();
    let ring = dcel.connect(root, root, Split::default()).unwrap().half_edge;
    for _ in 1..vertices {
        dcel.split_edge(ring).unwrap();
    }
    for _ in vertices..edges {
        dcel.connect(ring, ring, Split::default()).unwrap();
    }
    assert!(dcel.validate().is_valid());
    REQUESTS.get() - before
}

#[test]
fn where_room_was_made_for_a_connected_map_no_more_is_asked_for() {
    // The validation at the end requests some memory regardless of the room.
    let validation = grow(&mut Dcel::with_capacity(1, 1), 1, 1);
    for (vertices, edges) in [(1, 300), (300, 300), (100, 300), (299, 300)] {
        let mut dcel = Dcel::with_capacity(vertices, edges);
        assert_eq!(dcel.half_edge_count() + dcel.vertex_count(), 0);
        assert_eq!(grow(&mut dcel, vertices, edges), validation, "{vertices} vertices, {edges} edges");
        assert!(grow(&mut Dcel::new(), vertices, edges) > validation + 20);
    }
}

#[test]
fn capacity_that_no_machine_has_is_best_effort() {
    for (vertices, edges) in [(usize::MAX, 0), (0, usize::MAX), (usize::MAX, usize::MAX), (0, usize::MAX / 2)] {
        let mut dcel = Dcel::with_capacity(vertices, edges);
        assert_eq!(dcel.face_count(), 1);
        grow(&mut dcel, 10, 20);
        assert_eq!((dcel.vertex_count(), dcel.half_edge_count(), dcel.face_count()), (10, 40, 12));
    }
}

#[test]
fn a_record_takes_as_many_bytes_as_the_documentation_says() {
    const EACH: usize = 1000;
    let columns = |vertices: usize, edges: usize, faces: usize, boundaries: usize| {
        8 * (vertices + 1) + 36 * (edges + 1) + 12 * (faces + 1) + 16 * (boundaries + 1)
    };
    let before = LIVE_BYTES.get();
    // Equal numbers of faces and boundary components, plus one for the outside.
    let dcel = Dcel::with_capacity(EACH, 2 * EACH);
    let held = (LIVE_BYTES.get() - before).cast_unsigned();
    let stated = columns(EACH, 2 * EACH, EACH + 2, EACH + 2);
    assert!(held <= stated && held + 64 >= stated, "{held} bytes, {stated} stated");
    drop(dcel);

    // A single inner boundary component is stored in the column.
    let mut dcel = Dcel::with_capacity(EACH, EACH);
    let outside = dcel.unbounded_face().key();
    let before = LIVE_BYTES.get();
    let vertex = dcel.add_isolated_vertex(outside).unwrap().vertex;
    assert_eq!(LIVE_BYTES.get(), before);
    let others: Vec<_> = (0..9).map(|_| dcel.add_isolated_vertex(outside).unwrap().vertex).collect();
    assert!(LIVE_BYTES.get() > before);
    for vertex in others.into_iter().chain([vertex]) {
        dcel.remove_isolated_vertex(vertex).unwrap();
    }
    assert!(dcel.validate().is_valid());
}
