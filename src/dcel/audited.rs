//! A structure that is validated after each change.

use super::structure::Dcel;
use super::watched::Watched;
use crate::store::{SlotStore, Store};
use crate::validate::near::{Baseline, BaselineError, WriteSet, validate_near};
use crate::validate::{Expectation, Report};
use alloc::boxed::Box;

/// A [`Dcel`] that is validated after each operator, in the time that the operator took: see [`validate::near`](crate::validate::near)
/// for what is checked.
///
/// No sequence of operators breaks a rule. Take this to test that, or while you change an operator, on maps for
/// which [`Dcel::validate`] after each step is too slow.
///
/// ```
/// use twinedge::dcel::{Audited, Dcel};
/// let mut audited = Audited::new(Dcel::new())?;
/// let outside = audited.dcel().unbounded_face().key();
/// let v = audited.change(|dcel| dcel.add_isolated_vertex(outside))??.vertex;
/// audited.change(|dcel| dcel.connect(v, v, Default::default()))??;
/// assert_eq!(audited.dcel().face_count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Audited<S: Store = SlotStore> {
    dcel: Dcel<Watched<S>>,
    baseline: Baseline,
    /// True if the last change passed validation; the baseline has then followed it.
    is_right: bool,
}

impl<S: Store> Audited<S> {
    /// Validates the structure, and keeps a copy of its links. O(n). The keys stay the same.
    ///
    /// # Errors
    /// The structure is not valid.
    pub fn new(dcel: Dcel<S>) -> Result<Self, BaselineError> {
        let baseline = Baseline::new(&dcel, &Expectation::plane())?;
        Ok(Self { dcel: Dcel::watched_by(dcel, WriteSet::default()), baseline, is_right: true })
    }

    /// The structure. O(1).
    #[must_use]
    pub const fn dcel(&self) -> &Dcel<S> {
        &self.dcel.store.dcel
    }

    /// Changes the structure by one operator or more, and validates what was written. O(k log k) for k records that were written,
    /// beside the change itself.
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken. The structure stays as it is then.
    pub fn change<T>(&mut self, change: impl FnOnce(&mut Dcel<Watched<S>>) -> T) -> Result<T, Box<Report>> {
        if self.is_right {
            self.dcel.store.watch.clear();
        }
        let answer = change(&mut self.dcel);
        self.is_right = false;
        validate_near(&mut self.baseline, &self.dcel.store.dcel, &self.dcel.store.watch)?;
        self.is_right = true;
        Ok(answer)
    }

    /// The records that the last change wrote, some of them several times. O(1).
    #[must_use]
    pub const fn written(&self) -> &WriteSet {
        &self.dcel.store.watch
    }

    /// The structure, in the store that it came in. O(1).
    #[must_use]
    pub fn into_dcel(self) -> Dcel<S> {
        self.dcel.store.dcel
    }
}
