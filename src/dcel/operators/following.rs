//! Attribute values that follow operators: each operator announces its steps before writing, and settles the new records
//! afterwards.

use super::corner::CheckedCorner;
use super::flip::Turn;
use crate::dcel::access::OperatorError;
use crate::dcel::bulk::MergedFace;
use crate::dcel::structure::Dcel;
use crate::store::attributes::{Kind, Step};
use crate::store::{FaceSlot, HalfEdgeSlot, VertexSlot};
use alloc::vec::Vec;
use slotmap::{Key, KeyData};

type Steps = Vec<(Kind, Step)>;

#[derive(Clone, Copy)]
struct EdgeData {
    edge: KeyData,
    sides: [KeyData; 2],
}

impl Dcel {
    #[inline]
    pub(in crate::dcel) fn has_attributes(&self) -> bool {
        self.store.attributes().is_some()
    }

    pub(in crate::dcel) fn announce(&mut self, steps: &[(Kind, Step)]) -> Result<(), OperatorError> {
        let Some(attributes) = self.attributes_to_change() else { return Ok(()) };
        attributes.announce(steps).map_err(OperatorError::Refused)
    }

    fn settle(&mut self, made: &[(Kind, KeyData)]) {
        if let Some(attributes) = self.store.attributes_mut() {
            attributes.settle(made);
        }
    }

    fn half_edge_data(&self, h: HalfEdgeSlot) -> KeyData {
        self.store.half_edge_key(h).data()
    }

    fn vertex_data(&self, v: VertexSlot) -> KeyData {
        self.store.vertex_key(v).data()
    }

    fn face_data(&self, f: FaceSlot) -> KeyData {
        self.store.face_key(f).data()
    }

    fn edge_data(&self, h: HalfEdgeSlot) -> EdgeData {
        let t = self.store.twin(h);
        let sides = [h, t].map(|h| self.half_edge_data(h));
        let is_first = h.index() < t.index();
        EdgeData { edge: sides[usize::from(!is_first)], sides }
    }

    #[cold]
    pub(super) fn announce_vertex(&mut self) -> Result<(), OperatorError> {
        self.announce(&[(Kind::Vertex, Step::Make)])
    }

    #[cold]
    pub(super) fn settle_vertex(&mut self, v: VertexSlot) {
        self.settle(&[(Kind::Vertex, self.vertex_data(v))]);
    }

    #[cold]
    pub(super) fn announce_no_vertex(&mut self, v: VertexSlot) -> Result<(), OperatorError> {
        self.announce(&[(Kind::Vertex, Step::Drop(self.vertex_data(v)))])
    }

    /// `split` is the face that the edge splits, if any.
    #[cold]
    pub(super) fn announce_connected(
        &mut self,
        corners: [CheckedCorner; 2],
        split: Option<FaceSlot>,
    ) -> Result<(), OperatorError> {
        let mut steps = edge_made();
        for corner in corners {
            steps.push((Kind::Corner, self.corner_made(corner)));
        }
        steps.extend(split.map(|f| (Kind::Face, Step::Split(self.face_data(f)))));
        self.announce(&steps)
    }

    #[cold]
    pub(super) fn settle_connected(&mut self, n: HalfEdgeSlot, face: Option<FaceSlot>) {
        let mut made = self.made_edge(n);
        made.extend(face.map(|f| (Kind::Face, self.face_data(f))));
        self.settle(&made);
    }

    /// The step for a new corner next to an existing one.
    fn corner_made(&self, corner: CheckedCorner) -> Step {
        match corner {
            CheckedCorner::At(h) => Step::Split(self.half_edge_data(h)),
            CheckedCorner::Isolated(..) => Step::Make,
        }
    }

    fn made_edge(&self, n: HalfEdgeSlot) -> Vec<(Kind, KeyData)> {
        let EdgeData { edge, sides: [n, t] } = self.edge_data(n);
        [(Kind::Edge, edge), (Kind::HalfEdge, n), (Kind::HalfEdge, t), (Kind::Corner, n), (Kind::Corner, t)].into()
    }

    /// `merged` are the faces that merge, the surviving one first.
    #[cold]
    pub(super) fn announce_removed(
        &mut self,
        n: HalfEdgeSlot,
        merged: Option<[FaceSlot; 2]>,
    ) -> Result<(), OperatorError> {
        let t = self.store.twin(n);
        let mut steps = self.edge_dropped(n);
        // Each corner merges into the next one clockwise. If that one is also removed, it comes later.
        let sides = if self.store.next(n) == n { [t, n] } else { [n, t] };
        let mut gone = None;
        for h in sides {
            let after = self.store.next(self.store.twin(h));
            steps.push((Kind::Corner, self.corner_joined(h, (after != h && Some(after) != gone).then_some(after))));
            gone = Some(h);
        }
        let merged = merged.map(|faces| faces.map(|f| self.face_data(f)));
        steps.extend(merged.map(|[kept, dropped]| (Kind::Face, Step::Merge(kept, dropped))));
        self.announce(&steps)
    }

