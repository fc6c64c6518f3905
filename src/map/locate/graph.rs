//! The search graph, packed: questions of 12 bytes each, which lead to a face.

use super::bounds::Bounds;
use super::slabs::{Slab, Slabs};
use super::trapezoids::{Drawn, GraphError, search_graph};
use crate::geometry::threads;
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
    pub(super) fn new(drawn: Drawn, faces: &[u32], outside: u32) -> Result<Self, GraphError> {
        let slabs = Slabs::new(&drawn);
        let walls = slabs.walls.len();
        let numbers: Vec<usize> = (0..slabs.len()).collect();
        let parts = threads::map(&numbers, |slab| Self::pack(&slabs.slab(*slab, &drawn), faces, outside));
        let mut questions = Vec::with_capacity(3 * drawn.segments.len());
        questions.resize(walls, Question { of: 0, below: 0, above: 0 });
        let mut roots = Vec::with_capacity(slabs.len());
        for part in parts {
            let (root, part) = part?;
            let before = questions.len() as u32;
            let moved = |stage: Stage| if stage & MARK == 0 { stage + before } else { stage };
            roots.push(moved(root));
            questions.extend(part.iter().map(|question| Question {
                of: question.of,
                below: moved(question.below),
                above: moved(question.above),
            }));
        }
        // The walls, as a balanced tree.
        for at in 0..walls {
            let depth = (at + 1).ilog2();
            let width = slabs.len() >> depth;
            let first = (at + 1 - (1 << depth)) * width;
            let child = |child: usize| if child < walls { child as u32 } else { roots[child - walls] };
            questions[at] = Question {
                of: MARK | slabs.walls[first + width / 2 - 1],
                below: child(2 * at + 1),
                above: child(2 * at + 2),
            };
        }
        let root = if walls == 0 { roots[0] } else { 0 };
        Ok(Self { root, questions, points: drawn.points, segments: drawn.ends })
    }

    /// The search graph of one slab, packed: nodes of trapezoids are taken out.
    fn pack(slab: &Slab, faces: &[u32], outside: u32) -> Result<(Stage, Vec<Question>), GraphError> {
        let nodes = search_graph(&slab.drawn)?;
        let names: Vec<u32> =
            slab.segments.iter().copied().chain(slab.points.iter().map(|point| MARK | *point)).chain([0]).collect();
        let faces: Vec<u32> =
            slab.segments.iter().map(|segment| faces[*segment as usize]).chain([outside]).map(Self::stage).collect();
        // Without branches: what comes next looks random.
        let (trapezoid, none) = (names.len() as u32 - 1, slab.segments.len());
        let mut next = 0;
        let stages: Vec<Stage> = nodes
            .iter()
            .map(|node| {
                let face = faces[(node.above as usize).min(none)];
                let stage = if node.of == trapezoid { face } else { next };
                next += u32::from(node.of != trapezoid);
                stage
            })
            .collect();
        let mut questions = vec![Question { of: 0, below: 0, above: 0 }; next as usize + 1];
        let mut place = 0;
        for node in &nodes {
            questions[place] = Question {
                of: names[node.of as usize],
                below: stages[node.below as usize],
                above: stages[node.above as usize],
            };
            place += usize::from(node.of != trapezoid);
        }
        questions.pop();
        Ok((stages[0], questions))
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
