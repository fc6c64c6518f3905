//! The published numbers of maps, by their formulas. A number that exceeds 128 bits is replaced by the largest one.

pub(crate) fn factorial(n: u128) -> u128 {
    (1..=n).product()
}

pub(crate) fn binomial(n: u128, k: u128) -> u128 {
    if k > n { 0 } else { (0..k).fold(1, |product, i| product * (n - i) / (i + 1)) }
}

fn totient(n: u128) -> u128 {
    let coprime = |k: &u128| {
        let (mut a, mut b) = (n, *k);
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a == 1
    };
    (1..=n).filter(coprime).count() as u128
}

fn power_of_three(n: u128) -> u128 {
    (0..n).fold(1, |power, _| 3 * power)
}

/// Up to this number, every step of the formulas below fits into 128 bits.
const MOST_EDGES: usize = 32;

/// Returns the number of rooted planar maps with n edges (Tutte, *A census of planar maps*, 1963; OEIS A000168).
pub(crate) fn rooted(n: usize) -> u128 {
    if n > MOST_EDGES {
        return u128::MAX;
    }
    let n = n as u128;
    2 * power_of_three(n) * binomial(2 * n, n) / ((n + 1) * (n + 2))
}

/// Returns the number of planar maps with n edges without root, with mirror images told apart (Liskovets; Wormald; OEIS A006384).
pub(crate) fn sensed(n: usize) -> u128 {
    match n {
        0 => return 1,
        1..=MOST_EDGES => {}
        _ => return u128::MAX,
    }
    let symmetric = |k: usize| totient((n / k) as u128) * binomial(k as u128 + 2, 2) * rooted(k);
    // In quarters, since the last term is a number of quarters.
    let n_wide = n as u128;
    let turned = if n % 2 == 1 { (n_wide + 3) * rooted(n / 2) } else { (n_wide - 1) * rooted(n / 2 - 1) };
    let others: u128 = (1..n).filter(|k| n.is_multiple_of(*k)).map(symmetric).sum();
    (2 * (rooted(n) + others) / n_wide + turned) / 4
}

/// Returns the same with one face distinguished as the outside (Liskovets and Walsh, *Counting unrooted maps on the plane*, 2006;
/// OEIS A103937).
pub(crate) fn plane(n: usize) -> u128 {
    match n {
        0 => return 1,
        1..=MOST_EDGES => {}
        _ => return u128::MAX,
    }
    let n_wide = n as u128;
    let symmetric = |k: usize| {
        let (turns, k) = ((n / k) as u128, k as u128);
        totient(turns) * power_of_three(k) * binomial(2 * k, k)
    };
    let others: u128 = (1..n).filter(|k| n.is_multiple_of(*k)).map(symmetric).sum();
    let all = power_of_three(n_wide) * binomial(2 * n_wide, n_wide) / (n_wide + 1);
    let half = (n_wide - 1) / 2;
    let turned =
        if n % 2 == 1 { power_of_three(half) * binomial(n_wide - 1, half) * 2 * n_wide / (n_wide + 1) } else { 0 };
    (all + others + turned) / (2 * n_wide)
}

/// Rooted maps with n edges by genus, for the sizes of the histogram (Walsh and Lehman, *Counting rooted maps by genus*, 1972;
/// OEIS A000168, A006300, A006298).
pub(crate) const BY_GENUS: [&[u64]; 6] = [&[1], &[2], &[9, 1], &[54, 20], &[378, 307, 21], &[2916, 4280, 966]];

/// Returns the number of simple triangulations of the sphere with this number of vertices, mirror images together (OEIS A000109).
pub(crate) fn spheres(vertices: usize) -> Option<u64> {
    [1, 1, 1, 2, 5, 14, 50, 233].get(vertices.checked_sub(3)?).copied()
}

/// Returns the same with a root (Tutte, *A census of planar triangulations*, 1962; OEIS A000260).
pub(crate) fn tutte(vertices: usize) -> Option<u64> {
    [1, 1, 3, 13, 68, 399, 2530].get(vertices.checked_sub(3)?).copied()
}

/// Returns the number of simple triangulations of a disc, rooted at its border (Brown, *Enumeration of triangulations of the
/// disk*, 1964): with n inner and m + 3 outer vertices, 2 (2m + 3)! (4n + 2m + 1)! / ((m + 2)! m! n! (3n + 2m + 3)!). `None`
/// for larger numbers.
pub(crate) fn brown(outer: usize, inner: usize) -> Option<u64> {
    let (m, n) = (outer.checked_sub(3)? as u128, inner as u128);
    if m + n > 6 {
        return None;
    }
    let above = 2 * factorial(2 * m + 3) * factorial(4 * n + 2 * m + 1);
    let below = factorial(m + 2) * factorial(m) * factorial(n) * factorial(3 * n + 2 * m + 3);
    u64::try_from(above / below).ok()
}

#[cfg(test)]
mod tests {
    use super::{BY_GENUS, MOST_EDGES, brown, plane, rooted, sensed, tutte};

    #[test]
    fn triangulations_of_a_triangle_are_those_of_the_sphere() {
        for inner in 0..=6 {
            assert_eq!(brown(3, inner), tutte(inner + 3));
        }
        // The two diagonals of a square; the wheel, and a vertex in one of four triangles.
        assert_eq!((brown(4, 0), brown(4, 1), brown(5, 0)), (Some(2), Some(5), Some(5)));
    }

    #[test]
    fn the_formulas_give_the_published_numbers() {
        let rooted: Vec<u128> = (0..=8).map(rooted).collect();
        assert_eq!(rooted, [1, 2, 9, 54, 378, 2916, 24_057, 208_494, 1_876_446]);
        let sensed: Vec<u128> = (0..=8).map(sensed).collect();
        assert_eq!(sensed, [1, 2, 4, 14, 57, 312, 2071, 15_030, 117_735]);
        let plane: Vec<u128> = (0..=9).map(plane).collect();
        assert_eq!(plane, [1, 2, 6, 26, 150, 1032, 8074, 67_086, 586_752, 5_317_226]);
        for (found, all) in BY_GENUS.iter().zip(rooted) {
            assert_eq!(u128::from(found[0]), all);
        }
    }

    #[test]
    fn numbers_that_do_not_fit_do_not_overflow() {
        for formula in [rooted, sensed, plane] {
            let numbers: Vec<u128> = (0..=MOST_EDGES).map(formula).collect();
            assert!(numbers.is_sorted() && numbers[MOST_EDGES] < u128::MAX, "{numbers:?}");
            for n in [MOST_EDGES + 1, 1_000, usize::MAX] {
                assert_eq!(formula(n), u128::MAX);
            }
        }
    }
}
