//! A structure whose every change is compared with the operator's report.
#![allow(dead_code, reason = "each test file uses a part of it")]
#![allow(clippy::infinite_iter, reason = "the cycle of a half-edge has nothing to do with `Iterator::cycle`")]

use std::collections::BTreeSet;
use twinedge::dcel::{
    AddedVertex, Boundary, BoundaryKey, Connected, Connection, ContractedEdge, Corner, Dcel, Face, FaceKey, HalfEdge,
    HalfEdgeKey, JoinedEdges, OperatorError, RemovedEdge, RemovedVertex, Side, Split, SplitEdge, SplitVertex, Turn,
    Vertex, VertexKey,
};
use twinedge::validate::Table;

/// All keys of a structure.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Keys {
    pub(crate) vertices: BTreeSet<VertexKey>,
    pub(crate) half_edges: BTreeSet<HalfEdgeKey>,
    pub(crate) boundaries: BTreeSet<BoundaryKey>,
    pub(crate) faces: BTreeSet<FaceKey>,
}

impl Keys {
    pub(crate) fn of(map: &Dcel) -> Self {
        Self {
            vertices: map.vertices().map(Vertex::key).collect(),
            half_edges: map.half_edges().map(HalfEdge::key).collect(),
            boundaries: map.boundaries().map(Boundary::key).collect(),
            faces: map.faces().map(Face::key).collect(),
        }
    }

    /// Returns true if every one of these keys resolves.
    pub(crate) fn are_live(&self, map: &Dcel) -> bool {
        self.vertices.iter().all(|k| map.vertex(*k).is_ok())
            && self.half_edges.iter().all(|k| map.half_edge(*k).is_ok())
            && self.boundaries.iter().all(|k| map.boundary(*k).is_ok())
            && self.faces.iter().all(|k| map.face(*k).is_ok())
    }

    /// Returns true if none of these keys resolves.
    pub(crate) fn are_stale(&self, map: &Dcel) -> bool {
        self.vertices.iter().all(|k| map.vertex(*k).is_err())
            && self.half_edges.iter().all(|k| map.half_edge(*k).is_err())
            && self.boundaries.iter().all(|k| map.boundary(*k).is_err())
            && self.faces.iter().all(|k| map.face(*k).is_err())
    }

    /// The keys that are not among the others.
    pub(crate) fn without(&self, others: &Self) -> Self {
        Self {
            vertices: &self.vertices - &others.vertices,
            half_edges: &self.half_edges - &others.half_edges,
            boundaries: &self.boundaries - &others.boundaries,
            faces: &self.faces - &others.faces,
        }
    }

    pub(crate) fn add(&mut self, others: &Self) {
        self.vertices.extend(&others.vertices);
        self.half_edges.extend(&others.half_edges);
        self.boundaries.extend(&others.boundaries);
        self.faces.extend(&others.faces);
    }

    fn edge(mut self, map: &Dcel, h: HalfEdgeKey) -> Self {
        self.half_edges.extend([h, map.half_edge(h).unwrap().twin().key()]);
        self
    }

    fn vertex(mut self, v: VertexKey) -> Self {
        self.vertices.insert(v);
        self
    }

    fn boundary(mut self, b: BoundaryKey) -> Self {
        self.boundaries.insert(b);
        self
    }

    fn face(mut self, f: FaceKey) -> Self {
        self.faces.insert(f);
        self
    }

    fn change(&self, made: &Self, dropped: &Self) -> Self {
        fn sets<K: Ord + Copy>(all: &BTreeSet<K>, made: &BTreeSet<K>, dropped: &BTreeSet<K>) -> BTreeSet<K> {
            assert!(made.is_disjoint(all), "what is reported made was there");
            assert!(dropped.is_subset(all), "what is reported dropped was not there");
            all.union(made).filter(|key| !dropped.contains(key)).copied().collect()
        }
        Self {
            vertices: sets(&self.vertices, &made.vertices, &dropped.vertices),
            half_edges: sets(&self.half_edges, &made.half_edges, &dropped.half_edges),
            boundaries: sets(&self.boundaries, &made.boundaries, &dropped.boundaries),
            faces: sets(&self.faces, &made.faces, &dropped.faces),
        }
    }
}

