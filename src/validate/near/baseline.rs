//! The structure as it was when it was last found right.

use super::changes::{Changes, Counts};
use super::check::find_changes;
use super::column::Row;
use super::mirror::{Mirror, Now, Vertex};
use super::touched::Touched;
use crate::validate::columns::NIL;
use crate::validate::expectation::Expectation;
use crate::validate::report::{Collect, Report};
use crate::validate::structure::{Part, Parts, View};
use crate::validate::validator::validate;
use alloc::boxed::Box;

/// The links of a structure that was found right, to compare it with after a change. See [`validate_near`].
///
/// Takes 24 bytes per half-edge, 12 per vertex, 20 per boundary component, and 12 per face. The memory
/// that a check takes is kept for the next one: some 40 bytes for each record that was touched, where there were most of them.
#[derive(Clone, Debug)]
pub struct Baseline {
    pub(super) expect: Expectation,
    pub(super) mirror: Mirror,
    pub(super) counts: Counts,
    /// What the last check has found.
    pub(super) changes: Changes,
}

/// Why there is no [`Baseline`] of a structure.
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
        Self::of_right(view, expectation)
    }

    /// Whether local validation is to be had.
    pub(super) fn supports(expectation: &Expectation, parts: Parts) -> Result<(), BaselineError> {
        if expectation.is_open() {
            return Err(BaselineError::OpenBoundaries);
        }
        let needed = [Part::BoundaryComponents, Part::Places, Part::UnboundedFace];
        match needed.into_iter().find(|part| parts.has(Part::Holes) && !parts.has(*part)) {
            Some(part) => Err(BaselineError::Lacks(part)),
            None => Ok(()),
        }
    }

    /// Of a structure that is right.
    pub(super) fn of_right<V: View + ?Sized>(view: &V, expectation: &Expectation) -> Result<Self, BaselineError> {
        let mut baseline = Self {
            expect: *expectation,
            mirror: Mirror::default(),
            counts: Counts::default(),
            changes: Changes::default(),
        };
        baseline.read(view).ok_or(BaselineError::Changing)?;
        Ok(baseline)
    }

    /// What the structure is held to.
    #[must_use]
    pub const fn expectation(&self) -> &Expectation {
        &self.expect
    }

    /// Reads every link of a valid structure: all records are touched.
    pub(super) fn read<V: View + ?Sized>(&mut self, view: &V) -> Option<()> {
        let now = Now::new(view, self.expect)?;
        self.mirror = Mirror::default();
        let mut counts = Counts::default();
        let mirror = &mut self.mirror;
        for v in 0..now.vertices {
            let is_live = now.is_vertex(v);
            counts.vertices += usize::from(is_live);
            let has_isolated = now.has(Part::BoundaryComponents) && now.has(Part::Holes);
            let isolated = if has_isolated { view.isolated(v) } else { None };
            let row = Vertex { leaving: NIL, isolated: isolated.map_or(NIL, |b| b as u32) };
            mirror.vertices.push(if is_live { row } else { Vertex::VACANT });
        }
        for h in 0..now.half_edges {
            let row = now.half_edge(h)?;
            counts.half_edges += usize::from(row.is_live());
            mirror.half_edges.push(row);
            if row.is_live() {
                mirror.vertices.row_mut(row.origin as usize)?.leaving = h as u32;
            }
        }
        for h in 0..now.half_edges {
            let row = mirror.half_edge(h);
            if row.is_live() {
                mirror.half_edges.row_mut(row.next as usize)?.prev = h as u32;
            }
        }
        if now.has(Part::Faces) {
            for b in 0..now.labels {
                mirror.labels.push(now.label(b)?);
            }
            counts.faces = (0..now.faces).filter(|f| now.is_face(*f)).count();
        }
        if now.has(Part::BoundaryComponents) {
            for f in 0..now.faces {
                let face = now.face(f)?;
                counts.unbounded += usize::from(face.outer == NIL);
                counts.inner += face.inner as usize;
                mirror.faces.push(face);
            }
        }
        self.counts = counts;
        Some(())
    }

    /// Finds what has changed. Nothing if it cannot be right.
    pub(super) fn find_changes<V: View + ?Sized>(&mut self, now: &Now<'_, V>, touched: &Touched) -> Option<()> {
        find_changes(&mut self.mirror, now, self.counts, touched, &mut self.changes)
    }

    /// Follows the structure to where the last check has found it.
    pub(super) fn follow(&mut self) {
        let Self { mirror, changes, .. } = self;
        for (h, row) in changes.touched() {
            put(mirror.half_edges.row_mut(h), row);
        }
        for (h, seen) in changes.half_edges.iter().skip(changes.touched) {
            if let Some(row) = mirror.half_edges.row_mut(h) {
                row.prev = seen.row.prev;
            }
        }
        for (v, seen) in changes.vertices.iter() {
            put(mirror.vertices.row_mut(v), seen.row);
        }
        for (b, seen) in changes.labels.iter() {
            put(mirror.labels.row_mut(b), seen.row);
        }
        for (f, seen) in changes.faces.iter() {
            put(mirror.faces.row_mut(f), seen.row);
        }
        self.counts = changes.counts;
    }
}

fn put<T>(place: Option<&mut T>, row: T) {
    if let Some(place) = place {
        *place = row;
    }
}

/// Validates a structure after a change, in time proportional to the change: [what is checked](super#what-is-checked).
///
/// `touched` names every record that has changed since the baseline was made or last moved on. If all is right, the
/// baseline moves on to the structure as it is. Costs O(k log k) for k records that were touched, and the walks in step along the
/// cycles and rotations between them; it does not depend on the size of the structure.
///
/// If something is wrong, the structure is validated in full, so that the report is that of [`validate`]: O(n). The baseline stays
/// as it is then.
///
/// ```
/// use twinedge::validate::near::{Baseline, Touched, validate_near};
/// use twinedge::validate::{Expectation, Rule, Table};
/// // An edge between two vertices.
/// let mut table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let mut baseline = Baseline::new(&table, &Expectation::plane())?;
/// table.half_edges[0].as_mut().unwrap().origin = Some(1);
/// let touched = Touched { half_edges: vec![0], ..Touched::default() };
/// let report = validate_near(&mut baseline, &table, &touched).unwrap_err();
/// assert_eq!(report.broken_rules().next(), Some(Rule::V1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The report of the full validation, if a rule is broken.
pub fn validate_near<V: View + ?Sized>(
    baseline: &mut Baseline,
    view: &V,
    touched: &Touched,
) -> Result<(), Box<Report>> {
    let found = Now::new(view, baseline.expect).and_then(|now| baseline.find_changes(&now, touched));
    if found.is_some() {
        baseline.follow();
        return Ok(());
    }
    validate(view, &baseline.expect, Collect::All).into_result()?;
    // The structure is right: some record that has changed was not named.
    let _ = baseline.read(view);
    Ok(())
}
