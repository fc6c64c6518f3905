//! The interface between a structure around a [`Dcel`] and the histories and audits of its changes.

use super::structure::Dcel;
use crate::store::attributes::{Attributes, Saved};
use crate::store::{Log, Way};
use crate::validate::near::WriteSet;
use alloc::vec::Vec;
use core::ops::Range;

/// The right to write to the [`Dcel`] inside a [`Recorder`]. Only a [`History`](super::History) and an
/// [`Audited`](super::Audited) have it, so nobody else changes the links behind the back of a structure.
#[derive(Debug)]
pub struct Access(());

/// A [`Dcel`], or a structure around one that has more than its links. While the log of the `Dcel` is on, the structure logs what is
/// overwritten of that, too.
///
/// [`History`](super::History) and [`Audited`](super::Audited) take any such structure.
pub trait Recorder: Clone {
    /// Something that was overwritten and is no link of the `Dcel`.
    type Other: Clone;

    /// The structure of links.
    fn dcel(&self) -> &Dcel;

    /// The structure of links, for a history or an audit.
    fn dcel_mut(&mut self, access: Access) -> &mut Dcel;

    /// Begins to log others than links, and forgets the others that were logged; or ends that log.
    fn log_others(&mut self, on: bool, access: Access);

    /// Takes the others that the present change has overwritten.
    fn take_others(&mut self, access: Access) -> Vec<Self::Other>;

    /// Applies a rewrite of the links, and exchanges the others for what is there: from the last to the first, if the
    /// [way](Rewrite::way) leads back.
    fn rewrite(&mut self, links: Rewrite, others: &mut [Self::Other]);

    /// Adds to the records whose links were written those of others.
    fn add_written(&self, written: &mut WriteSet, others: &[Self::Other]) {
        let _ = (written, others);
    }
}

/// A part of the log, to be taken back or to be written again.
#[derive(Debug)]
#[must_use = "nothing is rewritten until it is applied"]
pub struct Rewrite {
    part: Range<usize>,
    way: Way,
    token: Option<u32>,
    /// True if what is taken back is for good.
    forgets: bool,
}

impl Rewrite {
    /// The direction. O(1).
    #[must_use]
    pub const fn way(&self) -> Way {
        self.way
    }

    /// The half-edges with an even index and the vertices, by index, of edges and vertices that came or went, of edges that have another
    /// end, and of vertices that may be isolated or not; each perhaps several times. O(entries).
    #[must_use]
    pub fn redrawn(&self, dcel: &Dcel) -> (Vec<usize>, Vec<usize>) {
        let log = dcel.store.log.get().filter(|log| self.is_of(log));
        log.map(|log| log.redrawn(self.part.clone())).unwrap_or_default()
    }

    /// Rewrites the links. Nothing happens if the log has gone on since, or is another one. O(entries).
    pub fn apply(self, dcel: &mut Dcel) {
        if dcel.store.log.get().is_some_and(|log| self.is_of(log)) {
            let start = self.part.start;
            dcel.store.replay(self.part, self.way);
            if let (true, Some(log)) = (self.forgets, dcel.store.log.get_mut()) {
                let failed = log.entries.split_off(start);
                log.keep_from(&failed);
                log.cut_back(start);
            }
        }
    }

    fn is_of(&self, log: &Log) -> bool {
        let end = self.part.end;
        log.token() == self.token && if self.forgets { end == log.entries.len() } else { end <= log.entries.len() }
    }
}

/// A place in the log of a [`Dcel`].
#[derive(Clone, Copy, Debug)]
pub struct LogPlace {
    entries: usize,
    serial: u64,
    token: Option<u32>,
}

impl Dcel {
    /// Begins a log of the links that are overwritten, as another one than before: a [`History`](super::History) of this structure begins
    /// anew. O(1).
    pub fn begin_log(&mut self) {
        self.store.begin_log();
    }

    /// Keeps no log any more. O(1).
    pub fn end_log(&mut self) {
        self.store.end_log();
    }

