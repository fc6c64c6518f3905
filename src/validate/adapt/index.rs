//! Dense indices for records with other names.

use crate::validate::report::Record;
use crate::validate::structure::Link;
use alloc::vec::Vec;

/// Dense indices for the ids of one kind of record: keys, handles, pointers, names, or any other ordered type.
///
/// A [`View`](crate::validate::View) uses indices `0 .. n`. For a structure with ids, create an `Index` each for its vertices,
/// half-edges and faces, and answer every question with [`follow`](Self::follow). An unknown id (of a removed record, or of another
/// structure) becomes a dangling link, which R1 reports. The report does not contain that id, only the record and the field where the
/// structure stores it. [`Report::named`](crate::validate::Report::named) prints a report with ids; see
/// [`Ids::name`](super::Ids::name).
///
/// ```
/// use twinedge::validate::adapt::Index;
/// use twinedge::validate::{Collect, Expectation, Link, Parts, Record, View, validate};
/// use std::collections::HashMap;
///
/// /// Half-edges by name: each has an origin, a twin and a next.
/// struct Named {
///     links: HashMap<&'static str, (char, &'static str, &'static str)>,
///     vertices: Index<char>,
///     half_edges: Index<&'static str>,
/// }
///
/// impl View for Named {
///     fn parts(&self) -> Parts { Parts::NONE }
///     fn vertex_slots(&self) -> usize { self.vertices.len() }
///     fn half_edge_slots(&self) -> usize { self.half_edges.len() }
///     fn origin(&self, h: usize) -> Link { self.half_edges.follow(h, &self.vertices, |h| Some(self.links[h].0)) }
///     fn twin(&self, h: usize) -> Link { self.half_edges.follow(h, &self.half_edges, |h| Some(self.links[h].1)) }
///     fn next(&self, h: usize) -> Link { self.half_edges.follow(h, &self.half_edges, |h| Some(self.links[h].2)) }
/// }
///
/// // An edge from a to b; its second half-edge has itself as next.
/// let links = HashMap::from([("ab", ('a', "ba", "ba")), ("ba", ('b', "ab", "ba"))]);
/// let (vertices, half_edges) = (Index::of(['a', 'b']), Index::of(["ab", "ba"]));
/// let edge = Named { links, vertices, half_edges };
/// let report = validate(&edge, &Expectation::plane(), Collect::All);
/// let names = |record| match record {
///     Record::Vertex(v) => edge.vertices.name(v),
///     Record::HalfEdge(h) => edge.half_edges.name(h),
///     other => other.to_string(),
/// };
/// assert!(report.named(names).to_string().contains("half-edges \"ab\" and \"ba\" both have next \"ba\""));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Index<K> {
    ids: Vec<K>,
    sorted: Vec<usize>,
}

impl<K: Ord> Index<K> {
    /// Numbers the ids in the given order. A repeated id refers to its first occurrence.
    ///
    /// O(n log n) time, O(n) if they are sorted; stores the ids and 8 bytes for each.
    ///
    /// # Panics
    /// May panic if `Ord` is not a total order for `K`.
    #[must_use]
    pub fn of(ids: impl IntoIterator<Item = K>) -> Self {
        let ids: Vec<K> = ids.into_iter().collect();
        let mut sorted: Vec<usize> = (0..ids.len()).collect();
        sorted.sort_by(|a, b| ids[*a].cmp(&ids[*b]));
        Self { ids, sorted }
    }

