//! Tests whether half-edges lie on one orbit: half-edges that are new in a rotation or on a cycle, or have a new successor there.

use alloc::vec::Vec;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Member {
    /// The vertex or label of the orbit.
    pub(super) of: u32,
    pub(super) half_edge: u32,
    /// True if it belonged there before.
    pub(super) is_old: bool,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Members(Vec<Member>);

impl Members {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
    pub(super) fn push(&mut self, member: Member) {
        self.0.push(member);
    }
    pub(super) fn sort(&mut self) {
        self.0.sort_unstable();
    }
    pub(super) fn of(&self, orbit: usize) -> &[Member] {
        let from = self.0.partition_point(|member| (member.of as usize) < orbit);
        let rest = &self.0[from..];
        &rest[..rest.partition_point(|member| member.of as usize == orbit)]
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct Walks {
    /// The member where each unfinished walk began, and its current half-edge.
    under_way: Vec<(usize, usize)>,
    /// By member: the member that its walk has met.
    meets: Vec<Option<usize>>,
    is_met: Vec<bool>,
}

impl Walks {
    /// Checks that all members lie on one orbit of the permutation `step`, together with any earlier half-edges that remain. Members
    /// are sorted and distinct.
    ///
    /// ```text
    ///    a ──► · ──► b ──► c ──► · ──► · ──► · ──► …        a meets b, b meets c: c leads back to a
    /// ```
    ///
    /// The walks from all members advance in step, and each ends at the first member that it meets. One walk may be left unfinished:
    /// no two walks meet the same member, so if the others form one chain, the last one leads back to its beginning. Walks do not
    /// overlap, so the number of steps is at most the size of the orbit, and at most the number of members times the second largest
    /// distance between them.
    ///
    /// An orbit without members is an unchanged one. So if any earlier half-edge remains, a member must be an old one.
    ///
    /// Returns `None` if the members lie on several orbits, if a step leads nowhere, or after more than `limit` steps, which can
    /// happen if `step` is not a permutation.
    pub(super) fn on_one(
        &mut self,
        members: &[Member],
        remains: bool,
        limit: usize,
        step: impl Fn(usize) -> Option<usize>,
    ) -> Option<()> {
        let joins = !remains || members.iter().any(|member| member.is_old);
        if members.is_empty() || !joins {
            return members.is_empty().then_some(());
        }
        let Self { under_way, meets, is_met } = self;
        under_way.clear();
        under_way.extend(members.iter().map(|member| member.half_edge as usize).enumerate());
        meets.clear();
        meets.resize(members.len(), None);
        is_met.clear();
        is_met.resize(members.len(), false);
        let mut left = limit;
        while under_way.len() > 1 {
            left = left.checked_sub(under_way.len())?;
            let mut position = 0;
            while let Some((from, at)) = under_way.get_mut(position) {
                *at = step(*at)?;
                let Ok(met) = members.binary_search_by_key(at, |member| member.half_edge as usize) else {
                    position += 1;
                    continue;
                };
                if core::mem::replace(&mut is_met[met], true) {
                    return None;
                }
                meets[*from] = Some(met);
                under_way.swap_remove(position);
            }
        }
        // From the member that no walk has met, if there is one, the chain must contain all members.
        let first = is_met.iter().position(|met| !met).unwrap_or(0);
        let chain = core::iter::successors(Some(first), |at| meets.get(*at).copied()?.filter(|next| *next != first));
        (chain.take(members.len()).count() == members.len()).then_some(())
    }
}
