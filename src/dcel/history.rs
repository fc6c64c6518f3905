//! A structure with undo and redo.

use super::recorder::{Logged as _, Recorder};
use super::structure::Dcel;
use crate::store::{Entry, Log, Way};
use crate::validate::near::WriteSet;
use alloc::borrow::Cow;
use alloc::vec::Vec;

/// Positions in the log of links and in the log of other values.
type Place = [usize; 2];

/// A structure with undo and redo: the core of an editor. The structure is a [`Dcel`] or another [`Recorder`], such as a `PlanarMap`.
///
/// A change is any number of operators or edits under one name, which users see in a menu. It is atomic: after an error or a panic
/// nothing has changed. [`undo`](Self::undo) and [`redo`](Self::redo) move between the states before and after changes.
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
/// After `undo` the structure *equals* the structure before the change, including keys. Keys of records that the change removed are
/// live again and name the same records; keys of records that it made are stale until `redo`. A key issued by a change never names
/// another record, even after the change was undone or can no longer be redone.
///
/// # Other data
///
/// [Attributes](Dcel#attributes) are undone and redone with the structure. Data that only grows needs no undo: store it
/// by key in a `HashMap`, insert an entry for each new record, and keep the entries of removed records. (A
/// [`SecondaryMap`](super::SecondaryMap) has room for only one entry per slot.)
///
/// In a map, undo covers positions, features and their names, and `PlanarMap::locate`, whose index is updated rather than rebuilt. A
/// feature id, however, is a plain number: undoing an insertion frees it for reuse.
///
/// # Linear history
///
/// A change made after `undo` discards the changes that could be redone, as in nearly all editors: users know this behaviour, and the
/// position in the line identifies a state. To keep the discarded changes, clone the history first, O(n); a tree of states would add
/// its bookkeeping to every step. A change that fails or writes nothing is not recorded and discards nothing.
///
/// # Costs
///
/// Nothing is copied. The log has 12 bytes for each overwritten link, 48 for each change, and every overwritten value of an attribute,
/// point or set of features, so time and memory depend on the change, not on the size of the structure. Writing or exchanging an entry
/// takes about 2 ns. Operators on a large map wait for memory, so the overhead is small: in a map of a million edges, splitting a face
/// takes 204 ns, 1.03 times as long as a change, and 0.4 times as long to undo. For an operator on a few cached links it is large:
/// splitting an edge takes 11 ns, 3.5 times as long as a change, and twice as long to undo. [`forget`](Self::forget) limits the memory.
///
/// # Validation
///
/// Neither operators nor undo break a rule. To check that, validate the [`written`](Self::written) records:
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
/// A clone starts with the same changes and is then independent.
#[derive(Debug)]
pub struct History<D: Recorder = Dcel> {
    structure: D,
    /// The number of the log, unless the closure of a change replaces the structure.
    token: Option<u32>,
    /// The log of overwritten values other than links.
    others: Vec<D::Other>,
    /// The changes; each ends at a position in the logs.
    timeline: Timeline<Place>,
    /// Keys issued from this position of the log of links on are kept from being issued again.
    kept_from: usize,
    /// The parts of the logs that the last call wrote or replayed.
    last: [Place; 2],
    /// Redo entries, set aside while a change that may discard them runs.
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
    /// Wraps a structure, without changes. Keys stay valid. O(1).
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

    /// Returns the structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &D {
        &self.structure
    }

    /// Returns the structure, consuming the history. O(1). Keys issued by undone changes may then be issued again.
    #[must_use]
    pub fn into_inner(mut self) -> D {
        self.structure.end_logs();
        self.structure
    }

    /// Changes the structure by any number of operators, undone and redone together.
    ///
    /// Takes the time of the operators, plus O(1) for each link or other value that they write. Discards changes that could be redone;
    /// if the change fails it keeps them, in O(their entries).
    ///
    /// If the closure replaces the structure, by assignment or by [`compact`](Dcel::compact), a new history begins: earlier changes
    /// cannot be undone, and an error does not restore the old structure.
    ///
    /// # Errors
    /// Returns the closure's error. On error or panic the structure and the redo list are unchanged.
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

    /// Undoes the last change; returns false if there is none. At most the time of the change, and no memory.
    pub fn undo(&mut self) -> bool {
        let end = self.timeline.now();
        self.timeline.back().is_some_and(|start| self.replay(start, end, Way::Back))
    }

    /// Redoes the last undone change; returns false if there is none. At most the time of the change.
    pub fn redo(&mut self) -> bool {
        let start = self.timeline.now();
        self.timeline.forth().is_some_and(|end| self.replay(start, end, Way::Forth))
    }

    /// Undoes all changes since a mark was set. Returns false, and does nothing, if no earlier state is the marked one.
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

    /// Marks the current state for [`undo_to`](Self::undo_to). O(1).
    #[must_use]
    pub fn mark(&self) -> Mark {
        self.timeline.mark(self.token)
    }

    /// Returns the name of the change that [`undo`](Self::undo) would undo. O(1).
    #[must_use]
    pub fn undo_name(&self) -> Option<&str> {
        self.timeline.undo_name()
    }

    /// Returns the name of the change that [`redo`](Self::redo) would redo. O(1).
    #[must_use]
    pub fn redo_name(&self) -> Option<&str> {
        self.timeline.redo_name()
    }

    /// Returns the records written by the last change, `undo`, `undo_to` or `redo`, possibly with repetitions, as input for
    /// [`validate_near`](crate::validate::near::validate_near). O(k) for k links and other values.
    #[must_use]
    pub fn written(&self) -> WriteSet {
        let [start, end] = self.last;
        let mut written = WriteSet::default();
        self.structure.add_written_by(start[0]..end[0], &self.others[start[1]..end[1]], &mut written);
        written
    }

    /// Forgets all undone changes, and all but the last `keep` of the others. Reuses their memory. O(size of the logs).
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

    /// Returns the log of links; `None` if the structure was replaced.
    fn log(&mut self) -> Option<&mut Log> {
        self.structure.links().store.log.get_mut()
    }

    /// Moves undone entries off the log, to restore them if the change fails.
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

    /// Ends a change: records it under `name`, or rolls it back if it failed.
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

    fn begin(&mut self) {
        self.token = self.structure.begin_logs();
        self.others.clear();
        self.undone.clear();
        self.timeline = Timeline::new([0; 2]);
        (self.kept_from, self.last) = (usize::MAX, [[0; 2]; 2]);
    }
}

