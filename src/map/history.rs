//! A map whose edits can be taken back.

use super::index::IndexedEdge;
use super::notes::{MapEntry, MapJournal, Notes};
use super::planar_map::PlanarMap;
use crate::dcel::{Dcel, HalfEdge, Mark, Past, Recorder, Vertex};
use crate::store::links::Links;
use crate::store::{FeatureId, Journal, Way};
use crate::validate::near::WriteSet;
use std::borrow::Cow;
use std::mem;
use std::ops::Range;

/// A [`PlanarMap`] whose edits can be taken back and done again: the core of an editor.
///
/// A change is any number of edits under one name, which users see in a menu. Either all of them are done or, after an error or a panic,
/// none. [`undo`](Self::undo) and [`redo`](Self::redo) move between the states before and after changes.
///
/// ```
/// use twinedge::map::edit::EditError;
/// use twinedge::map::{History, PlanarMap};
///
/// let mut history = History::new(PlanarMap::new());
/// let parcel = history.change("draw a parcel", |map| map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]))?;
/// let fence = history.change("divide it", |map| map.insert_segment(parcel.vertices[0], parcel.vertices[2]))?;
///
/// // Both edits or none: the second one would cross the fence.
/// let refused = history.change("divide it again", |map| {
///     map.insert_point([1.0, 3.0])?;
///     map.insert_segment([1.0, 3.0], [3.0, 1.0])
/// });
/// assert!(matches!(refused, Err(EditError::Crosses(_))));
/// assert_eq!(history.get().dcel().vertex_count(), 4);
///
/// assert_eq!(history.undo_name(), Some("divide it"));
/// assert!(history.undo());
/// assert!(history.get().dcel().half_edge(fence.way[0]).is_err());
/// assert!(history.redo());
/// assert!(history.get().dcel().half_edge(fence.way[0]).is_ok());
/// # Ok::<(), EditError>(())
/// ```
///
/// Positions, features and their names follow, [attributes](PlanarMap#attributes), and so do the answers of [`locate`](PlanarMap::locate): the index that the map keeps for
/// them is brought along, not built anew. What is said of keys, of the line of changes and of validation at
/// [`dcel::History`](crate::dcel::History) is true here, too. A [`FeatureId`](super::FeatureId), however, is no more than a number:
/// that of a feature that was taken back is given to the next one.
///
/// # Costs
///
/// Time and memory are those of the change, whatever the size of the map: 12 bytes for each link that was overwritten, 24 for each
/// point, set of features or value of an attribute (and the value), and 48 for each change. An edge of a map of a hundred thousand that is erased or drawn takes 1.1 times as long
/// as a change, and 0.4 times to undo: O(k), and O(log n) in the index for each edge that was drawn or erased.
///
/// A clone has the same changes, and its own from then on.
#[derive(Clone, Debug)]
pub struct History {
    past: Past<PlanarMap>,
}

impl History {
    /// Starts with a map, and no changes. O(1). The keys stay the same.
    #[must_use]
    pub fn new(map: PlanarMap) -> Self {
        Self { past: Past::new(map) }
    }

    /// The map. O(1).
    #[must_use]
    pub const fn get(&self) -> &PlanarMap {
        &self.past.recorder
    }

    /// The map, for good. O(1). It knows nothing of what was undone, so it may issue a key again that an undone change had issued.
    #[must_use]
    pub fn into_map(self) -> PlanarMap {
        let mut map = self.past.recorder;
        map.notes = Notes::default();
        map
    }

    /// Changes the map by one edit or more, which are undone and redone together.
    ///
    /// The time that the edits take, and O(1) for each link, point and set of features that they write. Changes that could be redone are dropped; if it
    /// fails, they are kept, which takes O(their entries).
    ///
    /// A map that the closure puts in place of the other, as by assignment, begins a history of its own: nothing before it can be undone, and
    /// an error does not bring the other one back.
    ///
    /// # Errors
    /// That of the closure. The map is as it was then, and so is what can be redone. The same is so if the closure panics.
    pub fn change<T, E>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut PlanarMap) -> Result<T, E>,
    ) -> Result<T, E> {
        self.past.change(name, change)
    }

    /// Takes the last change back; false if there is none. At most the time that the change took.
    pub fn undo(&mut self) -> bool {
        self.past.undo()
    }

    /// Does the last change that was undone again; false if there is none. At most the time that the change took.
    pub fn redo(&mut self) -> bool {
        self.past.redo()
    }

    /// Takes back all changes since a mark was set; false, and nothing is done, if none of the states before is the one that was marked.
    pub fn undo_to(&mut self, mark: Mark) -> bool {
        self.past.undo_to(mark)
    }

    /// Marks the state, so that [`undo_to`](Self::undo_to) finds back to it. O(1).
    #[must_use]
    pub fn mark(&self) -> Mark {
        self.past.mark()
    }

    /// Returns the name of the change that [`undo`](Self::undo) takes back. O(1).
    #[must_use]
    pub fn undo_name(&self) -> Option<&str> {
        self.past.undo_name()
    }

    /// Returns the name of the change that [`redo`](Self::redo) does again. O(1).
    #[must_use]
    pub fn redo_name(&self) -> Option<&str> {
        self.past.redo_name()
    }

    /// Returns the records that the last change, `undo`, `undo_to` or `redo` wrote, some of them several times: what
    /// [`validate_embedding_near`](crate::validate::near::validate_embedding_near) needs. O(k) for k links and points.
    #[must_use]
    pub fn written(&self) -> WriteSet {
        let (links, others) = self.past.last();
        let map = self.get();
        let journal = map.notes.journal.as_ref().map(|journal| journal.links.written(map.dcel.store(), links));
        let mut written = journal.unwrap_or_default();
        written.vertices.extend(others.iter().filter_map(MapEntry::vertex));
        written
    }

    /// Forgets the changes that were undone, and of the others all but the last `keep`. Their memory is used for those that follow.
    /// O(size of the journal).
    pub fn forget(&mut self, keep: usize) {
        self.past.forget(keep);
    }
}

