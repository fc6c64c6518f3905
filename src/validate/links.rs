//! L1, L2, L3: the links between half-edges.
//!
//! ```text
//!        prev(h)        h         next(h)
//!   ·──────────────►·────────►·──────────────►·
//!                    ◄────────
//!                     twin(h)
//!
//!   L1  twin(twin(h)) = h, twin(h) ≠ h
//!   L2  prev(next(h)) = h, next(prev(h)) = h
//!   L3  origin(next(h)) = origin(twin(h)), the target of h
//! ```

use super::report::Flow;
use super::run::{NIL, Run, column};
use super::{Part, Rule, Unchecked, View, Violation};

impl<V: View + ?Sized> Run<'_, V> {
    /// Runs L1, L2 and L3 on every half-edge whose links are live.
    pub(super) fn links(&mut self) -> Flow {
        let with_prev = self.expect.has(Part::Prev);
        if !with_prev {
            self.derived_prev = column(self.half_edges, NIL)?;
        }
        // Where R1 found every link live, a slot in range needs no second look.
        let sure = self.map_is_live;
        let mut checked = [0, 0, 0];
        for h in 0..self.half_edges {
            if !self.live_half_edge(h) {
                continue;
            }
            let twin = Some(self.twin(h)).filter(|t| *t != NIL && (sure || self.live_half_edge(*t)));
            let next = Some(self.next(h)).filter(|n| *n != NIL && (sure || self.live_half_edge(*n)));
            if let Some(t) = twin {
                checked[0] += 1;
                self.twin_is_mutual(h, t, sure)?;
            }
            if let Some(n) = next {
                checked[1] += 1;
                if with_prev {
                    self.prev_of_next(h, n, sure)?;
                } else {
                    self.next_is_its_own(h, n)?;
                }
            }
            if with_prev {
                let p = self.prev(h);
                if p != NIL && (sure || self.live_half_edge(p)) {
                    self.next_of_prev(h, p, sure)?;
                }
            }
            if let (Some(t), Some(n)) = (twin, next) {
                let (target, found) = (self.origin(t), self.origin(n));
                if target != NIL && found != NIL && (sure || self.live_vertex(target) && self.live_vertex(found)) {
                    checked[2] += 1;
                    if target != found {
                        self.findings.add_in_pass(
                            Violation::Target {
                                half_edge: h as usize,
                                next: n as usize,
                                target: target as usize,
                                found: found as usize,
                            },
                            Rule::L1,
                        )?;
                    }
                }
            }
        }
        for (rule, checked) in [Rule::L1, Rule::L2, Rule::L3].into_iter().zip(checked) {
            self.findings.checked(rule, checked);
            if !sure {
                self.findings.not_checked(rule, Unchecked::Broken(Rule::R1));
            }
        }
        self.findings.end_pass()
    }

    #[inline]
    fn twin_is_mutual(&mut self, h: u32, t: u32, sure: bool) -> Flow {
        if t == h {
            return self.findings.add_in_pass(Violation::TwinIsSelf { half_edge: h as usize }, Rule::L1);
        }
        let back = self.twin(t);
        let link = if back == NIL {
            // At an open boundary nil is a legal link, but not where somebody claims to be the twin.
            if self.view.twin(t as usize).is_some() || !self.expect.is_open() {
                return Ok(());
            }
            None
        } else if back == h || !(sure || self.live_half_edge(back)) {
            return Ok(());
        } else {
            Some(back as usize)
        };
        self.findings
            .add_in_pass(Violation::TwinNotMutual { half_edge: h as usize, twin: t as usize, found: link }, Rule::L1)
    }

    #[inline]
    fn prev_of_next(&mut self, h: u32, n: u32, sure: bool) -> Flow {
        let back = self.prev(n);
        if back == h || back == NIL || !(sure || self.live_half_edge(back)) {
            return Ok(());
        }
        let (half_edge, next, found) = (h as usize, n as usize, back as usize);
        self.findings.add_in_pass(Violation::PrevOfNext { half_edge, next, found }, Rule::L1)
    }

    #[inline]
    fn next_of_prev(&mut self, h: u32, p: u32, sure: bool) -> Flow {
        let back = self.next(p);
        if back == h || back == NIL || !(sure || self.live_half_edge(back)) {
            return Ok(());
        }
        let (half_edge, prev, found) = (h as usize, p as usize, back as usize);
        self.findings.add_in_pass(Violation::NextOfPrev { half_edge, prev, found }, Rule::L1)
    }

    /// Without `prev`, L2 says that `next` is a permutation: no two half-edges share their next.
    #[inline]
    fn next_is_its_own(&mut self, h: u32, n: u32) -> Flow {
        let first = core::mem::replace(&mut self.derived_prev[n as usize], h);
        if first == NIL {
            return Ok(());
        }
        self.findings.add_in_pass(
            Violation::NextShared { first: first as usize, second: h as usize, next: n as usize },
            Rule::L1,
        )
    }
}
