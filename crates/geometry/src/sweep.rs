//! One pass of a sweep line over points and straight segments: decides if they are plane, and finds the segment below each point.
//!
//! A vertical line runs from left to right. The *status* lists the segments that it currently crosses, from the bottom up; it
//! changes only where the line passes a point of the drawing. If the drawing is plane, the status is always in order, so binary
//! search finds the place of a point among the segments, and the segment below is the first one that a ray straight down would
//! hit. If the drawing is not plane, then immediately to the left of the leftmost fault the offending segments are neighbours in
//! the status; so it suffices to examine segments that become neighbours.
//!
//! ```text
//!      a ________|_______
//!                |    ___
//!            ____|___/ d        status: e, c, a
//!     b \___/  c |               next event: c ends and d starts in its place
//!                |
//!      e ________|____
//! ```
//!
//! The line leans a little, by less than any angle of the drawing, so it passes points in lexicographic order and no segment is
//! parallel to it: a vertical segment starts at its lower end and is the steepest segment in the status. No case is special.
//!
//! # Why every fault is found
//!
//! A fault is a point shared by two segments that is not an endpoint of both, a point of the drawing inside a segment, or the
//! left end of the common part of two overlapping segments. Equal points follow each other in the order of events and are found
//! before the line moves. Otherwise let f be the lexicographically smallest fault. Before f the status is in order, and the
//! segments that reach f are neighbours in it.
//!
//! - If several segments reach f and not all of them end there, then two neighbours among them clash in f, and they were examined
//!   when they became neighbours.
//! - If one reaches f and passes through, then f is a point of the drawing at which nothing ends. So its place is searched for,
//!   and the search for a point on a segment of the status finds that segment.
//! - If all that reach f end there, then two segments start at f in the same direction. Segments that start together are inserted
//!   into the status sorted by angle, so these two become neighbours and are examined.
//!
//! This suffices to decide whether the drawing is plane. Otherwise the pass continues after the first fault, without examining
//! neighbours. The status may then be out of order, and the segments that it reports below points are guesses. But it remains a
//! list, and everything except the search uses handles, so the pass still ends within the same time.
//!
//! Sources: M. I. Shamos and D. Hoey, "Geometric intersection problems", FOCS 1976, 208-215; M. de Berg, O. Cheong,
//! M. van Kreveld, M. Overmars, "Computational Geometry", 3rd edition, 2008, chapter 2.

use crate::NIL;
use core::cmp::Ordering;
use core::ops::Range;

use super::crossing::{Clash, InvalidSegments, check, classify};
use super::events::{Event, accumulate, sorted};
use super::point::Point;
use super::predicates::{Meeting, Orientation, meeting, orientation};
use super::status::{Gap, Status, Strand};
use super::threads;
use crate::steps::count_step;

/// The result of [`sweep`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Sweep {
    /// For each query the segment directly below the point, if there is one. A guess if there is a clash.
    pub below: Vec<Option<u32>>,
    /// A fault of the drawing, or `None`. It is one of the [`clashes`](super::crossing::clashes), perhaps not the leftmost.
    pub clash: Option<Clash>,
}

/// Decides whether segments meet only at shared endpoints, and finds the segment below each of some points.
///
/// `segments` contains pairs of indices into `points`, and `queries` indices into `points`. The segment *below* a point is the
/// first that a ray straight down from it meets; segments that end at the point itself do not count. If the ray runs into an
/// endpoint or along a segment, it leans to the right, by less than any angle of the drawing:
///
/// ```text
///        q                   q                   q
///        :                   :   / b         b   :
///   _____:_____ a            :  /             \  :
///        :                   : /               \ :
///   _____:_____ b            :/____ a      a ___\:
///
///    below: a              below: b         below: none
/// ```
///
/// Isolated points are part of the drawing: one in the interior of a segment is a clash.
///
/// Time O(n log n) for n points and segments, even if they clash, and memory O(n). The expected time depends on the shape of a
/// treap whose priorities are hashes, so it is equal in every run.
///
/// # Errors
///
/// [`InvalidSegments`], if the arrays do not describe segments. Clashing segments are not an error, but part of the result.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_geometry::crossing::Clash;
/// use twinedge_geometry::sweep::sweep;
///
/// // A triangle, and a point in it.
/// let mut points = [[0.0, 0.0], [4.0, 0.0], [1.0, 4.0], [1.0, 1.0]].map(Point::from);
/// let segments = [[0, 1], [1, 2], [2, 0]];
/// let swept = sweep(&points, &segments, &[0, 3])?;
/// assert_eq!(swept.below, [None, Some(0)]);
/// assert_eq!(swept.clash, None);
///
/// points[3] = Point::new(3.0, 0.0);
/// assert_eq!(sweep(&points, &segments, &[])?.clash, Some(Clash::Touch { vertex: 3, segment: 0 }));
/// # Ok::<(), twinedge_geometry::crossing::InvalidSegments>(())
/// ```
pub fn sweep(points: &[Point], segments: &[[u32; 2]], queries: &[u32]) -> Result<Sweep, InvalidSegments> {
    let (below, clash) = sweep_all(points, segments)?;
    match (0..).zip(queries).find(|(_, point)| **point as usize >= points.len()) {
        Some((query, &point)) => Err(InvalidSegments::NoSuchQuery { query, point }),
        None => Ok(Sweep { below: below.of(queries), clash }),
    }
}

