//! A structure that is validated after each change.

use super::recorder::{Logged as _, Recorder};
use super::structure::Dcel;
use crate::validate::near::{Baseline, BaselineError, WriteSet, validate_near};
use crate::validate::{Expectation, Report};
use alloc::boxed::Box;

/// A structure that can be validated after a change, by what the change wrote.
pub trait Auditable: Recorder {
    /// Its links when it was last found right, and whatever else is compared with those after a change.
    type Baseline: Clone;

    /// Validates all, and keeps what is there.
    ///
    /// # Errors
    /// The structure is not valid, or cannot be validated after a change.
    fn baseline(&self) -> Result<Self::Baseline, BaselineError>;
    /// Validates what was written.
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken.
    fn check_near(&self, baseline: &mut Self::Baseline, written: &WriteSet) -> Result<(), Box<Report>>;
    /// Validates all.
    fn check(&self) -> Report;
}

impl Auditable for Dcel {
    type Baseline = Baseline;

    fn baseline(&self) -> Result<Baseline, BaselineError> {
        Baseline::new(self, &Expectation::plane())
    }

    fn check_near(&self, baseline: &mut Baseline, written: &WriteSet) -> Result<(), Box<Report>> {
        validate_near(baseline, self, written)
    }

    fn check(&self) -> Report {
        self.validate()
    }
}

/// A structure that is validated after each change, in about the time that the change took: see [`validate::near`](crate::validate::near)
/// for what is checked. The structure is a [`Dcel`] or a `PlanarMap` of `twinedge-map`, of which the rules of coordinates G1 … G5 are
/// checked, too.
///
/// No sequence of operators breaks a rule, and no edit of a map. Take this to test that, or while you change an operator or write an editor, on
/// structures for which [`Dcel::validate`] after each step is too slow. The index by which edits of a map find their place has no part in the
/// validation, so a fault in it is found like any other.
///
/// ```
/// use twinedge::dcel::{Audited, Dcel};
/// let mut audited = Audited::new(Dcel::new())?;
/// let outside = audited.get().unbounded_face().key();
/// let v = audited.change(|dcel| dcel.add_isolated_vertex(outside))??.vertex;
/// audited.change(|dcel| dcel.connect(v, v, Default::default()))??;
/// assert_eq!(audited.get().face_count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Audited<D: Auditable = Dcel> {
    structure: D,
    /// The number of the log, unless the closure of a change puts another structure in place.
    token: Option<u32>,
    baseline: D::Baseline,
    /// The records that were written since the structure was last found right.
    written: WriteSet,
    /// True if the last change passed validation; the baseline has then followed it.
    is_right: bool,
}

impl<D: Auditable> Clone for Audited<D> {
    fn clone(&self) -> Self {
        let (baseline, written) = (self.baseline.clone(), self.written.clone());
        let mut structure = self.structure.clone();
        let token = structure.begin_logs();
        Self { structure, token, baseline, written, is_right: self.is_right }
    }
}

impl<D: Auditable> Audited<D> {
    /// Validates the structure, and keeps a copy of its links, and of the coordinates of a map. O(n); O(n log n) for a map. The keys stay the
    /// same.
    ///
    /// # Errors
    /// The structure is not valid.
    pub fn new(mut structure: D) -> Result<Self, BaselineError> {
        let baseline = structure.baseline()?;
        let token = structure.begin_logs();
        Ok(Self { structure, token, baseline, written: WriteSet::default(), is_right: true })
    }

    /// The structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &D {
        &self.structure
    }

    /// Changes the structure by one operator or more, and validates what was written.
    ///
    /// O(k log k) for k records that were written, beside the change itself; for a map O(k log n), and what
    /// `validate_embedding_near` takes for edges whose boxes meet, and for islands close to a border that has moved. A structure that is put
    /// in place of the other is validated in full.
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken. The structure stays as it is then.
    pub fn change<T>(&mut self, change: impl FnOnce(&mut D) -> T) -> Result<T, Box<Report>> {
        if self.is_right {
            self.written.clear();
        }
        let answer = change(&mut self.structure);
        self.is_right = false;
        let token = self.token;
        if self.structure.dcel().store.log.get().is_some_and(|log| log.token() == token) {
            self.written.extend(self.structure.take_written());
            self.structure.check_near(&mut self.baseline, &self.written)?;
        } else {
            self.written.clear();
            self.baseline = self.structure.baseline().map_err(|error| match error {
                BaselineError::Invalid(report) => report,
                _ => Box::new(self.structure.check()),
            })?;
            self.token = self.structure.begin_logs();
        }
        self.is_right = true;
        Ok(answer)
    }

    /// The records that the last change wrote, some of them several times; none if it put another structure in place. O(1).
    #[must_use]
    pub const fn written(&self) -> &WriteSet {
        &self.written
    }

    /// The structure, for good. O(1).
    #[must_use]
    pub fn into_inner(mut self) -> D {
        self.structure.end_logs();
        self.structure
    }
}
