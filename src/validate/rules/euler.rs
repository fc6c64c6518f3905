//! T3 Euler: per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane.

use crate::validate::columns::Components;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs T3, unless the genus is `known` already, and adds up the genus.
pub(crate) fn check(
    subject: Subject<'_>,
    components: &Components,
    known: Option<usize>,
    findings: &mut Findings,
) -> Flow {
    let mut total = known.unwrap_or(0);
    for component in components.all.iter().filter(|_| known.is_none()) {
        let vertex = component.vertex as usize;
        let (vertices, edges, cycles) = (component.vertices as usize, component.edges(), component.cycles as usize);
        let handles = (2 + edges).checked_sub(vertices + cycles);
        match handles {
            Some(twice) if twice % 2 == 0 => {
                let genus = twice / 2;
                total += genus;
                if genus > 0 && subject.extent.is_plane() {
                    findings.add(Violation::Genus { vertex, vertices, edges, cycles, genus })?;
                }
            }
            _ => findings.add(Violation::NoSuchSurface { vertex, vertices, edges, cycles })?,
        }
    }
    findings.checked(Rule::T3, components.all.len() as u64);
    findings.counts.genus = Some(total);
    Ok(())
}
