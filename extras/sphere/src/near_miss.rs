//! C3 near miss: borders of two features coincide or are farther apart than a given width.
//!
//! As in the [plane](twinedge_coverage), two borders face each other across an unclaimed place, run in opposite directions and have each other to
//! their left. They are a near miss if both have a stretch longer than the width, or several stretches that together are four times as long as the
//! width and do not diverge steadily. Everything is measured in doubles, between chords in space, along the sphere: such close arcs have the same
//! curvature.

use crate::claims::Cover;
use crate::clash::boxed;
use crate::finding::Finding;
use crate::measure::RADIUS;
use crate::place::Place;
use crate::vector::{Vector, cross, dot, length, minus};
use rstar::{AABB, RTree};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use twinedge_coverage::CoverageRule;
use twinedge_geometry::Point;

/// The minimal total length of short stretches, as a multiple of the width.
const LEAST: f64 = 4.0;

/// A part of a side opposite another side, and the distances at its ends. Lengths are on the unit sphere.
#[derive(Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    widths: [f64; 2],
    /// True if the part is longer than the width, on both sides.
    is_long: bool,
    other: u32,
}

/// Returns the near misses up to a width in metres. `spaces` has the space of each unclaimed face to search.
///
/// O(n log n + c log c) for c pairs of arcs whose boxes are within the width.
pub(crate) fn near_misses(cover: &Cover<'_>, spaces: &FxHashMap<u32, u32>, width: f64) -> Vec<Finding> {
    let map = cover.map;
    let width = width / RADIUS;
    let sides = Sides { cover };
    let is_side = |dart: &u32| spaces.contains_key(&map.face(*dart)) && !sides.features(*dart).is_empty();
    let all: Vec<u32> = (0..map.dart_count() as u32).filter(is_side).collect();
    let tree = RTree::bulk_load(all.iter().map(|side| boxed(*side, sides.places(*side))).collect());
    // By pair of features, then by side.
    let mut pairs: BTreeMap<[u32; 2], BTreeMap<u32, Vec<Stretch>>> = BTreeMap::new();
    for side in all {
        let (ends, features, space) = (sides.ends(side), sides.features(side), spaces.get(&map.face(side)));
        let own = boxed(side, sides.places(side));
        let (low, high) = (own.geom().lower().map(|x| x - width), own.geom().upper().map(|x| x + width));
        for near in tree.locate_in_envelope_intersecting(AABB::from_corners(low, high)) {
            let other = near.data;
            let others = sides.features(other);
            let is_apart = other != side
                && space == spaces.get(&map.face(other))
                && !features.iter().any(|feature| others.binary_search(feature).is_ok());
            let Some(stretch) = is_apart.then(|| facing(ends, sides.ends(other), width)).flatten() else { continue };
            for one in features {
                for another in others {
                    let pair = [*one.min(another), *one.max(another)];
                    let of_side = pairs.entry(pair).or_default().entry(side).or_default();
                    of_side.push(Stretch { other, ..stretch });
                }
            }
        }
    }
    let mut found = Vec::new();
    for (pair, near) in &pairs {
        let clusters = clusters(near, &sides);
        found.extend(clusters.iter().filter_map(|cluster| near_miss(*pair, cluster, near, &sides, width)));
    }
    found
}

/// The darts along borders with a space to their left.
struct Sides<'a> {
    cover: &'a Cover<'a>,
}

impl Sides<'_> {
    fn places(&self, side: u32) -> [Place; 2] {
        [side, side ^ 1].map(|dart| self.cover.map.place(self.cover.map.origin(dart)))
    }

    fn ends(&self, side: u32) -> [Vector; 2] {
        self.places(side).map(Place::unit)
    }

    fn features(&self, side: u32) -> &[u32] {
        &self.cover.features[self.cover.map.face(side ^ 1) as usize]
    }
}

