//! A map, audited.

use crate::coverage::Coverage;
use crate::input::Imported;
use crate::query::label;
use std::collections::BTreeSet;
use twinedge::dcel::{Boundary, Face, Vertex};
use twinedge::map::PlanarMap;
use twinedge::validate::{Record, Report, Violation};

/// A map, audited.
pub(super) struct Audited<'a> {
    pub(super) imported: &'a Imported,
    pub(super) report: &'a Report,
    pub(super) coverage: Coverage,
    pub(super) is_valid: bool,
    pub(super) elapsed: f64,
}

/// The names of the features that a violation touches; numbers, counted from 0, for those without name.
pub(super) fn features(map: &PlanarMap, violation: &Violation) -> Vec<String> {
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
    found.into_iter().map(|feature| label(map, feature)).collect()
}
