//! V1 and V2: the half-edges around each vertex.
//!
//! ```text
//!        \   |   /              \   |
//!         \  |  /                \  |   ___
//!   ───────  v  ───────    ───────  v  ___   two fans that share a vertex: each is closed under
//!         /  |  \                /  |        next∘twin, and neither sees the other
//!        /   |   \              /   |
//! ```
//!
//! Where L holds, `next∘twin` permutes the half-edges that leave one vertex, so the rotation of a vertex is all of them if
//! and only if its orbit is as long as the vertex has half-edges.

use super::report::{Flow, Halt};
use super::run::Run;
use super::{Part, Rule, Unchecked, View, Violation};

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs V1 and V2. The walk around the vertices that V2 takes finds the components, too.
    pub(super) fn rotations(&mut self) -> Result<(), Halt> {
        if self.expect.has(Part::Leaving) {
            self.leaving()?;
        } else {
            self.findings.not_checked(Rule::V1, Unchecked::Lacks(Part::Leaving));
        }
        if let Some(rule) = self.map_broken() {
            self.findings.not_checked(Rule::V2, Unchecked::Broken(rule));
            return Ok(());
        }
        self.components()
    }

    fn leaving(&mut self) -> Flow {
        let mut checked = 0;
        for v in 0..self.vertices {
            if !self.live_vertex(v) {
                continue;
            }
            let Some(h) = self.view.leaving(v as usize).filter(|h| *h < self.half_edges as usize) else {
                continue;
            };
            if !self.view.is_half_edge(h) {
                continue;
            }
            let origin = self.origin(h as u32);
            if !self.live_vertex(origin) {
                continue;
            }
            checked += 1;
            if origin != v {
                self.findings.add(Violation::NotLeaving {
                    vertex: v as usize,
                    half_edge: h,
                    origin: origin as usize,
                })?;
            }
        }
        self.findings.checked(Rule::V1, checked);
        Ok(())
    }
}
