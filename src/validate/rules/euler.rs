//! T3 Euler: per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane.
//!
//! ```text
//!   ·─────·
//!   │   ╱ │    V = 4, E = 5, three cycles: two triangles and the outside
//!   │ ╱   │    4 − 5 + 3 = 2, so g = 0
//!   ·─────·
//! ```

use crate::validate::columns::Components;
use crate::validate::expectation::Surface;
use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs T3, and adds up the genus.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, components: &Components) -> Flow {
    if let Some(known) = &run.known.whole {
        run.counts.genus = Some(known.genus);
        run.findings.checked(Rule::T3, components.all.len() as u64);
        return Ok(());
    }
    let mut total = 0;
    for component in &components.all {
        let vertex = component.vertex as usize;
        let (vertices, edges, cycles) = (component.vertices as usize, component.edges(), component.cycles as usize);
        let handles = (2 + edges).checked_sub(vertices + cycles);
        match handles {
            Some(twice) if twice % 2 == 0 => {
                let genus = twice / 2;
                total += genus;
                if genus > 0 && run.expect.surface_kind() == Surface::Plane {
                    run.findings.add(Violation::Genus { vertex, vertices, edges, cycles, genus })?;
                }
            }
            _ => run.findings.add(Violation::NoSuchSurface { vertex, vertices, edges, cycles })?,
        }
    }
    run.findings.checked(Rule::T3, components.all.len() as u64);
    run.counts.genus = Some(total);
    Ok(())
}
