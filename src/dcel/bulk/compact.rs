//! Closes the gaps left by removed records.

use crate::dcel::assemble::Assembly;
use crate::dcel::structure::Dcel;
use crate::numbers::NIL;
use crate::store::attributes::Kind;
use crate::store::{
    BoundaryKey, BoundarySlot, BoundaryStart, FaceKey, HalfEdgeKey, HalfEdgeSlot, InOrder, Numbered, Room, Store,
    VertexKey, VertexLink, VertexSlot,
};
use alloc::vec;
use alloc::vec::Vec;
use slotmap::{Key, SecondaryMap};

/// The new key for each old key, from [`Dcel::compact`].
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Renamed {
    /// The vertices.
    pub vertices: SecondaryMap<VertexKey, VertexKey>,
    /// The half-edges.
    pub half_edges: SecondaryMap<HalfEdgeKey, HalfEdgeKey>,
    /// The boundary components.
    pub boundaries: SecondaryMap<BoundaryKey, BoundaryKey>,
    /// The faces.
    pub faces: SecondaryMap<FaceKey, FaceKey>,
}

struct Live<T> {
    slots: Vec<T>,
    /// The number of each slot, by index; nil if vacant.
    numbers: Vec<u32>,
}

impl<T: Copy> Live<T> {
    /// Numbers the live slots with indices below `end`, `first` before all others.
    fn new(end: usize, first: Option<usize>, at: impl Fn(usize) -> Option<T>) -> Self {
        let (mut slots, mut numbers) = (Vec::with_capacity(end), vec![NIL; end]);
        for index in first.into_iter().chain((0..end).filter(|index| Some(*index) != first)) {
            if let Some(slot) = at(index) {
                numbers[index] = slots.len() as u32;
                slots.push(slot);
            }
        }
        Self { slots, numbers }
    }

    fn renamed<K: Key>(&self, old_key: impl Fn(T) -> K, new_key: impl Fn(u32) -> K) -> SecondaryMap<K, K> {
        let mut renamed = SecondaryMap::with_capacity(self.numbers.len());
        for (number, old) in (0..).zip(&self.slots) {
            renamed.insert(old_key(*old), new_key(number));
        }
        renamed
    }
}

impl Dcel {
    fn renamed_attributes(&mut self, mut new: Self, renamed: &Renamed) -> Self {
        new.store.set_attributes(self.store.take_attributes().map(|mut attributes| {
            attributes.rename(&|kind, old| match kind {
                Kind::Vertex => renamed.vertices.get(old.into()).map(|key| key.data()),
                Kind::HalfEdge | Kind::Edge | Kind::Corner => renamed.half_edges.get(old.into()).map(|key| key.data()),
                Kind::Face => renamed.faces.get(old.into()).map(|key| key.data()),
                Kind::Other => Some(old),
            });
            attributes
        }));
        new
    }
}

impl Dcel {
    /// Closes the gaps left by removed records, so that memory and the time of walks over all records fit the number of
    /// records. Returns the new key for each old key.
    ///
    /// Keeps the order of records, of lists and of the two half-edges of an edge, but moves the unbounded face to the front.
    /// Indices are then without gaps: from 1 for vertices, boundary components and faces, from 2 for half-edges.
    ///
    /// All keys change, including the keys of records that did not move. Old keys become stale, with the [limits](Dcel#keys)
    /// that apply to keys of another structure, because generations start again. Data stored by key must be moved:
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, SecondaryMap};
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// let gone = map.add_isolated_vertex(outside)?.vertex;
    /// let rome = map.add_isolated_vertex(outside)?.vertex;
    /// let mut places = SecondaryMap::from_iter([(rome, [12.5, 41.9])]);
    /// map.remove_isolated_vertex(gone)?;
    ///
    /// let renamed = map.compact();
    /// let places: SecondaryMap<_, _> = places.drain().map(|(old, place)| (renamed.vertices[old], place)).collect();
    /// let rome = map.vertices().next().unwrap();
    /// assert_eq!((rome.index(), places[rome.key()]), (1, [12.5, 41.9]));
    /// assert!(map.vertex(gone).is_err());
    /// # Ok::<(), twinedge::dcel::OperatorError>(())
    /// ```
    ///
    /// O(slots) time. Needs memory for both structures while it runs; the result takes 16 bytes per record.
    pub fn compact(&mut self) -> Renamed {
        let old = &self.store;
        let vertices = Live::new(old.vertex_slots(), None, |i| old.vertex_at(i));
        let half_edges = Live::new(old.half_edge_slots(), None, |i| old.half_edge_at(i));
        let boundaries = Live::new(old.boundary_slots(), None, |i| old.boundary_at(i));
        let unbounded = old.unbounded().index();
        let faces = Live::new(old.face_slots(), Some(unbounded), |i| old.face_at(i));

        let vertex = |v: VertexSlot| vertices.numbers[v.index()];
        let half_edge = |h: HalfEdgeSlot| half_edges.numbers[h.index()];
        let boundary = |b: BoundarySlot| boundaries.numbers[b.index()];
        let links: Vec<_> = vertices
            .slots
            .iter()
            .map(|v| match old.vertex_link(*v) {
                VertexLink::Leaving(h) => VertexLink::Leaving(half_edge(h)),
                VertexLink::Isolated(b) => VertexLink::Isolated(boundary(b)),
            })
            .collect();
        let starts: Vec<_> = boundaries
            .slots
            .iter()
            .map(|b| match old.start(*b) {
                BoundaryStart::HalfEdge(h) => BoundaryStart::HalfEdge(half_edge(h)),
                BoundaryStart::Vertex(v) => BoundaryStart::Vertex(vertex(v)),
            })
            .collect();
        let inner: Vec<_> = (0..)
            .zip(&faces.slots)
            .flat_map(|(n, f)| (0..old.inner_count(*f)).filter_map(move |i| Some((n, boundary(old.inner(*f, i)?)))))
            .collect();
        let column = |of: &dyn Fn(usize) -> u32| -> Vec<u32> { (0..half_edges.slots.len()).map(of).collect() };
        let assembly = Assembly {
            vertices: &links,
            origin: &column(&|i| vertex(old.origin(half_edges.slots[i]))),
            next: &column(&|i| half_edge(old.next(half_edges.slots[i]))),
            boundary: &column(&|i| boundary(old.boundary(half_edges.slots[i]))),
            starts: &starts,
            outer: &faces.slots.iter().filter_map(|f| old.outer(*f)).map(boundary).collect::<Vec<_>>(),
            inner: &inner,
        };
        let need = Room {
            vertices: vertices.slots.len(),
            edges: half_edges.slots.len() / 2,
            boundaries: boundaries.slots.len(),
            faces: faces.slots.len() - 1,
        };
        let mut new = assembly.link(Store::with_room(need).filled(need), &InOrder);
        new.store.most = old.most;
        let to = &new.store;
        let renamed = Renamed {
            vertices: vertices.renamed(|v| old.vertex_key(v), |n| to.vertex_key(InOrder.vertex(n))),
            half_edges: half_edges.renamed(|h| old.half_edge_key(h), |n| to.half_edge_key(InOrder.half_edge(n))),
            boundaries: boundaries.renamed(|b| old.boundary_key(b), |n| to.boundary_key(InOrder.boundary(n))),
            faces: faces.renamed(|f| old.face_key(f), |n| to.face_key(InOrder.face(n))),
        };
        let new = self.renamed_attributes(new, &renamed);
        *self = new;
        renamed
    }
}
