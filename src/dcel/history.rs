//! A structure whose changes can be taken back.

use super::structure::Dcel;
use super::timeline::{Mark, Timeline};
use super::watched::Watched;
use crate::store::{Entry, Journal, SlotStore};
use crate::validate::near::WriteSet;
use alloc::borrow::Cow;
use alloc::vec::Vec;
use core::ops::Range;

/// A [`Dcel`] whose changes can be taken back and done again: the core of an editor.
///
/// A change is any number of operators under one name, which users see in a menu. Either all of them are done or, after an error or a
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
/// again, and names the same record; the key of a record that it made is stale, until `redo`. Data kept in a
/// [`SecondaryMap`](super::SecondaryMap) need not be touched when records come and go, if nothing but their keys counts. A key that a
/// change has issued never names another record: not when the change was taken back, nor when it can no longer be done again.
///
/// # One line, no branches
///
/// A change after some were undone drops those that could be redone, as in nearly all editors: users know it, and a state has one
/// name, its place in the line. To keep what would be dropped, clone the history, O(n), which is rare; a tree of states would
/// cost its bookkeeping in each step, for good. A change that fails, or that writes nothing, drops nothing and is no step.
///
/// # Costs
///
/// Nothing is copied: the journal has 12 bytes for each link that was overwritten, and 40 for each change. So a change takes what
/// its operators take, and a part of that for the journal; `undo` and `redo` take less than the operators took, whatever the size of
/// the structure. [`forget`](Self::forget) gives the memory back.
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
#[derive(Debug)]
pub struct History {
    dcel: Dcel<Recorded>,
    /// That of the journal, unless the closure of a change puts another structure in place.
    token: Option<u32>,
    log: Vec<Entry>,
    /// Each change ends at a place of the log.
    timeline: Timeline<usize>,
    /// From this place of the log on, the keys that were issued are kept from being issued again.
    kept_from: usize,
    /// The part of the log that the last call did or took back.
    last: Range<usize>,
}

/// The store of the structure that the closures of [`History::change`] are given.
pub type Recorded = Watched<SlotStore, Journal>;

/// A clone has the same changes, and its own from then on. O(n).
impl Clone for History {
    fn clone(&self) -> Self {
        let Self { dcel, log, timeline, kept_from, last, .. } = self;
        let dcel = dcel.clone();
        let token = dcel.store.watch.token();
        Self { dcel, token, log: log.clone(), timeline: timeline.clone(), kept_from: *kept_from, last: last.clone() }
    }
}

impl History {
    /// Starts with a structure, and no changes. O(1). The keys stay the same.
    #[must_use]
    pub fn new(dcel: Dcel) -> Self {
        let mut journal = Journal::default();
        journal.begin(&dcel.store);
        let token = journal.token();
        let dcel = Dcel::watched_by(dcel, journal);
        Self { dcel, token, log: Vec::new(), timeline: Timeline::new(0), kept_from: 0, last: 0..0 }
    }

    /// The structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &Dcel {
        &self.dcel.store.dcel
    }

    /// The structure, for good. O(1).
    #[must_use]
    pub fn into_dcel(self) -> Dcel {
        self.dcel.store.dcel
    }

    /// Changes the structure by one operator or more, which are undone and redone together.
    ///
    /// The time that the operators take, and O(1) for each link that they write. Changes that could be redone are dropped.
    ///
    /// A structure that the closure puts in place of the other, as by [`core::mem::swap`], begins a history of its own: nothing before
    /// it can be undone, and an error does not bring the other one back.
    ///
    /// # Errors
    /// That of the closure. The structure is as it was then, and so is what can be redone. The same is so if the closure panics.
    pub fn change<T, E>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut Dcel<Recorded>) -> Result<T, E>,
    ) -> Result<T, E> {
        let end = self.timeline.now();
        let undone = self.log.get(end..self.kept_from).unwrap_or_default();
        let journal = &mut self.dcel.store.watch;
        journal.keep_from(undone);
        journal.save_vacant(self.timeline.redo_name().is_some());
        self.kept_from = self.kept_from.min(end);
        let mut running = Running { history: self, name: None };
        let outcome = change(&mut running.history.dcel);
        if outcome.is_ok() {
            running.name = Some(name.into());
        }
        outcome
    }

    /// Takes the last change back; false if there is none. At most the time that the change took, and no memory.
    pub fn undo(&mut self) -> bool {
        let end = self.timeline.now();
        self.timeline.back().is_some_and(|start| self.take_back(start..end))
    }

    /// Does the last change that was undone again; false if there is none. At most the time that the change took.
    pub fn redo(&mut self) -> bool {
        let start = self.timeline.now();
        let Some(end) = self.timeline.forth() else { return false };
        let Watched { dcel, watch } = &mut self.dcel.store;
        dcel.store.redo(&mut self.log[start..end]);
        watch.follow(&dcel.store);
        self.last = start..end;
        true
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
        self.timeline.back_to(mark, self.token).is_some_and(|start| self.take_back(start..end))
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

    /// Returns the records that the last change, `undo`, `undo_to` or `redo` wrote, some of them several times. O(k) for k links.
    #[must_use]
    pub fn written(&self) -> WriteSet {
        self.get().store.written(&self.log[self.last.clone()])
    }

    /// Forgets the changes that were undone, and of the others all but the last `keep`, to save memory. O(size of the journal).
    pub fn forget(&mut self, keep: usize) {
        let end = self.timeline.now();
        self.dcel.store.watch.keep_from(&self.log[end..]);
        let (from, to) = self.timeline.forget(keep, |a, b| a - b);
        self.log.truncate(to);
        self.log.drain(..from);
        self.log.shrink_to_fit();
        self.kept_from = self.log.len();
        self.last = 0..0;
    }

    /// Takes back what a part of the log says that was done last.
    fn take_back(&mut self, part: Range<usize>) -> bool {
        let Watched { dcel, watch } = &mut self.dcel.store;
        dcel.store.undo(&mut self.log[part.clone()]);
        watch.follow(&dcel.store);
        self.last = part;
        true
    }
}

/// A change that is being made. It is taken back when this is dropped, unless it has got its name.
struct Running<'a> {
    history: &'a mut History,
    name: Option<Cow<'static, str>>,
}

impl Drop for Running<'_> {
    fn drop(&mut self) {
        let History { dcel, token, log, timeline, kept_from, last } = &mut *self.history;
        let Watched { dcel, watch } = &mut dcel.store;
        if watch.token() != *token {
            watch.begin(&dcel.store);
            (*token, *timeline) = (watch.token(), Timeline::new(0));
            log.clear();
            (*kept_from, *last) = (0, 0..0);
            return;
        }
        let end = timeline.now();
        let Some(name) = self.name.take() else {
            watch.take_back(&mut dcel.store);
            *last = end..end;
            return;
        };
        if watch.entries.is_empty() {
            *last = end..end;
            return;
        }
        log.truncate(end);
        log.append(&mut watch.entries);
        timeline.add(name, log.len());
        (*kept_from, *last) = (log.len(), end..log.len());
    }
}
