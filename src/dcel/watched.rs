//! A structure that is watched while operators change it.

use super::structure::Dcel;
#[cfg(feature = "map")]
use crate::store::SlotStore;
use crate::store::attributes::Attributes;
use crate::store::links::{AttributeStore, BoundaryStart, Links, Need, RecordKind, Store, VertexLink};
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey, Watch};
use crate::validate::near::WriteSet;

/// A [`Dcel`] as the store of another one, whose operators write to it, while somebody is told what they write.
///
/// [`Audited`](super::Audited) and [`History`](super::History) hand one to the closures that change their structure.
#[derive(Clone, Debug)]
pub struct Watched<S: Store, W = WriteSet> {
    pub(super) dcel: Dcel<S>,
    pub(super) watch: W,
}

impl<S: Store, W: Watch<S>> Dcel<Watched<S, W>> {
    pub(super) const fn watched_by(dcel: Dcel<S>, watch: W) -> Self {
        Self { store: Watched { dcel, watch } }
    }
}

impl<S: Store, W: Watch<S>> Store for Watched<S, W> {}

impl<S: AttributeStore, W: Watch<S>> AttributeStore for Watched<S, W> {
    fn kept_attributes(&mut self) -> &mut Attributes {
        self.dcel.store.kept_attributes()
    }
}

/// Questions, which are handed on.
macro_rules! questions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $answer:ty;)*) => {
        $(#[inline]
        fn $name(&self, $($argument: $type),*) -> $answer {
            self.dcel.store.$name($($argument),*)
        })*
    };
}

/// Records that are added, which is told before and after.
macro_rules! additions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $record:ty, $tell:ident;)*) => {
        $(fn $name(&mut self, $($argument: $type),*) -> $record {
            self.watch.$name(&mut self.dcel.store);
            let record = self.dcel.store.$name($($argument),*);
            self.watch.$tell(&mut self.dcel.store, record);
            record
        })*
    };
}

/// Changes, which are told first, with some of their arguments.
macro_rules! changes {
    ($($name:ident($($told:ident: $type:ty),* $(; $value:ident: $of:ty)?);)*) => {
        $(fn $name(&mut self, $($told: $type,)* $($value: $of)?) {
            self.watch.$name(&self.dcel.store, $($told),*);
            self.dcel.store.$name($($told,)* $($value)?);
        })*
    };
}

impl<S: Store, W: Watch<S>> Links for Watched<S, W> {
    type Vertex = S::Vertex;
    type HalfEdge = S::HalfEdge;
    type Boundary = S::Boundary;
    type Face = S::Face;

    const RECORDS: bool = W::RECORDS;

    fn attributes(&self) -> Option<&Attributes> {
        self.dcel.store.attributes()
    }

    fn attributes_mut(&mut self) -> Option<&mut Attributes> {
        self.dcel.store.attributes_mut()
    }

    fn trial(&self) -> Option<Self> {
        Some(Self { dcel: Dcel { store: self.dcel.store.trial()? }, watch: W::default() })
    }

    fn with_room(need: Need) -> Self {
        Self { dcel: Dcel::with_room(need), watch: W::default() }
    }

