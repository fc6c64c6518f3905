//! G4 disjoint: edges meet only at shared endpoints.
//!
//! ```text
//!   \ /        |              ______
//!    X         |         ====/======      o o
//!   / \    ----+----        /
//!
//!  Cross     Touch        Overlap      SamePlace
//! ```

use crate::geometry::crossing::clashes;
use crate::geometry::sweep::sweep;
use crate::validate::findings::{Findings, Halt};
use crate::validate::geometric::segments::Segments;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;

/// Runs G4, and gives the segment below each of these vertices, which is a guess if G4 is broken. None if there are too
/// many segments.
pub(in crate::validate) fn check(
    findings: &mut Findings,
    segments: &Segments,
    vertices: &[u32],
) -> Result<Option<Vec<Option<u32>>>, Halt> {
    findings.checked(Rule::G4, segments.ends.len() as u64);
    let queries: Vec<u32> = vertices.iter().map(|v| segments.numbers[*v as usize]).collect();
    // The arrays describe segments: G1 holds, and every number was given out by `Segments::of`.
    let Ok(swept) = sweep(&segments.points, &segments.ends, &queries) else {
        findings.not_checked(Rule::G4, Unchecked::TooLarge);
        return Ok(None);
    };
    if swept.clash.is_some() {
        let (found, total) =
            clashes(&segments.points, &segments.ends, findings.room()).unwrap_or_else(|_| (Vec::new(), 0));
        let kept = found.len() as u64;
        for clash in found {
            findings.add(segments.violation(clash))?;
        }
        findings.add_uncollected(Rule::G4, total.saturating_sub(kept));
    }
    Ok(Some(swept.below))
}
