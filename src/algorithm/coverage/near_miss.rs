//! C3 near miss: borders of two features coincide or are farther apart than a given width.
//!
//! ```text
//!   ┌────────┐ ┌────────┐      h, on the border of a, faces g, on the border of b: the outside is to the left of
//!   │   a    │h│   b    │      both, they run in opposite directions, and a stretch of each lies within the width of the other.
//!   │       ▲│ │▼       │      Stretches that follow each other, or face each other, are one near miss.
//!   └────────┘g└────────┘
//! ```
//!
//! Two borders that part at a vertex are near each other there. So a near miss counts from a length of [`LEAST`] times the
//! width on: borders that part at more than 14 degrees are none.

use super::claims::features_of;
use super::finding::{CoverageRule, Finding, Limits};
use super::region::{ends, length, mean_width};
use super::sliver::median;
use crate::algorithm::area::Sum;
use crate::dcel::HalfEdge;
use crate::geometry::Point;
use crate::map::{FeatureId, PlanarMap};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// The least length of a near miss, as a multiple of the given width.
const LEAST: f64 = 4.0;

/// The part of the median length of edges that is the width if none is given.
const OF_MEDIAN: f64 = 100.0;

/// A half-edge of a feature's border with the outside to its left.
struct Side<'a> {
    half_edge: HalfEdge<'a>,
    ends: [Point; 2],
    features: Vec<FeatureId>,
}

/// A part of a side that is near another side: its start and end along the side, and the other side.
#[derive(Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    other: usize,
}

/// The near misses, and the width up to which they are such. `outside` has the faces that hang
/// together with the unbounded one, by index. O(n log n + c log c) for c pairs of edges whose boxes come as near as the width.
pub(super) fn near_misses(map: &PlanarMap, outside: &FxHashSet<usize>, limits: &Limits) -> (Vec<Finding>, f64) {
    let sides = sides(map, outside);
    let width =
        limits.gap_width.unwrap_or_else(|| median(map.dcel().edges().map(|h| length(map, h)).collect()) / OF_MEDIAN);
    // By the two features, then by side.
    let mut pairs: BTreeMap<[FeatureId; 2], BTreeMap<usize, Vec<Stretch>>> = BTreeMap::new();
    let boxed = |(i, side): (usize, &Side<'_>)| {
        let [a, b] = side.ends;
        GeomWithData::new(Rectangle::from_corners([a.x, a.y], [b.x, b.y]), i)
    };
    let tree = RTree::bulk_load(sides.iter().enumerate().map(boxed).collect());
    for (i, side) in sides.iter().enumerate() {
        let [a, b] = side.ends;
        let low = [a.x.min(b.x) - width, a.y.min(b.y) - width];
        let high = [a.x.max(b.x) + width, a.y.max(b.y) + width];
        for near in tree.locate_in_envelope_intersecting(AABB::from_corners(low, high)) {
            let other = &sides[near.data];
            if near.data == i || have_common(&side.features, &other.features) {
                continue;
            }
            let Some((from, to)) = facing(side.ends, other.ends, width) else { continue };
            for one in &side.features {
                for another in &other.features {
                    let pair = [*one.min(another), *one.max(another)];
                    let stretches = pairs.entry(pair).or_default().entry(i).or_default();
                    stretches.push(Stretch { from, to, other: near.data });
                }
            }
        }
    }
    let by_half_edge: FxHashMap<usize, usize> = sides.iter().map(|side| side.half_edge.index()).zip(0..).collect();
    let mut findings = Vec::new();
    for (pair, near) in &pairs {
        for cluster in clusters(near, &sides, &by_half_edge) {
            findings.extend(near_miss(*pair, &cluster, near, &sides, width));
        }
    }
    (findings, width)
}

/// The half-edges with the outside to their left and claimed faces to their right.
fn sides<'a>(map: &'a PlanarMap, outside: &FxHashSet<usize>) -> Vec<Side<'a>> {
    let mut sides = Vec::new();
    for half_edge in map.dcel().half_edges().filter(|h| outside.contains(&h.face().index())) {
        let features: Vec<FeatureId> = features_of(map, half_edge.twin().face()).collect();
        if !features.is_empty() {
            sides.push(Side { half_edge, ends: ends(map, half_edge), features });
        }
    }
    sides
}

/// Returns true if two sorted lists have an element in common.
fn have_common(a: &[FeatureId], b: &[FeatureId]) -> bool {
    a.iter().any(|feature| b.binary_search(feature).is_ok())
}

