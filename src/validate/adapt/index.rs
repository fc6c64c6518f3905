//! Dense indices for records that have names of their own.

use crate::validate::view::Link;
use alloc::vec::Vec;

/// Dense indices for the ids of one kind of record: keys, handles, pointers, names, whatever can be ordered.
///
/// A [`View`](crate::validate::View) answers by indices `0 .. n`. For a structure with ids make one `Index` for its vertices,
/// one for its half-edges and one for its faces, and answer each question by [`follow`](Self::follow). An id that is nobody's
/// (of a record that was removed, or of another structure) becomes a link that dangles, which R1 reports. To print a
/// report with the ids, see [`Report::named`](crate::validate::Report::named).
///
/// ```
/// use twinedge::validate::adapt::Index;
/// use twinedge::validate::{Collect, Expectation, Link, Part, Record, View, validate};
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
/// let expectation = Expectation::plane().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
/// let report = validate(&edge, &expectation, Collect::All);
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
    /// Indices in the order of their ids.
    sorted: Vec<usize>,
}

impl<K: Ord> Index<K> {
    /// Numbers the ids in the order in which they come. If an id comes twice, links lead to the first.
    ///
    /// O(n log n) time, O(n) if they come in order; the ids and 8 bytes for each.
    ///
    /// # Panics
    /// May panic if `Ord` is no total order for `K`.
    #[must_use]
    pub fn of(ids: impl IntoIterator<Item = K>) -> Self {
        let ids: Vec<K> = ids.into_iter().collect();
        let mut sorted: Vec<usize> = (0..ids.len()).collect();
        sorted.sort_by(|a, b| ids[*a].cmp(&ids[*b]));
        Self { ids, sorted }
    }

    /// How many ids there are: the number of slots.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    /// The id with this index. O(1).
    #[must_use]
    pub fn id(&self, index: usize) -> Option<&K> {
        self.ids.get(index)
    }

    /// The index of this id. O(log n).
    #[must_use]
    pub fn get(&self, id: &K) -> Option<usize> {
        let first = *self.sorted.get(self.sorted.partition_point(|i| self.ids[*i] < *id))?;
        (self.ids[first] == *id).then_some(first)
    }

    /// A link by id as a link by index: nil stays nil, and an id that is nobody's dangles. O(log n).
    #[must_use]
    pub fn link(&self, id: Option<K>) -> Link {
        Some(self.get(&id?).unwrap_or(usize::MAX))
    }

    /// The link that the record with this index keeps: `stored` says it by ids, `to` turns it into an index. O(log n).
    #[must_use]
    pub fn follow<T: Ord>(&self, index: usize, to: &Index<T>, stored: impl FnOnce(&K) -> Option<T>) -> Link {
        to.link(stored(self.id(index)?))
    }
}

impl<K: core::fmt::Debug> Index<K> {
    /// The `Debug` form of the id with this index; the index, if no id has it.
    #[must_use]
    pub fn name(&self, index: usize) -> alloc::string::String {
        match self.ids.get(index) {
            Some(id) => alloc::format!("{id:?}"),
            None => alloc::format!("{index}"),
        }
    }
}