/// Returns the sets of sides that face or follow each other; each set is sorted.
fn clusters(near: &BTreeMap<u32, Vec<Stretch>>, sides: &Sides<'_>) -> Vec<Vec<u32>> {
    let before: FxHashMap<u32, u32> = near.keys().map(|side| (sides.cover.map.next(*side), *side)).collect();
    let mut seen = FxHashSet::default();
    let mut clusters: Vec<Vec<u32>> = Vec::new();
    for start in near.keys() {
        if !seen.insert(*start) {
            continue;
        }
        let (mut cluster, mut next) = (vec![*start], 0);
        while let Some(side) = cluster.get(next).copied() {
            next += 1;
            let along = [Some(sides.cover.map.next(side)), before.get(&side).copied()].into_iter().flatten();
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

/// A part of a side, with the distance to the other side at both ends.
struct Piece {
    ends: [Vector; 2],
    length: f64,
    widths: [f64; 2],
}

impl Piece {
    fn greatest(&self) -> f64 {
        self.widths[0].max(self.widths[1])
    }

    fn width(&self) -> f64 {
        f64::midpoint(self.widths[0], self.widths[1])
    }
}

fn near_miss(
    pair: [u32; 2],
    cluster: &[u32],
    near: &BTreeMap<u32, Vec<Stretch>>,
    sides: &Sides<'_>,
    width: f64,
) -> Option<Finding> {
    let mut pieces: Vec<Piece> = cluster.iter().flat_map(|side| pieces(&near[side], sides.ends(*side))).collect();
    let sum = |pieces: &[Piece], of: fn(&Piece) -> f64| pieces.iter().map(of).sum::<f64>();
    let is_long = cluster.iter().flat_map(|side| &near[side]).any(|stretch| stretch.is_long);
    let total = sum(&pieces, |piece| piece.length);
    // Each border is counted separately.
    if !is_long && (total < 2.0 * LEAST * width || parts(&pieces, width)) {
        return None;
    }
    let degrees = |at: Vector| Place::toward(at).map(|place| Point::from(place.degrees())).unwrap_or_default();
    let border = pieces.iter().map(|piece| piece.ends.map(degrees)).collect();
    narrow(&mut pieces);
    // Each border was measured separately, and the space once from each border.
    let (length, area) = (sum(&pieces, |piece| piece.length), sum(&pieces, |piece| piece.length * piece.width()) / 2.0);
    let longest = pieces.iter().max_by(|a, b| a.length.total_cmp(&b.length))?;
    Some(Finding {
        rule: CoverageRule::NearMiss,
        features: pair.to_vec(),
        area: area * RADIUS * RADIUS,
        width: if length > 0.0 { 2.0 * area / length * RADIUS } else { 0.0 },
        length: length * RADIUS,
        at: degrees(along(longest.ends[0], longest.ends[1], 0.5)),
        border,
        missing: Vec::new(),
    })
}

/// Returns the union of a side's stretches, in order and without overlaps.
fn pieces(stretches: &[Stretch], [a, b]: [Vector; 2]) -> Vec<Piece> {
    let mut sorted = stretches.to_vec();
    sorted.sort_by(|p, q| {
        p.from.total_cmp(&q.from).then(p.widths[0].total_cmp(&q.widths[0])).then(p.other.cmp(&q.other))
    });
    let mut end = 0.0_f64;
    let mut pieces = Vec::new();
    for Stretch { from, to, widths: [first, last], .. } in sorted {
        let start = from.max(end);
        if start < to {
            let at_start = first + (last - first) * ((start - from) / (to - from));
            let ends = [along(a, b, start), along(a, b, to)];
            pieces.push(Piece { ends, length: length(minus(ends[1], ends[0])), widths: [at_start, last] });
            end = to;
        }
    }
    pieces
}

/// Returns true if borders diverge steadily, as in a wedge: they are about as long within half the width as beyond it.
fn parts(pieces: &[Piece], width: f64) -> bool {
    let near: f64 = pieces.iter().filter(|piece| piece.width() <= width / 2.0).map(|piece| piece.length).sum();
    (0.25..0.75).contains(&(near / pieces.iter().map(|piece| piece.length).sum::<f64>()))
}

/// Keeps the narrow pieces, up to the greatest width at which the strip is at least half as slender as the most slender strip.
fn narrow(pieces: &mut Vec<Piece>) {
    pieces.sort_by(|a, b| a.greatest().total_cmp(&b.greatest()).then(a.length.total_cmp(&b.length)));
    let mut length = 0.0;
    let slenderness: Vec<f64> = pieces
        .iter()
        .map(|piece| {
            length += piece.length;
            length / piece.greatest().max(f64::MIN_POSITIVE)
        })
        .collect();
    let most = slenderness.iter().copied().fold(0.0, f64::max);
    let last = slenderness.iter().rposition(|slender| *slender >= most / 2.0).unwrap_or_default();
    pieces.truncate(last + 1);
}

/// Returns the stretch of a chord opposite another chord that faces it. The chords run in opposite directions with the other to the left, at most a
/// width apart at both ends. O(1).
fn facing([a, b]: [Vector; 2], [c, d]: [Vector; 2], width: f64) -> Option<Stretch> {
    let (from, to) = opposite([a, b], [d, c])?;
    let (back, forth) = opposite([d, c], [a, b])?;
    let (near, far) = ([along(a, b, from), along(a, b, to)], [along(d, c, back), along(d, c, forth)]);
    let up = along(near[0], near[1], 0.5);
    // Ignore the vertical difference: the longer of two chords lies deeper.
    let level = |p: Vector, q: Vector| {
        let across = minus(q, p);
        let height = dot(across, up) / dot(up, up);
        minus(across, up.map(|x| x * height))
    };
    let widths = [length(level(near[0], far[0])), length(level(near[1], far[1]))];
    let across = level(up, along(far[0], far[1], 0.5));
    let is_left = |along: Vector| dot(up, cross(along, across));
    let is_between = is_left(minus(b, a)) > 0.0 && is_left(minus(d, c)) < 0.0;
    let is_long = length(minus(near[1], near[0])) > width && length(minus(far[1], far[0])) > width;
    (is_between && widths[0] <= width && widths[1] <= width).then_some(Stretch { from, to, widths, is_long, other: 0 })
}

/// Returns the start and the end, as fractions of its length, of the part of a chord with the other chord at a right angle; `None` if the chords do
/// not run in opposite directions.
fn opposite([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> Option<(f64, f64)> {
    let u = minus(b, a);
    let part = |p: Vector| dot(minus(p, a), u) / dot(u, u);
    let (from, to) = (part(c).max(0.0), part(d).min(1.0));
    (from < to).then_some((from, to))
}

fn along(a: Vector, b: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)
}
