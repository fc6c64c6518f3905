//! T2 nesting: containment is a tree rooted at the unbounded face.
//!
//! Following component ► face ► component … ends at the unbounded face.

use super::containment_unchecked;
use crate::validate::columns::{Components, NIL, column};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs T2: from each component outwards, until the unbounded face or a component that was passed before.
pub(crate) fn check(subject: Subject<'_>, components: &Components, lies_in: &[u32], findings: &mut Findings) -> Flow {
    let why = containment_unchecked(subject, findings);
    if let Some(why) = why.or_else(|| findings.broken(&[Rule::T1]).map(Unchecked::Broken)) {
        findings.not_checked(Rule::T2, why);
        return Ok(());
    }
    let count = components.all.len() as u32;
    // The round in which a component was first passed; all rounds before the present one ended well or were reported.
    let mut passed = column(count, NIL)?;
    for first in 0..count {
        let mut c = first as usize;
        loop {
            match passed[c] {
                NIL => passed[c] = first,
                round if round == first => {
                    let (vertex, face) = (components.all[c].vertex as usize, lies_in[c] as usize);
                    findings.add(Violation::NestedInItself { vertex, face })?;
                    break;
                }
                _ => break,
            }
            match container(subject, components, lies_in[c]) {
                Some(outer) => c = outer,
                None => break,
            }
        }
    }
    findings.checked(Rule::T2, u64::from(count));
    Ok(())
}

/// The component whose outer boundary component bounds this face; none for the unbounded one.
fn container(subject: Subject<'_>, components: &Components, face: u32) -> Option<usize> {
    let face = subject.extent.faces.existing(Some(face as usize))?;
    subject.component_of_start(components, subject.outer_start(face))
}
