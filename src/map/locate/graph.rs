//! The search graph, packed: questions of 12 bytes each, which lead to a face.

use super::bounds::Bounds;
use super::trapezoids::{Drawn, GraphError, Node, search_graph};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, count_step, orientation};
use core::cmp::Ordering;

/// Marks the number of a face among those of questions, and the number of a point among those of segments.
const MARK: u32 = 1 << 31;

/// A question of the graph, or a face, marked.
pub(super) type Stage = u32;

/// On which side of a segment or point does the query lie?
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
pub(super) enum GraphHit {
    Face(u32),
    Point(u32),
    Segment(u32),
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
    pub(super) fn new(drawn: Drawn, face_above: impl Fn(Option<u32>) -> u32) -> Result<Self, GraphError> {
        let nodes = search_graph(&drawn)?;
        let mut questions = 0;
        let stages: Vec<Stage> = nodes
            .iter()
            .map(|node| {
                if let Node::Trapezoid(trapezoid) = node {
                    return Self::stage(face_above(trapezoid.segment_below()));
                }
                questions += 1;
                questions - 1
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
        Ok(Self { root: stages[0], questions: packed, points: drawn.points, segments: drawn.ends })
    }

    /// Where every way begins.
    pub(super) const fn root(&self) -> Stage {
        self.root
    }

    /// Where a point lies that comes through this stage. O(log n) expected from the root.
    #[inline]
    pub(super) fn find(&self, mut stage: Stage, p: Point) -> GraphHit {
        while stage & MARK == 0 {
            count_step();
            let question = self.questions[stage as usize];
            let above = if question.of & MARK == 0 {
                let [low, high] = self.segments[question.of as usize];
                match orientation(low, high, p) {
                    Orientation::CounterClockwise => true,
                    Orientation::Clockwise => false,
                    // The search comes to a segment only between the walls of its ends.
                    Orientation::Collinear => return GraphHit::Segment(question.of),
                }
            } else {
                match compare_lexicographic(p, self.points[(question.of ^ MARK) as usize]) {
                    Ordering::Greater => true,
                    Ordering::Less => false,
                    Ordering::Equal => return GraphHit::Point(question.of ^ MARK),
                }
            };
            stage = if above { question.above } else { question.below };
        }
        GraphHit::Face(stage ^ MARK)
    }

    /// Goes on from a stage as far as all of a box goes one way.
    pub(super) fn narrow(&self, mut stage: Stage, bounds: &Bounds) -> Stage {
        while stage & MARK == 0 {
            count_step();
            let question = self.questions[stage as usize];
            let above = if question.of & MARK == 0 {
                bounds.above(self.segments[question.of as usize])
            } else {
                bounds.after(self.points[(question.of ^ MARK) as usize])
            };
            let Some(above) = above else { break };
            stage = if above { question.above } else { question.below };
        }
        stage
    }

    /// The stage at which it is known that a point lies in this face.
    pub(super) const fn stage(face: u32) -> Stage {
        MARK | face
    }

    /// The points.
    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    /// The segments, each from its lower end to its higher.
    pub(super) fn segments(&self) -> &[[Point; 2]] {
        &self.segments
    }

    #[cfg(test)]
    pub(super) fn questions(&self) -> usize {
        self.questions.len()
    }
}
