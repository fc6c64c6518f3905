//! The rings of polygons: their contacts and their nesting.

use core::cmp::Ordering;
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge_algorithm::area::ring_area;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::boxes::Boxes;
use twinedge_geometry::predicates::{Endpoint, Meeting, Orientation, compare_angle, meeting, on_segment, orientation};

/// A ring of at least three points, without consecutive repetitions, also from the last to the first.
pub(super) struct Ring {
    pub(super) points: Vec<Point>,
    pub(super) polygon: usize,
    /// Its number in the polygon: 0 is the shell.
    pub(super) number: usize,
}

impl Ring {
    fn point(&self, i: usize) -> Point {
        self.points[i % self.points.len()]
    }

    pub(super) fn segment(&self, i: usize) -> [Point; 2] {
        [self.point(i), self.point(i + 1)]
    }

    /// Returns the points before and after a point on this segment of the ring.
    fn around(&self, p: Point, segment: usize) -> [Point; 2] {
        let [a, b] = self.segment(segment);
        if p == a {
            [self.point(segment + self.points.len() - 1), b]
        } else if p == b {
            [a, self.point(segment + 2)]
        } else {
            [a, b]
        }
    }
}

/// A kind of contact between two rings, or between two parts of one ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Contact {
    /// They cross or overlap.
    Crossing,
    /// A ring visits a point twice.
    SelfTouch,
    /// Two rings share a point without crossing there.
    Touch,
}

/// A place where rings meet.
pub(super) struct Meet {
    pub(super) contact: Contact,
    pub(super) at: Point,
    /// The two rings; equal if a ring meets itself.
    pub(super) rings: [usize; 2],
    /// The segment of each ring that meets the other.
    pub(super) segments: [usize; 2],
}

/// The segments of rings, numbered one ring after the other.
struct Segments<'a> {
    rings: &'a [Ring],
    /// The number of the first segment of each ring.
    first: Vec<u32>,
    ring: Vec<u32>,
}

impl Segments<'_> {
    /// Returns the ring of a segment, and its index there.
    fn place(&self, segment: u32) -> (usize, usize) {
        let ring = self.ring[segment as usize];
        (ring as usize, (segment - self.first[ring as usize]) as usize)
    }

    fn bounds(&self, segment: u32) -> Bounds {
        let (ring, i) = self.place(segment);
        let [a, b] = self.rings[ring].segment(i).map(Bounds::one);
        a.joined(b)
    }
}

pub(super) struct Rings<'a> {
    all: &'a [Ring],
    segments: &'a Segments<'a>,
    boxes: Boxes<'a>,
    right: f64,
}

