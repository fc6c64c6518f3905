//! The published numbers of maps, by their formulas. A number that 128 bits cannot hold is given as the greatest one.

pub(crate) fn factorial(n: u128) -> u128 {
    (1..=n).product()
}

pub(crate) fn binomial(n: u128, k: u128) -> u128 {
    if k > n { 0 } else { (0..k).fold(1, |product, i| product * (n - i) / (i + 1)) }
}

/// Euler's function.
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

/// Up to here every step of the formulas below fits into 128 bits.
const MOST_EDGES: usize = 32;

/// Rooted planar maps with n edges (Tutte, *A census of planar maps*, 1963; OEIS A000168).
pub(crate) fn rooted(n: usize) -> u128 {
    if n > MOST_EDGES {
        return u128::MAX;
    }
    let n = n as u128;
    2 * power_of_three(n) * binomial(2 * n, n) / ((n + 1) * (n + 2))
}

/// Planar maps with n edges without root, mirror images told apart (Liskovets; Wormald; OEIS A006384).
pub(crate) fn sensed(n: usize) -> u128 {
    match n {
        0 => return 1,
        1..=MOST_EDGES => {}
        _ => return u128::MAX,
    }
    let symmetric = |k: usize| totient((n / k) as u128) * binomial(k as u128 + 2, 2) * rooted(k);
    // In quarters, for what is left over is one.
    let n_wide = n as u128;
    let turned = if n % 2 == 1 { (n_wide + 3) * rooted(n / 2) } else { (n_wide - 1) * rooted(n / 2 - 1) };
    let others: u128 = (1..n).filter(|k| n.is_multiple_of(*k)).map(symmetric).sum();
    (2 * (rooted(n) + others) / n_wide + turned) / 4
}

/// The same with one face distinguished as the outside (Liskovets and Walsh, *Counting unrooted maps on the plane*, 2006;
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

/// Rooted maps with n edges by genus, as far as the histogram goes (Walsh and Lehman, *Counting rooted maps by genus*, 1972;
/// OEIS A000168, A006300, A006298).
pub(crate) const BY_GENUS: [&[u64]; 6] = [&[1], &[2], &[9, 1], &[54, 20], &[378, 307, 21], &[2916, 4280, 966]];

#[cfg(test)]
mod tests {
    use super::{BY_GENUS, MOST_EDGES, plane, rooted, sensed};

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
