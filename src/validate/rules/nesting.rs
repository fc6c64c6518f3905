//! T2 nesting: containment is a tree rooted at the unbounded face.
//!
//! ```text
//!   unbounded face
//!     └─ component a
//!          └─ face of a ─ component c
//!                           └─ face of c ─ …
//! ```
//!
//! Following component ► face ► component … ends at the unbounded face.

use crate::validate::columns::{Components, NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Start, View};
use crate::validate::violation::Violation;

/// Runs T2: from each component outwards, until the unbounded face or a component that was passed before.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, components: &Components) -> Flow {
    let why = run.containment_unchecked().or_else(|| run.findings.broken(&[Rule::T1]).map(Unchecked::Broken));
    if let Some(why) = why {
        run.findings.not_checked(Rule::T2, why);
        return Ok(());
    }
    let count = components.all.len() as u32;
    // The round in which a component was first passed; all rounds before the present one ended well or were reported.
    let mut passed = column(count, NIL)?;
    for first in 0..count {
        let mut c = first;
        loop {
            match passed[c as usize] {
                NIL => passed[c as usize] = first,
                round if round == first => {
                    let component = &components.all[c as usize];
                    let (vertex, face) = (component.vertex as usize, component.lies_in as usize);
                    run.findings.add(Violation::NestedInItself { vertex, face })?;
                    break;
                }
                _ => break,
            }
            match container(run, components, c) {
                Some(outer) => c = outer as u32,
                None => break,
            }
        }
    }
    run.findings.checked(Rule::T2, u64::from(count));
    Ok(())
}

/// The component whose outer boundary component bounds the face in which this component lies; none at the root.
fn container<V: View + ?Sized>(run: &Run<'_, V>, components: &Components, c: u32) -> Option<usize> {
    let face = components.all[c as usize].lies_in as usize;
    if face >= run.faces as usize {
        return None;
    }
    let start = if run.expect.has(Part::BoundaryComponents) {
        run.view.boundary_start(run.view.outer(face).filter(|b| *b < run.boundaries as usize)?)
    } else {
        run.view.outer_half_edge(face).map(Start::HalfEdge)
    };
    run.component_of_start(components, start)
}