/// Calls a function with an index of rings. O(n log n) for n points.
pub(super) fn with_index<T>(all: &[Ring], ask: impl FnOnce(&Rings<'_>) -> T) -> T {
    let (mut first, mut ring) = (Vec::with_capacity(all.len()), Vec::new());
    for (number, one) in (0..).zip(all) {
        first.push(ring.len() as u32);
        ring.resize(ring.len() + one.points.len(), number);
    }
    let segments = Segments { rings: all, first, ring };
    let bounds = |segment: u32| segments.bounds(segment);
    let boxes = Boxes::new(0..segments.ring.len() as u32, &bounds);
    let right = all.iter().flat_map(|ring| &ring.points).map(|p| p.x).fold(f64::NEG_INFINITY, f64::max);
    ask(&Rings { all, segments: &segments, boxes, right })
}

impl Rings<'_> {
    /// Returns all places where rings meet, except where a ring continues. Where several segments meet at a point, each pair of
    /// rings is reported once for each kind of contact. O(n log n + p log p) for p pairs of segments whose boxes meet.
    pub(super) fn meets(&self) -> Vec<Meet> {
        let each = |found: &mut Vec<([u32; 2], Contact, Point)>, segment: u32, others: &[u32]| {
            for other in others.iter().filter(|other| **other > segment) {
                let contact = self.contact(self.segments.place(segment), self.segments.place(*other));
                found.extend(contact.map(|(contact, at)| ([segment, *other], contact, at)));
            }
        };
        let merge = |mut one: Vec<_>, mut other: Vec<_>| {
            one.append(&mut other);
            one
        };
        let mut found = self.boxes.pairs(0.0, &Vec::new, &each, &merge);
        found.sort_by_key(|(segments, ..)| *segments);
        let mut known: FxHashSet<((u64, u64), [usize; 2], Contact)> = FxHashSet::default();
        let meets = found.into_iter().filter_map(|(segments, contact, at)| {
            let places = segments.map(|segment| self.segments.place(segment));
            let (rings, segments) = (places.map(|(ring, _)| ring), places.map(|(_, segment)| segment));
            let is_new = known.insert((at.hash_key(), rings, contact));
            is_new.then_some(Meet { contact, at, rings, segments })
        });
        meets.collect()
    }

    fn contact(&self, (r, i): (usize, usize), (q, j): (usize, usize)) -> Option<(Contact, Point)> {
        let (one, other) = (&self.all[r], &self.all[q]);
        let ([a, b], [c, d]) = (one.segment(i), other.segment(j));
        let at = match meeting(a, b, c, d) {
            Meeting::Disjoint => return None,
            Meeting::Cross => return Some((Contact::Crossing, crossing(a, b, c, d))),
            Meeting::Overlap => {
                // An end of one lies on the other.
                let at = if on_segment(a, c, d) { a } else { b };
                return Some((Contact::Crossing, if on_segment(at, c, d) { at } else { c }));
            }
            Meeting::Touch(Endpoint::A) => a,
            Meeting::Touch(Endpoint::B) => b,
            Meeting::Touch(Endpoint::C) => c,
            Meeting::Touch(Endpoint::D) => d,
            Meeting::SharedEndpoint => {
                if a == c || a == d {
                    a
                } else {
                    b
                }
            }
        };
        if r == q {
            let follows = |i: usize, j: usize| (i + 1) % one.points.len() == j;
            return (!follows(i, j) && !follows(j, i)).then_some((Contact::SelfTouch, at));
        }
        let cross = crosses_at(at, one.around(at, i), other.around(at, j));
        Some((if cross { Contact::Crossing } else { Contact::Touch }, at))
    }

    /// Returns, for each ring, the rings that contain it, if no two of them cross. O(log n + segments to its right) for each
    /// ring, as long as one of its points lies on no other ring.
    pub(super) fn containers(&self) -> Vec<Vec<usize>> {
        (0..self.all.len()).map(|r| self.containers_of(r)).collect()
    }

    fn containers_of(&self, r: usize) -> Vec<usize> {
        // For each ring to its right, true if this ring lies inside. A ring is unknown while all points so far lie on it.
        let mut inside: FxHashMap<usize, bool> = FxHashMap::default();
        let mut unknown: FxHashSet<usize> = FxHashSet::default();
        for (n, p) in self.all[r].points.iter().enumerate() {
            let (odd, on) = self.ray(*p);
            for q in odd.iter().chain(&on).chain(&unknown).copied().filter(|q| *q != r).collect::<Vec<_>>() {
                if on.contains(&q) {
                    if !inside.contains_key(&q) && (n == 0 || unknown.contains(&q)) {
                        unknown.insert(q);
                    }
                } else if n == 0 || unknown.remove(&q) {
                    inside.insert(q, odd.contains(&q));
                }
            }
            if unknown.is_empty() {
                break;
            }
        }
        let starts = unknown.into_iter().filter(|q| self.starts_inside(r, *q));
        let mut found: Vec<usize> = inside.into_iter().filter(|(_, is)| *is).map(|(q, _)| q).chain(starts).collect();
        found.sort_unstable();
        found
    }

    /// Returns the rings that a ray to the right crosses an odd number of times, and the rings that contain its start.
    fn ray(&self, p: Point) -> (FxHashSet<usize>, FxHashSet<usize>) {
        let (mut odd, mut on) = (FxHashSet::default(), FxHashSet::default());
        let reach = Bounds { low: p, high: Point::new(self.right.max(p.x), p.y) };
        for (q, i) in self.boxes.meeting(&reach).into_iter().map(|segment| self.segments.place(segment)) {
            let [a, b] = self.all[q].segment(i);
            if on_segment(p, a, b) {
                on.insert(q);
            }
            let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
            let is_crossed = low.y <= p.y && p.y < high.y && orientation(low, high, p) == Orientation::CounterClockwise;
            if is_crossed && !odd.insert(q) {
                odd.remove(&q);
            }
        }
        (odd, on)
    }

    /// Returns true if a ring whose points all lie on another ring starts towards the inside of the other.
    fn starts_inside(&self, r: usize, q: usize) -> bool {
        let [p, next] = self.all[r].segment(0);
        let other = &self.all[q];
        let on = (0..other.points.len()).find(|i| {
            let [a, b] = other.segment(*i);
            on_segment(p, a, b)
        });
        let Some([before, after]) = on.map(|i| other.around(p, i)) else { return false };
        let between = is_between(p, after, before, next);
        // The inside of a counter-clockwise ring lies counter-clockwise from the next point to the previous one.
        between == (ring_area(other.points.iter().copied()) > 0.0)
    }
}

/// Returns true if a direction lies strictly between two others, counter-clockwise from the first to the second.
fn is_between(center: Point, from: Point, to: Point, direction: Point) -> bool {
    let less = |a, b| compare_angle(center, a, b) == Ordering::Less;
    if less(from, to) {
        less(from, direction) && less(direction, to)
    } else {
        less(from, direction) || less(direction, to)
    }
}

/// Returns true if two chains through a point cross there: the ends of one lie on different sides of the other.
fn crosses_at(at: Point, [before, after]: [Point; 2], [one, other]: [Point; 2]) -> bool {
    let same = |a, b| compare_angle(at, a, b) == Ordering::Equal;
    let along = [one, other].into_iter().any(|p| same(p, before) || same(p, after));
    // Chains along each other have overlapping segments, which are found elsewhere.
    !along && is_between(at, before, after, one) != is_between(at, before, after, other)
}

/// Returns the crossing point of two segments that cross, rounded.
fn crossing(a: Point, b: Point, c: Point, d: Point) -> Point {
    let (ux, uy, vx, vy) = (b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y);
    let t = ((c.x - a.x) * vy - (c.y - a.y) * vx) / (ux * vy - uy * vx);
    let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.5 };
    Point::new(a.x + ux * t, a.y + uy * t)
}