    /// The end of the log, if one is kept. O(1).
    #[must_use]
    pub fn log_place(&self) -> Option<LogPlace> {
        self.store.log.get().map(|log| LogPlace {
            entries: log.entries.len(),
            serial: log.serial(),
            token: log.token(),
        })
    }

    /// The records that were written since a place in the log, some of them several times; none if the log is another one. O(entries).
    #[must_use]
    pub fn written_since(&self, place: LogPlace) -> WriteSet {
        let log = self.store.log.get().filter(|log| log.token() == place.token && place.entries <= log.entries.len());
        log.map(|log| self.store.written(place.entries..log.entries.len())).unwrap_or_default()
    }

    /// The rewrite that takes back, for good, what was written since a place in the log. O(1).
    ///
    /// It does nothing if the place is of an earlier change, of another log, or if the log was rolled back to before it since.
    pub fn roll_back(&mut self, to: LogPlace) -> Rewrite {
        let log = self.store.log.get().filter(|log| log.has_kept(to.entries, to.serial));
        let end = log.map_or(to.entries, |log| log.entries.len());
        Rewrite { part: to.entries..end, way: Way::Back, token: log.and(to.token), forgets: true }
    }
}

/// The work of histories and audits on the logs.
pub(super) trait Logged: Recorder {
    /// The links, to write to their log.
    fn links(&mut self) -> &mut Dcel {
        self.dcel_mut(Access(()))
    }

    /// Begins both logs anew. Returns the number of that of links, which no other has.
    fn begin_logs(&mut self) -> Option<u32> {
        self.log_others(true, Access(()));
        let store = &mut self.links().store;
        store.begin_log();
        store.log.get().and_then(Log::token)
    }

    /// Keeps no log any more.
    fn end_logs(&mut self) {
        self.log_others(false, Access(()));
        self.links().store.end_log();
    }

    /// The others that the present change has overwritten.
    fn others(&mut self) -> Vec<Self::Other> {
        self.take_others(Access(()))
    }

    /// Takes back what a part of the log and others say was written last, or writes it again.
    fn replay(&mut self, part: Range<usize>, others: &mut [Self::Other], way: Way) {
        let token = self.dcel().store.log.get().and_then(Log::token);
        self.rewrite(Rewrite { part, way, token, forgets: false }, others);
    }

    /// The records that a part of the log and others wrote.
    fn written_by(&self, part: Range<usize>, others: &[Self::Other]) -> WriteSet {
        let mut written = self.dcel().store.written(part);
        self.add_written(&mut written, others);
        written
    }

    /// The records that were written since the logs were begun or taken last.
    fn take_written(&mut self) -> WriteSet {
        let others = self.others();
        let links = self.dcel().store.log.get().map_or(0, |log| log.entries.len());
        let written = self.written_by(0..links, &others);
        if let Some(log) = self.links().store.log.get_mut() {
            log.entries.clear();
            log.begin_change();
        }
        written
    }
}

impl<D: Recorder> Logged for D {}

impl Recorder for Dcel {
    type Other = Saved;

    fn dcel(&self) -> &Dcel {
        self
    }

    fn dcel_mut(&mut self, _: Access) -> &mut Dcel {
        self
    }

    fn log_others(&mut self, _: bool, access: Access) {
        let _ = self.take_others(access);
    }

    fn take_others(&mut self, _: Access) -> Vec<Saved> {
        self.store.attributes_mut().map(Attributes::take_log).unwrap_or_default()
    }

    fn rewrite(&mut self, links: Rewrite, others: &mut [Saved]) {
        let way = links.way();
        links.apply(self);
        if let Some(attributes) = self.store.attributes_mut() {
            match way {
                Way::Back => others.iter_mut().rev().for_each(|saved| attributes.exchange(saved)),
                Way::Forth => others.iter_mut().for_each(|saved| attributes.exchange(saved)),
            }
        }
    }
}