    /// The step that merges the corner of a half-edge into another one, or drops it.
    fn corner_joined(&self, h: HalfEdgeSlot, other: Option<HalfEdgeSlot>) -> Step {
        let gone = self.half_edge_data(h);
        other.map_or(Step::Drop(gone), |other| Step::Merge(self.half_edge_data(other), gone))
    }

    fn edge_dropped(&self, n: HalfEdgeSlot) -> Steps {
        let EdgeData { edge, sides: [n, t] } = self.edge_data(n);
        [(Kind::Edge, edge), (Kind::HalfEdge, n), (Kind::HalfEdge, t)].map(|(kind, key)| (kind, Step::Drop(key))).into()
    }

    #[cold]
    pub(super) fn announce_split_edge(&mut self, h: HalfEdgeSlot) -> Result<(), OperatorError> {
        let EdgeData { edge, sides: [of_h, of_t] } = self.edge_data(h);
        let [a, b] = [h, self.store.twin(h)].map(|h| self.vertex_data(self.store.origin(h)));
        self.announce(&[
            (Kind::Edge, Step::Split(edge)),
            (Kind::HalfEdge, Step::Split(of_h)),
            (Kind::HalfEdge, Step::Split(of_t)),
            (Kind::Vertex, Step::Between(a, b)),
            // The twin leaves the new vertex, and the new half-edge on its side takes over its corner.
            (Kind::Corner, Step::Move(of_t)),
            (Kind::Corner, Step::Make),
            (Kind::Corner, Step::Make),
        ])
    }

    #[cold]
    pub(super) fn settle_split_edge(&mut self, h: HalfEdgeSlot, n: HalfEdgeSlot) {
        let EdgeData { edge, sides: [n, m] } = self.edge_data(n);
        let t = self.store.twin(h);
        let (w, t) = (self.vertex_data(self.store.origin(t)), self.half_edge_data(t));
        self.settle(&[
            (Kind::Edge, edge),
            (Kind::HalfEdge, n),
            (Kind::HalfEdge, m),
            (Kind::Vertex, w),
            (Kind::Corner, m),
            (Kind::Corner, n),
            (Kind::Corner, t),
        ]);
    }

    #[cold]
    pub(super) fn announce_joined(&mut self, h: HalfEdgeSlot, n: HalfEdgeSlot) -> Result<(), OperatorError> {
        let (kept, gone) = (self.edge_data(h), self.edge_data(n));
        let v = self.vertex_data(self.store.origin(n));
        let ([h, t], [n, m]) = (kept.sides, gone.sides);
        self.announce(&[
            (Kind::Edge, Step::Merge(kept.edge, gone.edge)),
            (Kind::HalfEdge, Step::Merge(h, n)),
            (Kind::HalfEdge, Step::Merge(t, m)),
            (Kind::Vertex, Step::Drop(v)),
            (Kind::Corner, Step::Drop(n)),
            (Kind::Corner, Step::Drop(t)),
            (Kind::Corner, Step::Rename(m, t)),
        ])
    }

    #[cold]
    pub(super) fn announce_split_vertex(
        &mut self,
        v: VertexSlot,
        corners: [CheckedCorner; 2],
    ) -> Result<(), OperatorError> {
        let mut steps = edge_made();
        steps.push((Kind::Vertex, Step::Split(self.vertex_data(v))));
        // The corners of the new half-edge and of its twin. The twin is at a leaf if the given corners are equal.
        let [from, to] = corners.map(|corner| self.corner_made(corner));
        let is_leaf = matches!(corners, [CheckedCorner::At(a), CheckedCorner::At(b)] if a == b);
        steps.extend([(Kind::Corner, to), (Kind::Corner, if is_leaf { Step::Make } else { from })]);
        self.announce(&steps)
    }

    #[cold]
    pub(super) fn settle_split_vertex(&mut self, w: VertexSlot, n: HalfEdgeSlot) {
        let mut made = self.made_edge(n);
        made.push((Kind::Vertex, self.vertex_data(w)));
        self.settle(&made);
    }

