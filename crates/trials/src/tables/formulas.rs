//! The number of valid tables, by formulas for maps on labelled half-edges.

use crate::published::{binomial, factorial, rooted};

/// Returns the number of permutations of n things with k orbits: unsigned Stirling numbers of the first kind.
fn permutations_with_orbits(n: u128, k: u128) -> u128 {
    match (n, k) {
        (0, 0) => 1,
        (0, _) | (_, 0) => 0,
        _ => permutations_with_orbits(n - 1, k - 1) + (n - 1) * permutations_with_orbits(n - 1, k),
    }
}

/// Returns the number of ways to pair off 2n half-edges as twins: (2n − 1)!!. The largest number if it exceeds 128 bits.
pub(crate) fn pairings(edges: u128) -> u128 {
    let mut pairings = 1_u128;
    for i in 1..=edges {
        pairings = pairings.saturating_mul(2 * i - 1);
        if pairings == u128::MAX {
            break;
        }
    }
    pairings
}

/// Returns the number of maps with n edges on labelled half-edges, on any surface: `next` may be any permutation.
pub(crate) fn maps(edges: u128) -> u128 {
    pairings(edges) * factorial(2 * edges)
}

/// Returns the same with k of m vertices assigned to the rotations. The other vertices are isolated.
pub(crate) fn maps_with_vertices(edges: u128, vertices: u128) -> u128 {
    let named = |k| factorial(k) * binomial(vertices, k) * permutations_with_orbits(2 * edges, k);
    pairings(edges) * (0..=vertices).map(named).sum::<u128>()
}

/// Returns the same with a half-edge chosen from each rotation: k orbits of n things with a first thing each correspond to the
/// things in a row with k − 1 bars between them.
pub(crate) fn maps_with_leaving(edges: u128, vertices: u128) -> u128 {
    let named = |k| binomial(vertices, k) * factorial(2 * edges) * binomial(2 * edges - 1, k - 1);
    pairings(edges) * (1..=vertices).map(named).sum::<u128>()
}

/// Returns the number of connected plane maps on labelled half-edges. A rooted one has (2n − 1)! labellings with its root first.
pub(crate) fn connected_plane_maps(edges: u128) -> u128 {
    rooted(edges as usize) * factorial(2 * edges - 1)
}

/// Returns the number of plane maps on labelled half-edges: the component of the first half-edge, and the rest.
pub(crate) fn plane_maps(edges: u128) -> u128 {
    if edges == 0 {
        return 1;
    }
    let with_first = |k| binomial(2 * edges - 1, 2 * k - 1) * connected_plane_maps(k) * plane_maps(edges - k);
    (1..=edges).map(with_first).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_can_be_counted_by_hand() {
        assert_eq!([1, 2, 3].map(pairings), [1, 3, 15]);
        // A loop or an edge, for each way to name the half-edges.
        assert_eq!((maps(1), plane_maps(1)), (2, 2));
        assert_eq!((maps_with_vertices(1, 2), maps_with_leaving(1, 2)), (2 + 2, 2 * 2 + 2));
        // With two edges, all but one rooted map of the torus lie in the plane.
        assert_eq!((maps(2), plane_maps(2)), (72, 66));
        // With three, 20 on the torus, and 15 ways to have one next to a plane edge.
        assert_eq!(maps(3) - plane_maps(3), 20 * 120 + 15 * 2 * 6);
    }
}