/// A structure that is checked after each operator: it must be valid, with the old keys plus those reported made, minus
/// those reported dropped. A refused operator must change nothing.
#[derive(Clone, Default)]
pub(crate) struct Tracked {
    pub(crate) map: Dcel,
}

impl Tracked {
    pub(crate) fn outside(&self) -> FaceKey {
        self.map.unbounded_face().key()
    }

    pub(crate) fn twin(&self, h: HalfEdgeKey) -> HalfEdgeKey {
        self.map.half_edge(h).unwrap().twin().key()
    }

    pub(crate) fn next(&self, h: HalfEdgeKey) -> HalfEdgeKey {
        self.map.half_edge(h).unwrap().next().key()
    }

    pub(crate) fn origin(&self, h: HalfEdgeKey) -> VertexKey {
        self.map.half_edge(h).unwrap().origin().key()
    }

    pub(crate) fn target(&self, h: HalfEdgeKey) -> VertexKey {
        self.map.half_edge(h).unwrap().target().key()
    }

    pub(crate) fn face(&self, h: HalfEdgeKey) -> FaceKey {
        self.map.half_edge(h).unwrap().face().key()
    }

    pub(crate) fn boundary(&self, h: HalfEdgeKey) -> BoundaryKey {
        self.map.half_edge(h).unwrap().boundary().key()
    }

    pub(crate) fn isolated(&self, v: VertexKey) -> BoundaryKey {
        self.map.vertex(v).unwrap().isolated().unwrap().key()
    }

    pub(crate) fn is_outer(&self, h: HalfEdgeKey) -> bool {
        self.map.half_edge(h).unwrap().boundary().is_outer()
    }

    /// The inner boundary components of a face.
    pub(crate) fn inner(&self, f: FaceKey) -> BTreeSet<BoundaryKey> {
        self.map.face(f).unwrap().inner().map(Boundary::key).collect()
    }

    pub(crate) fn cycle(&self, h: HalfEdgeKey) -> Vec<HalfEdgeKey> {
        self.map.half_edge(h).unwrap().boundary_cycle().map(HalfEdge::key).collect()
    }

    /// V, E, F, components.
    pub(crate) fn counts(&self) -> [usize; 4] {
        let components = self.map.validate().counts().components.unwrap();
        [self.map.vertex_count(), self.map.edge_count(), self.map.face_count(), components]
    }

    /// Makes a polygon in a face; returns its half-edges with the inside to their left.
    pub(crate) fn polygon(&mut self, f: FaceKey, corners: usize) -> Vec<HalfEdgeKey> {
        let v = self.add(f).vertex;
        let mut sides = vec![self.connect(v, v, Split::default()).half_edge];
        for _ in 1..corners {
            sides.push(self.split_edge(*sides.last().unwrap()).half_edge);
        }
        sides
    }

    /// Makes an edge from the corner of `h` to a new vertex.
    pub(crate) fn leaf(&mut self, h: HalfEdgeKey) -> HalfEdgeKey {
        self.split_vertex(h, h).half_edge
    }

    /// Makes a separate edge in a face.
    pub(crate) fn edge(&mut self, f: FaceKey) -> HalfEdgeKey {
        let v = self.add(f).vertex;
        self.split_vertex(v, v).half_edge
    }

    pub(crate) fn add(&mut self, f: FaceKey) -> AddedVertex {
        self.run(
            |map| map.add_isolated_vertex(f),
            |added, _, after| {
                assert_eq!(after.vertex(added.vertex).unwrap().isolated().unwrap().key(), added.boundary);
                assert_eq!(after.boundary(added.boundary).unwrap().face().key(), f);
                (Keys::default().vertex(added.vertex).boundary(added.boundary), Keys::default())
            },
        )
    }