    questions! {
        unbounded() -> S::Face;
        room_for(need: Need) -> Result<(), RecordKind>;

        find_vertex(key: VertexKey) -> Option<S::Vertex>; find_half_edge(key: HalfEdgeKey) -> Option<S::HalfEdge>;
        find_boundary(key: BoundaryKey) -> Option<S::Boundary>; find_face(key: FaceKey) -> Option<S::Face>;
        vertex_key(v: S::Vertex) -> VertexKey; half_edge_key(h: S::HalfEdge) -> HalfEdgeKey;
        boundary_key(b: S::Boundary) -> BoundaryKey; face_key(f: S::Face) -> FaceKey;

        vertex_count() -> usize; edge_count() -> usize; boundary_count() -> usize; face_count() -> usize;
        vertex_slots() -> usize; half_edge_slots() -> usize; boundary_slots() -> usize; face_slots() -> usize;
        vertex_at(index: usize) -> Option<S::Vertex>; half_edge_at(index: usize) -> Option<S::HalfEdge>;
        boundary_at(index: usize) -> Option<S::Boundary>; face_at(index: usize) -> Option<S::Face>;
        origin_in(index: usize) -> Option<usize>; twin_in(index: usize) -> Option<usize>;
        next_in(index: usize) -> Option<usize>; prev_in(index: usize) -> Option<usize>;
        boundary_in(index: usize) -> Option<usize>;
        vertex_index(v: S::Vertex) -> usize; half_edge_index(h: S::HalfEdge) -> usize;
        boundary_index(b: S::Boundary) -> usize; face_index(f: S::Face) -> usize;

        origin(h: S::HalfEdge) -> S::Vertex; twin(h: S::HalfEdge) -> S::HalfEdge;
        next(h: S::HalfEdge) -> S::HalfEdge; prev(h: S::HalfEdge) -> S::HalfEdge;
        boundary(h: S::HalfEdge) -> S::Boundary;
        vertex_link(v: S::Vertex) -> VertexLink<S::HalfEdge, S::Boundary>;
        face(b: S::Boundary) -> S::Face;
        start(b: S::Boundary) -> BoundaryStart<S::HalfEdge, S::Vertex>;
        place(b: S::Boundary) -> u32;
        outer(f: S::Face) -> Option<S::Boundary>; outer_half_edge(f: S::Face) -> Option<S::HalfEdge>;
        inner_count(f: S::Face) -> usize; inner(f: S::Face, position: usize) -> Option<S::Boundary>;
    }

    additions! {
        add_vertex(link: VertexLink<S::HalfEdge, S::Boundary>) -> S::Vertex, added_vertex;
        add_edge(from: S::Vertex, to: S::Vertex, b: S::Boundary) -> S::HalfEdge, added_edge;
        add_boundary(f: S::Face, start: BoundaryStart<S::HalfEdge, S::Vertex>) -> S::Boundary, added_boundary;
    }

    changes! {
        remove_vertex(v: S::Vertex);
        remove_edge(h: S::HalfEdge);
        remove_boundary(b: S::Boundary);
        remove_face(f: S::Face);
        set_origin(h: S::HalfEdge; v: S::Vertex);
        join(h: S::HalfEdge, n: S::HalfEdge);
        set_boundary(h: S::HalfEdge; b: S::Boundary);
        set_vertex_link(v: S::Vertex; link: VertexLink<S::HalfEdge, S::Boundary>);
        set_start(b: S::Boundary; start: BoundaryStart<S::HalfEdge, S::Vertex>);
        set_place(b: S::Boundary; place: u32);
        list_outer(f: S::Face, b: S::Boundary);
        list_inner(f: S::Face, b: S::Boundary);
        unlist(b: S::Boundary);
    }

    fn add_face(&mut self) -> S::Face {
        let f = self.dcel.store.add_face();
        self.watch.added_face(&mut self.dcel.store, f);
        f
    }

    fn add_isolated(&mut self, f: S::Face) -> (S::Vertex, S::Boundary) {
        self.watch.add_isolated(&mut self.dcel.store);
        let (v, b) = self.dcel.store.add_isolated(f);
        self.watch.added_isolated(&mut self.dcel.store, v, b);
        (v, b)
    }
}

/// A structure that is lent to be watched, and comes back when this is dropped: also where a policy panics.
#[cfg(feature = "map")]
struct Lent<'a, W: Watch<SlotStore>> {
    places: (&'a mut Dcel, &'a mut W),
    watched: Dcel<Watched<SlotStore, W>>,
}

#[cfg(feature = "map")]
impl<W: Watch<SlotStore>> Drop for Lent<'_, W> {
    fn drop(&mut self) {
        let Watched { dcel, watch } = &mut self.watched.store;
        core::mem::swap(self.places.0, dcel);
        core::mem::swap(self.places.1, watch);
    }
}

#[cfg(feature = "map")]
impl Dcel {
    /// Changes the structure, and tells `watch` what is written. O(1) beside the change.
    pub(crate) fn watched<T, W: Watch<SlotStore>>(
        &mut self,
        watch: &mut W,
        change: impl FnOnce(&mut Dcel<Watched<SlotStore, W>>) -> T,
    ) -> T {
        let dcel = core::mem::replace(self, Self { store: SlotStore::hollow() });
        let watched = Dcel::watched_by(dcel, core::mem::take(watch));
        change(&mut Lent { places: (self, watch), watched }.watched)
    }
}
