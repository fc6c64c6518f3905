//! A map, audited.

use crate::coverage::Coverage;
use crate::input::Imported;
use crate::output::{counted, not_checked};
use crate::query::label;
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::map::{FeatureId, PlanarMap};
use twinedge::validate::{Record, Report, Rule, Unchecked, Violation};

/// A map, audited.
pub(super) struct Audited<'a> {
    pub(super) imported: &'a Imported,
    pub(super) report: &'a Report,
    pub(super) coverage: Coverage,
    /// Whether findings of the coverage count as violations.
    pub(super) is_coverage_rule: bool,
    pub(super) is_valid: bool,
    pub(super) elapsed: f64,
}

/// Stands after a violation that follows from others.
pub(super) const FOLLOWS: &str = "which follows from the crossings (G4)";

impl Audited<'_> {
    /// The violations, and those that follow from them: where borders cross, the map does not fit in the plane.
    pub(super) fn violations(&self) -> (Vec<&Violation>, Vec<&Violation>) {
        let crossings = self.report.outcome(Rule::G4).is_some_and(|outcome| outcome.violations > 0);
        self.report.violations().iter().partition(|violation| !(crossings && violation.rule() == Rule::T3))
    }

    /// Whether the map is valid, in a sentence.
    pub(super) fn verdict(&self) -> String {
        let found = self.coverage.total();
        if self.is_valid {
            let beside = match found {
                0 => String::new(),
                n => format!("; C1 to C6 have {}, which --coverage counts as violations", counted(n, "finding")),
            };
            return format!("valid: every rule that applies holds{beside}");
        }
        let of_coverage = if self.is_coverage_rule { found } else { 0 };
        let all = counted(self.report.violation_count() as usize + of_coverage, "violation");
        let is_missing = |why: Unchecked| !why.is_by_design();
        let of_structure =
            self.report.outcomes().filter(|(_, outcome)| outcome.unchecked.is_some_and(is_missing)).count();
        // C1 to C5.
        let of_coverage = if self.is_coverage_rule && self.coverage.not_checked().is_some() { 5 } else { 0 };
        format!("not valid: {all}{}", not_checked(of_structure + of_coverage))
    }
}

/// The features that a violation touches, in order.
pub(super) fn features(map: &PlanarMap, violation: &Violation) -> BTreeSet<FeatureId> {
    let dcel = map.dcel();
    let mut found = BTreeSet::new();
    for record in violation.records().into_iter().flatten() {
        let half_edges: Vec<_> = match record {
            Record::HalfEdge(h) => dcel.half_edge_at(h).into_iter().collect(),
            Record::Vertex(v) => dcel.vertex_at(v).into_iter().flat_map(Vertex::rotation).collect(),
            Record::Boundary(b) => dcel.boundary_at(b).and_then(Boundary::start).into_iter().collect(),
            Record::Face(f) => {
                let face = dcel.face_at(f).map(Face::key);
                found.extend(face.and_then(|f| map.features_of(f).ok()).into_iter().flatten());
                Vec::new()
            }
        };
        for h in half_edges {
            found.extend(map.features_along(h.key()).into_iter().flatten());
        }
    }
    found
}

/// The names of the features that a violation touches; numbers, counted from 0, for those without name.
pub(super) fn labels(map: &PlanarMap, violation: &Violation) -> Vec<String> {
    features(map, violation).into_iter().map(|feature| label(map, feature)).collect()
}
