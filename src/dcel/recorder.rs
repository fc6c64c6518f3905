//! The interface between a structure and the histories and audits of its changes.

use super::structure::Dcel;
use crate::store::attributes::{Attributes, Saved};
use crate::store::{Log, Way};
use crate::validate::near::WriteSet;
use alloc::vec::Vec;
use core::ops::Range;

/// A structure around a [`Dcel`], which may have more than its links: what is overwritten of that, too, is logged while the log of the
/// `Dcel` is on.
///
/// Public in name only: nobody outside the crate can name it. A [`Dcel`] is one, and so is a map.
#[allow(unnameable_types, reason = "it is sealed so")]
pub trait Recorder: Clone {
    /// Something that was overwritten and is no link of the `Dcel`.
    type Other: Clone;

    fn dcel(&self) -> &Dcel;
    fn dcel_mut(&mut self) -> &mut Dcel;
    /// Begins to log others than links, and forgets those that were logged.
    fn begin(&mut self);
    /// Logs no others any more.
    fn end(&mut self);
    /// The others that the change that is being made has overwritten, for good.
    fn take_others(&mut self) -> Vec<Self::Other>;
    /// Takes back what a part of the log and others say that was written last, from the end, or writes it again.
    fn replay(&mut self, links: Range<usize>, others: &mut [Self::Other], way: Way);
    /// The records that these links and others are of.
    fn written(&self, links: Range<usize>, others: &[Self::Other]) -> WriteSet;

    /// Begins both logs anew. Returns the number of that of links, which no other has.
    fn begin_logs(&mut self) -> Option<u32> {
        self.begin();
        let store = &mut self.dcel_mut().store;
        store.begin_log();
        store.log.get().and_then(Log::token)
    }

    /// Keeps no log any more.
    fn end_logs(&mut self) {
        self.end();
        self.dcel_mut().store.end_log();
    }

    /// The records that were written since the logs were begun or taken last.
    fn take_written(&mut self) -> WriteSet {
        let others = self.take_others();
        let links = self.dcel().store.log.get().map_or(0, |log| log.entries.len());
        let written = self.written(0..links, &others);
        if let Some(log) = self.dcel_mut().store.log.get_mut() {
            log.entries.clear();
        }
        written
    }
}

impl Recorder for Dcel {
    type Other = Saved;

    fn dcel(&self) -> &Dcel {
        self
    }

    fn dcel_mut(&mut self) -> &mut Dcel {
        self
    }

    fn begin(&mut self) {
        let _ = self.take_others();
    }

    fn end(&mut self) {
        self.begin();
    }

    fn take_others(&mut self) -> Vec<Saved> {
        self.store.attributes_mut().map(Attributes::take_log).unwrap_or_default()
    }

    fn replay(&mut self, links: Range<usize>, others: &mut [Saved], way: Way) {
        self.store.replay(links, way);
        if let Some(attributes) = self.store.attributes_mut() {
            match way {
                Way::Back => others.iter_mut().rev().for_each(|saved| attributes.exchange(saved)),
                Way::Forth => others.iter_mut().for_each(|saved| attributes.exchange(saved)),
            }
        }
    }

    fn written(&self, links: Range<usize>, _: &[Saved]) -> WriteSet {
        self.store.written(links)
    }
}