    #[cold]
    pub(super) fn announce_contracted(
        &mut self,
        n: HalfEdgeSlot,
        [kept, dropped]: [VertexSlot; 2],
    ) -> Result<(), OperatorError> {
        let t = self.store.twin(n);
        let mut steps = self.edge_dropped(n);
        steps.push((Kind::Vertex, Step::Merge(self.vertex_data(kept), self.vertex_data(dropped))));
        // At both ends, the corners on either side of the edge merge.
        let sides = if self.store.next(t) == n { [t, n] } else { [n, t] };
        let mut gone = None;
        for h in sides {
            let after = self.store.next(h);
            steps.push((Kind::Corner, self.corner_joined(h, (Some(after) != gone).then_some(after))));
            gone = Some(h);
        }
        self.announce(&steps)
    }

    /// Both ends of an edge leave their corners and split others.
    #[cold]
    pub(super) fn announce_flipped(&mut self, [n, t]: [HalfEdgeSlot; 2], turn: Turn) -> Result<(), OperatorError> {
        let store = &self.store;
        let [after_n, after_t] = [store.next(n), store.next(t)];
        let entered = match turn {
            // Past the first half-edge of the other side, as they follow without the edge.
            Turn::CounterClockwise => [(after_t, t, after_n), (after_n, n, after_t)]
                .map(|(first, end, beyond)| if store.next(first) == end { beyond } else { store.next(first) }),
            Turn::Clockwise => [store.prev(n), store.prev(t)],
        };
        self.announce_turned(&[[after_t, n], [after_n, t]], &entered)
    }

    /// A loop alone on one side leaves its corner and splits another one, for both half-edges.
    #[cold]
    pub(super) fn announce_slid(&mut self, [lone, t]: [HalfEdgeSlot; 2], turn: Turn) -> Result<(), OperatorError> {
        let store = &self.store;
        let (before, after) = (store.prev(t), store.next(t));
        let first = match turn {
            Turn::CounterClockwise if before != after => store.next(after),
            Turn::CounterClockwise => after,
            Turn::Clockwise => before,
        };
        self.announce_turned(&[[t, lone], [after, t]], &[first; 2])
    }

    fn announce_turned(&mut self, left: &[[HalfEdgeSlot; 2]], entered: &[HalfEdgeSlot]) -> Result<(), OperatorError> {
        let left = left.iter().map(|[kept, gone]| Step::Merge(self.half_edge_data(*kept), self.half_edge_data(*gone)));
        let entered = entered.iter().map(|h| Step::Split(self.half_edge_data(*h)));
        let steps: Steps = left.chain(entered).map(|step| (Kind::Corner, step)).collect();
        self.announce(&steps)
    }

    #[cold]
    pub(super) fn settle_turned(&mut self, turned: [HalfEdgeSlot; 2]) {
        self.settle(&turned.map(|h| (Kind::Corner, self.half_edge_data(h))));
    }

    /// The steps for removing vertices and half-edges, both marked by index. Faces are merged separately.
    #[cold]
    pub(in crate::dcel) fn announce_retained(
        &mut self,
        vertex_goes: &[bool],
        goes: &[bool],
        merged: &[MergedFace],
    ) -> Result<(), OperatorError> {
        let store = &self.store;
        let merged = merged.iter().map(|face| Step::Merge(face.kept.data(), face.dropped.data()));
        let mut steps: Steps = merged.map(|step| (Kind::Face, step)).collect();
        let gone: Vec<HalfEdgeSlot> =
            goes.iter().enumerate().filter(|(_, goes)| **goes).filter_map(|(i, _)| store.half_edge_at(i)).collect();
        let index = |h: HalfEdgeSlot| h.index();
        for h in &gone {
            if index(*h) < index(store.twin(*h)) {
                steps.extend(self.edge_dropped(*h));
            }
            // Corners counter-clockwise from a kept half-edge merge into its corner.
            let stays = store.next(store.twin(*h));
            let mut next = *h;
            while !goes[index(stays)] && goes[index(next)] {
                steps.push((Kind::Corner, self.corner_joined(next, Some(stays))));
                next = store.twin(store.prev(next));
            }
        }
        // Corners merged into others have no value any more.
        steps.extend(gone.iter().map(|h| (Kind::Corner, self.corner_joined(*h, None))));
        let vertices = (0..vertex_goes.len()).filter(|v| vertex_goes[*v]).filter_map(|v| store.vertex_at(v));
        steps.extend(vertices.map(|v| (Kind::Vertex, Step::Drop(self.vertex_data(v)))));
        self.announce(&steps)
    }
}

fn edge_made() -> Steps {
    [Kind::Edge, Kind::HalfEdge, Kind::HalfEdge].map(|kind| (kind, Step::Make)).into()
}
