//! V2 rotation: the rotation of a vertex is all half-edges with that origin.
//!
//! ```text
//!        \   |   /              \   |
//!         \  |  /                \  |   ___
//!   ───────  v  ───────    ───────  v  ___   two fans that share a vertex: each is closed under
//!         /  |  \                /  |        next∘twin, and neither reaches the other
//!        /   |   \              /   |
//! ```
//!
//! Where L holds, `next∘twin` permutes the half-edges that leave one vertex, so the rotation of a vertex is all of them if
//! and only if its orbit is as long as the vertex has half-edges.

use crate::validate::findings::Flow;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Checks one vertex, of whose half-edges the walk around it reached so many.
#[inline]
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, v: u32, reached: u32) -> Flow {
    let fan = run.fans[v as usize];
    if reached == fan.degree {
        return Ok(());
    }
    run.findings.add(Violation::SplitRotation {
        vertex: v as usize,
        half_edge: fan.leaving as usize,
        reached: reached as usize,
        degree: fan.degree as usize,
    })
}
