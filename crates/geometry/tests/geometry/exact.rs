//! Slow and obvious results in whole numbers, for comparison with the library.

use std::cmp::Ordering;

use twinedge_geometry::Point;
use twinedge_geometry::crossing::Clash;

pub(crate) type Grid = (i32, i32);

type Vector = (i128, i128);

pub(crate) fn point((x, y): Grid) -> Point {
    Point::new(x.into(), y.into())
}

fn minus(a: Grid, b: Grid) -> Vector {
    (i128::from(a.0) - i128::from(b.0), i128::from(a.1) - i128::from(b.1))
}

fn cross(a: Vector, b: Vector) -> i128 {
    a.0 * b.1 - a.1 * b.0
}

fn dot(a: Vector, b: Vector) -> i128 {
    a.0 * b.0 + a.1 * b.1
}

/// Twice the area of the triangle: positive if it turns counter-clockwise.
pub(crate) fn area(a: Grid, b: Grid, c: Grid) -> i128 {
    cross(minus(b, a), minus(c, a))
}

/// The ways in which two segments of positive length meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meets {
    No,
    AtEnds,
    Cross,
    /// At this endpoint: 0 and 1 belong to the first segment, 2 and 3 to the second.
    Touch(usize),
    Overlap,
}

/// By parameters: the first segment is a + t (b - a), the second c + u (d - c), with t and u from 0 to 1.
pub(crate) fn meets(a: Grid, b: Grid, c: Grid, d: Grid) -> Meets {
    let (ab, cd, ac) = (minus(b, a), minus(d, c), minus(c, a));
    let scale = cross(ab, cd);
    if scale == 0 {
        if cross(ab, ac) != 0 {
            return Meets::No;
        }
        // Collinear: the positions of c and d, as multiples of 1 / |ab|^2.
        let (c, d, one) = (dot(ab, ac), dot(ab, minus(d, a)), dot(ab, ab));
        let shared = c.max(d).min(one) - c.min(d).max(0);
        return match shared.cmp(&0) {
            Ordering::Less => Meets::No,
            Ordering::Equal => Meets::AtEnds,
            Ordering::Greater => Meets::Overlap,
        };
    }
    let (t, u) = (cross(ac, cd) * scale.signum(), cross(ac, ab) * scale.signum());
    let scale = scale.abs();
    if t < 0 || t > scale || u < 0 || u > scale {
        return Meets::No;
    }
    let end = |parameter: i128| {
        if parameter == 0 { Some(0) } else { (parameter == scale).then_some(1) }
    };
    match (end(t), end(u)) {
        (Some(_), Some(_)) => Meets::AtEnds,
        (Some(end), None) => Meets::Touch(end),
        (None, Some(end)) => Meets::Touch(2 + end),
        (None, None) => Meets::Cross,
    }
}

pub(crate) fn lies_on(p: Grid, a: Grid, b: Grid) -> bool {
    area(a, b, p) == 0 && dot(minus(a, p), minus(b, p)) <= 0
}

pub(crate) fn all_clashes(points: &[Grid], segments: &[[u32; 2]]) -> Vec<Clash> {
    let mut all = Vec::new();
    let places = 0..points.len() as u32;
    for b in places.clone() {
        all.extend((0..b).filter(|&a| points[a as usize] == points[b as usize]).map(|a| Clash::SamePlace { a, b }));
    }
    for (b, &[k, l]) in (0u32..).zip(segments) {
        for (a, &[i, j]) in (0..b).zip(segments) {
            let at = |point: u32| points[point as usize];
            match meets(at(i), at(j), at(k), at(l)) {
                Meets::No | Meets::AtEnds => {}
                Meets::Cross => all.push(Clash::Cross { a, b }),
                Meets::Overlap => all.push(Clash::Overlap { a, b }),
                Meets::Touch(end) => {
                    all.push(Clash::Touch { vertex: [i, j, k, l][end], segment: if end < 2 { b } else { a } });
                }
            }
        }
    }
    for vertex in places.filter(|vertex| !segments.as_flattened().contains(vertex)) {
        for (segment, ends) in (0..).zip(segments) {
            let [p, a, b] = [vertex, ends[0], ends[1]].map(|point| points[point as usize]);
            if p != a && p != b && lies_on(p, a, b) {
                all.push(Clash::Touch { vertex, segment });
            }
        }
    }
    // The documented order: equal points, then segment by segment.
    let key = |&clash: &Clash| match clash {
        Clash::SamePlace { .. } => (0, clash),
        Clash::Cross { a, .. } | Clash::Overlap { a, .. } => (a + 1, clash),
        Clash::Touch { segment, .. } => (segment + 1, clash),
    };
    all.sort_by_key(key);
    // Several segments may touch another one at the endpoint that they share.
    all.dedup();
    all
}

/// The segment directly below a point of a plane drawing: the highest of those that pass below, lexicographically.
pub(crate) fn segment_below(points: &[Grid], segments: &[[u32; 2]], q: Grid) -> Option<u32> {
    (0..)
        .zip(segments)
        .filter_map(|(id, ends)| {
            let [a, b] = ends.map(|end| points[end as usize]);
            let (low, high) = (a.min(b), a.max(b));
            (low < q && q < high && area(low, high, q) > 0).then_some((id, low, high))
        })
        .max_by(|&(_, low, high), &(_, other_low, other_high)| {
            // Heights over q.0, as fractions; the slope distinguishes segments that start there at equal height.
            let height = |low: Grid, high: Grid| {
                let (step, to_q) = (minus(high, low), minus(q, low));
                (i128::from(low.1) * step.0 + step.1 * to_q.0, step.0)
            };
            let slope = |low: Grid, high: Grid| {
                let step = minus(high, low);
                (step.1, step.0)
            };
            let compare = |(n, d): Vector, (m, e): Vector| (n * e).cmp(&(m * d));
            compare(height(low, high), height(other_low, other_high))
                .then_with(|| compare(slope(low, high), slope(other_low, other_high)))
        })
        .map(|(id, ..)| id)
}
