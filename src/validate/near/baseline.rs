//! The structure when it was last found valid.

use super::check::{Scratch, check};
use super::diff::{Diff, WriteSet};
use super::links::LinkReader;
use crate::validate::expectation::Expectation;
use crate::validate::report::{Collect, Report};
use crate::validate::structure::{Part, Parts, View};
use crate::validate::validator::validate;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The links of a valid structure, for comparison after a change. See [`validate_near`].
///
/// Takes 24 bytes per half-edge, 12 per vertex, 20 per boundary component, and 12 per face. Checks reuse their memory: about 40
/// bytes for each written record, for the largest change so far.
#[derive(Clone, Debug)]
pub struct Baseline {
    expect: Expectation,
    /// The links, and the state of the written records in the last check.
    diff: Diff,
    scratch: Scratch,
}

/// The reason why a structure has no [`Baseline`].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum BaselineError {
    /// The structure breaks a rule.
    Invalid(Box<Report>),
    /// The expectation allows open boundaries, which are not validated locally.
    OpenBoundaries,
    /// The structure has lists of inner boundary components, but lacks a part needed to check them: records for boundary
    /// components, their places in the lists, or the unbounded face.
    Lacks(Part),
    /// The view changed its answers while it was read.
    Changing,
    /// The structure may lie outside the plane, so there is no drawing to validate.
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
    /// Validates the structure in full, and stores its links. O(n).
    ///
    /// # Errors
    /// The structure is not valid; or the expectation has open boundaries; or faces have holes but no boundary components, places
    /// or unbounded face.
    pub fn new<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, BaselineError> {
        Self::supports(expectation, expectation.looks_at(view.parts()))?;
        validate(view, expectation, Collect::All).into_result().map_err(BaselineError::Invalid)?;
        let mut baseline = Self::of_right(view, expectation)?;
        baseline.commit();
        Ok(baseline)
    }

    /// Returns an error if structures with these parts, or with this expectation, are not validated locally.
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

    /// Creates a baseline of a structure known to be valid, as changes to an empty one: see [`commit`](Self::commit). O(n).
    ///
    /// # Errors
    /// [`BaselineError::Changing`].
    pub fn of_right<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, BaselineError> {
        let mut baseline = Self { expect: *expectation, diff: Diff::default(), scratch: Scratch::default() };
        baseline.read(view).ok_or(BaselineError::Changing)?;
        Ok(baseline)
    }

    /// Returns the links before and after the change seen by the last check. O(1).
    #[must_use]
    pub const fn changes(&self) -> &Diff {
        &self.diff
    }

    /// Moves on to the structure seen by the last check. O(written records).
    pub fn commit(&mut self) {
        self.diff.commit();
    }

    /// Returns the expectation.
    #[must_use]
    pub const fn expectation(&self) -> &Expectation {
        &self.expect
    }

    /// Reads every link of a valid structure, as if all records were new and written. `None` if the links are invalid. O(n).
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

    /// Checks the links of the written records, and computes the difference; `None` if the new state cannot be valid. Takes the
    /// time of [`validate_near`].
    pub fn check<V: View + ?Sized>(&mut self, view: &V, written: &WriteSet) -> Option<()> {
        let now = LinkReader::new(view, self.expect)?;
        check(&mut self.diff, &now, written, &mut self.scratch)
    }
}

/// Validates a structure after a change, in time proportional to the change: see [what is checked](super#what-is-checked).
///
/// `written` must name every record that has changed since the baseline was created or last moved on. If the structure is valid,
/// the baseline moves on to it. Costs O(k log k) for k written records, plus the walks in step along the cycles and rotations
/// between them, regardless of the size of the structure.
///
/// Otherwise the structure is validated in full, and the report is the result of [`validate`]: O(n). The baseline then stays unchanged.
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
    // The structure is valid: some changed record was not named.
    if baseline.read(view).is_some() {
        baseline.commit();
    }
    Ok(())
}
