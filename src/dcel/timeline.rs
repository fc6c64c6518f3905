//! The changes of a history in order, and the number of changes in effect.

use alloc::borrow::Cow;
use alloc::vec::Vec;

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
