//! The steps of each operator on the values of attributes.
//!
//! An operator applies its steps after its checks and before it writes, with the keys that its new records will get. So when a
//! policy refuses, no link has changed.

use super::corner::CheckedCorner;
use super::flip::Turn;
use crate::dcel::access::OperatorError;
use crate::dcel::bulk::MergedFace;
use crate::dcel::structure::Dcel;
use crate::store::attributes::{Kind, Step};
use crate::store::{FaceSlot, HalfEdgeSlot, VertexSlot};
use alloc::vec;
use alloc::vec::Vec;
use slotmap::{Key, KeyData};

type Steps = Vec<(Kind, Step)>;

impl Dcel {
    /// Applies the steps of an operator to the values of attributes, if there are any. If a policy refuses, nothing changes.
    #[inline]
    pub(in crate::dcel) fn follow(&mut self, steps: impl FnOnce(&Self) -> Steps) -> Result<(), OperatorError> {
        if self.store.attributes().is_some() { self.change_values(steps) } else { Ok(()) }
    }

    #[cold]
    fn change_values(&mut self, steps: impl FnOnce(&Self) -> Steps) -> Result<(), OperatorError> {
        let steps = steps(self);
        self.attributes_to_change().map_or(Ok(()), |all| all.follow(&steps)).map_err(OperatorError::Refused)
    }

    fn vertex_data(&self, v: VertexSlot) -> KeyData {
        self.store.vertex_key(v).data()
    }

    fn face_data(&self, f: FaceSlot) -> KeyData {
        self.store.face_key(f).data()
    }

    fn half_edge_data(&self, h: HalfEdgeSlot) -> KeyData {
        self.store.half_edge_key(h).data()
    }

    /// The keys of a half-edge and its twin.
    fn sides(&self, h: HalfEdgeSlot) -> [KeyData; 2] {
        [h, self.store.twin(h)].map(|h| self.half_edge_data(h))
    }

    pub(super) fn steps_to_add_vertex(&self) -> Steps {
        vec![(Kind::Vertex, Step::Make(self.store.next_vertex().data()))]
    }

    pub(super) fn steps_to_remove_vertex(&self, v: VertexSlot) -> Steps {
        vec![(Kind::Vertex, Step::Drop(self.vertex_data(v)))]
    }

    /// `split` is the face that the edge splits, if any.
    pub(super) fn steps_to_connect(&self, corners: [CheckedCorner; 2], split: Option<FaceSlot>) -> Steps {
        let sides = self.store.next_edge().map(|h| h.data());
        let mut steps = of_edge(sides, Step::Make);
        steps.extend(corners.into_iter().zip(sides).map(|(corner, new)| self.corner_made(corner, new)));
        steps.extend(split.map(|f| (Kind::Face, Step::Split(self.face_data(f), self.store.next_face().data()))));
        steps
    }

    /// The step for a new corner next to an existing one.
    fn corner_made(&self, corner: CheckedCorner, new: KeyData) -> (Kind, Step) {
        let step = match corner {
            CheckedCorner::At(h) => Step::Split(self.half_edge_data(h), new),
            CheckedCorner::Isolated(..) => Step::Make(new),
        };
        (Kind::Corner, step)
    }

    /// `merged` are the faces that merge, the surviving one first.
    pub(super) fn steps_to_remove_edge(&self, n: HalfEdgeSlot, merged: Option<[FaceSlot; 2]>) -> Steps {
        let mut steps = of_edge(self.sides(n), Step::Drop);
        // Each corner merges into the next one clockwise.
        steps.extend(self.corners_joined(n, |h| self.store.next(self.store.twin(h))));
        let merged = merged.map(|faces| faces.map(|f| self.face_data(f)));
        steps.extend(merged.map(|[kept, dropped]| (Kind::Face, Step::Merge(kept, dropped))));
        steps
    }

    /// Merges the corners of a half-edge and its twin into the corners of the half-edges `after` them: first the corner that merges
    /// into the other one, if there is one. A corner is dropped if the corner after it is itself, or is already gone.
    fn corners_joined(&self, n: HalfEdgeSlot, after: impl Fn(HalfEdgeSlot) -> HalfEdgeSlot) -> [(Kind, Step); 2] {
        let t = self.store.twin(n);
        let [first, last] = if after(t) == n { [t, n] } else { [n, t] };
        [(first, [first; 2]), (last, [first, last])].map(|(h, gone)| {
            let (key, after) = (self.half_edge_data(h), after(h));
            let is_dropped = gone.contains(&after);
            (Kind::Corner, if is_dropped { Step::Drop(key) } else { Step::Merge(self.half_edge_data(after), key) })
        })
    }

    pub(super) fn steps_to_split_edge(&self, h: HalfEdgeSlot) -> Steps {
        let [a, b] = [h, self.store.twin(h)].map(|h| self.vertex_data(self.store.origin(h)));
        let ([h, t], [n, m]) = (self.sides(h), self.store.next_edge().map(|h| h.data()));
        vec![
            (Kind::Edge, Step::Split(h.min(t), n.min(m))),
            (Kind::HalfEdge, Step::Split(h, n)),
            (Kind::HalfEdge, Step::Split(t, m)),
            (Kind::Vertex, Step::Between(a, b, self.store.next_vertex().data())),
            // The twin leaves the new vertex, and the new half-edge on its side takes over its corner.
            (Kind::Corner, Step::Move(t, m)),
            (Kind::Corner, Step::Make(n)),
            (Kind::Corner, Step::Make(t)),
        ]
    }

