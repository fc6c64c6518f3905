//! The search graph, packed: questions of 12 bytes. The first find the slab of a point; the others form the slab's search graph.

use super::slabs::{Slab, Slabs};
use super::trapezoids::{Drawing, GraphError, search_graph};
use core::cmp::Ordering;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};
use twinedge_geometry::steps::count_step;
use twinedge_geometry::{Point, threads};

/// Distinguishes the number of a face from a question, and the number of a point from a segment.
const MARK: u32 = 1 << 31;

/// A question of the graph, or a face, marked.
pub(super) type Stage = u32;

/// On which side of a segment or point does the query lie?
#[derive(Clone, Copy)]
struct Question {
    /// A segment, or a marked point.
    of: u32,
    /// The next stage on the right of the segment; on the left of the point.
    below: Stage,
    /// The next stage on the left of the segment; on the right of the point.
    above: Stage,
}

impl Question {
    const NONE: Self = Self { of: 0, below: 0, above: 0 };
}

/// The location of a point: in a face, or at a point or inside a segment of the drawing, by their indices there.
#[derive(Clone, Copy)]
pub(super) enum GraphHit {
    Face(u32),
    Point(u32),
    Segment(u32),
}

pub(super) struct Graph {
    root: Stage,
    questions: Vec<Question>,
    points: Vec<Point>,
    segments: Vec<[Point; 2]>,
}

impl Graph {
    /// Builds the graph, given the face above each segment and the face outside. Expected O(n log n), memory O(n). Uses threads.
    pub(super) fn new(drawn: Drawing, faces: &[u32], outside: u32) -> Result<Self, GraphError> {
        let slabs = Slabs::new(&drawn);
        let numbers: Vec<usize> = (0..slabs.len()).collect();
        let parts = threads::map(&numbers, |slab| Self::pack(&slabs.slab(*slab, &drawn), faces, outside));
        let parts = parts.into_iter().collect::<Result<Vec<_>, _>>()?;
        // The questions of the walls come first.
        let walls = slabs.walls.len();
        let count = walls + parts.iter().map(|(_, questions)| questions.len()).sum::<usize>();
        if count >= MARK as usize {
            return Err(GraphError::TooLarge);
        }
        let mut stages = vec![0; slabs.len() + walls];
        let mut questions = Vec::with_capacity(count);
        questions.resize(walls, Question::NONE);
        for (slab, (root, part)) in parts.into_iter().enumerate() {
            let before = questions.len() as u32;
            let moved = |stage: Stage| if stage & MARK == 0 { stage + before } else { stage };
            stages[walls + slab] = moved(root);
            questions.extend(part.iter().map(|Question { of, below, above }| Question {
                of: *of,
                below: moved(*below),
                above: moved(*above),
            }));
        }
        // A balanced tree, numbered from the root and from left to right. Its leaves are the roots of the slabs.
        for at in (0..walls).rev() {
            let depth = (at + 1).ilog2();
            let slabs_below = slabs.len() >> depth;
            let wall = (at + 1 - (1 << depth)) * slabs_below + slabs_below / 2 - 1;
            let [below, above] = [2 * at + 1, 2 * at + 2].map(|child| stages[child]);
            questions[at] = Question { of: MARK | slabs.walls[wall], below, above };
            stages[at] = at as u32;
        }
        Ok(Self { root: stages[0], questions, points: drawn.points, segments: drawn.ends })
    }

    /// Returns the root and the questions of the search graph of one slab, without the nodes of trapezoids.
    fn pack(slab: &Slab, faces: &[u32], outside: u32) -> Result<(Stage, Vec<Question>), GraphError> {
        let nodes = search_graph(&slab.drawn)?;
        let names: Vec<u32> =
            slab.segments.iter().copied().chain(slab.points.iter().map(|point| MARK | *point)).chain([0]).collect();
        let faces: Vec<u32> =
            slab.segments.iter().map(|segment| faces[*segment as usize]).chain([outside]).map(Self::stage).collect();
        // Branch-free, as the kinds of nodes look random.
        let (trapezoid, none) = (names.len() as u32 - 1, slab.segments.len());
        let mut next = 0;
        let mut stages: Vec<Stage> = nodes
            .iter()
            .map(|node| {
                let face = faces[(node.above as usize).min(none)];
                let stage = if node.of == trapezoid { face } else { next };
                next += u32::from(node.of != trapezoid);
                stage
            })
            .collect();
        // Numbers of trapezoids, read here like numbers of nodes, go up to 1 even if there is one node.
        stages.push(Self::stage(outside));
        let mut questions = vec![Question::NONE; next as usize + 1];
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

    /// Returns the stage at which every search begins.
    pub(super) const fn root(&self) -> Stage {
        self.root
    }

    /// Returns the location of a point, continuing its search from this stage. O(log n) expected from the root.
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
                    // The search reaches a segment only between the walls of its ends.
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

    /// Continues from a stage as long as all of a box goes one way.
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

    /// Returns the final stage for points in this face.
    pub(super) const fn stage(face: u32) -> Stage {
        MARK | face
    }

    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    /// Returns the segments, each from its lower end to its higher.
    pub(super) fn segments(&self) -> &[[Point; 2]] {
        &self.segments
    }

    #[cfg(test)]
    pub(super) fn questions(&self) -> usize {
        self.questions.len()
    }
}