    pub(crate) fn remove(&mut self, v: VertexKey) -> RemovedVertex {
        self.run(
            |map| map.remove_isolated_vertex(v),
            |removed, before, _| {
                assert_eq!(before.boundary(removed.boundary).unwrap().face().key(), removed.face);
                (Keys::default(), Keys::default().vertex(v).boundary(removed.boundary))
            },
        )
    }

    pub(crate) fn connect(&mut self, from: impl Into<Corner>, to: impl Into<Corner>, split: Split<'_>) -> Connected {
        self.run(
            |map| map.connect(from, to, split),
            |connected, before, after| {
                let h = after.half_edge(connected.half_edge).unwrap();
                let sides = [h.boundary().key(), h.twin().boundary().key()];
                let made = Keys::default().edge(after, h.key());
                match connected.connection {
                    Connection::Bridge { kept, dropped } => {
                        assert_eq!(sides, [kept, kept]);
                        let face = |b| before.boundary(b).unwrap().face();
                        assert_eq!(face(kept), face(dropped));
                        (made, Keys::default().boundary(dropped))
                    }
                    Connection::Split { kept, made: b, face } => {
                        assert_eq!(BTreeSet::from(sides), BTreeSet::from([kept, b]));
                        let new = if split.new_face == Side::Left { h } else { h.twin() };
                        assert_eq!((new.face().key(), new.boundary().is_outer()), (face, true));
                        let longer = h.boundary_cycle().count().max(h.twin().boundary_cycle().count());
                        assert_eq!(after.boundary(kept).unwrap().half_edges().count(), longer);
                        (made.boundary(b).face(face), Keys::default())
                    }
                    other => panic!("{other:?}"),
                }
            },
        )
    }

    pub(crate) fn remove_edge(&mut self, h: HalfEdgeKey) -> RemovedEdge {
        self.run(
            |map| map.remove_edge(h),
            |removed, before, after| {
                let gone = Keys::default().edge(before, h);
                let h = before.half_edge(h).unwrap();
                let sides = BTreeSet::from([h.boundary().key(), h.twin().boundary().key()]);
                match *removed {
                    RemovedEdge::Merged { kept_face, dropped_face, kept, dropped } => {
                        assert_eq!(sides, BTreeSet::from([kept, dropped]));
                        let faces = BTreeSet::from([h.face().key(), h.twin().face().key()]);
                        assert_eq!(faces, BTreeSet::from([kept_face, dropped_face]));
                        assert_eq!(after.boundary(kept).unwrap().face().key(), kept_face);
                        let shorter = h.boundary_cycle().count().min(h.twin().boundary_cycle().count());
                        assert_eq!(before.boundary(dropped).unwrap().half_edges().count(), shorter);
                        (Keys::default(), gone.boundary(dropped).face(dropped_face))
                    }
                    RemovedEdge::Parted { kept, made } => {
                        assert_eq!(sides, BTreeSet::from([kept]));
                        let count = |b| after.boundary(b).unwrap().half_edges().count();
                        assert!(count(kept) >= count(made));
                        assert_eq!(count(kept) + count(made) + 2, h.boundary_cycle().count());
                        (Keys::default().boundary(made), gone)
                    }
                    ref other => panic!("{other:?}"),
                }
            },
        )
    }

    pub(crate) fn split_edge(&mut self, h: HalfEdgeKey) -> SplitEdge {
        self.run(
            |map| map.split_edge(h),
            |split, before, after| {
                let (old, new) = (after.half_edge(h).unwrap(), after.half_edge(split.half_edge).unwrap());
                assert_eq!(old.next(), new);
                assert_eq!((old.target(), new.origin()), (new.origin(), after.vertex(split.vertex).unwrap()));
                let was = before.half_edge(h).unwrap();
                assert_eq!(old.origin().key(), was.origin().key());
                assert_eq!(new.target().key(), was.target().key());
                (Keys::default().vertex(split.vertex).edge(after, split.half_edge), Keys::default())
            },
        )
    }

