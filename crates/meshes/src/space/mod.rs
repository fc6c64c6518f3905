//! Optional rules about the coordinates of the points of a mesh, M9 … M11.
//!
//! Points at the same place count as one, as in files that repeat a point for each texture. A face with more than three sides is
//! taken as the triangles between its first corner and its other sides. All signs are exact, unless products of coordinates
//! exceed the range of 64-bit numbers.

mod area;
mod crossing;
mod exact;
mod outward;
mod places;
mod segment;

use super::space_rule::{SpaceOutcome, SpaceRule};
use super::{Finding, Findings, HalfEdgeMesh, Kind};
use places::Places;

/// Checks rules. O(n) expected for M9; O(n log n + k) for M10, for k pairs of faces with overlapping boxes; O(n) for M11, plus
/// O(n) for each component that faces inwards.
pub(super) fn check(mesh: &HalfEdgeMesh<'_>, rules: &[SpaceRule], findings: &mut Findings) -> Vec<SpaceOutcome> {
    let mut asked = rules.to_vec();
    asked.sort_unstable();
    asked.dedup();
    let places = Places::new(mesh.mesh());
    let mut outcome = |rule: SpaceRule| {
        let mut found = |finding: Finding| findings.add(Kind::of(rule), || finding);
        let (checked, left_out) = match rule {
            SpaceRule::Area => (area::check(mesh, &places, &mut found), 0),
            SpaceRule::Crossing => crossing::check(mesh, &places, &mut found),
            SpaceRule::Outward => (outward::check(mesh, &places, &mut found), 0),
        };
        SpaceOutcome { rule, checked, left_out }
    };
    asked.into_iter().map(&mut outcome).collect()
}
