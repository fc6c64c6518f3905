//! A map that is validated after each edit.

use super::notes::Notes;
use super::planar_map::PlanarMap;
use crate::validate::near::{BaselineError, EmbeddingBaseline, WriteSet, validate_embedding_near};
use crate::validate::{Expectation, Report};
use core::ptr;

/// A [`PlanarMap`] that is validated after each edit, all rules from R1 to T4 and from G1 to G5, in about the time that the edit took:
/// see [`validate::near`](crate::validate::near#with-coordinates) for what is checked, and how.
///
/// No sequence of edits breaks a rule. Take this to test that, or while you work on edits or on an editor, on maps for which
/// [`PlanarMap::validate`] after each edit is too slow. The index by which edits find their place has no part in the validation, so a
/// fault in it is found like any other.
///
/// ```
/// use twinedge::map::{Audited, PlanarMap};
///
/// let mut audited = Audited::new(PlanarMap::new())?;
/// let square = audited.change(|map| map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]))??;
/// audited.change(|map| map.insert_segment(square.vertices[0], square.vertices[2]))??;
/// // An edit that is refused has changed nothing, which is right as well.
/// assert!(audited.change(|map| map.insert_segment([1.0, 3.0], [3.0, 1.0]))?.is_err());
/// assert_eq!(audited.map().dcel().face_count(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Audited {
    map: PlanarMap,
    baseline: EmbeddingBaseline,
    /// True if the last change passed validation; the baseline has then followed it.
    is_right: bool,
}

impl Audited {
    /// Validates the map, and keeps a copy of its links and coordinates. O(n log n).
    ///
    /// # Errors
    /// The map is not valid, as where it is [not plane](PlanarMap::is_plane).
    pub fn new(mut map: PlanarMap) -> Result<Self, BaselineError> {
        let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
        map.notes = Notes { written: Some(Box::default()), journal: None };
        Ok(Self { map, baseline, is_right: true })
    }

    /// The map. O(1).
    #[must_use]
    pub const fn map(&self) -> &PlanarMap {
        &self.map
    }

    /// Changes the map by one edit or more, and validates what was written.
    ///
    /// O(k log n) for k records that were written, beside the change itself, and what
    /// [`validate_embedding_near`] takes for edges whose boxes meet, and for
    /// islands close to a border that has moved. A map that is put in place of the other is validated in full, O(n log n).
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken. The map stays as it is then.
    pub fn change<T>(&mut self, change: impl FnOnce(&mut PlanarMap) -> T) -> Result<T, Box<Report>> {
        let mark = self.map.notes.written.as_deref_mut().map(|notes| {
            if self.is_right {
                notes.clear();
            }
            ptr::from_ref::<WriteSet>(notes)
        });
        let answer = change(&mut self.map);
        self.is_right = false;
        if let Some(notes) = self.map.notes.written.as_deref().filter(|notes| mark == Some(ptr::from_ref(*notes))) {
            validate_embedding_near(&mut self.baseline, &self.map, notes)?;
        } else {
            // It is another map, whose edits were not noted, or for others.
            self.map.notes = Notes::default();
            let baseline = EmbeddingBaseline::new(&self.map, self.baseline.expectation());
            self.baseline = baseline.map_err(|error| match error {
                BaselineError::Invalid(report) => report,
                _ => Box::new(self.map.validate()),
            })?;
            self.map.notes.written = Some(Box::default());
        }
        self.is_right = true;
        Ok(answer)
    }

    /// The records that the last change wrote, some of them several times; none if it put another map in place that is not right. O(1).
    #[must_use]
    pub fn written(&self) -> Option<&WriteSet> {
        self.map.notes.written.as_deref()
    }

    /// The map, for good. O(1).
    #[must_use]
    pub fn into_map(mut self) -> PlanarMap {
        self.map.notes.written = None;
        self.map
    }
}
