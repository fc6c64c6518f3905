//! All places where a drawing is not plane.
//!
//! The [sweep](mod@super::sweep) says quickly whether a drawing of points and straight segments is plane, and names
//! one fault if it is not. [`clashes`] finds all of them.

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::ControlFlow;

use rstar::{AABB, RTree, RTreeObject};

use super::point::Point;
use super::predicates::{Endpoint, Meeting, compare_lexicographic, in_range, meeting, on_segment};

/// A reason why points and straight segments do not draw a plane map.
///
/// Points and segments are named by their places in the arrays. In [`Cross`](Self::Cross), [`Overlap`](Self::Overlap)
/// and [`SamePlace`](Self::SamePlace) `a` is the smaller of the two.
///
/// ```text
///   \ /        |              ______
///    X         |         ====/======      o o
///   / \    ----+----        /
///
///  Cross     Touch        Overlap      SamePlace
/// ```
///
/// Two segments that clash do so in exactly one of the first three ways pictured. A segment that ends on another
/// touches it, and does not also cross it; segments on one line that share more than a point overlap, and the
/// endpoints of the one do not also touch the other.
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
    /// Two collinear segments that share more than a point, perhaps everything.
    Overlap {
        /// A segment.
        a: u32,
        /// Another segment.
        b: u32,
    },
    /// A point, isolated or the endpoint of some segment, in the interior of a segment.
    Touch {
        /// The point.
        vertex: u32,
        /// The segment.
        segment: u32,
    },
}

/// An error in arrays that should describe points and segments.
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
        /// The point that it names.
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
        /// Its place among the queries.
        query: u32,
        /// The point that it names.
        point: u32,
    },
}

/// All clashes of a drawing, each once: the first `cap` of them, and how many there are.
///
/// `segments` holds pairs of places in `points`. The order is that of the arrays: first the points in the same place,
/// sorted; then, for each segment in turn, what it crosses and overlaps among the later segments and what touches it,
/// sorted. Where k points coincide, each of the k (k - 1) / 2 pairs counts.
///
/// Time O(n log n + p log p), where p is the number of pairs of bounding boxes that meet or that an R-tree cannot tell
/// apart from those early, and memory O(n + cap). p may be quadratic even for a plane drawing (long parallel
/// diagonals), so ask the [sweep](super::sweep::sweep) first.
///
/// # Errors
///
/// [`InvalidSegments`], if the arrays do not describe segments.
///
/// ```
/// use twinedge::geometry::Point;
/// use twinedge::geometry::crossing::{Clash, clashes};
///
/// // A square with both diagonals, and a point in the middle that neither of them knows.
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]].map(Point::from);
/// let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3]];
/// let (found, total) = clashes(&points, &segments, 2)?;
/// assert_eq!(found, [Clash::Cross { a: 4, b: 5 }, Clash::Touch { vertex: 4, segment: 4 }]);
/// assert_eq!(total, 3);
/// # Ok::<(), twinedge::geometry::crossing::InvalidSegments>(())
/// ```
pub fn clashes(points: &[Point], segments: &[[u32; 2]], cap: usize) -> Result<(Vec<Clash>, u64), InvalidSegments> {
    check(points, segments)?;
    let mut found = Clashes { first: Vec::new(), total: 0, cap };
    same_places(points, &mut found);

    let tree = boxes(points, segments);
    let mut here = Vec::new();
    for (id, &[u, v]) in (0u32..).zip(segments) {
        let (p, q) = (points[u as usize], points[v as usize]);
        let visit = |other: &Entry| {
            match other.what {
                What::Segment(other) if other != id => {
                    match classify(points, segments, id, other) {
                        // This is found from both sides: the smaller reports it.
                        Some(clash @ (Clash::Cross { a, .. } | Clash::Overlap { a, .. })) if a == id => {
                            here.push(clash);
                        }
                        // This may be found for several segments that end there: see below.
                        Some(clash @ Clash::Touch { segment, .. }) if segment == id => {
                            here.push(clash);
                        }
                        _ => {}
                    }
                }
                What::Point(vertex)
                    if on_segment(points[vertex as usize], p, q) && !at_end(points[vertex as usize], p, q) =>
                {
                    here.push(Clash::Touch { vertex, segment: id });
                }
                _ => {}
            }
            ControlFlow::<()>::Continue(())
        };
        let _never_breaks = tree.locate_in_envelope_intersecting_int(AABB::from_corners(p.into(), q.into()), visit);
        here.sort_unstable();
        here.dedup();
        found.extend(&mut here);
    }
    Ok((found.first, found.total))
}

