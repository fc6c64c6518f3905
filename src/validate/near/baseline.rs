//! The structure as it was when it was last found right.

use super::check::{Scratch, check};
use super::diff::Diff;
use super::links::LinkReader;
use super::write_set::WriteSet;
use crate::validate::expectation::Expectation;
use crate::validate::report::{Collect, Report};
use crate::validate::structure::{Part, Parts, View};
use crate::validate::validator::validate;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The links of a structure that was found right, to compare it with after a change. See [`validate_near`].
///
/// Takes 24 bytes per half-edge, 12 per vertex, 20 per boundary component, and 12 per face. The memory
/// that a check takes is kept for the next one: some 40 bytes for each record that was written, where there were most of them.
#[derive(Clone, Debug)]
pub struct Baseline {
    expect: Expectation,
    /// The links, and what the last check has found of those that were written.
    diff: Diff,
    scratch: Scratch,
}

/// The reason for which there is no [`Baseline`] of a structure.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum BaselineError {
    /// The structure breaks a rule.
    Invalid(Box<Report>),
    /// The expectation allows open boundaries, where local validation is not to be had.
    OpenBoundaries,
    /// The structure has lists of inner boundary components, and lacks what they are checked by: records for boundary
    /// components, the place that each has in the list, or the unbounded face.
    Lacks(Part),
    /// The answers of the view changed while it was read.
    Changing,
    /// The structure need not lie in the plane, so it has no drawing there to validate.
    NotPlane,
    /// Edges have bends, which are not validated locally.
    Bends,
}

impl core::fmt::Display for BaselineError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Invalid(report) => write!(f, "the structure is not valid\n{report}"),
            Self::OpenBoundaries => f.write_str("open boundaries are not validated locally: use `validate`"),
            Self::Lacks(part) => {
                write!(f, "faces with holes are validated locally only with {}: use `validate`", part.name())
            }
            Self::Changing => f.write_str("the view gives other answers each time it is asked"),
            Self::NotPlane => f.write_str("coordinates are validated locally only of maps in the plane"),
            Self::Bends => f.write_str("edges with bends are not validated locally: use `validate_embedding`"),
        }
    }
}

impl core::error::Error for BaselineError {}

impl Baseline {
    /// Validates the structure in full, and keeps its links. O(n).
    ///
    /// # Errors
    /// The structure is not valid; or the expectation has open boundaries, or faces with holes and without boundary components,
    /// places or an unbounded face.
    pub fn new<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, BaselineError> {
        Self::supports(expectation, expectation.looks_at(view.parts()))?;
        validate(view, expectation, Collect::All).into_result().map_err(BaselineError::Invalid)?;
        let mut baseline = Self::of_right(view, expectation)?;
        baseline.commit();
        Ok(baseline)
    }

    /// Returns an error for structures that are not validated locally: for those with these parts, or for this expectation.
    ///
    /// # Errors
    /// [`BaselineError::OpenBoundaries`], [`BaselineError::Lacks`].
    pub fn supports(expectation: &Expectation, parts: Parts) -> Result<(), BaselineError> {
        if expectation.is_open() {
            return Err(BaselineError::OpenBoundaries);
        }
        let needed = [Part::BoundaryComponents, Part::Places, Part::UnboundedFace];
        match needed.into_iter().find(|part| parts.has(Part::Holes) && !parts.has(*part)) {
            Some(part) => Err(BaselineError::Lacks(part)),
            None => Ok(()),
        }
    }

    /// The links of a structure that is known to be right, as changes since there was nothing: see [`commit`](Self::commit). O(n).
    ///
    /// # Errors
    /// [`BaselineError::Changing`].
    pub fn of_right<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, BaselineError> {
        let mut baseline = Self { expect: *expectation, diff: Diff::default(), scratch: Scratch::default() };
        baseline.read(view).ok_or(BaselineError::Changing)?;
        Ok(baseline)
    }

    /// The links before and after, as the last check has found them. O(1).
    #[must_use]
    pub const fn changes(&self) -> &Diff {
        &self.diff
    }

    /// Moves on to the structure as the last check has found it. O(records that were written).
    pub fn commit(&mut self) {
        self.diff.commit();
    }

    /// The expectation that the structure is held to.
    #[must_use]
    pub const fn expectation(&self) -> &Expectation {
        &self.expect
    }

    /// Reads every link of a structure that is right: all records are written, and there were none before. Nothing if the links are not right.
    /// O(n).
    pub fn read<V: View + ?Sized>(&mut self, view: &V) -> Option<()> {
        let now = LinkReader::new(view, self.expect)?;
        let written = WriteSet {
            vertices: (0..now.vertices).collect(),
            half_edges: (0..now.half_edges).collect(),
            boundaries: (0..now.labels).collect(),
            faces: (0..now.faces).collect(),
            listed: Vec::new(),
        };
        self.diff = Diff::default();
        // The memory for this is not kept.
        check(&mut self.diff, &now, &written, &mut Scratch::default())
    }

    /// Checks the links of the records that were written, and finds what has changed. Nothing if these links cannot be right. The cost is that of
    /// [`validate_near`].
    pub fn check<V: View + ?Sized>(&mut self, view: &V, written: &WriteSet) -> Option<()> {
        let now = LinkReader::new(view, self.expect)?;
        check(&mut self.diff, &now, written, &mut self.scratch)
    }
}

/// Validates a structure after a change, in time proportional to the change: [what is checked](super#what-is-checked).
///
/// `written` names every record that has changed since the baseline was made or last moved on. If all is right, the
/// baseline moves on to the structure as it is. Costs O(k log k) for k records that were written, and the walks in step along the
/// cycles and rotations between them; it does not depend on the size of the structure.
///
/// If something is wrong, the structure is validated in full, so that the report is that of [`validate`]: O(n). The baseline stays
/// as it is then.
///
/// ```
/// use twinedge::validate::near::{Baseline, WriteSet, validate_near};
/// use twinedge::validate::{Expectation, Rule, Table};
/// // An edge between two vertices.
/// let mut table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let mut baseline = Baseline::new(&table, &Expectation::plane())?;
/// table.half_edges[0].as_mut().unwrap().origin = Some(1);
/// let written = WriteSet { half_edges: vec![0], ..WriteSet::default() };
/// let report = validate_near(&mut baseline, &table, &written).unwrap_err();
/// assert_eq!(report.broken_rules().next(), Some(Rule::V1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The report of the full validation, if a rule is broken.
pub fn validate_near<V: View + ?Sized>(
    baseline: &mut Baseline,
    view: &V,
    written: &WriteSet,
) -> Result<(), Box<Report>> {
    if baseline.check(view, written).is_some() {
        baseline.commit();
        return Ok(());
    }
    validate(view, &baseline.expect, Collect::All).into_result()?;
    // The structure is right: some record that has changed was not named.
    if baseline.read(view).is_some() {
        baseline.commit();
    }
    Ok(())
}