    /// Numbers more ids, after the existing ones. Known ids keep their indices. O(n log n) for n ids in all.
    ///
    /// For a structure that changes: after each change, extend the index with the ids of all live records, so that an index always
    /// names the same record, and answer `is_vertex`, `is_half_edge` and `is_face` from the structure.
    ///
    /// ```
    /// use twinedge::validate::adapt::Index;
    /// let mut index = Index::of(['b', 'a']);
    /// index.extend(['c', 'a']);
    /// assert_eq!((index.len(), index.get(&'a'), index.get(&'c')), (3, Some(1), Some(2)));
    /// ```
    ///
    /// # Panics
    /// May panic if `Ord` is not a total order for `K`.
    pub fn extend(&mut self, ids: impl IntoIterator<Item = K>) {
        let first = self.ids.len();
        let more: Vec<K> = ids.into_iter().filter(|id| self.get(id).is_none()).collect();
        self.ids.extend(more);
        let mut order: Vec<usize> = (first..self.ids.len()).collect();
        order.sort_by(|a, b| self.ids[*a].cmp(&self.ids[*b]));
        let mut twice: Vec<usize> =
            order.windows(2).filter(|pair| self.ids[pair[0]] == self.ids[pair[1]]).map(|pair| pair[1]).collect();
        twice.sort_unstable();
        let mut index = 0;
        self.ids.retain(|_| {
            index += 1;
            twice.binary_search(&(index - 1)).is_err()
        });
        self.sorted.extend(first..self.ids.len());
        self.sorted.sort_by(|a, b| self.ids[*a].cmp(&self.ids[*b]));
    }

    /// Returns the number of ids, which is also the number of slots.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Returns true if there are no ids.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// Returns the id with this index. O(1).
    #[must_use]
    pub fn id(&self, index: usize) -> Option<&K> {
        self.ids.get(index)
    }

    /// Returns the index of this id. O(log n).
    #[must_use]
    pub fn get(&self, id: &K) -> Option<usize> {
        let first = *self.sorted.get(self.sorted.partition_point(|i| self.ids[*i] < *id))?;
        (self.ids[first] == *id).then_some(first)
    }

    /// Converts a link from ids to indices: nil stays nil, and an unknown id dangles. O(log n).
    #[must_use]
    pub fn link(&self, id: Option<K>) -> Link {
        Some(self.get(&id?).unwrap_or(usize::MAX))
    }

    /// Returns a link of the record with this index: `stored` reads it as an id, and `to` converts it into an index. O(log n).
    #[must_use]
    pub fn follow<T: Ord>(&self, index: usize, to: &Index<T>, stored: impl FnOnce(&K) -> Option<T>) -> Link {
        to.link(stored(self.id(index)?))
    }
}

impl<K: core::fmt::Debug> Index<K> {
    /// Returns the `Debug` form of the id with this index, or the index if it has no id.
    #[must_use]
    pub fn name(&self, index: usize) -> alloc::string::String {
        match self.ids.get(index) {
            Some(id) => alloc::format!("{id:?}"),
            None => alloc::format!("{index}"),
        }
    }
}

/// The ids of the vertices, half-edges and faces of one structure.
///
/// ```
/// use twinedge::validate::Record;
/// use twinedge::validate::adapt::{Ids, Index};
/// let ids = Ids { vertices: Index::of(["a", "b"]), half_edges: Index::of(["ab", "ba"]), faces: Index::of([7]) };
/// assert_eq!(ids.name(Record::HalfEdge(1)), "\"ba\"");
/// assert_eq!(ids.name(Record::Face(0)), "7");
/// // report.named(|record| ids.name(record)) prints the report with them.
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Ids<V, H, F> {
    /// The ids of the vertices.
    pub vertices: Index<V>,
    /// The ids of the half-edges.
    pub half_edges: Index<H>,
    /// The ids of the faces.
    pub faces: Index<F>,
}

impl<V: core::fmt::Debug, H: core::fmt::Debug, F: core::fmt::Debug> Ids<V, H, F> {
    /// Returns the `Debug` form of the id of a record, for [`Report::named`](crate::validate::Report::named), or its index if it has
    /// no id, as for boundary components.
    #[must_use]
    pub fn name(&self, record: Record) -> alloc::string::String {
        match record {
            Record::Vertex(v) => self.vertices.name(v),
            Record::HalfEdge(h) => self.half_edges.name(h),
            Record::Face(f) => self.faces.name(f),
            Record::Boundary(b) => alloc::format!("{b}"),
        }
    }
}