/// Like [`sweep`], finds the segment below every point: a guess if there is a clash.
///
/// # Errors
/// [`InvalidSegments`].
pub fn sweep_all(points: &[Point], segments: &[[u32; 2]]) -> Result<(Below, Option<Clash>), InvalidSegments> {
    check(points, segments)?;
    let mut line = Line::new(points, segments);
    let below = line.run(|_| false);
    Ok((below, line.clash))
}

/// Like [`sweep`], finds the segment below every point of a plane drawing. Stops at a clash and returns `None`.
///
/// # Errors
/// [`InvalidSegments`].
pub fn sweep_plane(points: &[Point], segments: &[[u32; 2]]) -> Result<Option<Below>, InvalidSegments> {
    check(points, segments)?;
    let mut line = Line::new(points, segments);
    let below = line.run(|line| line.clash.is_some());
    Ok(line.clash.is_none().then_some(below))
}

/// The segment below each point, or nil.
pub struct Below(Vec<u32>);

impl Below {
    /// Returns the segments below these points of the drawing.
    #[must_use]
    pub fn of(&self, points: &[u32]) -> Vec<Option<u32>> {
        points.iter().map(|&point| Some(self.0[point as usize]).filter(|&segment| segment != NIL)).collect()
    }
}

/// A segment, filed under the event at which it starts.
#[derive(Clone, Copy)]
struct Start {
    segment: u32,
    end: u32,
}

struct Line<'a> {
    points: &'a [Point],
    segments: &'a [[u32; 2]],
    events: Vec<Event>,
    /// The segments, by the event at which they start: event i has the range `first[i]..first[i + 1]`.
    starts: Vec<Start>,
    first: Vec<u32>,
    /// For each event, the node of a strand that ends there; the others follow as its companions.
    arriving: Vec<u32>,
    status: Status,
    clash: Option<Clash>,
    /// The nodes that end at the current event.
    ending: Vec<u32>,
}

impl<'a> Line<'a> {
    fn new(points: &'a [Point], segments: &'a [[u32; 2]]) -> Self {
        let events = sorted(points);
        let same_place = events.windows(2).find(|pair| pair[0].at == pair[1].at);
        let clash = same_place.map(|pair| Clash::SamePlace { a: pair[0].vertex, b: pair[1].vertex });
        let mut rank = vec![0; points.len()];
        for (i, event) in (0..).zip(&events) {
            rank[event.vertex as usize] = i;
        }
        let span = |&[u, v]: &[u32; 2]| {
            let (i, j) = (rank[u as usize], rank[v as usize]);
            (i.min(j), i.max(j))
        };
        // Counting sort, two entries ahead: after summation, `first[i + 1]` starts the segments of event i, then moves on.
        let mut first = vec![0; points.len() + 2];
        for segment in segments {
            first[span(segment).0 as usize + 2] += 1;
        }
        accumulate(&mut first);
        let mut starts = vec![Start { segment: NIL, end: NIL }; segments.len()];
        for (id, segment) in (0..).zip(segments) {
            let (start, end) = span(segment);
            let place = &mut first[start as usize + 1];
            starts[*place as usize] = Start { segment: id, end };
            *place += 1;
        }
        Self {
            points,
            segments,
            arriving: vec![NIL; events.len()],
            events,
            starts,
            first,
            status: Status::new(),
            clash,
            ending: Vec::new(),
        }
    }

    /// Moves the line over all events, or until `stops` returns true.
    fn run(&mut self, stops: impl Fn(&Self) -> bool) -> Below {
        let mut below = vec![NIL; self.points.len()];
        for event in 0..self.events.len() {
            if stops(self) {
                break;
            }
            let under = self.pass(event);
            if under != NIL {
                below[self.events[event].vertex as usize] = self.status.strand(under).segment;
            }
        }
        Below(below)
    }

