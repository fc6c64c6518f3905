//! Tests of `boxes`.

use super::{Bounds, Boxes, Point};
use quickcheck::{Gen, QuickCheck};

/// The pairs of numbers whose boxes meet, each both ways, with the first box grown.
fn pairs(boxes: &[Bounds], by: f64) -> Vec<(u32, u32)> {
    let of = |number: u32| boxes[number as usize];
    let tree = Boxes::new(0..boxes.len() as u32, &of);
    let each = |found: &mut Vec<(u32, u32)>, number: u32, others: &[u32]| {
        found.extend(others.iter().map(|other| (number, *other)));
    };
    let merge = |mut one: Vec<_>, mut other: Vec<_>| {
        one.append(&mut other);
        one
    };
    let mut found = tree.pairs(by, &Vec::new, &each, &merge);
    found.sort_unstable();
    found
}

#[expect(clippy::needless_pass_by_value, reason = "what quickcheck asks for")]
fn finds_all(raw: Vec<(i8, i8, u8, u8)>, by: u8) -> bool {
    let boxes: Vec<Bounds> = raw
        .iter()
        .map(|(x, y, width, height)| {
            let low = Point::new(f64::from(*x), f64::from(*y));
            Bounds { low, high: Point::new(low.x + f64::from(width % 16), low.y + f64::from(height / 8)) }
        })
        .collect();
    let by = f64::from(by % 4);
    let numbers = || 0..boxes.len();
    let all = numbers().flat_map(|a| numbers().map(move |b| (a, b)));
    let meeting = all.filter(|(a, b)| {
        let (a_box, b_box) = (boxes[*a], boxes[*b]);
        let apart = |low: f64, high: f64, other: [f64; 2]| other[1] < low - by || other[0] > high + by;
        a != b
            && !apart(a_box.low.x, a_box.high.x, [b_box.low.x, b_box.high.x])
            && !apart(a_box.low.y, a_box.high.y, [b_box.low.y, b_box.high.y])
    });
    pairs(&boxes, by).into_iter().eq(meeting.map(|(a, b)| (a as u32, b as u32)))
}

#[test]
fn the_tree_finds_what_trying_all_pairs_finds() {
    assert!(pairs(&[], 1.0).is_empty());
    for (size, tests) in [(5, 300), (30, 300), (600, 20)] {
        let check = finds_all as fn(Vec<(i8, i8, u8, u8)>, u8) -> bool;
        QuickCheck::new().rng(Gen::from_size_and_seed(size, 3)).tests(tests).quickcheck(check);
    }
}