impl MapEntry {
    /// The vertex whose point it is.
    pub(super) const fn vertex(&self) -> Option<usize> {
        if let Self::Point(v, _) = self { Some(*v as usize) } else { None }
    }
}

impl Recorder for PlanarMap {
    type Other = MapEntry;

    fn journal(&mut self) -> Option<&mut Journal> {
        self.notes.journal.as_deref_mut().map(|journal| &mut journal.links)
    }

    fn take_others(&mut self) -> Vec<MapEntry> {
        let entries = self.notes.journal.as_deref_mut().map(|journal| mem::take(&mut journal.entries));
        let mut others = entries.unwrap_or_default();
        if let Some(attributes) = self.dcel.store_mut().attributes_mut() {
            others.extend(attributes.take_log().into_iter().map(MapEntry::Value));
        }
        others
    }

    fn replay(&mut self, links: Range<usize>, others: &mut [MapEntry], way: Way) {
        let redrawn = self.index.if_built().is_some().then(|| Redrawn::new(self, links.clone(), others));
        if let (Some(redrawn), Some(index)) = (&redrawn, self.index.if_built()) {
            redrawn.edges_of(&self.dcel).for_each(|h| index.remove_edge(&IndexedEdge::new(h, &self.points)));
            redrawn.isolated_of(&self.dcel).for_each(|v| index.remove_vertex(v.index(), self.points[v.index()]));
        }
        if let Some(journal) = &mut self.notes.journal {
            journal.links.replay(self.dcel.store_mut(), links, way);
        }
        match way {
            Way::Back => others.iter_mut().rev().for_each(|entry| self.exchange(entry, way)),
            Way::Forth => others.iter_mut().for_each(|entry| self.exchange(entry, way)),
        }
        if let (Some(redrawn), Some(index)) = (&redrawn, self.index.if_built()) {
            redrawn.isolated_of(&self.dcel).for_each(|v| index.add_vertex(v, &self.points));
            redrawn.edges_of(&self.dcel).for_each(|h| index.add_edge(h, &self.points));
        }
    }

    fn begin(&mut self) {
        self.notes.written = None;
        let journal = self.notes.journal.get_or_insert_default();
        journal.entries.clear();
        journal.links.begin(self.dcel.store());
        if let Some(attributes) = self.dcel.store_mut().attributes_mut() {
            attributes.clear_log();
        }
    }

    fn copied(&self) -> Self {
        let mut copy = self.clone();
        let journal = self.notes.journal.as_ref();
        copy.notes.journal = journal.map(|journal| Box::new(MapJournal::clone(journal)));
        copy
    }
}

impl PlanarMap {
    /// Exchanges what is there for what an entry has.
    fn exchange(&mut self, entry: &mut MapEntry, way: Way) {
        match entry {
            MapEntry::Point(v, point) => mem::swap(&mut self.points[*v as usize], point),
            MapEntry::OfFace(f, set) => {
                let had = self.features.of_face(*f as usize);
                self.features.put_face(*f as usize, mem::replace(set, had));
            }
            MapEntry::Along(h, set) => {
                let had = self.features.along(*h as usize);
                self.features.put_along(*h as usize, mem::replace(set, had));
            }
            MapEntry::Feature(name) => match way {
                Way::Back => *name = self.names.pop().flatten().map(String::into_boxed_str),
                Way::Forth => self.names.push(name.take().map(String::from)),
            },
            MapEntry::Name(feature, name) => {
                let removed = FeatureId::new(*feature);
                if !self.features.removed.remove(&removed) {
                    self.features.removed.insert(removed);
                }
                let had = self.names[*feature as usize].take();
                self.names[*feature as usize] = mem::replace(name, had.map(String::into_boxed_str)).map(String::from);
            }
            MapEntry::Value(saved) => {
                if let Some(attributes) = self.dcel.store_mut().attributes_mut() {
                    attributes.exchange(saved);
                }
            }
        }
    }
}

/// Records that are drawn differently before and after a change: edges by their even half-edges, and vertices that may be isolated, by index.
struct Redrawn {
    edges: Vec<usize>,
    vertices: Vec<usize>,
}

impl Redrawn {
    /// Of a change that is about to be taken back or done again.
    fn new(map: &PlanarMap, links: Range<usize>, others: &[MapEntry]) -> Self {
        let journal = map.notes.journal.as_ref().map(|journal| journal.links.redrawn(links));
        let (mut edges, mut vertices) = journal.unwrap_or_default();
        for v in others.iter().filter_map(MapEntry::vertex) {
            vertices.push(v);
            // Those of its edges that come or go are among them already.
            let rotation = map.dcel.vertex_at(v).into_iter().flat_map(|v| v.rotation());
            edges.extend(rotation.map(|h| h.index() & !1));
        }
        for list in [&mut edges, &mut vertices] {
            list.sort_unstable();
            list.dedup();
        }
        Self { edges, vertices }
    }

    /// Those of its edges that are there.
    fn edges_of<'a>(&'a self, dcel: &'a Dcel) -> impl Iterator<Item = HalfEdge<'a>> {
        self.edges.iter().filter_map(|h| dcel.half_edge_at(*h))
    }

    /// Those of its vertices that are there, and are isolated.
    fn isolated_of<'a>(&'a self, dcel: &'a Dcel) -> impl Iterator<Item = Vertex<'a>> {
        self.vertices.iter().filter_map(|v| dcel.vertex_at(*v)).filter(|v| v.isolated().is_some())
    }
}
