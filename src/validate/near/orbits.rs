//! A test for half-edges on one orbit: those that are new in a rotation or on a cycle, or are followed by another one there.

use alloc::vec::Vec;

/// A half-edge on an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Member {
    /// The vertex or label of the orbit.
    pub(super) of: u32,
    pub(super) half_edge: u32,
    /// True if it belonged there before.
    pub(super) is_old: bool,
}

/// Members of several orbits.
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
    /// Those of one orbit, when all are sorted.
    pub(super) fn of(&self, orbit: usize) -> &[Member] {
        let from = self.0.partition_point(|member| (member.of as usize) < orbit);
        let rest = &self.0[from..];
        &rest[..rest.partition_point(|member| member.of as usize == orbit)]
    }
}

/// Memory for the walks, which is kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Walks {
    /// The member from which each walk that has not ended comes, and where it is.
    under_way: Vec<(usize, usize)>,
    /// By member the one that its walk has met.
    meets: Vec<Option<usize>>,
    is_met: Vec<bool>,
}

impl Walks {
    /// Finds all members on one orbit of the permutation `step`, and on it what `remains` of those of before. They are sorted, and
    /// differ from each other.
    ///
    /// ```text
    ///    a ──► · ──► b ──► c ──► · ──► · ──► · ──► …        a meets b, b meets c: c leads back to a
    /// ```
    ///
    /// The walks from all members advance in step. Each ends at the first member that it meets. One of them need not end: no two
    /// meet the same member, so if the others form one chain, the last leads back to its beginning. The walks do not overlap, so
    /// there are at most as many steps as the orbit has elements, and no more than there are members times the second largest of the
    /// distances between them.
    ///
    /// An orbit without member is one of before, all of it. So if any half-edge remains, a member must be an old one.
    ///
    /// Nothing if they do not lie on one, if a step leads nowhere, or after more than `limit` steps, as can be where `step` is no
    /// permutation.
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
        // From the one that no walk has met, if there is one, the chain is as long as there are members.
        let first = is_met.iter().position(|met| !met).unwrap_or(0);
        let chain = core::iter::successors(Some(first), |at| meets.get(*at).copied()?.filter(|next| *next != first));
        (chain.take(members.len()).count() == members.len()).then_some(())
    }
}
