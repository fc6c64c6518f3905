//! C3 near miss: borders of two features coincide or are farther apart than a given width.
//!
//! ```text
//!   ┌────────┐ ┌────────┐      h, on the border of a, faces g, on the border of b: the outside is to the left of
//!   │   a    │h│   b    │      both, they run in opposite directions, and a stretch of each lies within the width of the other.
//!   │       ▲│ │▼       │      Stretches that follow each other, or face each other, are one near miss.
//!   └────────┘g└────────┘
//! ```
//!
//! Only stretches of two edges that lie opposite each other count, and only if they are within the width at both ends. So edges
//! that part at a vertex, and are farther apart than the width where one of them ends, do not count. A near miss has a stretch
//! longer than the width on both sides (the condition of GEOS and JTS), or it is [`LEAST`] times as long as the width, over any
//! number of edges, and its borders do not [part](parts) steadily.

use super::finding::{CoverageRule, Finding};
use super::region::{ends, first_corner, length, mean_width};
use super::sliver::median;
use core::cmp::Ordering;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use twinedge::dcel::HalfEdge;
use twinedge_algorithm::area::Sum;
use twinedge_algorithm::claims::features_of;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::boxes::Boxes;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{FeatureId, PlanarMap};

/// The least length of a near miss of short stretches, as a multiple of the given width.
const LEAST: f64 = 4.0;

/// The divisor of the median edge length that yields the default width.
const OF_MEDIAN: f64 = 100.0;

/// Returns the features that cover the face on the other side of a half-edge.
pub(crate) type Beyond<'a> = dyn Fn(HalfEdge<'a>) -> &'a [FeatureId] + Sync + 'a;

/// The stretches of two features that lie opposite each other, by side.
type Pairs = BTreeMap<[FeatureId; 2], BTreeMap<usize, Vec<Stretch>>>;

/// The sides: half-edges of features' borders with one of the spaces to their left, by index. Their data is looked up instead of
/// stored, since with islands in a sea every half-edge is a side.
#[derive(Clone, Copy)]
struct Sides<'a> {
    map: &'a PlanarMap,
    /// The space of each unclaimed face, by index.
    spaces: &'a FxHashMap<usize, usize>,
    beyond: &'a Beyond<'a>,
}

impl<'a> Sides<'a> {
    fn all(self) -> impl Iterator<Item = usize> {
        let is_side = move |h: &HalfEdge<'a>| self.space(*h).is_some() && !(self.beyond)(*h).is_empty();
        self.map.dcel().half_edges().filter(is_side).map(|h| h.index())
    }

    fn half_edge(&self, side: usize) -> HalfEdge<'a> {
        self.map.dcel().half_edge_at(side).expect("sides are half-edges of the map")
    }

    fn ends(&self, side: usize) -> [Point; 2] {
        ends(self.map, self.half_edge(side))
    }

    fn space(&self, h: HalfEdge<'_>) -> Option<usize> {
        self.spaces.get(&h.face().index()).copied()
    }

    fn features(&self, side: usize) -> &'a [FeatureId] {
        (self.beyond)(self.half_edge(side))
    }
}

/// A part of a side that lies opposite another side: its start and end along the side, and the distances of the other side there.
#[derive(Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    widths: [f64; 2],
    /// True if it is longer than the greatest width of a near miss, on both sides.
    is_long: bool,
    other: usize,
}

/// Returns the default width of near misses. O(n), expected.
pub(super) fn chosen_width(map: &PlanarMap) -> f64 {
    width_by(map.dcel().edges().map(|h| length(map, h)).collect())
}

/// Returns the default width of near misses, from the lengths of all edges.
pub(crate) fn width_by(lengths: Vec<f64>) -> f64 {
    median(lengths) / OF_MEDIAN
}

/// Returns the near misses up to a width. `spaces` contains the space of each unclaimed face searched for near misses, both by
/// index. O(n log n + c log c) for c pairs of edges whose boxes come within the width.
pub(super) fn near_misses(map: &PlanarMap, spaces: &FxHashMap<usize, usize>, width: f64) -> Vec<Finding> {
    let mut features: FxHashMap<usize, Vec<FeatureId>> = FxHashMap::default();
    for h in map.dcel().half_edges().filter(|h| spaces.contains_key(&h.face().index())) {
        let beside = h.twin().face();
        if !spaces.contains_key(&beside.index()) {
            features.entry(beside.index()).or_insert_with(|| features_of(map, beside).collect());
        }
    }
    near_misses_beside(map, spaces, &|h| features.get(&h.twin().face().index()).map_or(&[], Vec::as_slice), width)
}

