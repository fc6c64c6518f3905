//! A structure whose changes can be taken back.

use super::recorder::{Logged as _, Recorder};
use super::structure::Dcel;
use super::timeline::{Mark, Timeline};
use crate::store::{Entry, Log, Way};
use crate::validate::near::WriteSet;
use alloc::borrow::Cow;
use alloc::vec::Vec;

/// Places in the two logs, of links and of others.
type Place = [usize; 2];

/// A structure whose changes can be taken back and done again: the core of an editor. The structure is a [`Dcel`] or another [`Recorder`], such as a
/// `PlanarMap`.
///
/// A change is any number of operators or edits under one name, which users see in a menu. Either all of them are done or, after an error or a
/// panic, none. [`undo`](Self::undo) and [`redo`](Self::redo) move between the states before and after changes.
///
/// ```
/// use twinedge::dcel::{Dcel, History, OperatorError};
///
/// let mut history = History::new(Dcel::new());
/// let outside = history.get().unbounded_face().key();
/// let v = history.change("add a vertex", |dcel| dcel.add_isolated_vertex(outside))?.vertex;
/// let h = history.change("add a loop", |dcel| Ok::<_, OperatorError>(dcel.connect(v, v, Default::default())?.half_edge))?;
/// assert_eq!(history.undo_name(), Some("add a loop"));
///
/// assert!(history.undo());
/// assert!(history.get().half_edge(h).is_err());
/// assert!(history.redo());
/// assert!(history.get().half_edge(h).is_ok());
///
/// // Not one of the operators is done unless all of them are.
/// let refused = history.change("erase everything", |dcel| {
///     dcel.remove_edge(h)?;
///     dcel.remove_isolated_vertex(v)?;
///     dcel.remove_isolated_vertex(v)
/// });
/// assert!(refused.is_err());
/// assert!(history.get().half_edge(h).is_ok());
/// # Ok::<(), OperatorError>(())
/// ```
///
/// # Keys
///
/// The structure after `undo` *equals* that before the change, keys included. The key of a record that the change removed is live
/// again, and names the same record; the key of a record that it made is stale, until `redo`. A key that a change has issued never
/// names another record: not when the change was taken back, nor when it can no longer be done again.
///
/// # Data beside the structure
///
/// [Attributes](Dcel#attributes) are undone and redone with the structure. Other data that is only added need not be undone: keep it by key in a
/// `HashMap`, add an entry for each record that is made, and leave those of removed records. (A
/// [`SecondaryMap`](super::SecondaryMap) has room for one entry in each slot only.)
///
/// Of a map, positions, features and their names follow, and so do the answers of `PlanarMap::locate`: the index that the map keeps for
/// them is brought along, not built anew. The id of a feature, however, is no more than a number: that of a feature that was taken back is
/// given to the next one.
///
/// # One line, no branches
///
/// A change after some were undone drops those that could be redone, as in nearly all editors: users know it, and a state has one
/// name, its place in the line. To keep what would be dropped, clone the history, O(n), which is rare; a tree of states would
/// cost its bookkeeping in each step, for good. A change that fails, or that writes nothing, drops nothing and is no step.
///
/// # Costs
///
/// Nothing is copied: the log has 12 bytes for each link that was overwritten, 48 for each change, and each value of an attribute, point or set of features that
/// was overwritten, so time and memory are those of the change, whatever the size of the structure. An entry takes some 2 ns to write and to exchange. Beside an operator on a large map, which
/// waits for memory, this is little: splitting a face of a map of a million edges takes 204 ns, as a change 1.03 times as long, and undone
/// 0.4 times. It is much beside an operator of a few links in the cache: splitting an edge takes 11 ns, as a change 3.5 times as long, and undone
/// twice. [`forget`](Self::forget) sets a limit to the memory.
///
/// # Validation
///
/// No sequence of operators breaks a rule, and neither does undoing. To see for yourself, validate what was
/// [`written`](Self::written):
///
/// ```
/// use twinedge::dcel::{Dcel, History};
/// use twinedge::validate::Expectation;
/// use twinedge::validate::near::{Baseline, validate_near};
///
/// let mut history = History::new(Dcel::new());
/// let mut baseline = Baseline::new(history.get(), &Expectation::plane())?;
/// let outside = history.get().unbounded_face().key();
/// history.change("add a vertex", |dcel| dcel.add_isolated_vertex(outside))?;
/// validate_near(&mut baseline, history.get(), &history.written())?;
/// history.undo();
/// validate_near(&mut baseline, history.get(), &history.written())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A clone has the same changes, and its own from then on.
#[derive(Debug)]
pub struct History<D: Recorder = Dcel> {
    structure: D,
    /// The number of the log, unless the closure of a change puts another structure in place.
    token: Option<u32>,
    /// The log of what was overwritten beside links.
    others: Vec<D::Other>,
    /// Each change ends at a place of the logs.
    timeline: Timeline<Place>,
    /// From this place of the links on, the keys that were issued are kept from being issued again.
    kept_from: usize,
    /// The parts of the logs that the last call did or took back.
    last: [Place; 2],
    /// The links that are undone, while another change is being made that may drop them.
    undone: Vec<Entry>,
}

