//! The memory of a history depends on the written values, not on the size of the map.

use crate::counting::{LIVE_BYTES, REQUESTS};
use twinedge::dcel::{Dcel, History};

const CHANGES: usize = 1 << 15;

/// A history of a map with `vertices` isolated vertices and some spare room.
fn history(vertices: usize) -> History {
    let mut dcel = Dcel::with_capacity(vertices + CHANGES, 0);
    let outside = dcel.unbounded_face().key();
    for _ in 0..vertices {
        dcel.add_isolated_vertex(outside).unwrap();
    }
    History::new(dcel)
}

/// The bytes per change that a history takes.
fn bytes_per_change(history: &mut History) -> isize {
    let outside = history.get().unbounded_face().key();
    let start = LIVE_BYTES.get();
    for _ in 0..CHANGES / 2 {
        let v = history.change("add a vertex", |dcel| dcel.add_isolated_vertex(outside)).unwrap().vertex;
        history.change("remove it", |dcel| dcel.remove_isolated_vertex(v)).unwrap();
    }
    (LIVE_BYTES.get() - start) / CHANGES.cast_signed()
}

#[test]
fn a_change_takes_64_bytes_beside_what_it_writes() {
    // A vertex, a boundary component and a list entry are added; four links and these records are removed, and two links are
    // written.
    let entries = isize::midpoint(3, 9) * 12;
    for vertices in [0, 10_000] {
        let taken = bytes_per_change(&mut history(vertices));
        // The logs may have twice the required capacity; here the number of changes is a power of two.
        assert!(taken <= 64 + 2 * entries, "{taken} bytes");
    }
}

#[test]
fn undoing_and_redoing_ask_for_no_memory() {
    let mut history = history(10);
    bytes_per_change(&mut history);
    let before = (REQUESTS.get(), LIVE_BYTES.get());
    while history.undo() {}
    while history.redo() {}
    assert_eq!((REQUESTS.get(), LIVE_BYTES.get()), before);
}
