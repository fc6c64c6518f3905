//! T1 outside: each component has exactly one inner boundary component, its outside.
//!
//! ```text
//!   face 0
//!   ┌───────────────┐
//!   │  a   ┌─────┐  │    face 0 lists the outside of a,
//!   │      │  c  │  │    the face between them lists the outside of c
//!   │      └─────┘  │
//!   └───────────────┘
//! ```

use crate::validate::columns::Components;
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::record::Record;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Start, View};
use crate::validate::violation::Violation;

/// Runs T1, and notes in which face each component lies.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, components: &mut Components) -> Flow {
    if let Some(why) = run.containment_unchecked() {
        run.findings.not_checked(Rule::T1, why);
        return Ok(());
    }
    if run.known.outsides {
        run.findings.checked(Rule::T1, components.all.len() as u64);
        return Ok(());
    }
    let mut budget = run.list_budget;
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        let listed = run.view.inner_count(f).min(budget);
        budget -= listed;
        for i in 0..listed {
            let (start, record) = inner(run, f, i);
            let (Some(c), Some(record)) = (run.component_of_start(components, start), record) else {
                continue;
            };
            let component = &mut components.all[c];
            if let Some(first) = component.outside {
                let vertex = component.vertex as usize;
                run.findings.add(Violation::TwoOutsides { vertex, first, second: record })?;
            } else {
                component.outside = Some(record);
                component.lies_in = f as u32;
            }
        }
    }
    run.findings.checked(Rule::T1, components.all.len() as u64);
    // What lies in no face, because the unbounded one has no record, has no inner boundary component either.
    let needed = run.expect.has(Part::UnboundedFace);
    for component in &components.all {
        if component.outside.is_none() && needed && !component.open {
            run.findings.add(Violation::NoOutside { vertex: component.vertex as usize })?;
        }
    }
    Ok(())
}

/// Where the inner boundary component at this position starts, and the record by which a report names it.
fn inner<V: View + ?Sized>(run: &Run<'_, V>, f: usize, i: usize) -> (Option<Start>, Option<Record>) {
    if run.expect.has(Part::BoundaryComponents) {
        let b = run.view.inner(f, i).filter(|b| *b < run.boundaries as usize);
        return (b.and_then(|b| run.view.boundary_start(b)), b.map(Record::Boundary));
    }
    let start = run.view.inner_start(f, i);
    let record = start.map(|start| match start {
        Start::HalfEdge(h) => Record::HalfEdge(h),
        Start::Vertex(v) => Record::Vertex(v),
    });
    (start, record)
}