impl<D: Recorder> Clone for History<D> {
    fn clone(&self) -> Self {
        let mut structure = self.structure.clone();
        structure.begin_logs();
        structure.links().store.copy_log(&self.structure.dcel().store);
        let token = structure.dcel().store.log.get().and_then(Log::token);
        let Self { others, timeline, kept_from, last, .. } = self;
        let (others, timeline) = (others.clone(), timeline.clone());
        Self { structure, token, others, timeline, kept_from: *kept_from, last: *last, undone: Vec::new() }
    }
}

impl<D: Recorder> History<D> {
    /// Starts with a structure, and no changes. O(1). The keys stay the same.
    #[must_use]
    pub fn new(structure: D) -> Self {
        let mut history = Self {
            structure,
            token: None,
            others: Vec::new(),
            timeline: Timeline::new([0; 2]),
            kept_from: usize::MAX,
            last: [[0; 2]; 2],
            undone: Vec::new(),
        };
        history.begin();
        history
    }

    /// The structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &D {
        &self.structure
    }

    /// The structure, for good. O(1). It knows nothing of what was undone, so it may issue a key again that an undone change had issued.
    #[must_use]
    pub fn into_inner(mut self) -> D {
        self.structure.end_logs();
        self.structure
    }

    /// Changes the structure by one operator or more, which are undone and redone together.
    ///
    /// The time that the operators take, and O(1) for each link or other value that they write. Changes that could be redone are dropped; if it
    /// fails, they are kept, which takes O(their entries).
    ///
    /// A structure that the closure puts in place of the other, as by assignment or by [`compact`](Dcel::compact), begins a history of its own:
    /// nothing before it can be undone, and an error does not bring the other one back.
    ///
    /// # Errors
    /// That of the closure. The structure is as it was then, and so is what can be redone. The same is so if the closure panics.
    pub fn change<T, E>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut D) -> Result<T, E>,
    ) -> Result<T, E> {
        if self.timeline.redo_name().is_some() {
            self.set_aside();
        }
        if let Some(log) = self.log() {
            log.begin_change();
        }
        let mut running = Running { history: self, name: None };
        let outcome = change(&mut running.history.structure);
        if outcome.is_ok() {
            running.name = Some(name.into());
        }
        outcome
    }

    /// Takes the last change back; false if there is none. At most the time that the change took, and no memory.
    pub fn undo(&mut self) -> bool {
        let end = self.timeline.now();
        self.timeline.back().is_some_and(|start| self.replay(start, end, Way::Back))
    }

    /// Does the last change that was undone again; false if there is none. At most the time that the change took.
    pub fn redo(&mut self) -> bool {
        let start = self.timeline.now();
        self.timeline.forth().is_some_and(|end| self.replay(start, end, Way::Forth))
    }

    /// Takes back all changes since a mark was set; false, and nothing is done, if none of the states before is the one that was marked.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, History};
    ///
    /// let mut history = History::new(Dcel::new());
    /// let outside = history.get().unbounded_face().key();
    /// history.change("add", |dcel| dcel.add_isolated_vertex(outside))?;
    /// let mark = history.mark();
    /// history.change("add", |dcel| dcel.add_isolated_vertex(outside))?;
    /// history.change("add", |dcel| dcel.add_isolated_vertex(outside))?;
    /// assert!(history.undo_to(mark));
    /// assert_eq!(history.get().vertex_count(), 1);
    /// # Ok::<(), twinedge::dcel::OperatorError>(())
    /// ```
    pub fn undo_to(&mut self, mark: Mark) -> bool {
        let end = self.timeline.now();
        self.timeline.back_to(mark, self.token).is_some_and(|start| self.replay(start, end, Way::Back))
    }

    /// Marks the state, so that [`undo_to`](Self::undo_to) finds back to it. O(1).
    #[must_use]
    pub fn mark(&self) -> Mark {
        self.timeline.mark(self.token)
    }

    /// Returns the name of the change that [`undo`](Self::undo) takes back. O(1).
    #[must_use]
    pub fn undo_name(&self) -> Option<&str> {
        self.timeline.undo_name()
    }

    /// Returns the name of the change that [`redo`](Self::redo) does again. O(1).
    #[must_use]
    pub fn redo_name(&self) -> Option<&str> {
        self.timeline.redo_name()
    }

    /// Returns the records that the last change, `undo`, `undo_to` or `redo` wrote, some of them several times: what
    /// [`validate_near`](crate::validate::near::validate_near) needs. O(k) for k links and others.
    #[must_use]
    pub fn written(&self) -> WriteSet {
        let [start, end] = self.last;
        self.structure.written_by(start[0]..end[0], &self.others[start[1]..end[1]])
    }

    /// Forgets the changes that were undone, and of the others all but the last `keep`. Their memory is used for those that follow.
    /// O(size of the logs).
    pub fn forget(&mut self, keep: usize) {
        let end = self.timeline.now();
        let start = self.timeline.forget(keep, |a, b| [a[0] - b[0], a[1] - b[1]]);
        if let Some(log) = self.log() {
            let undone = log.entries.split_off(end[0]);
            log.keep_from(&undone);
            log.entries.drain(..start[0]);
        }
        self.others.truncate(end[1]);
        self.others.drain(..start[1]);
        self.kept_from = usize::MAX;
        self.last = [self.timeline.now(); 2];
    }

    /// The log of links; none if there is another structure in place, which has none.
    fn log(&mut self) -> Option<&mut Log> {
        self.structure.links().store.log.get_mut()
    }

    /// Takes what is undone off the log, to put it back if the change fails.
    #[cold]
    fn set_aside(&mut self) {
        let [end, _] = self.timeline.now();
        let kept = self.kept_from.saturating_sub(end);
        let Some(log) = self.log() else { return };
        let undone = log.entries.split_off(end);
        log.keep_from(&undone[..kept.min(undone.len())]);
        log.set_saves_vacant(true);
        self.undone = undone;
        self.kept_from = self.kept_from.min(end);
    }

    fn replay(&mut self, start: Place, end: Place, way: Way) -> bool {
        self.structure.replay(start[0]..end[0], &mut self.others[start[1]..end[1]], way);
        self.last = [start, end];
        true
    }

    /// Ends a change that has this name, or failed.
    fn end(&mut self, name: Option<Cow<'static, str>>) {
        let start = self.timeline.now();
        let token = self.token;
        let Some(log) = self.log().filter(|log| log.token() == token) else {
            return self.begin();
        };
        let links = log.entries.len();
        let mut others = self.structure.others();
        self.last = [start; 2];
        match name {
            Some(name) if links > start[0] || !others.is_empty() => {
                self.others.truncate(start[1]);
                self.others.append(&mut others);
                let end = [links, self.others.len()];
                self.timeline.add(name, end);
                (self.kept_from, self.last) = (usize::MAX, [start, end]);
                self.undone.clear();
            }
            name => {
                if name.is_none() {
                    self.structure.replay(start[0]..links, &mut others, Way::Back);
                }
                let mut undone = core::mem::take(&mut self.undone);
                if let Some(log) = self.log() {
                    let failed = log.entries.split_off(start[0]);
                    log.keep_from(&failed);
                    log.entries.append(&mut undone);
                }
                self.undone = undone;
            }
        }
        if let Some(log) = self.log() {
            log.set_saves_vacant(false);
        }
    }

    /// Begins anew with the structure that is in place.
    fn begin(&mut self) {
        self.token = self.structure.begin_logs();
        self.others.clear();
        self.undone.clear();
        self.timeline = Timeline::new([0; 2]);
        (self.kept_from, self.last) = (usize::MAX, [[0; 2]; 2]);
    }
}

/// A change that is being made. It is taken back when this is dropped, unless it has got its name.
struct Running<'a, D: Recorder> {
    history: &'a mut History<D>,
    name: Option<Cow<'static, str>>,
}

impl<D: Recorder> Drop for Running<'_, D> {
    fn drop(&mut self) {
        self.history.end(self.name.take());
    }
}
