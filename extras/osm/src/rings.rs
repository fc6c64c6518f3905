//! The rings that the ways of a relation form.
//!
//! A segment that occurs twice bounds nothing and is left out. Where more than two segments meet, those with the inside between
//! them are joined, so that rings do not cross there. A ring that returns to a point is split in two.
//!
//! ```text
//!   ○─────────────○
//!   │ ╲  hole   ╱ │      The ways meet at v. The shell goes on from a to d, and the hole from b to c:
//!   │   ╲     ╱   │      one ring by a, b, c, d, which is cut at v.
//!   │    b╲ ╱c    │
//!   ○──a───v───d──○
//! ```

use crate::elements::Role;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::VecDeque;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_angle, orientation};

#[derive(Clone, Debug)]
pub(crate) struct Piece<'a> {
    pub(crate) way: i64,
    pub(crate) role: Role,
    pub(crate) nodes: &'a [i64],
    pub(crate) points: Vec<Point>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ring {
    /// The points; the last equals the first.
    pub(crate) points: Vec<Point>,
    /// The numbers of its pieces, each with true if it runs from its first node to its last.
    pub(crate) pieces: Vec<(usize, bool)>,
}

/// The nodes at which an odd number of pieces end, in order: no rings pass through all of these.
pub(crate) fn open_ends(pieces: &[Piece<'_>]) -> Vec<i64> {
    let mut ends: Vec<i64> =
        pieces.iter().flat_map(|piece| [piece.nodes[0], piece.nodes[piece.nodes.len() - 1]]).collect();
    ends.sort_unstable();
    ends.chunk_by(|a, b| a == b).filter(|same| !same.len().is_multiple_of(2)).map(|same| same[0]).collect()
}

/// A segment between two points, by their numbers.
#[derive(Clone, Copy)]
struct Segment {
    ends: [usize; 2],
    piece: usize,
}

impl Segment {
    fn other(&self, end: usize) -> usize {
        if self.ends[0] == end { self.ends[1] } else { self.ends[0] }
    }
}

struct Segments {
    points: Vec<Point>,
    /// In order, with none for a segment that is left out.
    all: Vec<Option<Segment>>,
    at: Vec<Vec<usize>>,
}

impl Segments {
    fn new(pieces: &[Piece<'_>]) -> Self {
        let mut numbers: FxHashMap<[u64; 2], usize> = FxHashMap::default();
        let mut found = Self { points: Vec::new(), all: Vec::new(), at: Vec::new() };
        let mut known: FxHashMap<[usize; 2], usize> = FxHashMap::default();
        for (number, piece) in pieces.iter().enumerate() {
            let of_point = |p: &Point| {
                *numbers.entry([p.x + 0.0, p.y + 0.0].map(f64::to_bits)).or_insert_with(|| {
                    found.points.push(*p);
                    found.points.len() - 1
                })
            };
            let along: Vec<usize> = piece.points.iter().map(of_point).collect();
            for ends in along.windows(2).filter(|ends| ends[0] != ends[1]) {
                let ends = [ends[0], ends[1]];
                // A segment that occurs twice cancels out.
                if let Some(first) = known.remove(&[ends[0].min(ends[1]), ends[0].max(ends[1])]) {
                    found.all[first] = None;
                } else {
                    known.insert([ends[0].min(ends[1]), ends[0].max(ends[1])], found.all.len());
                    found.all.push(Some(Segment { ends, piece: number }));
                }
            }
        }
        found.at = vec![Vec::new(); found.points.len()];
        for (number, segment) in found.all.iter().enumerate() {
            segment.iter().flat_map(|segment| segment.ends).for_each(|end| found.at[end].push(number));
        }
        found
    }

    fn remove(&mut self, segment: usize) {
        for end in self.all[segment].take().into_iter().flat_map(|segment| segment.ends) {
            self.at[end].retain(|other| *other != segment);
        }
    }

    /// Leaves out dead ends: the shortest paths between points where an odd number of segments meet, until no such points remain.
    fn leave_out_open(&mut self) {
        for start in 0..self.points.len() {
            if self.at[start].len().is_multiple_of(2) {
                continue;
            }
            // The segment by which each point was reached first.
            let mut by: FxHashMap<usize, usize> = FxHashMap::default();
            let mut ahead = VecDeque::from([start]);
            let odd = loop {
                // Another such point is reachable, since each segment has two ends.
                let Some(at) = ahead.pop_front() else { break start };
                if at != start && !self.at[at].len().is_multiple_of(2) {
                    break at;
                }
                for segment in &self.at[at] {
                    let Some(to) = self.all[*segment].map(|segment| segment.other(at)) else { continue };
                    if to != start && !by.contains_key(&to) {
                        by.insert(to, *segment);
                        ahead.push_back(to);
                    }
                }
            };
            let mut at = odd;
            while let Some(segment) = by.get(&at).copied().filter(|_| at != start) {
                at = self.all[segment].map_or(start, |segment| segment.other(at));
                self.remove(segment);
            }
        }
    }

    /// Returns true if the inside lies directly below the ray to the right of a point. O(segments).
    fn is_inside_right_of(&self, p: Point) -> bool {
        let crosses = |segment: &Segment| {
            let [a, b] = segment.ends.map(|end| self.points[end]);
            let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
            low.y < p.y && p.y <= high.y && orientation(low, high, p) == Orientation::CounterClockwise
        };
        self.all.iter().flatten().filter(|segment| crosses(segment)).count() % 2 == 1
    }

    /// Maps each end of a segment to the segment that continues there.
    fn joined(&self) -> FxHashMap<(usize, usize), usize> {
        let mut joined = FxHashMap::default();
        for (point, at) in self.at.iter().enumerate() {
            let center = self.points[point];
            let mut around = at.clone();
            if around.len() > 2 {
                let far = |segment: &usize| self.all[*segment].map_or(center, |one| self.points[one.other(point)]);
                around.sort_by(|a, b| compare_angle(center, far(a), far(b)));
                if self.is_inside_right_of(center) {
                    around.rotate_left(1);
                }
            }
            for pair in around.chunks_exact(2) {
                joined.insert((point, pair[0]), pair[1]);
                joined.insert((point, pair[1]), pair[0]);
            }
        }
        joined
    }
}

/// Returns the rings. None passes through a point twice, and none crosses another at a point. O(n log n) for n nodes, plus O(n)
/// for each point where more than two segments meet and for each dead end.
pub(crate) fn rings(pieces: &[Piece<'_>]) -> Vec<Ring> {
    let mut segments = Segments::new(pieces);
    segments.leave_out_open();
    let joined = segments.joined();
    let mut used = vec![false; segments.all.len()];
    let mut rings = Vec::new();
    for start in 0..segments.all.len() {
        let (Some(first), false) = (segments.all[start], used[start]) else { continue };
        // The points of the path, each with the segment that leaves it.
        let mut path: Vec<(usize, usize)> = Vec::new();
        let mut on_path: FxHashSet<usize> = FxHashSet::default();
        let (mut at, mut segment) = (first.ends[0], start);
        loop {
            if !on_path.insert(at) {
                let place = path.iter().position(|(point, _)| *point == at).unwrap_or(0);
                let ring = path.split_off(place);
                for (point, _) in ring.iter().skip(1) {
                    on_path.remove(point);
                }
                rings.push(segments.ring(&ring));
            }
            if std::mem::replace(&mut used[segment], true) {
                break;
            }
            path.push((at, segment));
            let Some(of) = segments.all[segment] else { break };
            at = of.other(at);
            let Some(next) = joined.get(&(at, segment)) else { break };
            segment = *next;
        }
    }
    rings
}

impl Segments {
    /// Returns the ring of these points, each with the segment that leaves it.
    fn ring(&self, path: &[(usize, usize)]) -> Ring {
        let mut points: Vec<Point> = path.iter().map(|(point, _)| self.points[*point]).collect();
        points.extend(points.first().copied());
        let passed = path.iter().filter_map(|(point, segment)| {
            let segment = self.all[*segment]?;
            Some((segment.piece, segment.ends[0] == *point))
        });
        let mut pieces: Vec<(usize, bool)> = passed.collect();
        pieces.dedup();
        if pieces.len() > 1 && pieces.first() == pieces.last() {
            pieces.pop();
        }
        Ring { points, pieces }
    }
}