/// The sides that belong together: they face or follow each other. Each set is sorted.
fn clusters(
    near: &BTreeMap<usize, Vec<Stretch>>,
    sides: &[Side<'_>],
    by_half_edge: &FxHashMap<usize, usize>,
) -> Vec<Vec<usize>> {
    let mut seen = FxHashSet::default();
    let mut clusters: Vec<Vec<usize>> = Vec::new();
    for start in near.keys() {
        if !seen.insert(*start) {
            continue;
        }
        let mut cluster = vec![*start];
        let mut next = 0;
        while let Some(side) = cluster.get(next).copied() {
            next += 1;
            let h = sides[side].half_edge;
            let along = [h.next(), h.prev()].into_iter().filter_map(|h| by_half_edge.get(&h.index()).copied());
            let facing = near.get(&side).into_iter().flatten().map(|stretch| stretch.other);
            for other in along.chain(facing).filter(|other| near.contains_key(other)) {
                if seen.insert(other) {
                    cluster.push(other);
                }
            }
        }
        cluster.sort_unstable();
        clusters.push(cluster);
    }
    clusters
}

/// The near miss that some sides of two features are, if it is long enough.
fn near_miss(
    pair: [FeatureId; 2],
    cluster: &[usize],
    near: &BTreeMap<usize, Vec<Stretch>>,
    sides: &[Side<'_>],
    width: f64,
) -> Option<Finding> {
    let (mut total, mut area) = (Sum::default(), Sum::default());
    let mut stretches: Vec<[Point; 2]> = Vec::new();
    let mut longest = (0.0, Point::default());
    for side in cluster {
        let [a, b] = sides[*side].ends;
        let side_length = distance(a, b);
        for (from, to) in merged(&near[side]) {
            let [p, q] = [along(a, b, from), along(a, b, to)];
            let stretch = (to - from) * side_length;
            stretches.push([p, q]);
            total.add(stretch);
            // The distance to the other border, at both ends and in the middle.
            let [first, (middle, opposite), last] =
                [p, Point::new(f64::midpoint(p.x, q.x), f64::midpoint(p.y, q.y)), q].map(|p| {
                    let others = near[side].iter().map(|stretch| nearest(p, sides[stretch.other].ends));
                    let nearest = others.min_by(|a, b| distance(p, *a).total_cmp(&distance(p, *b))).unwrap_or(p);
                    (distance(p, nearest), Point::new(f64::midpoint(p.x, nearest.x), f64::midpoint(p.y, nearest.y)))
                });
            area.add(stretch * (first.0 + 2.0 * middle + last.0) / 4.0);
            if stretch > longest.0 {
                longest = (stretch, opposite);
            }
        }
    }
    // Each border was measured by itself, and so was the space, once from each of them.
    let (length, area) = (total.value(), area.value() / 2.0);
    (length >= 2.0 * LEAST * width).then(|| Finding {
        rule: CoverageRule::NearMiss,
        features: pair.to_vec(),
        area,
        width: mean_width(area, length),
        length,
        at: longest.1,
        faces: Vec::new(),
        stretches,
    })
}

/// The union of stretches of one side, in order.
fn merged(stretches: &[Stretch]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = stretches.iter().map(|stretch| (stretch.from, stretch.to)).collect();
    sorted.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut merged: Vec<(f64, f64)> = Vec::new();
    for (from, to) in sorted {
        match merged.last_mut() {
            Some(last) if from <= last.1 => last.1 = last.1.max(to),
            _ => merged.push((from, to)),
        }
    }
    merged
}

/// From where to where, as parts of its length, a segment lies within a width of another that faces it: both run in opposite
/// directions, and each has the other to its left there. O(1).
fn facing([a, b]: [Point; 2], [c, d]: [Point; 2], width: f64) -> Option<(f64, f64)> {
    let (u, v) = (minus(b, a), minus(d, c));
    if dot(u, v) >= 0.0 {
        return None;
    }
    let (from, to) = within([a, b], [c, d], width)?;
    let middle = along(a, b, f64::midpoint(from, to));
    let across = minus(nearest(middle, [c, d]), middle);
    (from < to && cross(u, across) > 0.0 && cross(v, across) < 0.0).then_some((from, to))
}

/// From where to where, as parts of its length, a segment lies within a width of another: inside a box around that one, or
/// one of the disks at its ends. These make up a convex set, so the answer is the hull of three intervals.
fn within([a, b]: [Point; 2], [c, d]: [Point; 2], width: f64) -> Option<(f64, f64)> {
    let (u, v) = (minus(b, a), minus(d, c));
    let start = minus(a, c);
    let reach = dot(v, v).sqrt();
    // Along the other segment from 0 to its length, and across it from -width to width.
    let in_box = slab(dot(start, v) / reach, dot(u, v) / reach, 0.0, reach)
        .zip(slab(cross(v, start) / reach, cross(v, u) / reach, -width, width))
        .map(|(along, across)| (along.0.max(across.0), along.1.min(across.1)));
    let disks = [c, d].map(|center| disk(minus(a, center), u, width));
    let parts = [in_box, disks[0], disks[1]].into_iter().flatten().filter(|(from, to)| from <= to);
    let hull = parts.reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)))?;
    let (from, to) = (hull.0.max(0.0), hull.1.min(1.0));
    (from <= to).then_some((from, to))
}

/// The t for which `start + t · step` is between two bounds.
fn slab(start: f64, step: f64, low: f64, high: f64) -> Option<(f64, f64)> {
    if step == 0.0 {
        return (low <= start && start <= high).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (one, other) = ((low - start) / step, (high - start) / step);
    Some((one.min(other), one.max(other)))
}

/// The t for which `start + t · step` is at most this far from the origin.
fn disk(start: Point, step: Point, radius: f64) -> Option<(f64, f64)> {
    let (a, b) = (dot(step, step), dot(start, step));
    let root = b * b - a * (dot(start, start) - radius * radius);
    (root >= 0.0).then(|| ((-b - root.sqrt()) / a, (-b + root.sqrt()) / a))
}

/// The point of a segment that is nearest to a point.
fn nearest(p: Point, [a, b]: [Point; 2]) -> Point {
    let u = minus(b, a);
    along(a, b, (dot(minus(p, a), u) / dot(u, u)).clamp(0.0, 1.0))
}

fn along(a: Point, b: Point, t: f64) -> Point {
    Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t)
}

fn minus(a: Point, b: Point) -> Point {
    Point::new(a.x - b.x, a.y - b.y)
}

fn distance(a: Point, b: Point) -> f64 {
    (b.x - a.x).hypot(b.y - a.y)
}

fn dot(a: Point, b: Point) -> f64 {
    a.x * b.x + a.y * b.y
}

fn cross(a: Point, b: Point) -> f64 {
    a.x * b.y - a.y * b.x
}
