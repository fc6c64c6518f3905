//! All places where a drawing is not plane.
//!
//! The [sweep](mod@super::sweep) decides quickly whether a drawing of points and straight segments is plane, and names one fault
//! if it is not. [`clashes`] finds all faults.

use std::collections::BinaryHeap;

use super::bounds::Bounds;
use super::boxes::Boxes;
use super::events::{Event, sorted};
use super::point::Point;
use super::predicates::{Endpoint, Meeting, Orientation, in_range, meeting, on_segment, orientation};

/// A reason why a drawing of points and straight segments is not plane.
///
/// Points and segments are named by their indices in the arrays. In [`Cross`](Self::Cross), [`Overlap`](Self::Overlap) and
/// [`SamePlace`](Self::SamePlace), `a` is the smaller index.
///
/// ```text
///   \ /        |              ______
///    X         |         ====/======      o o
///   / \    ----+----        /
///
///  Cross     Touch        Overlap      SamePlace
/// ```
///
/// Two segments that clash do so in exactly one of the first three ways pictured. A segment that ends on another one touches it,
/// and does not also cross it. Collinear segments that share more than a point overlap, and their endpoints do not also touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Clash {
    /// Two points with the same coordinates.
    SamePlace {
        /// A point.
        a: u32,
        /// Another point.
        b: u32,
    },
    /// Two segments that cross in a point interior to both.
    Cross {
        /// A segment.
        a: u32,
        /// Another segment.
        b: u32,
    },
    /// Two collinear segments that share more than a point.
    Overlap {
        /// A segment.
        a: u32,
        /// Another segment.
        b: u32,
    },
    /// A point, isolated or an endpoint, in the interior of a segment.
    Touch {
        /// The point.
        vertex: u32,
        /// The segment.
        segment: u32,
    },
}

/// The error of arrays that do not describe points and segments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidSegments {
    /// There are 2^32 - 1 or more points or segments.
    #[error("more points or segments than 32 bits can number")]
    TooLarge,
    /// A coordinate of this point is beyond the range in which the predicates are exact; see [`in_range`].
    #[error("point {point} has a coordinate beyond the range of exact arithmetic")]
    OutOfRange {
        /// The point.
        point: u32,
    },
    /// This segment names a point that does not exist.
    #[error("segment {segment} names the missing point {point}")]
    NoSuchPoint {
        /// The segment.
        segment: u32,
        /// The named point.
        point: u32,
    },
    /// The two endpoints of this segment have the same coordinates.
    #[error("segment {segment} has no length")]
    NoLength {
        /// The segment.
        segment: u32,
    },
    /// This query, counted from 0, names a point that does not exist.
    #[error("query {query} names the missing point {point}")]
    NoSuchQuery {
        /// The index of the query.
        query: u32,
        /// The named point.
        point: u32,
    },
}

/// Returns the first `cap` clashes of a drawing, each once, and their total number.
///
/// `segments` contains pairs of indices into `points`. The order follows the arrays: first pairs of equal points, sorted; then,
/// for each segment in turn, its crossings and overlaps with later segments and the points that touch it, sorted. If k points are
/// equal, each of the k (k - 1) / 2 pairs counts.
///
/// Time O(n log n + p log p) and memory O(n + cap), where p is the number of pairs of bounding boxes that meet, or that a tree of
/// boxes cannot distinguish early from such pairs. p may be quadratic even for a plane drawing (long parallel diagonals), so call
/// the [sweep](super::sweep::sweep) first.
///
/// # Errors
///
/// [`InvalidSegments`], if the arrays do not describe segments.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_geometry::crossing::{Clash, clashes};
///
/// // A square with both diagonals, and a point in the middle that neither of them knows.
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]].map(Point::from);
/// let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]];
/// let (found, total) = clashes(&points, &segments, 2)?;
/// assert_eq!(found, [Clash::Cross { a: 4, b: 5 }, Clash::Touch { vertex: 4, segment: 4 }]);
/// assert_eq!(total, 3);
/// # Ok::<(), twinedge_geometry::crossing::InvalidSegments>(())
/// ```
pub fn clashes(points: &[Point], segments: &[[u32; 2]], cap: usize) -> Result<(Vec<Clash>, u64), InvalidSegments> {
    check(points, segments)?;
    let mut first = Vec::new();
    let mut total = same_places(points, &mut first, cap);

    // The unused points follow the segments.
    let isolated = isolated(points, segments);
    let things = u32::try_from(segments.len() + isolated.len()).map_err(|_| InvalidSegments::TooLarge)?;
    let segment_of = |thing: u32| segments.get(thing as usize);
    let bounds = |thing: u32| {
        let ends = segment_of(thing).copied().unwrap_or_else(|| [isolated[thing as usize - segments.len()]; 2]);
        let [a, b] = ends.map(|end| Bounds::one(points[end as usize]));
        a.joined(b)
    };
    let room = cap - first.len();
    let each = |found: &mut Clashes, id: u32, others: &[u32]| {
        let Some(ends) = segment_of(id) else { return };
        let [p, q] = ends.map(|end| points[end as usize]);
        // A point that touches a segment may be found for several segments that end there.
        let mut here: Vec<Clash> = others
            .iter()
            .filter_map(|&other| {
                let clash = if segment_of(other).is_some() {
                    classify(points, segments, id, other)?
                } else {
                    let vertex = isolated[other as usize - segments.len()];
                    let at = points[vertex as usize];
                    (on_segment(at, p, q) && !at_end(at, p, q)).then_some(Clash::Touch { vertex, segment: id })?
                };
                // The others are found from the other side.
                let of_this = match clash {
                    Clash::Cross { a, .. } | Clash::Overlap { a, .. } => a,
                    Clash::Touch { segment, .. } => segment,
                    Clash::SamePlace { .. } => return None,
                };
                (of_this == id).then_some(clash)
            })
            .collect();
        here.sort_unstable();
        here.dedup();
        found.total += here.len() as u64;
        for clash in here {
            found.take(id, clash, room);
        }
    };
    let merge = |mut one: Clashes, other: Clashes| {
        one.total += other.total;
        for (id, clash) in other.first {
            one.take(id, clash, room);
        }
        one
    };
    let found = Boxes::new(0..things, &bounds).pairs(0.0, &Clashes::default, &each, &merge);
    total += found.total;
    first.extend(found.first.into_sorted_vec().into_iter().map(|(_, clash)| clash));
    Ok((first, total))
}

