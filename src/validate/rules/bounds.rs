//! T4 bounds: a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`.
//!
//! It follows from the rules before it, so it is a check of the counting.

use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Bounds, Unchecked, Violation};
use crate::validate::rule::Rule;

/// Runs T4.
pub(crate) fn check(is_simple: bool, findings: &mut Findings) -> Flow {
    let (vertices, edges, faces) = (findings.counts.vertices, findings.counts.edges, findings.counts.faces);
    if !is_simple || vertices < 3 {
        findings.not_checked(Rule::T4, Unchecked::NotSimple);
        return Ok(());
    }
    let most = Bounds { most_edges: 3 * vertices - 6, most_faces: 2 * vertices - 4 };
    findings.checked(Rule::T4, 1);
    if edges > most.most_edges {
        findings.add(Violation::TooManyEdges { vertices, edges })?;
    }
    if faces > most.most_faces {
        findings.add(Violation::TooManyFaces { vertices, faces })?;
    }
    findings.bounds = Some(most);
    Ok(())
}
