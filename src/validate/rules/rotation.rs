//! V2 rotation: the rotation of a vertex is all half-edges with that origin.
//!
//! Where L holds, `next∘twin` permutes the half-edges that leave one vertex, so the rotation of a vertex is all of them if
//! and only if its orbit is as long as the vertex has half-edges.

use super::live::Fan;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;

/// Checks one vertex, of whose half-edges the walk around it reached so many.
pub(crate) fn check(v: u32, fan: Fan, reached: u32, findings: &mut Findings) -> Flow {
    if reached == fan.degree {
        return Ok(());
    }
    findings.add(Violation::SplitRotation {
        vertex: v as usize,
        half_edge: fan.leaving as usize,
        reached: reached as usize,
        degree: fan.degree as usize,
    })
}