    pub(crate) fn join_edges(&mut self, h: HalfEdgeKey) -> JoinedEdges {
        self.run(
            |map| map.join_edges(h),
            |joined, before, after| {
                let was = before.half_edge(h).unwrap();
                assert_eq!((was.next().key(), was.target().key()), (joined.half_edge, joined.vertex));
                let is = after.half_edge(h).unwrap();
                assert_eq!(is.origin().key(), was.origin().key());
                assert_eq!(is.target().key(), was.next().target().key());
                (Keys::default(), Keys::default().vertex(joined.vertex).edge(before, joined.half_edge))
            },
        )
    }

    pub(crate) fn split_vertex(&mut self, from: impl Into<Corner>, to: impl Into<Corner>) -> SplitVertex {
        self.run(
            |map| map.split_vertex(from, to),
            |split, _, after| {
                let h = after.half_edge(split.half_edge).unwrap();
                let (origin, target) = (h.origin(), h.target());
                let new = after.vertex(split.vertex).unwrap();
                assert!([origin, target].contains(&new));
                assert_eq!(new.degree(), origin.degree().min(target.degree()));
                (Keys::default().vertex(split.vertex).edge(after, split.half_edge), Keys::default())
            },
        )
    }

    pub(crate) fn contract_edge(&mut self, h: HalfEdgeKey) -> ContractedEdge {
        self.run(
            |map| map.contract_edge(h),
            |contracted, before, _| {
                let was = before.half_edge(h).unwrap();
                let ends = BTreeSet::from([was.origin().key(), was.target().key()]);
                assert_eq!(ends, BTreeSet::from([contracted.kept, contracted.dropped]));
                let degree = |v| before.vertex(v).unwrap().degree();
                assert!(degree(contracted.kept) >= degree(contracted.dropped));
                (Keys::default(), Keys::default().vertex(contracted.dropped).edge(before, h))
            },
        )
    }

    pub(crate) fn flip_edge(&mut self, h: HalfEdgeKey, turn: Turn) {
        self.run(
            |map| map.flip_edge(h, turn),
            |(), before, after| {
                let faces = |map: &Dcel| {
                    let h = map.half_edge(h).unwrap();
                    [h, h.twin()].map(|h| (h.face().key(), h.boundary().key(), h.boundary_cycle().count()))
                };
                assert_eq!(faces(before), faces(after), "an edge that turns stays between its faces");
                (Keys::default(), Keys::default())
            },
        );
    }

    pub(crate) fn move_inner(&mut self, b: BoundaryKey, f: FaceKey) -> FaceKey {
        self.run(
            |map| map.move_inner(b, f),
            |old, before, after| {
                assert_eq!(before.boundary(b).unwrap().face().key(), *old);
                assert_eq!(after.boundary(b).unwrap().face().key(), f);
                (Keys::default(), Keys::default())
            },
        )
    }

    /// Runs an operator that must refuse.
    pub(crate) fn refuses<T: std::fmt::Debug>(
        &mut self,
        operator: impl FnOnce(&mut Dcel) -> Result<T, OperatorError>,
    ) -> OperatorError {
        let (table, keys) = (Table::copy_of(&self.map), Keys::of(&self.map));
        let error = operator(&mut self.map).unwrap_err();
        assert_eq!((Table::copy_of(&self.map), Keys::of(&self.map)), (table, keys), "{error}");
        error
    }

    /// Runs an operator; `made_and_dropped` extracts these from its report, and checks the rest.
    fn run<T: std::fmt::Debug>(
        &mut self,
        operator: impl FnOnce(&mut Dcel) -> Result<T, OperatorError>,
        made_and_dropped: impl FnOnce(&T, &Dcel, &Dcel) -> (Keys, Keys),
    ) -> T {
        let before = self.map.clone();
        let said = operator(&mut self.map).unwrap();
        let (made, dropped) = made_and_dropped(&said, &before, &self.map);
        assert_eq!(Keys::of(&before).change(&made, &dropped), Keys::of(&self.map), "{said:?}");
        assert!(made.are_live(&self.map) && made.are_stale(&before), "{said:?}");
        assert!(dropped.are_stale(&self.map) && dropped.are_live(&before), "{said:?}");
        let report = self.map.validate();
        assert!(report.is_valid(), "{said:?}\n{report}");
        said
    }
}
