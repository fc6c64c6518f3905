//! A structure that is validated after each change.

use super::recorder::{Logged as _, Recorder};
use super::structure::Dcel;
use crate::validate::near::{Baseline, BaselineError, WriteSet, validate_near};
use crate::validate::{Expectation, Report};
use alloc::boxed::Box;

/// A structure that can be validated after a change, from the records that the change wrote.
pub trait Auditable: Recorder {
    /// Its links when last found valid, and any other data compared after a change.
    type Baseline: Clone;

    /// Validates the whole structure, and records its current state.
    ///
    /// # Errors
    /// The structure is not valid, or cannot be validated after a change.
    fn baseline(&self) -> Result<Self::Baseline, BaselineError>;
    /// Validates the written records and their surroundings.
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken.
    fn check_near(&self, baseline: &mut Self::Baseline, written: &WriteSet) -> Result<(), Box<Report>>;
    /// Validates the whole structure.
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

/// A structure that is validated after each change, in about the time of the change; [`validate::near`](crate::validate::near) lists
/// the checks. The structure is a [`Dcel`], or a `PlanarMap` of `twinedge-map`, whose coordinates are also checked (rules G1 … G5).
///
/// No sequence of operators, or of edits of a map, breaks a rule. Use this type to test that, or while changing an operator or writing
/// an editor, on structures too large for [`Dcel::validate`] after each step. Validation does not use the index by which edits of a map
/// find their place, so it also detects faults of the index.
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
    /// The number of the log, unless the closure of a change replaces the structure.
    token: Option<u32>,
    baseline: D::Baseline,
    /// The records written since the structure was last found valid.
    written: WriteSet,
    /// True if the last change passed validation and the baseline includes it.
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
    /// Validates the structure, and copies its links and, for a map, its coordinates. Keys stay valid. O(n); O(n log n) for a map.
    ///
    /// # Errors
    /// The structure is not valid.
    pub fn new(mut structure: D) -> Result<Self, BaselineError> {
        let baseline = structure.baseline()?;
        let token = structure.begin_logs();
        Ok(Self { structure, token, baseline, written: WriteSet::default(), is_right: true })
    }

    /// Returns the structure. O(1).
    #[must_use]
    pub const fn get(&self) -> &D {
        &self.structure
    }

    /// Changes the structure by any number of operators, and validates the written records.
    ///
    /// O(k log k) for k written records, plus the change itself. For a map O(k log n), plus the cost of `validate_embedding_near` for
    /// edges whose boxes meet, and for islands close to a border that has moved. A structure put in place of the old one is validated
    /// in full.
    ///
    /// # Errors
    /// The report of a full validation, if a rule is broken. The broken structure stays in place.
    pub fn change<T>(&mut self, change: impl FnOnce(&mut D) -> T) -> Result<T, Box<Report>> {
        if self.is_right {
            self.written.clear();
        }
        let answer = change(&mut self.structure);
        self.is_right = false;
        let token = self.token;
        if self.structure.dcel().store.log.get().is_some_and(|log| log.token() == token) {
            self.structure.take_written(&mut self.written);
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

    /// Returns the records written by the last change, possibly with repetitions; empty if the change replaced the structure. O(1).
    #[must_use]
    pub const fn written(&self) -> &WriteSet {
        &self.written
    }

    /// Returns the structure, consuming the wrapper. O(1).
    #[must_use]
    pub fn into_inner(mut self) -> D {
        self.structure.end_logs();
        self.structure
    }
}
