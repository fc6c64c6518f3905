//! The search graph, packed: which questions to ask, in 12 bytes each, down to a face.

use super::trapezoids::{Drawn, Failure, Node, search_graph};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, in_range, orientation, work};
use core::cmp::Ordering;

/// Marks the number of a face among those of questions, and the number of a point among those of segments.
const MARK: u32 = 1 << 31;

/// A question of the graph, or a face, marked. The number of a question is smaller than those to which it leads.
pub(super) type Stage = u32;

/// Which side of something?
#[derive(Clone, Copy)]
struct Question {
    /// A segment, or a point, marked.
    of: u32,
    /// Where to go on the right of the segment; on the left of the point.
    below: Stage,
    /// Where to go on the left of the segment; on the right of the point.
    above: Stage,
}

/// Where a point lies: in a face, or at a point or inside a segment of the drawing, by their places there.
#[derive(Clone, Copy)]
pub(super) enum Found {
    Face(u32),
    Point(u32),
    Segment(u32),
}

/// A stage that some of a box comes to: no more than what is lexicographically from the first point to the last.
pub(super) struct Open {
    stage: Stage,
    first: Point,
    last: Point,
}

/// The packed graph.
pub(super) struct Graph {
    root: Stage,
    questions: Vec<Question>,
    points: Vec<Point>,
    segments: Vec<[Point; 2]>,
}

impl Graph {
    /// Builds the graph, with the face above each segment, and that above none. Expected time O(n log n), memory O(n).
    pub(super) fn new(drawn: Drawn, face_above: impl Fn(Option<u32>) -> u32) -> Result<Self, Failure> {
        let nodes = search_graph(&drawn)?;
        let mut questions = 0;
        let stages: Vec<Stage> = nodes
            .iter()
            .map(|node| match node {
                Node::Trapezoid(trapezoid) => MARK | face_above(trapezoid.segment_below()),
                _ => {
                    questions += 1;
                    questions - 1
                }
            })
            .collect();
        let stage = |node: u32| stages[node as usize];
        let mut packed = Vec::with_capacity(questions as usize);
        packed.extend(nodes.iter().filter_map(|node| match *node {
            Node::Point { vertex, left, right } => {
                Some(Question { of: MARK | vertex, below: stage(left), above: stage(right) })
            }
            Node::Segment { segment, below, above } => {
                Some(Question { of: segment, below: stage(below), above: stage(above) })
            }
            Node::Trapezoid(_) => None,
        }));
        let segments = drawn.segments.iter().map(|ends| ends.map(|end| drawn.points[end as usize])).collect();
        Ok(Self { root: stages[0], questions: packed, points: drawn.points, segments })
    }

    /// Where every way begins.
    pub(super) const fn root(&self) -> Stage {
        self.root
    }

    /// Where a point lies that comes through this stage. O(log n) expected from the root.
    #[inline]
    pub(super) fn find(&self, mut stage: Stage, p: Point) -> Found {
        while stage & MARK == 0 {
            work();
            let question = self.questions[stage as usize];
            let above = if question.of & MARK == 0 {
                let [low, high] = self.segments[question.of as usize];
                match orientation(low, high, p) {
                    Orientation::CounterClockwise => true,
                    Orientation::Clockwise => false,
                    // Whoever is asked about a segment is between the walls of its ends.
                    Orientation::Collinear => return Found::Segment(question.of),
                }
            } else {
                match compare_lexicographic(p, self.points[(question.of ^ MARK) as usize]) {
                    Ordering::Greater => true,
                    Ordering::Less => false,
                    Ordering::Equal => return Found::Point(question.of ^ MARK),
                }
            };
            stage = if above { question.above } else { question.below };
        }
        Found::Face(stage ^ MARK)
    }

    /// The last stage that everything in a box comes through, after one that it comes through, and before any question
    /// about something in the box itself; or an earlier one, if that takes more than `patience` questions. `open` is
    /// scratch.
    pub(super) fn settle(&self, from: Stage, bounds: [Point; 2], patience: &mut usize, open: &mut Vec<Open>) -> Stage {
        let [min, max] = bounds;
        // None is left out: if only one is open, everything comes through it.
        open.clear();
        open.push(Open { stage: from, first: min, last: max });
        let mut settled = from;
        while let Some(Open { stage, first, last }) = open.pop() {
            if open.is_empty() {
                settled = stage;
            }
            // Faces have the largest numbers: only faces are left.
            if stage & MARK != 0 || *patience == 0 {
                break;
            }
            *patience -= 1;
            let question = self.questions[stage as usize];
            let (below, above) = if question.of & MARK == 0 {
                // Whoever is asked about a segment is between the walls of its ends.
                let [low, high] = self.segments[question.of as usize];
                let part = [larger(first, low), smaller(last, high)];
                let Some((below, above)) = sides([low, high], part, bounds) else { break };
                (below.then_some(part), above.then_some(part))
            } else {
                let p = self.points[(question.of ^ MARK) as usize];
                if (min.x..=max.x).contains(&p.x) && (min.y..=max.y).contains(&p.y) {
                    break;
                }
                (Some([first, smaller(last, p)]), Some([larger(first, p), last]))
            };
            for (part, stage) in [(below, question.below), (above, question.above)] {
                let Some([first, last]) = part.filter(|part| reaches(*part, bounds)) else { continue };
                match open.binary_search_by(|other| stage.cmp(&other.stage)) {
                    Ok(place) => {
                        let same = &mut open[place];
                        (same.first, same.last) = (smaller(same.first, first), larger(same.last, last));
                    }
                    Err(place) => open.insert(place, Open { stage, first, last }),
                }
            }
        }
        settled
    }

    #[cfg(test)]
    pub(super) fn questions(&self) -> usize {
        self.questions.len()
    }
}

/// The lexicographically smaller of two points.
fn smaller(a: Point, b: Point) -> Point {
    if compare_lexicographic(a, b).is_le() { a } else { b }
}

/// The lexicographically larger of two points.
fn larger(a: Point, b: Point) -> Point {
    if compare_lexicographic(a, b).is_le() { b } else { a }
}

/// Whether there may be a point in a box that is lexicographically from the first to the last.
fn reaches([first, last]: [Point; 2], [min, max]: [Point; 2]) -> bool {
    first.x < last.x || first.x == last.x && first.y.max(min.y) <= last.y.min(max.y)
}

/// Whether something in a box, lexicographically from the first to the last, may lie on the right of a segment, and on the
/// left; nothing, if the segment itself is there.
fn sides([low, high]: [Point; 2], [first, last]: [Point; 2], [min, max]: [Point; 2]) -> Option<(bool, bool)> {
    work();
    // The corners furthest to the left and to the right of the segment.
    let (left, right) = if high.y >= low.y {
        (Point::new(first.x, max.y), Point::new(last.x, min.y))
    } else {
        (Point::new(last.x, max.y), Point::new(first.x, min.y))
    };
    if !in_range(left) || !in_range(right) {
        return None;
    }
    let below = orientation(low, high, right) != Orientation::CounterClockwise;
    let above = orientation(low, high, left) != Orientation::Clockwise;
    (!(below && above)).then_some((below, above))
}
