//! Unlinks edges.

use crate::dcel::structure::Dcel;
use crate::store::{HalfEdgeSlot, VertexLink};

impl Dcel {
    /// Unlinks an edge from its cycles and rotations. Its record and the labels stay. If a vertex loses its last half-edge, appends
    /// that half-edge to `last`. O(1).
    pub(super) fn splice_out(&mut self, n: HalfEdgeSlot, last: &mut impl Extend<HalfEdgeSlot>) {
        let store = &mut self.store;
        let t = store.twin(n);
        for h in [n, t] {
            let v = store.origin(h);
            if store.vertex_link(v) == VertexLink::Leaving(h) {
                // The next half-edge clockwise, skipping the other half of a loop.
                let after = store.next(store.twin(h));
                let after = if after == store.twin(h) { store.next(h) } else { after };
                if after == h {
                    last.extend([h]);
                } else {
                    store.set_vertex_link(v, VertexLink::Leaving(after));
                }
            }
        }
        let (before_n, after_n) = (store.prev(n), store.next(n));
        let (before_t, after_t) = (store.prev(t), store.next(t));
        if after_n == n {
            if after_t != t {
                store.join(before_t, after_t);
            }
        } else if after_t == t {
            store.join(before_n, after_n);
        } else {
            if after_t != n {
                store.join(before_n, after_t);
            }
            if after_n != t {
                store.join(before_t, after_n);
            }
        }
    }
}
