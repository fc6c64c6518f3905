//! What all visitors share while a file is read.

use core::mem;

use super::error::{Fault, Place, ReadError};
use super::json::Progress;

/// The state of a reading.
///
/// A fault does not stop the visitors at once: they go on to the end of the feature without storing anything, because
/// the feature's name may come last, and an error that names the feature is worth more.
pub(super) struct Scan<'p> {
    progress: &'p Progress,
    fault: Option<(Place, Fault)>,
    /// Whether a feature (or a geometry without one) is being read.
    in_feature: bool,
    /// The name of that feature and the rank of the property it was found under.
    name: Option<(usize, String)>,
    /// Positions of that feature with more than two numbers.
    pub(super) with_extra_dimensions: usize,
}

impl<'p> Scan<'p> {
    pub(super) fn new(progress: &'p Progress) -> Self {
        Self { progress, fault: None, in_feature: false, name: None, with_extra_dimensions: 0 }
    }

    /// The last byte read.
    pub(super) fn here(&self) -> Place {
        self.progress.at()
    }

    /// What is read from here on belongs to a feature, and so does what has been read since the last one.
    pub(super) fn enter_feature(&mut self) {
        self.in_feature = true;
    }

    /// What is read from here on belongs to a new feature.
    pub(super) fn start_feature(&mut self) {
        self.in_feature = true;
        self.name = None;
        self.with_extra_dimensions = 0;
    }

    pub(super) fn leave_feature(&mut self) {
        self.in_feature = false;
    }

    /// Notes a fault; the first one counts.
    pub(super) fn fail(&mut self, at: Place, fault: Fault) {
        self.fault.get_or_insert((at, fault));
    }

    pub(super) fn failed(&self) -> bool {
        self.fault.is_some()
    }

    /// Notes a name for the feature; the lowest rank counts, and of equal ranks the last.
    pub(super) fn propose_name(&mut self, rank: usize, name: String) {
        if self.name.as_ref().is_none_or(|(best, _)| rank <= *best) {
            self.name = Some((rank, name));
        }
    }

    pub(super) fn take_name(&mut self) -> Option<String> {
        self.name.take().map(|(_, name)| name)
    }

    pub(super) fn take_extra(&mut self) -> usize {
        mem::take(&mut self.with_extra_dimensions)
    }

    /// The error that the noted fault amounts to, `index` being that of the current feature.
    pub(super) fn take_error(&mut self, index: usize) -> Option<ReadError> {
        let (at, fault) = self.fault.take()?;
        Some(if self.in_feature {
            ReadError::Feature { index, name: self.take_name(), at, fault }
        } else {
            ReadError::NotGeoJson { at, fault }
        })
    }
}