/// A running change. Dropping it rolls the change back unless it has a name.
struct Running<'a, D: Recorder> {
    history: &'a mut History<D>,
    name: Option<Cow<'static, str>>,
}

impl<D: Recorder> Drop for Running<'_, D> {
    fn drop(&mut self) {
        self.history.end(self.name.take());
    }
}

/// A state of a history, to which [`undo_to`](super::History::undo_to) returns.
///
/// It identifies the state itself, not a number of changes: a mark is useless once its state can no longer be reached. A mark of
/// another history, even a clone, is also useless.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Mark {
    token: Option<u32>,
    serial: u64,
}

#[derive(Clone, Debug)]
struct Step<E> {
    name: Cow<'static, str>,
    end: E,
    /// Greater than all earlier serial numbers; never reused.
    serial: u64,
}

/// The steps of a history, the first `done` of them in effect, each ending at a position in a log.
#[derive(Clone, Debug)]
pub(crate) struct Timeline<E> {
    /// The position in the log and the serial number before the first step.
    start: (E, u64),
    steps: Vec<Step<E>>,
    done: usize,
    last_serial: u64,
}

impl<E: Copy> Timeline<E> {
    pub(crate) const fn new(start: E) -> Self {
        Self { start: (start, 0), steps: Vec::new(), done: 0, last_serial: 0 }
    }

    fn end_of(&self, steps: usize) -> E {
        steps.checked_sub(1).map_or(self.start.0, |last| self.steps[last].end)
    }

    fn serial_of(&self, steps: usize) -> u64 {
        steps.checked_sub(1).map_or(self.start.1, |last| self.steps[last].serial)
    }

    pub(crate) fn now(&self) -> E {
        self.end_of(self.done)
    }

    pub(crate) fn undo_name(&self) -> Option<&str> {
        self.done.checked_sub(1).map(|last| &*self.steps[last].name)
    }

    pub(crate) fn redo_name(&self) -> Option<&str> {
        self.steps.get(self.done).map(|step| &*step.name)
    }

    /// Adds a step that ends at a position in the log, discarding undone steps.
    pub(crate) fn add(&mut self, name: Cow<'static, str>, end: E) {
        self.steps.truncate(self.done);
        self.last_serial += 1;
        self.steps.push(Step { name, end, serial: self.last_serial });
        self.done += 1;
    }

    /// Goes back one step. Returns the position in the log where it began.
    pub(crate) fn back(&mut self) -> Option<E> {
        self.done = self.done.checked_sub(1)?;
        Some(self.now())
    }

    /// Goes forward one step. Returns the position in the log where it ends.
    pub(crate) fn forth(&mut self) -> Option<E> {
        let end = self.steps.get(self.done)?.end;
        self.done += 1;
        Some(end)
    }

    pub(crate) fn mark(&self, token: Option<u32>) -> Mark {
        Mark { token, serial: self.serial_of(self.done) }
    }

    /// Goes back to a mark. Returns its position in the log; `None` if the mark is not behind. O(log steps).
    pub(crate) fn back_to(&mut self, mark: Mark, token: Option<u32>) -> Option<E> {
        let steps = self.steps[..self.done].partition_point(|step| step.serial <= mark.serial);
        if mark.token != token || self.serial_of(steps) != mark.serial {
            return None;
        }
        self.done = steps;
        Some(self.now())
    }

    /// Forgets the undone steps, and all but the last `keep` of the others. Returns the position in the log where the kept steps begin,
    /// and subtracts it from all other positions.
    pub(crate) fn forget(&mut self, keep: usize, less: impl Fn(E, E) -> E) -> E {
        self.steps.truncate(self.done);
        let gone = self.done.saturating_sub(keep);
        let start = self.end_of(gone);
        self.start = (less(start, start), self.serial_of(gone));
        self.steps.drain(..gone);
        self.steps.iter_mut().for_each(|step| step.end = less(step.end, start));
        self.done = self.steps.len();
        start
    }
}