/// Returns the near misses up to a width, given a function that returns the features next to the spaces.
pub(crate) fn near_misses_beside<'a>(
    map: &'a PlanarMap,
    spaces: &'a FxHashMap<usize, usize>,
    beyond: &'a Beyond<'a>,
    width: f64,
) -> Vec<Finding> {
    let sides = &Sides { map, spaces, beyond };
    let bounds = |side: u32| {
        let [a, b] = sides.ends(side as usize).map(Bounds::one);
        a.joined(b)
    };
    let each = |pairs: &mut Pairs, side: u32, others: &[u32]| {
        let side = side as usize;
        let (ends, features) = (sides.ends(side), sides.features(side));
        let space = sides.space(sides.half_edge(side));
        for other in others.iter().map(|other| *other as usize) {
            if space != sides.space(sides.half_edge(other)) || have_common(features, sides.features(other)) {
                continue;
            }
            let Some(stretch) = facing(ends, sides.ends(other), width) else { continue };
            for one in features {
                for another in sides.features(other) {
                    let pair = [*one.min(another), *one.max(another)];
                    let stretches = pairs.entry(pair).or_default().entry(side).or_default();
                    stretches.push(Stretch { other, ..stretch });
                }
            }
        }
    };
    // Each side is processed once.
    let merge = |mut one: Pairs, other: Pairs| {
        for (pair, stretches) in other {
            one.entry(pair).or_default().extend(stretches);
        }
        one
    };
    let pairs = Boxes::new(sides.all().map(|side| side as u32), &bounds).pairs(width, &Pairs::new, &each, &merge);
    let mut findings = Vec::new();
    for (pair, near) in &pairs {
        for cluster in clusters(near, sides) {
            findings.extend(near_miss(*pair, &cluster, near, sides, width));
        }
    }
    findings
}

fn have_common(a: &[FeatureId], b: &[FeatureId]) -> bool {
    a.iter().any(|feature| b.binary_search(feature).is_ok())
}

