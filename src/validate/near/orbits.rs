//! Whether some elements lie on one orbit of a permutation.

use alloc::vec::Vec;

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
    /// Whether all members lie on one orbit of the permutation `step`. They are sorted, and differ from each other.
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
    /// Nothing if they do not, if a step leads nowhere, or after more than `limit` steps, as can be where `step` is no permutation.
    pub(super) fn on_one(
        &mut self,
        members: &[usize],
        limit: usize,
        step: impl Fn(usize) -> Option<usize>,
    ) -> Option<()> {
        let Self { under_way, meets, is_met } = self;
        under_way.clear();
        under_way.extend(members.iter().copied().enumerate());
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
                let Ok(met) = members.binary_search(at) else {
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

#[cfg(test)]
mod tests {
    use super::Walks;

    fn is_one(members: &[usize], next: &[usize]) -> bool {
        Walks::default().on_one(members, next.len(), |at| next.get(at).copied()).is_some()
    }

    #[test]
    fn members_of_one_orbit_are_found_on_it() {
        let cycle = [1, 2, 3, 4, 5, 0];
        for members in [&[][..], &[3], &[0, 1], &[0, 3], &[1, 2, 5], &[0, 1, 2, 3, 4, 5]] {
            assert!(is_one(members, &cycle), "{members:?}");
        }
    }

    #[test]
    fn members_of_two_orbits_are_not() {
        let two = [1, 0, 3, 4, 2, 6, 5];
        for members in [&[0, 2][..], &[0, 1, 2], &[2, 3, 5], &[0, 1, 5, 6], &[0, 1, 2, 3, 4]] {
            assert!(!is_one(members, &two), "{members:?}");
        }
    }

    #[test]
    fn what_is_no_permutation_ends() {
        assert!(!is_one(&[0, 1], &[2, 2, 3, 2]), "the walks never come back");
        assert!(!is_one(&[0, 1], &[2, 2, 9]), "the walks lead nowhere");
        assert!(!is_one(&[0, 1, 2], &[1, 2, 1]), "two meet the same");
    }
}
