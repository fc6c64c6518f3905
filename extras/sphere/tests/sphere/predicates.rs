//! Predicates, compared with a model in integers, and with f64 where f64 is reliable.

use crate::support::{Numbers, at};
use std::cmp::Ordering;
use twinedge_geometry::predicates::{Endpoint, Meeting, Orientation};
use twinedge_sphere::Place;
use twinedge_sphere::predicates::{compare_around, meeting, on_arc, side};

type Vector = [i64; 3];

/// All vectors with coordinates 0, ±1, ±2 and ±4 such that none is a multiple of another, in any order. All have exact places.
fn vectors() -> Vec<Vector> {
    let coordinates = [-4, -2, -1, 0, 1, 2, 4];
    let mut all = Vec::new();
    for x in coordinates {
        for y in coordinates {
            for z in coordinates {
                if [x, y, z].iter().any(|c| c % 2 != 0) {
                    all.push([x, y, z]);
                }
            }
        }
    }
    all
}

fn place(vector: Vector) -> Place {
    Place::toward(vector.map(|coordinate| coordinate as f64)).expect("it is not zero")
}

fn cross([a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn dot(a: Vector, b: Vector) -> i64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn same(a: Vector, b: Vector) -> bool {
    cross(a, b) == [0; 3] && dot(a, b) > 0
}

/// Returns true if a place lies on the closed arc, by angles in its plane.
fn contains([a, b]: [Vector; 2], p: Vector) -> bool {
    let normal = cross(a, b);
    dot(p, normal) == 0 && dot(cross(a, p), normal) >= 0 && dot(cross(p, b), normal) >= 0 && !same(p, a.map(|c| -c))
}

/// Classifies the meeting of two arcs by the intersection of their planes.
fn model(first: [Vector; 2], second: [Vector; 2]) -> Meeting {
    let along = cross(cross(first[0], first[1]), cross(second[0], second[1]));
    let is_end = |arc: [Vector; 2], p: Vector| arc.into_iter().any(|end| same(end, p));
    if along != [0; 3] {
        let met = [along, along.map(|c| -c)].into_iter().find(|p| contains(first, *p) && contains(second, *p));
        let Some(p) = met else { return Meeting::Disjoint };
        let ends = [first[0], first[1], second[0], second[1]];
        let names = [Endpoint::A, Endpoint::B, Endpoint::C, Endpoint::D];
        return match (is_end(first, p), is_end(second, p)) {
            (true, true) => Meeting::SharedEndpoint,
            (false, false) => Meeting::Cross,
            _ => Meeting::Touch(names[ends.iter().position(|end| same(*end, p)).expect("one of them")]),
        };
    }
    let common: Vec<Vector> = first
        .into_iter()
        .filter(|p| contains(second, *p))
        .chain(second.into_iter().filter(|p| contains(first, *p)))
        .collect();
    match common.first() {
        None => Meeting::Disjoint,
        Some(p) if common.iter().all(|q| same(*p, *q)) => Meeting::SharedEndpoint,
        Some(_) => Meeting::Overlap,
    }
}

/// Random arcs that often share ends or circles.
fn arcs(numbers: &mut Numbers, vectors: &[Vector]) -> [[Vector; 2]; 2] {
    loop {
        let mut any = || vectors[numbers.below(vectors.len())];
        let (a, b, c) = (any(), any(), any());
        let sum = |a: Vector, b: Vector| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        let near = [sum(a, b), sum(a, sum(a, b)), sum(b, a.map(|c| -c)), a, b.map(|c| -c)];
        let is_one = |v: &Vector| vectors.contains(v);
        let d = Some(near[numbers.below(near.len())]).filter(is_one).unwrap_or(vectors[numbers.below(vectors.len())]);
        if cross(a, b) != [0; 3] && cross(c, d) != [0; 3] {
            return [[a, b], [c, d]];
        }
    }
}

#[test]
fn meetings_are_those_of_a_model_in_integers() {
    let (vectors, mut numbers) = (vectors(), Numbers(3));
    let mut seen = std::collections::HashMap::new();
    for _ in 0..60_000 {
        let [first, second] = arcs(&mut numbers, &vectors);
        let [a, b] = first.map(place);
        let [c, d] = second.map(place);
        let expected = model(first, second);
        assert_eq!(meeting(a, b, c, d), expected, "{first:?} {second:?}");
        *seen.entry(format!("{expected:?}")).or_insert(0) += 1;
        assert_eq!(on_arc(c, a, b), contains(first, second[0]), "{first:?} {:?}", second[0]);
        let det = dot(cross(first[0], first[1]), second[0]);
        assert_eq!(side(a, b, c) == Orientation::CounterClockwise, det > 0);
        assert_eq!(side(a, b, c) == Orientation::Clockwise, det < 0);
    }
    assert!(seen.len() == 8 && seen.values().all(|count| *count > 100), "{seen:?}");
}

#[test]
fn exchanges_and_signs_of_axes_change_no_meeting() {
    let (vectors, mut numbers) = (vectors(), Numbers(4));
    for _ in 0..5_000 {
        let arcs = arcs(&mut numbers, &vectors);
        let of = |turned: &dyn Fn(Vector) -> Vector| {
            let [[a, b], [c, d]] = arcs.map(|arc| arc.map(|v| place(turned(v))));
            meeting(a, b, c, d)
        };
        let before = of(&|v| v);
        for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            for signs in 0..8 {
                let sign = |axis: usize| if signs >> axis & 1 == 0 { 1 } else { -1 };
                assert_eq!(of(&|v| [0, 1, 2].map(|axis| sign(axis) * v[axes[axis]])), before, "{arcs:?}");
            }
        }
    }
}

#[test]
fn directions_around_a_place_go_counter_clockwise_from_the_north() {
    let vectors = vectors();
    let mut numbers = Numbers(5);
    // The angle from the north to the west, or at a pole from the first meridian.
    let angle = |center: Vector, p: Vector| {
        let first = if center[0] == 0 && center[1] == 0 { [1, 0, 0] } else { [0, 0, 1] };
        let left = cross(center, first);
        let ahead = cross(left, center);
        let length = |v: Vector| (dot(v, v) as f64).sqrt();
        let angle = (dot(p, left) as f64 / length(left)).atan2(dot(p, ahead) as f64 / length(ahead));
        if angle < -1e-9 { angle + std::f64::consts::TAU } else { angle.max(0.0) }
    };
    let mut equal = 0;
    for _ in 0..30_000 {
        let mut any = || vectors[numbers.below(vectors.len())];
        let center = if any()[0] == 1 { [0, 0, any()[2].signum() | 1] } else { any() };
        let (a, b) = (any(), any());
        if [a, b].into_iter().any(|p| cross(center, p) == [0; 3]) {
            continue;
        }
        let difference = angle(center, a) - angle(center, b);
        let expected = if difference.abs() < 1e-9 { Ordering::Equal } else { difference.total_cmp(&0.0) };
        assert_eq!(compare_around(place(center), place(a), place(b)), expected, "{center:?} {a:?} {b:?}");
        equal += usize::from(expected.is_eq());
    }
    assert!(equal > 100);
}

/// The northernmost point of the great circle through two places on one parallel φ, λ apart, is at atan(tan φ / cos(λ/2)), which for (49, 28 degrees) is
/// 49.853 degrees. Sources of the case: a border along the 49th parallel that is drawn by its ends, and
/// <https://github.com/apache/sedona-db/issues/1154>.
#[test]
fn a_parallel_that_is_drawn_by_its_ends_bulges_to_the_north() {
    let (a, b) = (at(-123.0, 49.0), at(-95.0, 49.0));
    let top = (49.0_f64.to_radians().tan() / 14.0_f64.to_radians().cos()).atan().to_degrees();
    assert!((top - 49.852).abs() < 2e-3, "{top}");
    for (latitude, expected) in
        [(top - 1e-9, Meeting::Cross), (top + 1e-9, Meeting::Disjoint), (49.0, Meeting::Cross), (48.9, Meeting::Cross)]
    {
        assert_eq!(meeting(a, b, at(-109.0, latitude), at(-109.0, 60.0)), expected, "{latitude}");
    }
}

/// The difference is in the last digit of a double, which f64 arithmetic would miss.
#[test]
fn a_place_beside_an_arc_by_a_nanometre_is_beside_it() {
    let (a, b) = (at(10.0, 20.0), at(11.0, 20.0));
    let [x, y, z] = at(10.5, 20.000_1).vector();
    let up = |steps: u64| Place::toward([x, y, f64::from_bits(z.to_bits() + steps)]).expect("it is one");
    // Vectors in steps of one unit change from one side of the circle to the other exactly once.
    let sides: Vec<Orientation> = {
        let (mut low, mut high) = (0_u64, 1 << 40);
        let base = f64::from_bits(z.to_bits()) - 1e-5;
        let here =
            |steps: u64| side(a, b, Place::toward([x, y, f64::from_bits(base.to_bits() + steps)]).expect("it is one"));
        assert_eq!((here(low), here(high)), (Orientation::Clockwise, Orientation::CounterClockwise));
        while high - low > 1 {
            let middle = low.midpoint(high);
            if here(middle) == Orientation::Clockwise { low = middle } else { high = middle }
        }
        (low - 50..low + 50).map(here).collect()
    };
    assert!(sides.is_sorted_by_key(|side| *side != Orientation::Clockwise), "{sides:?}");
    assert_ne!(up(0), up(1));
}
