//! What can be undone and redone, whatever it is that changes.

use super::timeline::{Mark, Timeline};
use crate::store::{Entry, Journal, Way};
use alloc::borrow::Cow;
use alloc::vec::Vec;

/// A structure that writes a journal while it changes.
pub(crate) trait Recorder {
    /// Something that is written beside the links of records.
    type Other;

    /// The journal; none if there is another structure in place, which writes none.
    fn journal(&mut self) -> Option<&mut Journal>;
    /// What the change that is being made has written beside links, for good.
    fn take_others(&mut self) -> Vec<Self::Other>;
    /// Takes back what was written last, from the end, or writes again what was taken back last.
    fn replay(&mut self, links: &mut [Entry], others: &mut [Self::Other], way: Way);
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
    /// That of the journal, unless the closure of a change puts another structure in place.
    token: Option<u32>,
    links: Vec<Entry>,
    others: Vec<R::Other>,
    /// Each change ends at a place of the logs.
    timeline: Timeline<Place>,
    /// From this place of the links on, the keys that were issued are kept from being issued again.
    kept_from: usize,
    /// The parts of the logs that the last call did or took back.
    last: [Place; 2],
}

impl<R: Recorder<Other: Clone>> Clone for Past<R> {
    fn clone(&self) -> Self {
        let mut recorder = self.recorder.copied();
        let token = recorder.journal().and_then(|journal| journal.token());
        let Self { links, others, timeline, kept_from, last, .. } = self;
        let (links, others, timeline) = (links.clone(), others.clone(), timeline.clone());
        Self { recorder, token, links, others, timeline, kept_from: *kept_from, last: *last }
    }
}

impl<R: Recorder> Past<R> {
    pub(crate) fn new(mut recorder: R) -> Self {
        recorder.begin();
        let token = recorder.journal().and_then(|journal| journal.token());
        let (links, others, timeline) = (Vec::new(), Vec::new(), Timeline::new([0; 2]));
        Self { recorder, token, links, others, timeline, kept_from: 0, last: [[0; 2]; 2] }
    }

    pub(crate) fn change<T, E>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut R) -> Result<T, E>,
    ) -> Result<T, E> {
        let [end, _] = self.timeline.now();
        if let Some(journal) = self.recorder.journal() {
            journal.keep_from(self.links.get(end..self.kept_from).unwrap_or_default());
            journal.save_vacant(self.timeline.redo_name().is_some());
        }
        self.kept_from = self.kept_from.min(end);
        let mut running = Running { past: self, name: None };
        let outcome = change(&mut running.past.recorder);
        if outcome.is_ok() {
            running.name = Some(name.into());
        }
        outcome
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
        self.recorder.replay(&mut self.links[start[0]..end[0]], &mut self.others[start[1]..end[1]], way);
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

    /// What the last call did or took back.
    pub(crate) fn last(&self) -> (&[Entry], &[R::Other]) {
        let [start, end] = self.last;
        (&self.links[start[0]..end[0]], &self.others[start[1]..end[1]])
    }

    pub(crate) fn forget(&mut self, keep: usize) {
        let end = self.timeline.now();
        if let Some(journal) = self.recorder.journal() {
            journal.keep_from(&self.links[end[0]..]);
        }
        let start = self.timeline.forget(keep, |a, b| [a[0] - b[0], a[1] - b[1]]);
        self.links.truncate(end[0]);
        self.links.drain(..start[0]);
        self.links.shrink_to_fit();
        self.others.truncate(end[1]);
        self.others.drain(..start[1]);
        self.others.shrink_to_fit();
        self.kept_from = self.links.len();
        self.last = [self.timeline.now(); 2];
    }

    /// Ends a change that has this name, or failed.
    fn end(&mut self, name: Option<Cow<'static, str>>) {
        let Some(journal) = self.recorder.journal().filter(|journal| journal.token() == self.token) else {
            return self.begin();
        };
        let start = self.timeline.now();
        self.last = [start; 2];
        let mut links = core::mem::take(&mut journal.entries);
        let mut others = self.recorder.take_others();
        match name {
            None => {
                self.recorder.replay(&mut links, &mut others, Way::Back);
                if let Some(journal) = self.recorder.journal() {
                    journal.keep_from(&links);
                }
                links.clear();
            }
            // What can be redone stays if there is nothing to undo.
            Some(_) if links.is_empty() && others.is_empty() => {}
            Some(name) => {
                self.links.truncate(start[0]);
                self.links.append(&mut links);
                self.others.truncate(start[1]);
                self.others.append(&mut others);
                let end = [self.links.len(), self.others.len()];
                self.timeline.add(name, end);
                (self.kept_from, self.last) = (end[0], [start, end]);
            }
        }
        // The memory is used again.
        if let Some(journal) = self.recorder.journal() {
            journal.entries = links;
        }
    }

    /// Begins anew with the structure that is in place.
    fn begin(&mut self) {
        self.recorder.begin();
        self.token = self.recorder.journal().and_then(|journal| journal.token());
        self.links.clear();
        self.others.clear();
        self.timeline = Timeline::new([0; 2]);
        (self.kept_from, self.last) = (0, [[0; 2]; 2]);
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
