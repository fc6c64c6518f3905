//! The interface between a structure around a [`Dcel`], and histories and audits of its changes.

use super::structure::Dcel;
use crate::store::attributes::{Attributes, Saved};
use crate::store::{Log, Way};
use crate::validate::near::WriteSet;
use alloc::vec::Vec;
use core::ops::Range;

/// Permission to write to the [`Dcel`] inside a [`Recorder`]. Only a [`History`](super::History) and an [`Audited`](super::Audited)
/// have it, so no other code can change the links unnoticed.
#[derive(Debug)]
pub struct Access(());

/// A [`Dcel`], or a structure around one with values besides links. While the log of the `Dcel` is on, the structure also logs its own
/// overwritten values.
///
/// [`History`](super::History) and [`Audited`](super::Audited) accept any such structure.
pub trait Recorder: Clone {
    /// An overwritten value that is not a link of the `Dcel`.
    type Other: Clone;

    /// Returns the structure of links.
    fn dcel(&self) -> &Dcel;

    /// Returns the structure of links, for a history or an audit.
    fn dcel_mut(&mut self, access: Access) -> &mut Dcel;

    /// Turns the log of other values on, clearing it, or off.
    fn log_others(&mut self, on: bool, access: Access);

    /// Takes the other values overwritten by the current change.
    fn take_others(&mut self, access: Access) -> Vec<Self::Other>;

    /// Applies a rewrite of the links, and exchanges the other values with the current ones: from last to first if the
    /// [way](Rewrite::way) leads back.
    fn rewrite(&mut self, links: Rewrite, others: &mut [Self::Other]);

    /// Adds the records whose other values were written to the records whose links were written.
    fn add_written(&self, written: &mut WriteSet, others: &[Self::Other]) {
        let _ = (written, others);
    }
}

/// A part of the log, to be undone or redone.
#[derive(Debug)]
#[must_use = "nothing is rewritten until it is applied"]
pub struct Rewrite {
    part: Range<usize>,
    way: Way,
    token: Option<u32>,
    /// True if undoing is permanent.
    forgets: bool,
}

impl Rewrite {
    /// Returns the direction. O(1).
    #[must_use]
    pub const fn way(&self) -> Way {
        self.way
    }

    /// Returns the even half-edges and the vertices, by index, of edges and vertices that were added or removed, of edges with a
    /// different end, and of vertices that may have become isolated or ceased to be; possibly with repetitions. O(entries).
    #[must_use]
    pub fn redrawn(&self, dcel: &Dcel) -> (Vec<usize>, Vec<usize>) {
        let log = dcel.store.log.get().filter(|log| self.is_of(log));
        log.map(|log| log.redrawn(self.part.clone())).unwrap_or_default()
    }

    /// Rewrites the links. Has no effect if the log has grown since, or is a different log. O(entries).
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

/// A position in the log of a [`Dcel`].
#[derive(Clone, Copy, Debug)]
pub struct LogPlace {
    entries: usize,
    serial: u64,
    token: Option<u32>,
}

impl Dcel {
    /// Begins a new log of overwritten links. A [`History`](super::History) of this structure then starts again. O(1).
    pub fn begin_log(&mut self) {
        self.store.begin_log();
    }

    /// Ends the log. O(1).
    pub fn end_log(&mut self) {
        self.store.end_log();
    }

    /// Returns the end of the log, if there is one. O(1).
    #[must_use]
    pub fn log_place(&self) -> Option<LogPlace> {
        self.store.log.get().map(|log| LogPlace {
            entries: log.entries.len(),
            serial: log.serial(),
            token: log.token(),
        })
    }

    /// Returns the records written since a position in the log, possibly with repetitions; empty if the log is a different one.
    /// O(entries).
    #[must_use]
    pub fn written_since(&self, place: LogPlace) -> WriteSet {
        let log = self.store.log.get().filter(|log| log.token() == place.token && place.entries <= log.entries.len());
        let mut written = WriteSet::default();
        if let Some(log) = log {
            self.store.add_written(place.entries..log.entries.len(), &mut written);
        }
        written
    }

    /// Returns the rewrite that permanently undoes the changes since a position in the log. O(1).
    ///
    /// The rewrite does nothing if the position belongs to an earlier change or to another log, or if the log has since been rolled
    /// back to before it.
    pub fn roll_back(&mut self, to: LogPlace) -> Rewrite {
        let log = self.store.log.get().filter(|log| log.has_kept(to.entries, to.serial));
        let end = log.map_or(to.entries, |log| log.entries.len());
        Rewrite { part: to.entries..end, way: Way::Back, token: log.and(to.token), forgets: true }
    }
}

pub(super) trait Logged: Recorder {
    fn links(&mut self) -> &mut Dcel {
        self.dcel_mut(Access(()))
    }

    /// Begins both logs anew. Returns the unique number of the log of links.
    fn begin_logs(&mut self) -> Option<u32> {
        self.log_others(true, Access(()));
        let store = &mut self.links().store;
        store.begin_log();
        store.log.get().and_then(Log::token)
    }

    fn end_logs(&mut self) {
        self.log_others(false, Access(()));
        self.links().store.end_log();
    }

    fn others(&mut self) -> Vec<Self::Other> {
        self.take_others(Access(()))
    }

    /// Undoes or redoes a part of the log and other values.
    fn replay(&mut self, part: Range<usize>, others: &mut [Self::Other], way: Way) {
        let token = self.dcel().store.log.get().and_then(Log::token);
        self.rewrite(Rewrite { part, way, token, forgets: false }, others);
    }

    /// Adds the records written by a part of the log and other values.
    fn add_written_by(&self, part: Range<usize>, others: &[Self::Other], written: &mut WriteSet) {
        self.dcel().store.add_written(part, written);
        self.add_written(written, others);
    }

    /// Takes the records written since the logs were begun or last taken, adding them to `written`.
    fn take_written(&mut self, written: &mut WriteSet) {
        let others = self.others();
        let links = self.dcel().store.log.get().map_or(0, |log| log.entries.len());
        self.add_written_by(0..links, &others, written);
        if let Some(log) = self.links().store.log.get_mut() {
            log.entries.clear();
            log.begin_change();
        }
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
