//! The common case first: one pass over the half-edges that finds nothing to report.
//!
//! Most structures that are validated are right, and most of what there is to check is local to a half-edge. So where a
//! structure has all parts and a closed boundary, a first glance asks for each half-edge at once whether R1, L1, L2, L3 and
//! the first part of B1 hold of it. If they hold of all, there is nothing more to say about these rules. If anything is
//! amiss, the glance says nothing at all, and the rules are run one by one by the files that are named after them.

use super::report::Halt;
use super::run::{Fan, NIL, Run, column};
use super::{Part, Rule, View};

impl<V: View + ?Sized> Run<'_, V> {
    /// Whether R1, L1, L2, L3 and the first part of B1 hold of every half-edge. What was counted on the way is kept if so.
    pub(super) fn glance(&mut self) -> Result<bool, Halt> {
        let expected = [Part::Prev, Part::BoundaryComponents];
        if self.expect.is_open() || !expected.into_iter().all(|part| self.expect.has(part)) {
            return Ok(false);
        }
        let mut fans = column(self.vertices, Fan { degree: 0, leaving: NIL })?;
        let mut sizes = column(self.boundaries, 0_u32)?;
        let mut live = 0;
        for h in 0..self.half_edges {
            if !self.live_half_edge(h) {
                continue;
            }
            live += 1;
            let (v, t, n, p, b) = (self.origin(h), self.twin(h), self.next(h), self.prev(h), self.boundary(h));
            let (Some(fan), Some(size)) = (fans.get_mut(v as usize), sizes.get_mut(b as usize)) else {
                return Ok(false);
            };
            *fan = Fan { degree: fan.degree + 1, leaving: h };
            *size += 1;
            // Whether vertices and boundary components are live is asked below, once for each that is named.
            let lives = self.live_half_edge(t) && self.live_half_edge(n) && self.live_half_edge(p);
            let mutual = || t != h && self.twin(t) == h && self.prev(n) == h && self.next(p) == h;
            let follows = || self.origin(n) == self.origin(t) && self.boundary(n) == b;
            if !(lives && mutual() && follows()) {
                return Ok(false);
            }
        }
        let stray_vertex = (0..self.vertices).any(|v| fans[v as usize].degree > 0 && !self.live_vertex(v));
        let stray_boundary = (0..self.boundaries).any(|b| sizes[b as usize] > 0 && !self.live_boundary(b));
        if stray_vertex || stray_boundary {
            return Ok(false);
        }
        (self.fans, self.sizes) = (fans, sizes);
        self.counts.half_edges = live;
        self.counts.edges = live / 2;
        self.findings.checked(Rule::R1, 5 * live as u64);
        for rule in [Rule::L1, Rule::L2, Rule::L3, Rule::B1] {
            self.findings.checked(rule, live as u64);
        }
        Ok(true)
    }
}
