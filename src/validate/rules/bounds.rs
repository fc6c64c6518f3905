//! T4 bounds: a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`.
//!
//! It follows from the rules before it, so it is a check of the counting.

use crate::validate::columns::Components;
use crate::validate::counts::Bounds;
use crate::validate::expectation::Surface;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs T4.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, components: &Components) -> Flow {
    let (vertices, edges, faces) = (run.counts.vertices, run.counts.edges, run.counts.faces);
    let why = if run.expect.surface_kind() == Surface::Plane {
        (!components.simple || vertices < 3).then_some(Unchecked::NotSimple)
    } else {
        Some(Unchecked::PlaneOnly)
    };
    if let Some(why) = why {
        run.findings.not_checked(Rule::T4, why);
        return Ok(());
    }
    let most = Bounds { most_edges: 3 * vertices - 6, most_faces: 2 * vertices - 4 };
    run.findings.checked(Rule::T4, 1);
    if edges > most.most_edges {
        run.findings.add(Violation::TooManyEdges { vertices, edges })?;
    }
    if faces > most.most_faces {
        run.findings.add(Violation::TooManyFaces { vertices, faces })?;
    }
    run.bounds = Some(most);
    Ok(())
}