    /// Moves the line over an event. Returns the node directly below it.
    fn pass(&mut self, event: usize) -> u32 {
        let Event { at, vertex } = self.events[event];
        let mut starts = self.first[event] as usize..self.first[event + 1] as usize;
        let one = self.arriving[event];
        let (below, above, mut last);
        if one == NIL {
            Gap { below, above } = self.find(at, vertex, &starts);
            if starts.is_empty() {
                return below;
            }
            last = below;
            self.sort(at, starts.clone());
        } else if self.status.strand(one).companion == NIL && starts.len() == 1 {
            // One segment continues another: most points of most drawings are like this.
            self.replace(one, at, starts.start);
            starts = 0..0;
            (below, above) = (self.status.below(one), self.status.above(one));
            self.examine(below, one);
            last = one;
        } else {
            self.sort(at, starts.clone());
            (below, last, above) = self.exchange(event, one, &mut starts);
        }
        for start in starts {
            let node = self.status.insert(Gap { below: last, above }, self.strand(at, start));
            self.arriving[self.starts[start].end as usize] = node;
            self.examine(last, node);
            last = node;
        }
        self.examine(last, above);
        below
    }

    /// Searches for the place of a point at which no segment ends, and reports a clash if it lies on a segment.
    fn find(&mut self, at: Point, vertex: u32, starts: &Range<usize>) -> Gap {
        let (gap, on) = self.status.locate(at);
        if on != NIL && self.clash.is_none() {
            let segment = self.status.strand(on).segment;
            // Perhaps a segment that starts here lies along that segment.
            let of_start = self.starts[starts.clone()]
                .first()
                .and_then(|start| classify(self.points, self.segments, start.segment, segment));
            self.clash = of_start.or(Some(Clash::Touch { vertex, segment }));
        }
        gap
    }

    /// Sorts segments that start at a point by angle, lowest first.
    fn sort(&mut self, at: Point, starts: Range<usize>) {
        let events = &self.events;
        threads::sort_unstable_by(&mut self.starts[starts], |a, b| {
            match orientation(at, events[a.end as usize].at, events[b.end as usize].at) {
                Orientation::CounterClockwise => Ordering::Less,
                Orientation::Collinear => a.segment.cmp(&b.segment),
                Orientation::Clockwise => Ordering::Greater,
            }
        });
    }

    /// Removes the strands that end at an event, including `one`; starting segments take over their places, as far as there are
    /// any. Returns the node below, the node placed last (or else the node below), and the node above.
    fn exchange(&mut self, event: usize, one: u32, starts: &mut Range<usize>) -> (u32, u32, u32) {
        let ends_here = |status: &Status, node: u32| node != NIL && status.strand(node).end as usize == event;
        self.ending.clear();
        let mut node = one;
        while node != NIL {
            self.ending.push(node);
            node = self.status.strand(node).companion;
        }
        let at = self.events[event].at;
        let mut remaining = self.ending.len();

        let mut lowest = one;
        while ends_here(&self.status, self.status.below(lowest)) {
            count_step();
            lowest = self.status.below(lowest);
        }
        let below = self.status.below(lowest);
        let (mut last, mut node) = (below, lowest);
        while ends_here(&self.status, node) {
            count_step();
            let above = self.status.above(node);
            if let Some(start) = starts.next() {
                self.replace(node, at, start);
                self.examine(last, node);
                last = node;
            } else {
                self.status.remove(node);
            }
            remaining -= 1;
            node = above;
        }
        // They are adjacent, unless the status is out of order.
        if remaining > 0 {
            for &stray in &self.ending {
                if ends_here(&self.status, stray) {
                    self.status.remove(stray);
                }
            }
        }
        (below, last, node)
    }

    fn replace(&mut self, node: u32, at: Point, start: usize) {
        self.status.replace(node, self.strand(at, start));
        self.arriving[self.starts[start].end as usize] = node;
    }

    fn strand(&self, at: Point, start: usize) -> Strand {
        let Start { segment, end } = self.starts[start];
        Strand { low: at, high: self.events[end as usize].at, segment, end, companion: self.arriving[end as usize] }
    }

    #[inline]
    fn examine(&mut self, lower: u32, upper: u32) {
        if lower == NIL || upper == NIL || self.clash.is_some() {
            return;
        }
        let (a, b) = (self.status.strand(lower), self.status.strand(upper));
        if !matches!(meeting(a.low, a.high, b.low, b.high), Meeting::Disjoint | Meeting::SharedEndpoint) {
            self.clash = classify(self.points, self.segments, a.segment, b.segment);
        }
    }
}

#[cfg(test)]
mod tests;