    pub(super) fn steps_to_join(&self, h: HalfEdgeSlot, n: HalfEdgeSlot) -> Steps {
        let v = self.vertex_data(self.store.origin(n));
        let ([h, t], [n, m]) = (self.sides(h), self.sides(n));
        vec![
            (Kind::Edge, Step::Merge(h.min(t), n.min(m))),
            (Kind::HalfEdge, Step::Merge(h, n)),
            (Kind::HalfEdge, Step::Merge(t, m)),
            (Kind::Vertex, Step::Drop(v)),
            (Kind::Corner, Step::Drop(n)),
            (Kind::Corner, Step::Drop(t)),
            (Kind::Corner, Step::Move(m, t)),
        ]
    }

    pub(super) fn steps_to_split_vertex(&self, v: VertexSlot, [from, to]: [CheckedCorner; 2]) -> Steps {
        let [n, t] = self.store.next_edge().map(|h| h.data());
        let mut steps = of_edge([n, t], Step::Make);
        steps.push((Kind::Vertex, Step::Split(self.vertex_data(v), self.store.next_vertex().data())));
        // The twin is at a leaf if the given corners are equal.
        let is_leaf = matches!((from, to), (CheckedCorner::At(a), CheckedCorner::At(b)) if a == b);
        let at_twin = if is_leaf { (Kind::Corner, Step::Make(t)) } else { self.corner_made(from, t) };
        steps.extend([self.corner_made(to, n), at_twin]);
        steps
    }

    pub(super) fn steps_to_contract(&self, n: HalfEdgeSlot, [kept, dropped]: [VertexSlot; 2]) -> Steps {
        let mut steps = of_edge(self.sides(n), Step::Drop);
        steps.push((Kind::Vertex, Step::Merge(self.vertex_data(kept), self.vertex_data(dropped))));
        // At both ends, the corners on either side of the edge merge.
        steps.extend(self.corners_joined(n, |h| self.store.next(h)));
        steps
    }

    /// Both ends of an edge leave their corners and split others.
    pub(super) fn steps_to_flip(&self, [n, t]: [HalfEdgeSlot; 2], turn: Turn) -> Steps {
        let store = &self.store;
        let [after_n, after_t] = [store.next(n), store.next(t)];
        let entered = match turn {
            // Past the first half-edge of the other side, as they follow without the edge.
            Turn::CounterClockwise => [(after_t, t, after_n), (after_n, n, after_t)]
                .map(|(first, end, beyond)| if store.next(first) == end { beyond } else { store.next(first) }),
            Turn::Clockwise => [store.prev(n), store.prev(t)],
        };
        self.steps_to_turn([n, t], [after_t, after_n], entered)
    }

    /// A loop alone on one side leaves its corner and splits another one, for both half-edges.
    pub(super) fn steps_to_slide(&self, [lone, t]: [HalfEdgeSlot; 2], turn: Turn) -> Steps {
        let store = &self.store;
        let (before, after) = (store.prev(t), store.next(t));
        let first = match turn {
            Turn::CounterClockwise if before != after => store.next(after),
            Turn::CounterClockwise => after,
            Turn::Clockwise => before,
        };
        self.steps_to_turn([lone, t], [t, after], [first; 2])
    }

    fn steps_to_turn(&self, turned: [HalfEdgeSlot; 2], left: [HalfEdgeSlot; 2], entered: [HalfEdgeSlot; 2]) -> Steps {
        let steps_with = |others: [HalfEdgeSlot; 2], step: fn(KeyData, KeyData) -> Step| {
            others
                .into_iter()
                .zip(turned)
                .map(move |(other, h)| (Kind::Corner, step(self.half_edge_data(other), self.half_edge_data(h))))
        };
        steps_with(left, Step::Merge).chain(steps_with(entered, Step::Split)).collect()
    }

    /// The steps for removing vertices and half-edges, both marked by index. Faces are merged separately.
    pub(in crate::dcel) fn steps_to_retain(&self, vertex_goes: &[bool], goes: &[bool], merged: &[MergedFace]) -> Steps {
        let store = &self.store;
        let merged = merged.iter().map(|face| Step::Merge(face.kept.data(), face.dropped.data()));
        let mut steps: Steps = merged.map(|step| (Kind::Face, step)).collect();
        let gone: Vec<HalfEdgeSlot> =
            goes.iter().enumerate().filter(|(_, goes)| **goes).filter_map(|(i, _)| store.half_edge_at(i)).collect();
        let index = |h: HalfEdgeSlot| h.index();
        for h in &gone {
            if index(*h) < index(store.twin(*h)) {
                steps.extend(of_edge(self.sides(*h), Step::Drop));
            }
            // Corners counter-clockwise from a kept half-edge merge into its corner.
            let stays = store.next(store.twin(*h));
            let mut next = *h;
            while !goes[index(stays)] && goes[index(next)] {
                steps.push((Kind::Corner, Step::Merge(self.half_edge_data(stays), self.half_edge_data(next))));
                next = store.twin(store.prev(next));
            }
        }
        // Corners merged into others have no value any more.
        steps.extend(gone.iter().map(|h| (Kind::Corner, Step::Drop(self.half_edge_data(*h)))));
        let vertices = (0..vertex_goes.len()).filter(|v| vertex_goes[*v]).filter_map(|v| store.vertex_at(v));
        steps.extend(vertices.map(|v| (Kind::Vertex, Step::Drop(self.vertex_data(v)))));
        steps
    }
}

/// The same step for an edge and its two half-edges. The values of the edge are stored under the smaller key.
fn of_edge([n, t]: [KeyData; 2], step: fn(KeyData) -> Step) -> Steps {
    [(Kind::Edge, n.min(t)), (Kind::HalfEdge, n), (Kind::HalfEdge, t)].map(|(kind, key)| (kind, step(key))).into()
}
