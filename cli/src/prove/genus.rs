//! The histogram of accepted rotation systems by genus, from all permutations.

use super::permutations::{RotationSystem, beginnings, for_each};
use crate::work;
use twinedge::validate::{Collect, Expectation, Part, validate};

/// The most edges for which all permutations are gone through: 10! of them.
pub(super) const MOST_EDGES: usize = 5;

/// Rooted maps of so many edges by genus, as the validator accepts them.
///
/// With twins as they are, every permutation of the half-edges is the `next` of a map on closed surfaces. Where the validator
/// accepts it and finds one component, it counts for the genus that the validator finds. A rooted map has no symmetry, so
/// 2ⁿ⁻¹ (n − 1)! of them are the same but for the names of the half-edges.
///
/// None of those that were refused, which should be none, is counted; the second number is how many.
pub(super) fn histogram(edges: usize, threads: usize) -> (Vec<u64>, u64) {
    if edges == 0 {
        // One vertex.
        return (vec![1], 0);
    }
    let half_edges = 2 * edges as u8;
    let shares = beginnings(half_edges);
    let bar = work::bar(shares.len(), format!("rotation systems of {edges} edges"));
    let found = work::share(
        threads,
        shares.len(),
        &bar,
        || (Vec::new(), 0),
        |(by_genus, refused), number| {
            for_each(half_edges, &shares[number], |map| judge(map, by_genus, refused));
        },
    );
    let names: u64 = (1..edges as u64).map(|i| 2 * i).product();
    let mut sum = Vec::new();
    let mut refused = 0;
    for (by_genus, more_refused) in found {
        sum.resize(sum.len().max(by_genus.len()), 0);
        for (genus, count) in by_genus.into_iter().enumerate() {
            sum[genus] += count;
        }
        refused += more_refused;
    }
    // What does not divide is no count of maps: say so by rounding up, which no published number is.
    (sum.into_iter().map(|labelled: u64| labelled.div_ceil(names)).collect(), refused)
}

fn judge(map: &RotationSystem, by_genus: &mut Vec<u64>, refused: &mut u64) {
    let report = validate(map, &Expectation::surface().without(Part::Faces), Collect::First);
    let counts = report.counts();
    match (report.is_valid(), counts.genus) {
        (true, Some(genus)) if counts.components == Some(1) => {
            by_genus.resize(by_genus.len().max(genus + 1), 0);
            by_genus[genus] += 1;
        }
        (true, Some(_)) => {}
        _ => *refused += 1,
    }
}

#[cfg(test)]
mod tests {
    use super::histogram;
    use crate::counting::BY_GENUS;

    #[test]
    fn rooted_maps_of_every_genus_are_as_many_as_published() {
        for (edges, published) in BY_GENUS.iter().enumerate().take(5) {
            assert_eq!(histogram(edges, 2), (published.to_vec(), 0), "{edges} edges");
        }
    }
}