/// The first clashes of segments, each with the segment that reports it, and the total number.
#[derive(Default)]
struct Clashes {
    first: BinaryHeap<(u32, Clash)>,
    total: u64,
}

impl Clashes {
    /// Keeps a clash if it is among the first `room` ones.
    fn take(&mut self, id: u32, clash: Clash, room: usize) {
        if self.first.len() < room {
            self.first.push((id, clash));
        } else if let Some(mut last) = self.first.peek_mut().filter(|last| (id, clash) < **last) {
            *last = (id, clash);
        }
    }
}

fn isolated(points: &[Point], segments: &[[u32; 2]]) -> Vec<u32> {
    let mut is_used = vec![false; points.len()];
    for end in segments.as_flattened() {
        is_used[*end as usize] = true;
    }
    (0..).zip(is_used).filter(|(_, is_used)| !is_used).map(|(point, _)| point).collect()
}

/// Finds the first pairs of equal points, sorted, and returns their total number.
fn same_places(points: &[Point], first: &mut Vec<Clash>, cap: usize) -> u64 {
    let order = sorted(points);
    let groups: Vec<&[Event]> = order.chunk_by(|a, b| a.at == b.at).filter(|group| group.len() > 1).collect();
    let total = groups.iter().map(|group| (group.len() as u64) * (group.len() as u64 - 1) / 2).sum::<u64>();

    // The sorted pairs: all pairs of the smallest point, then of the next one. Each group contributes its points in turn.
    let mut pairs = Vec::new();
    for group in &groups {
        pairs.extend((0..group.len()).map(|i| (group[i].vertex, &group[i + 1..])));
    }
    pairs.sort_by_key(|(a, _)| *a);
    let pairs = pairs.into_iter().flat_map(|(a, later)| later.iter().map(move |b| Clash::SamePlace { a, b: b.vertex }));
    first.extend(pairs.take(cap));
    total
}

fn at_end(p: Point, a: Point, b: Point) -> bool {
    p == a || p == b
}

/// Returns the clash of two segments of a checked drawing, if they clash.
pub(super) fn classify(points: &[Point], segments: &[[u32; 2]], one: u32, other: u32) -> Option<Clash> {
    let (a, b) = (one.min(other), one.max(other));
    let ([first, second], [third, fourth]) = (segments[a as usize], segments[b as usize]);
    let at = |point: u32| points[point as usize];
    // Most segments that meet follow each other.
    let common = [
        [first, second, third, fourth],
        [first, second, fourth, third],
        [second, first, third, fourth],
        [second, first, fourth, third],
    ]
    .into_iter()
    .find(|[from, _, other, _]| from == other);
    let is_corner = |[from, to, _, other]: [u32; 4]| orientation(at(from), at(to), at(other)) != Orientation::Collinear;
    if common.is_some_and(is_corner) {
        return None;
    }
    match meeting(at(first), at(second), at(third), at(fourth)) {
        Meeting::Disjoint | Meeting::SharedEndpoint => None,
        Meeting::Cross => Some(Clash::Cross { a, b }),
        Meeting::Overlap => Some(Clash::Overlap { a, b }),
        Meeting::Touch(end) => Some(match end {
            Endpoint::A => Clash::Touch { vertex: first, segment: b },
            Endpoint::B => Clash::Touch { vertex: second, segment: b },
            Endpoint::C => Clash::Touch { vertex: third, segment: a },
            Endpoint::D => Clash::Touch { vertex: fourth, segment: a },
        }),
    }
}

/// Checks that the arrays describe a drawing: coordinates are in range, endpoints exist, and no segment has zero length. O(n).
pub(super) fn check(points: &[Point], segments: &[[u32; 2]]) -> Result<(), InvalidSegments> {
    if points.len().max(segments.len()) >= u32::MAX as usize {
        return Err(InvalidSegments::TooLarge);
    }
    if let Some(point) = points.iter().position(|&p| !in_range(p)) {
        return Err(InvalidSegments::OutOfRange { point: point as u32 });
    }
    for (segment, &[u, v]) in (0..).zip(segments) {
        let at = |point: u32| points.get(point as usize).ok_or(InvalidSegments::NoSuchPoint { segment, point });
        if at(u)? == at(v)? {
            return Err(InvalidSegments::NoLength { segment });
        }
    }
    Ok(())
}
