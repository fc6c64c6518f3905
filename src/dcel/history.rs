//! A structure whose changes can be taken back.

use super::past::{Past, Recorder};
use super::structure::Dcel;
use super::timeline::Mark;
use super::watched::Watched;
use crate::store::attributes::{Attributes, Saved};
use crate::store::links::Links;
use crate::store::{Journal, SlotStore, Way};
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
/// again, and names the same record; the key of a record that it made is stale, until `redo`. A key that a change has issued never
/// names another record: not when the change was taken back, nor when it can no longer be done again.
///
/// # Data beside the structure
///
/// [Attributes](Dcel#attributes) are undone and redone with the structure. Other data that is only added need not be undone: keep it by key in a
/// `HashMap`, add an entry for each record that is made, and leave those of removed records. (A
/// [`SecondaryMap`](super::SecondaryMap) has room for one entry in each slot only.)
///
/// # One line, no branches
///
/// A change after some were undone drops those that could be redone, as in nearly all editors: users know it, and a state has one
/// name, its place in the line. To keep what would be dropped, clone the history, O(n), which is rare; a tree of states would
/// cost its bookkeeping in each step, for good. A change that fails, or that writes nothing, drops nothing and is no step.
///
/// # Costs
///
/// Nothing is copied: the journal has 12 bytes for each link that was overwritten, 48 for each change, and each value of an attribute that was overwritten, so time and memory are those of
/// the change, whatever the size of the structure. An entry takes some 2 ns to write and to exchange. Beside an operator on a large map, which
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
#[derive(Clone, Debug)]
pub struct History {
    past: Past<Dcel<Recorded>>,
}

/// The store of the structure that the closures of [`History::change`] are given.
pub type Recorded = Watched<SlotStore, Journal>;

impl History {
    /// Starts with a structure, and no changes. O(1). The keys stay the same.
    #[must_use]
    pub fn new(dcel: Dcel) -> Self {
        Self { past: Past::new(Dcel::watched_by(dcel, Journal::default())) }
    }

    /// The structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &Dcel {
        &self.past.recorder.store.dcel
    }

    /// The structure, for good. O(1). It knows nothing of what was undone, so it may issue a key again that an undone change had issued.
    #[must_use]
    pub fn into_dcel(self) -> Dcel {
        self.past.recorder.store.dcel
    }

    /// Changes the structure by one operator or more, which are undone and redone together.
    ///
    /// The time that the operators take, and O(1) for each link that they write. Changes that could be redone are dropped; if it
    /// fails, they are kept, which takes O(their entries).
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
        self.past.change(name, change)
    }

    /// Takes the last change back; false if there is none. At most the time that the change took, and no memory.
    pub fn undo(&mut self) -> bool {
        self.past.undo()
    }

    /// Does the last change that was undone again; false if there is none. At most the time that the change took.
    pub fn redo(&mut self) -> bool {
        self.past.redo()
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

    /// Returns the records that the last change, `undo`, `undo_to` or `redo` wrote, some of them several times. O(k) for k links.
    #[must_use]
    pub fn written(&self) -> WriteSet {
        self.past.recorder.store.watch.written(&self.get().store, self.past.last().0)
    }

    /// Forgets the changes that were undone, and of the others all but the last `keep`. Their memory is used for those that follow.
    /// O(size of the journal).
    pub fn forget(&mut self, keep: usize) {
        self.past.forget(keep);
    }
}

impl Recorder for Dcel<Recorded> {
    type Other = Saved;

    fn journal(&mut self) -> Option<&mut Journal> {
        Some(&mut self.store.watch)
    }

    fn take_others(&mut self) -> Vec<Saved> {
        self.store.attributes_mut().map(Attributes::take_log).unwrap_or_default()
    }

    fn replay(&mut self, links: Range<usize>, others: &mut [Saved], way: Way) {
        self.store.watch.replay(&mut self.store.dcel.store, links, way);
        if let Some(attributes) = self.store.attributes_mut() {
            match way {
                Way::Back => others.iter_mut().rev().for_each(|saved| attributes.exchange(saved)),
                Way::Forth => others.iter_mut().for_each(|saved| attributes.exchange(saved)),
            }
        }
    }

    fn copied(&self) -> Self {
        self.clone()
    }

    fn begin(&mut self) {
        self.store.watch.begin(&self.store.dcel.store);
        let _ = self.take_others();
    }
}
