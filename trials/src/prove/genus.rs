//! Accepted rotation systems by genus, from all permutations.

use super::permutations::{CombinatorialMap, beginnings, for_each};
use crate::run::Run;
use twinedge::validate::{Collect, Expectation, validate};

/// The largest number of edges for which all permutations are tried: 10! of them.
pub(super) const MOST_EDGES: usize = 5;

/// Returns, for maps of `edges` edges with labelled half-edges, the number that the validator accepts by genus in this part of
/// the work, and the number that it rejects, which should be 0.
///
/// With fixed twins, every permutation of the half-edges is the `next` of a map on closed surfaces. If the validator accepts it
/// and finds one component, it counts for the genus that the validator finds.
pub(super) fn labelled(edges: usize, run: &Run<'_>) -> (Vec<u64>, u64) {
    if edges == 0 {
        // One vertex.
        return (if run.part().has(0) { vec![1] } else { vec![] }, 0);
    }
    let half_edges = 2 * edges as u8;
    let beginnings = beginnings(half_edges);
    let numbers: Vec<usize> = run.part().numbers(beginnings.len()).collect();
    let stage = format!("rotation systems of {edges} edges");
    let found = run.each(
        &stage,
        numbers.len(),
        || (Vec::new(), 0),
        |(by_genus, refused), number| {
            for_each(half_edges, &beginnings[numbers[number]], |map| judge(map, by_genus, refused));
        },
    );
    let mut sum = Vec::new();
    let mut refused = 0;
    for (by_genus, more_refused) in found {
        add(&mut sum, &by_genus);
        refused += more_refused;
    }
    (sum, refused)
}

pub(super) fn add(sum: &mut Vec<u64>, by_genus: &[u64]) {
    sum.resize(sum.len().max(by_genus.len()), 0);
    sum.iter_mut().zip(by_genus).for_each(|(sum, count)| *sum += count);
}

/// Returns the numbers of rooted maps for numbers of labelled ones. A rooted map has no symmetry, so it has 2ⁿ⁻¹ (n − 1)!
/// labellings.
pub(super) fn rooted(edges: usize, labelled: &[u64]) -> Vec<u64> {
    let names: u64 = (1..edges as u64).map(|i| 2 * i).product();
    // A number that is not divisible is not a count of maps. Rounded up, it is no published one either.
    labelled.iter().map(|labelled| labelled.div_ceil(names)).collect()
}

fn judge(map: &CombinatorialMap, by_genus: &mut Vec<u64>, refused: &mut u64) {
    let report = validate(map, &Expectation::surface(), Collect::First);
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
    use super::{labelled, rooted};
    use crate::published::BY_GENUS;
    use crate::run::Run;

    #[test]
    fn rooted_maps_of_every_genus_are_as_many_as_published() {
        for (edges, published) in BY_GENUS.iter().enumerate().take(5) {
            let (labelled, refused) = labelled(edges, &Run::default());
            assert_eq!((rooted(edges, &labelled), refused), (published.to_vec(), 0), "{edges} edges");
        }
    }
}