/// The first clashes, as many as wanted, and the number of all.
struct Clashes {
    first: Vec<Clash>,
    total: u64,
    cap: usize,
}

impl Clashes {
    /// Returns the number of clashes that are still wanted.
    fn room(&self) -> usize {
        self.cap - self.first.len()
    }

    /// Takes all of `clashes` in.
    fn extend(&mut self, clashes: &mut Vec<Clash>) {
        self.total += clashes.len() as u64;
        let room = self.room();
        self.first.extend(clashes.drain(..).take(room));
    }
}

/// Finds the pairs of points with the same coordinates, sorted.
fn same_places(points: &[Point], found: &mut Clashes) {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    let compare = |&a: &u32, &b: &u32| compare_lexicographic(points[a as usize], points[b as usize]);
    order.sort_unstable_by(|a, b| compare(a, b).then(a.cmp(b)));
    let mut groups: Vec<&[u32]> =
        order.chunk_by(|a, b| compare(a, b) == Ordering::Equal).filter(|group| group.len() > 1).collect();
    found.total += groups.iter().map(|group| (group.len() as u64) * (group.len() as u64 - 1) / 2).sum::<u64>();

    // The pairs sorted: all of the smallest point, then all of the next. Each group gives its first point up in its
    // turn.
    let mut pairs = Vec::new();
    for group in &mut groups {
        pairs.extend((0..group.len()).map(|i| (group[i], &group[i + 1..])));
    }
    pairs.sort_unstable();
    let pairs = pairs.into_iter().flat_map(|(a, later)| later.iter().map(move |&b| Clash::SamePlace { a, b }));
    found.first.extend(pairs.take(found.room()));
}

/// An entry of the tree of boxes: a segment, or a point that no segment uses.
enum What {
    Segment(u32),
    Point(u32),
}

struct Entry {
    what: What,
    envelope: AABB<[f64; 2]>,
}

impl RTreeObject for Entry {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        self.envelope
    }
}

/// The boxes of all segments and of all isolated points.
fn boxes(points: &[Point], segments: &[[u32; 2]]) -> RTree<Entry> {
    let mut isolated = alloc::vec![true; points.len()];
    let mut all = Vec::with_capacity(segments.len());
    for (id, ends) in (0..).zip(segments) {
        let [p, q] = ends.map(|end| {
            isolated[end as usize] = false;
            points[end as usize].into()
        });
        all.push(Entry { what: What::Segment(id), envelope: AABB::from_corners(p, q) });
    }
    for (id, &p) in (0..).zip(points) {
        if isolated[id as usize] {
            all.push(Entry { what: What::Point(id), envelope: AABB::from_point(p.into()) });
        }
    }
    RTree::bulk_load(all)
}

fn at_end(p: Point, a: Point, b: Point) -> bool {
    p == a || p == b
}

/// Returns the clash of two segments of a checked drawing, if they clash.
pub(super) fn classify(points: &[Point], segments: &[[u32; 2]], one: u32, other: u32) -> Option<Clash> {
    let (a, b) = (one.min(other), one.max(other));
    let ([first, second], [third, fourth]) = (segments[a as usize], segments[b as usize]);
    let at = |point: u32| points[point as usize];
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

/// Checks that the arrays describe a drawing: every coordinate in range, every endpoint there, no segment without length.
/// O(n).
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
