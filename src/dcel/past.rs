//! Changes that can be undone and redone, of whatever kind.

use super::timeline::{Mark, Timeline};
use crate::store::{Entry, Journal, Way};
use alloc::borrow::Cow;
use alloc::vec::Vec;
use core::ops::Range;

/// A structure that writes a journal while it changes.
pub(crate) trait Recorder {
    /// Something that is written beside the links of records.
    type Other;

    /// The journal; none if there is another structure in place, which writes none.
    fn journal(&mut self) -> Option<&mut Journal>;
    /// The writes beside links of the change that is being made, for good.
    fn take_others(&mut self) -> Vec<Self::Other>;
    /// Takes back what a part of the journal and others say that was written last, from the end, or writes it again.
    fn replay(&mut self, links: Range<usize>, others: &mut [Self::Other], way: Way);
    /// Starts a new journal.
    fn begin(&mut self);
    /// A clone that writes a journal of its own.
    fn copied(&self) -> Self;
}

/// Places in the two logs, of links and of others.
type Place = [usize; 2];

/// A structure with its changes.
#[derive(Debug)]
pub(crate) struct Past<R: Recorder> {
    pub(crate) recorder: R,
    /// That of the journal, unless the closure of a change puts another structure in place. The entries of the journal are the log of links.
    token: Option<u32>,
    others: Vec<R::Other>,
    /// Each change ends at a place of the logs.
    timeline: Timeline<Place>,
    /// From this place of the links on, the keys that were issued are kept from being issued again.
    kept_from: usize,
    /// The parts of the logs that the last call did or took back.
    last: [Place; 2],
    /// The links that are undone, while another change is being made that may drop them.
    undone: Vec<Entry>,
}

impl<R: Recorder<Other: Clone>> Clone for Past<R> {
    fn clone(&self) -> Self {
        let mut recorder = self.recorder.copied();
        let token = recorder.journal().and_then(|journal| journal.token());
        let Self { others, timeline, kept_from, last, .. } = self;
        let (others, timeline) = (others.clone(), timeline.clone());
        Self { recorder, token, others, timeline, kept_from: *kept_from, last: *last, undone: Vec::new() }
    }
}

impl<R: Recorder> Past<R> {
    pub(crate) fn new(mut recorder: R) -> Self {
        recorder.begin();
        let token = recorder.journal().and_then(|journal| journal.token());
        let timeline = Timeline::new([0; 2]);
        Self {
            recorder,
            token,
            others: Vec::new(),
            timeline,
            kept_from: usize::MAX,
            last: [[0; 2]; 2],
            undone: Vec::new(),
        }
    }

    pub(crate) fn change<T, E>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut R) -> Result<T, E>,
    ) -> Result<T, E> {
        if self.timeline.redo_name().is_some() {
            self.set_aside();
        }
        let mut running = Running { past: self, name: None };
        let outcome = change(&mut running.past.recorder);
        if outcome.is_ok() {
            running.name = Some(name.into());
        }
        outcome
    }

    /// Takes what is undone off the log, to put it back if the change fails.
    #[cold]
    fn set_aside(&mut self) {
        let [end, _] = self.timeline.now();
        let Some(journal) = self.recorder.journal() else { return };
        self.undone = journal.entries.split_off(end);
        let kept = self.kept_from.saturating_sub(end);
        journal.keep_from(&self.undone[..kept.min(self.undone.len())]);
        journal.save_vacant(true);
        self.kept_from = self.kept_from.min(end);
    }

    pub(crate) fn undo(&mut self) -> bool {
        let end = self.timeline.now();
        self.timeline.back().is_some_and(|start| self.replay(start, end, Way::Back))
    }

    pub(crate) fn undo_to(&mut self, mark: Mark) -> bool {
        let end = self.timeline.now();
        self.timeline.back_to(mark, self.token).is_some_and(|start| self.replay(start, end, Way::Back))
    }

    pub(crate) fn redo(&mut self) -> bool {
        let start = self.timeline.now();
        self.timeline.forth().is_some_and(|end| self.replay(start, end, Way::Forth))
    }

    fn replay(&mut self, start: Place, end: Place, way: Way) -> bool {
        self.recorder.replay(start[0]..end[0], &mut self.others[start[1]..end[1]], way);
        self.last = [start, end];
        true
    }

    pub(crate) fn mark(&self) -> Mark {
        self.timeline.mark(self.token)
    }

    pub(crate) fn undo_name(&self) -> Option<&str> {
        self.timeline.undo_name()
    }

    pub(crate) fn redo_name(&self) -> Option<&str> {
        self.timeline.redo_name()
    }

    /// The changes that the last call made or took back: a part of the links, and others.
    pub(crate) fn last(&self) -> (Range<usize>, &[R::Other]) {
        let [start, end] = self.last;
        (start[0]..end[0], &self.others[start[1]..end[1]])
    }

    pub(crate) fn forget(&mut self, keep: usize) {
        let end = self.timeline.now();
        let start = self.timeline.forget(keep, |a, b| [a[0] - b[0], a[1] - b[1]]);
        if let Some(journal) = self.recorder.journal() {
            let undone = journal.entries.split_off(end[0]);
            journal.keep_from(&undone);
            journal.entries.drain(..start[0]);
        }
        self.others.truncate(end[1]);
        self.others.drain(..start[1]);
        self.kept_from = usize::MAX;
        self.last = [self.timeline.now(); 2];
    }

    /// Ends a change that has this name, or failed.
    fn end(&mut self, name: Option<Cow<'static, str>>) {
        let start = self.timeline.now();
        let Some(journal) = self.recorder.journal().filter(|journal| journal.token() == self.token) else {
            return self.begin();
        };
        let links = journal.entries.len();
        let mut others = self.recorder.take_others();
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
                    self.recorder.replay(start[0]..links, &mut others, Way::Back);
                }
                if let Some(journal) = self.recorder.journal() {
                    let failed = journal.entries.split_off(start[0]);
                    journal.keep_from(&failed);
                    journal.entries.append(&mut self.undone);
                }
            }
        }
        if let Some(journal) = self.recorder.journal() {
            journal.save_vacant(false);
        }
    }

    /// Begins anew with the structure that is in place.
    fn begin(&mut self) {
        self.recorder.begin();
        self.token = self.recorder.journal().and_then(|journal| journal.token());
        self.others.clear();
        self.undone.clear();
        self.timeline = Timeline::new([0; 2]);
        (self.kept_from, self.last) = (usize::MAX, [[0; 2]; 2]);
    }
}

/// A change that is being made. It is taken back when this is dropped, unless it has got its name.
struct Running<'a, R: Recorder> {
    past: &'a mut Past<R>,
    name: Option<Cow<'static, str>>,
}

impl<R: Recorder> Drop for Running<'_, R> {
    fn drop(&mut self) {
        self.past.end(self.name.take());
    }
}
