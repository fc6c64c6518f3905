//! Tests of `number_table`.

use super::{NumberTable, hash};
use quickcheck::quickcheck;

quickcheck! {
    /// Holds even if many hashes are equal, and for items added one by one or many at once.
    fn numbers_are_those_of_the_first_equal_things(things: Vec<(u8, u8)>, few: bool, step: u8) -> bool {
        let hash_of = |(a, b): (u8, u8)| if few { u64::from(a % 2) << 32 } else { hash([a.into(), b.into()]) };
        let mut known: Vec<(u8, u8)> = Vec::new();
        let mut table = NumberTable::default();
        let mut listed = 0;
        things.iter().all(|thing| {
            let expected = known[..listed].iter().position(|other| other == thing);
            let found = table.find(hash_of(*thing), |number| known[number as usize] == *thing);
            if !known.contains(thing) {
                known.push(*thing);
            }
            if known.len() > listed + usize::from(step % 4) {
                listed = known.len();
                table.extend(listed, |number| hash_of(known[number as usize]));
            }
            found.ok().map(|number| number as usize) == expected
        })
    }
}

#[test]
fn hashes_of_small_and_of_round_numbers_spread() {
    let square =
        |unit: f64| (0..64).flat_map(move |x| (0..64).map(move |y| [f64::from(x) * unit, f64::from(y) * unit]));
    for unit in [1.0, 0.25, 1e-9] {
        let mut places: Vec<u64> = square(unit).map(|p| hash(p.map(f64::to_bits)) >> 32 & 0x1fff).collect();
        places.sort_unstable();
        // Of 4,096 entries in 8,192 slots, 3,223 distinct ones are expected.
        places.dedup();
        assert!(places.len() > 2900, "{unit}: {}", places.len());
    }
}
