//! The sweep compared with trying all pairs of segments.

use super::containers;
use crate::rings::{Ring, with_index};
use quickcheck::{Gen, QuickCheck};
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge_geometry::Point;

static APART: AtomicUsize = AtomicUsize::new(0);
static NESTED: AtomicUsize = AtomicUsize::new(0);

/// Rings of a few families: squares and diamonds, which are often disjoint, and arbitrary points.
fn rings(raw: &[(u8, u8, u8)], any: &[(u8, u8)]) -> Vec<Ring> {
    let even = |x: i32, y: i32| Point::new(f64::from(x), f64::from(y));
    let shapes = raw.iter().map(|(x, y, size)| {
        let (x, y, r) = (i32::from(x % 32), i32::from(y % 32), i32::from(size % 16) + 1);
        let mut ring = if size & 16 == 0 {
            vec![even(x - r, y - r), even(x + r, y - r), even(x + r, y + r), even(x - r, y + r)]
        } else {
            vec![even(x - r, y), even(x, y - r), even(x + r, y), even(x, y + r)]
        };
        if size & 32 == 0 {
            ring.reverse();
        }
        ring.rotate_left(usize::from(size >> 6));
        ring
    });
    let mut drawn: Vec<Point> = any.iter().map(|(x, y)| even(i32::from(x % 16), i32::from(y % 16))).collect();
    drawn.dedup();
    while drawn.len() > 1 && drawn.first() == drawn.last() {
        drawn.pop();
    }
    let all = shapes.chain([drawn]).filter(|ring| ring.len() > 2);
    all.enumerate().map(|(polygon, points)| Ring { points, polygon, number: 0 }).collect()
}

#[expect(clippy::needless_pass_by_value, reason = "what quickcheck asks for")]
fn agrees(raw: Vec<(u8, u8, u8)>, any: Vec<(u8, u8)>) -> bool {
    let rings = rings(&raw, &any);
    let found = containers(&rings);
    let expected = with_index(&rings, |all| all.meets().is_empty().then(|| all.containers()));
    APART.fetch_add(usize::from(expected.is_some()), Ordering::Relaxed);
    NESTED.fetch_add(expected.iter().flatten().map(Vec::len).sum(), Ordering::Relaxed);
    found == expected
}

#[test]
fn rings_that_one_sweep_finds_apart_meet_nowhere_and_lie_in_the_same_rings() {
    for (size, tests) in [(3, 2000), (6, 2000), (9, 2000)] {
        let check = agrees as fn(Vec<(u8, u8, u8)>, Vec<(u8, u8)>) -> bool;
        QuickCheck::new().rng(Gen::from_size_and_seed(size, 1)).tests(tests).quickcheck(check);
    }
    let [apart, nested] = [&APART, &NESTED].map(|count| count.load(Ordering::Relaxed));
    assert!(apart > 1000 && nested > 100, "{apart} {nested}");
}
