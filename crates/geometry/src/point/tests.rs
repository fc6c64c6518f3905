//! Tests of `point`.

use super::Point;
use core::hash::{BuildHasher, BuildHasherDefault};
use rustc_hash::FxHasher;

#[test]
fn hash_keys_of_coordinates_with_few_digits_spread() {
    // A table of 2^16 slots uses the lowest 16 bits of a hash first, and distinguishes entries by the highest 7.
    let spread = |scale: f64| {
        let (mut slots, mut tags) = (vec![0_u32; 1 << 16], std::vec![0_u32; 1 << 7]);
        for (x, y) in (0..256).flat_map(|x| (0..256).map(move |y| (f64::from(x), f64::from(y)))) {
            let key = Point::new(x * scale, y * scale).hash_key();
            let hash = BuildHasherDefault::<FxHasher>::default().hash_one(key);
            slots[hash as usize & 0xffff] += 1;
            tags[(hash >> 57) as usize] += 1;
        }
        (slots.into_iter().max().unwrap(), tags.into_iter().max().unwrap())
    };
    for scale in [1.0, 1024.0, 1.0 / 1024.0, 0.1] {
        let (most_in_slot, most_with_tag) = spread(scale);
        assert!(most_in_slot <= 16 && most_with_tag <= 1024, "{scale}: {most_in_slot}, {most_with_tag}");
    }
    assert_eq!(Point::new(0.0, -0.0).hash_key(), Point::new(-0.0, 0.0).hash_key());
}