/// Groups sides that face or follow each other. Each set is sorted.
fn clusters(near: &BTreeMap<usize, Vec<Stretch>>, sides: &Sides<'_>) -> Vec<Vec<usize>> {
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
            let h = sides.half_edge(side);
            let along = [h.next(), h.prev()].into_iter().map(|h| h.index());
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

/// Returns the near miss of some sides of two features, if they form one.
fn near_miss(
    pair: [FeatureId; 2],
    cluster: &[usize],
    near: &BTreeMap<usize, Vec<Stretch>>,
    sides: &Sides<'_>,
    width: f64,
) -> Option<Finding> {
    let mut pieces: Vec<Piece> = cluster.iter().flat_map(|side| pieces(&near[side], *side, sides)).collect();
    let total: Sum = pieces.iter().map(|piece| piece.length).collect();
    let is_long = cluster.iter().flat_map(|side| &near[side]).any(|stretch| stretch.is_long);
    // Each border is counted separately.
    if !is_long && (total.value() < 2.0 * LEAST * width || parts(&pieces, width)) {
        return None;
    }
    let stretches: Vec<[Point; 2]> = pieces.iter().map(|piece| piece.ends).collect();
    narrow(&mut pieces);
    let (length, area): (Sum, Sum) =
        (pieces.iter().map(|piece| piece.length).collect(), pieces.iter().map(Piece::area).collect());
    // Both borders were measured, and the space once from each of them.
    let (length, area) = (length.value(), area.value() / 2.0);
    let longest = pieces.iter().max_by(|a, b| a.length.total_cmp(&b.length))?;
    Some(Finding {
        rule: CoverageRule::NearMiss,
        features: pair.to_vec(),
        area,
        width: mean_width(area, length),
        length,
        at: longest.middle(sides),
        corner: first_corner(stretches.iter().flatten().copied()),
        faces: Vec::new(),
        stretches,
        missing: Vec::new(),
    })
}

/// A part of a side, with the distances of the other side at both ends.
struct Piece {
    ends: [Point; 2],
    length: f64,
    widths: [f64; 2],
    other: usize,
}

impl Piece {
    fn greatest(&self) -> f64 {
        self.widths[0].max(self.widths[1])
    }

    fn area(&self) -> f64 {
        self.length * f64::midpoint(self.widths[0], self.widths[1])
    }

    fn middle(&self, sides: &Sides<'_>) -> Point {
        let p = middle(self.ends);
        middle([p, nearest(p, sides.ends(self.other))])
    }
}

/// Merges the stretches of a side, in order, without repetition.
fn pieces(stretches: &[Stretch], side: usize, sides: &Sides<'_>) -> Vec<Piece> {
    let mut sorted = stretches.to_vec();
    let by_place = |a: &Stretch, b: &Stretch| compare_ends(sides.ends(a.other), sides.ends(b.other));
    sorted.sort_by(|a, b| {
        a.from.total_cmp(&b.from).then(a.widths[0].total_cmp(&b.widths[0])).then_with(|| by_place(a, b))
    });
    let [a, b] = sides.ends(side);
    let mut end = 0.0_f64;
    let mut pieces = Vec::new();
    for Stretch { from, to, widths: [first, last], other, .. } in sorted {
        let start = from.max(end);
        if start < to {
            let at_start = first + (last - first) * ((start - from) / (to - from));
            let ends = [along(a, b, start), along(a, b, to)];
            let length = (to - start) * distance(a, b);
            pieces.push(Piece { ends, length, widths: [at_start, last], other });
            end = to;
        }
    }
    pieces
}

/// Returns true if borders move apart steadily, as in a wedge: about half of their length is within half the width.
fn parts(pieces: &[Piece], width: f64) -> bool {
    let length = |pieces: &mut dyn Iterator<Item = &Piece>| pieces.map(|piece| piece.length).collect::<Sum>().value();
    let near =
        length(&mut pieces.iter().filter(|piece| f64::midpoint(piece.widths[0], piece.widths[1]) <= width / 2.0));
    (0.25..0.75).contains(&(near / length(&mut pieces.iter())))
}

/// Keeps the narrow pieces: up to the greatest width at which they form a strip at least half as slender as the most slender one.
/// This excludes the ends, where borders that coincide except for rounding move apart.
fn narrow(pieces: &mut Vec<Piece>) {
    pieces.sort_by(|a, b| a.greatest().total_cmp(&b.greatest()).then_with(|| compare_ends(a.ends, b.ends)));
    let mut length = 0.0;
    let lengths = pieces.iter().map(|piece| {
        length += piece.length;
        length / piece.greatest().max(f64::MIN_POSITIVE)
    });
    let slenderness: Vec<f64> = lengths.collect();
    let most = slenderness.iter().copied().fold(0.0, f64::max);
    let last = slenderness.iter().rposition(|slender| *slender >= most / 2.0).unwrap_or_default();
    pieces.truncate(last + 1);
}

/// Returns the stretch of a segment opposite another one. They must run in opposite directions, each with the other to its left,
/// at most a width apart at both ends. O(1).
fn facing([a, b]: [Point; 2], [c, d]: [Point; 2], width: f64) -> Option<Stretch> {
    let (u, v) = (minus(b, a), minus(d, c));
    let (from, to) = opposite([a, b], [d, c])?;
    let (back, forth) = opposite([d, c], [a, b])?;
    let (near, far) = ([along(a, b, from), along(a, b, to)], [along(d, c, back), along(d, c, forth)]);
    let widths = [distance(near[0], far[0]), distance(near[1], far[1])];
    let across = minus(middle(far), middle(near));
    let is_between = cross(u, across) > 0.0 && cross(v, across) < 0.0;
    let is_long = distance(near[0], near[1]) > width && distance(far[0], far[1]) > width;
    (is_between && widths[0] <= width && widths[1] <= width).then_some(Stretch { from, to, widths, is_long, other: 0 })
}

/// Returns the range of a segment, as fractions, with another at right angles to it; `None` for opposite directions.
fn opposite([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<(f64, f64)> {
    let u = minus(b, a);
    let part = |p: Point| dot(minus(p, a), u) / dot(u, u);
    let (from, to) = (part(c).max(0.0), part(d).min(1.0));
    (from < to).then_some((from, to))
}

fn nearest(p: Point, [a, b]: [Point; 2]) -> Point {
    let u = minus(b, a);
    along(a, b, (dot(minus(p, a), u) / dot(u, u)).clamp(0.0, 1.0))
}

/// Compares stretches by location, so that no result depends on the numbers of half-edges.
fn compare_ends([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Ordering {
    compare_lexicographic(a, c).then_with(|| compare_lexicographic(b, d))
}

fn along(a: Point, b: Point, t: f64) -> Point {
    Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t)
}

fn middle([a, b]: [Point; 2]) -> Point {
    Point::new(f64::midpoint(a.x, b.x), f64::midpoint(a.y, b.y))
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
