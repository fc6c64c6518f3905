//! G4 disjoint: edges meet only at shared endpoints.

use crate::drawing::columns::Columns;
use crate::drawing::components::Components;
use crate::drawing::segments::Segments;
use crate::numbers::NIL;
use twinedge::validate::{Findings, Halt, Rule, Unchecked};
use twinedge_geometry::crossing::clashes;
use twinedge_geometry::sweep::sweep_plane;

/// Runs G4. Returns the segment below the smallest point of each component, or `None` for too many segments or a broken G4.
pub(crate) fn check(
    findings: &mut Findings,
    columns: &Columns,
    segments: &Segments,
    components: &Components,
) -> Result<Option<Vec<Option<u32>>>, Halt> {
    findings.checked(Rule::G4, segments.edges as u64);
    let lowest = components.lowest.iter().zip(&components.lowest_bend);
    let number = |(vertex, bend): (&u32, &u32)| match *bend {
        NIL => segments.numbers[*vertex as usize],
        place => segments.bend(place as usize),
    };
    let queries: Vec<u32> = lowest.map(number).collect();
    // The arrays describe segments: G1 holds, and `Segments::of` issued every number.
    let Ok(swept) = sweep_plane(&segments.points, &segments.ends) else {
        findings.not_checked(Rule::G4, Unchecked::TooLarge);
        return Ok(None);
    };
    if swept.is_none() {
        let (found, total) =
            clashes(&segments.points, &segments.ends, findings.cap()).unwrap_or_else(|_| (Vec::new(), 0));
        let kept = found.len() as u64;
        for clash in found {
            findings.add(segments.violation(columns, clash))?;
        }
        findings.add_uncollected(Rule::G4, total.saturating_sub(kept));
    }
    Ok(swept.map(|below| below.of(&queries)))
}
