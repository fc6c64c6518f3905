//! The trapezoidal map of a plane drawing, and the search graph that grows with it.
//!
//! ```text
//!   :          :    :         From every vertex a wall runs up and one runs down, to the next segment or for ever. What is
//!   :    ______b____:_        left of the plane are trapezoids: one segment above, one below, one wall on either
//!   :___/      :    :         side. A trapezoid lies in one face.
//!   a\         :    :
//!   : \________c____:
//! ```
//!
//! Segments are put in one after the other, in random order. A new end point cuts the trapezoid that it lies in by its
//! walls; a new segment then cuts the trapezoids that it passes through, and takes away from the walls that it meets what
//! is beyond it. The search graph remembers: a trapezoid that is cut becomes a question ("left of this vertex?", "above
//! this segment?") whose answers are the pieces. A piece may come from several trapezoids, so the graph is no tree; that
//! keeps it of linear size.
//!
//! As in the [sweep](mod@twinedge_geometry::sweep), the walls lean a little, so that vertices are met in lexicographic order and
//! nothing is vertical. No case is left over.
//!
//! *Cost.* On average over the orders, a segment cuts O(1) trapezoids and a question is asked O(log n) times on the way to
//! any fixed point, whatever the drawing. The order is that of a fixed pseudo-random sequence, so it is the same in every
//! run; a drawing made up against this very sequence could be slow, and all others are as good as the average.
//!
//! In a large drawing it is memory that takes time, and a random order jumps through it. So points and segments are numbered
//! along a curve that fills the plane, and segments come in rounds, each of as many as all before it. Which round a segment is
//! in is random; within a round segments follow the curve, so that one is next to the one before. A round puts O(1) segments on
//! average through a trapezoid of the rounds before, so it adds O(1) questions to a way, and all rounds add O(log n). And the
//! points of a round are found together before it: neighbours share the way from the root.
//!
//! Nothing is gained by building anew if the graph came out deep: in a random order, the chance that any point at all takes
//! more than 3 λ ln (n + 1) questions is below 2 / (n + 1)^(0.22 λ − 3).
//!
//! Sources: M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, "Computational Geometry", 3rd edition, 2008, chapter 6
//! (after K. Mulmuley, 1990, and R. Seidel, 1991); N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", Symposium on
//! Computational Geometry 2003, 211-219.

use super::lists::Lists;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::{Bounds, is_before};
use twinedge_geometry::predicates::{Orientation, orientation};
use twinedge_geometry::steps::count_step;

/// No vertex, or no trapezoid. Links of no trapezoid are written and mean nothing.
const NO_VERTEX: u32 = u32::MAX;
const NOTHING: u32 = 0;

/// A plane drawing: distinct points, and segments that meet at shared endpoints only. Both are numbered along a curve that fills
/// the plane.
pub(super) struct Drawing {
    pub(super) points: Vec<Point>,
    /// The numbers of the lower and the higher end, in lexicographic order.
    pub(super) segments: Vec<[u32; 2]>,
    /// The lower and the higher end of each segment.
    pub(super) ends: Vec<[Point; 2]>,
}

impl Drawing {
    /// On which side of a segment a point lies.
    fn side(&self, segment: u32, p: Point) -> Orientation {
        let [low, high] = self.ends[segment as usize];
        orientation(low, high, p)
    }
}

/// A node of the search graph. Its number is smaller than those of the nodes to which it leads, so every search ends.
#[derive(Clone, Copy)]
pub(super) struct Node {
    /// The number of a segment: is it below or above? Or that of a vertex, plus the number of segments: is it left or right, in
    /// the lexicographic sense? Or the sum of both numbers: it is in this trapezoid.
    pub(super) of: u32,
    /// The next node below, or on the left. In a trapezoid: its number.
    pub(super) below: u32,
    /// The next node above, or on the right. In a trapezoid: the segment below it, or the number of segments if there is none.
    pub(super) above: u32,
}

/// A trapezoid. Its neighbours are those with which it shares a wall and the segment above (or below) it: so along each
/// side of a segment there is a list, linked both ways.
#[derive(Clone, Copy)]
struct Trapezoid {
    node: u32,
    /// The vertex whose wall is the right side.
    right: u32,
    /// To the left and to the right along the segment above.
    upper: [u32; 2],
    /// To the left and to the right along the segment below.
    lower: [u32; 2],
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

/// Into how many groups the points of a group are parted that are to be found together.
const PARTS: usize = 4;

/// The error of [`search_graph`].
pub(super) enum GraphError {
    /// There are too many nodes.
    TooLarge,
    /// The segments cannot have been disjoint.
    Clash,
}

/// The trapezoidal map of what has been put in so far.
struct TrapezoidalMap<'a> {
    drawn: &'a Drawing,
    nodes: Vec<Node>,
    /// From number 1 on: there are one more than points with walls and segments.
    trapezoids: Vec<Trapezoid>,
    /// A node whose region holds the point; if the point has its walls, what is to the right of it.
    starts: Vec<u32>,
    /// A mark for each point that has its walls.
    walled: Vec<bool>,
}

/// Builds the search graph; its root is the first node. Expected time O(n log n), memory O(n).
pub(super) fn search_graph(drawn: &Drawing) -> Result<Vec<Node>, GraphError> {
    let (points, segments) = (drawn.points.len(), drawn.segments.len());
    let everything = Trapezoid { node: 0, right: NO_VERTEX, upper: [NOTHING; 2], lower: [NOTHING; 2] };
    let mut nodes = Vec::with_capacity(2 * points + 5 * segments + 1);
    nodes.push(Node { of: (segments + points) as u32, below: 1, above: segments as u32 });
    let mut trapezoids = Vec::with_capacity(points + segments + 2);
    trapezoids.extend([everything; 2]);
    let mut map = TrapezoidalMap { drawn, nodes, trapezoids, starts: vec![0; points], walled: vec![false; points] };

    let rounds = rounds(segments);
    let count = rounds.iter().max().map_or(0, |last| *last as usize + 1);
    // A point is put in with the first of its segments.
    let mut first_rounds = vec![u32::MAX; points];
    for (ends, round) in drawn.segments.iter().zip(&rounds) {
        for end in ends {
            let first = &mut first_rounds[*end as usize];
            *first = *round.min(first);
        }
    }
    let isolated: Vec<u32> = (0..points as u32).filter(|point| first_rounds[*point as usize] == u32::MAX).collect();
    // An empty range for a point without segments.
    let points =
        Lists::new(count, first_rounds.iter().map(|round| if *round == u32::MAX { [1, 0] } else { [*round; 2] }));
    let segments = Lists::new(count, rounds.iter().map(|round| [*round; 2]));
    for round in 0..count {
        map.find_all(points.list(round));
        for segment in segments.list(round) {
            map.insert(*segment)?;
        }
    }
    // Vertices without segments come last: their walls would be cut by segments later on.
    let rounds = self::rounds(isolated.len());
    let count = rounds.iter().max().map_or(0, |last| *last as usize + 1);
    let lists = Lists::new(count, rounds.iter().map(|round| [*round; 2]));
    for round in 0..count {
        let points: Vec<u32> = lists.list(round).iter().map(|place| isolated[*place as usize]).collect();
        map.find_all(&points);
        for point in points {
            map.wall(point)?;
        }
    }
    Ok(map.nodes)
}

impl TrapezoidalMap<'_> {
    /// Puts a segment in.
    fn insert(&mut self, segment: u32) -> Result<(), GraphError> {
        let [low, high] = self.drawn.segments[segment as usize];
        self.wall(high)?;
        self.wall(low)?;
        let first = self.find(low, Some(high));
        self.thread(segment, first)
    }

    /// Finds nodes from which to start for all of some points that are to get their walls in this round, in ascending order.
    ///
    /// They are found in groups of neighbours: as far as all of a box around a group goes one way, the group goes it
    /// together.
    fn find_all(&mut self, points: &[u32]) {
        let mut groups = vec![(points, 0)];
        while let Some((group, from)) = groups.pop() {
            if let [point] = *group {
                self.starts[point as usize] = from;
                self.find(point, None);
                continue;
            }
            let Some(bounds) = Bounds::around(group.iter().map(|point| self.drawn.points[*point as usize])) else {
                continue;
            };
            let (node, ends) = self.narrow(from, &bounds);
            if ends {
                for point in group {
                    self.starts[*point as usize] = node;
                }
            } else {
                groups.extend(group.chunks(group.len().div_ceil(PARTS)).map(|part| (part, node)));
            }
        }
    }

    /// Goes from a node as far as all of a box goes one way, and says whether that is a trapezoid.
    fn narrow(&self, mut at: u32, bounds: &Bounds) -> (u32, bool) {
        loop {
            count_step();
            let node = self.nodes[at as usize];
            let above = if let Some(ends) = self.drawn.ends.get(node.of as usize) {
                bounds.above(*ends)
            } else if let Some(p) = self.drawn.points.get(self.vertex(node)) {
                bounds.after(*p)
            } else {
                return (at, true);
            };
            let Some(above) = above else { return (at, false) };
            at = if above { node.above } else { node.below };
        }
    }

    /// The number of the vertex of a question, if it is one of a vertex, or else a number too large.
    fn vertex(&self, node: Node) -> usize {
        (node.of as usize).wrapping_sub(self.drawn.segments.len())
    }

    /// The trapezoid in which a point lies that has no wall yet, or else that in which the way to another point, further
    /// right, begins. The next search for the point starts where this one came to what depends on the way.
    fn find(&mut self, from: u32, to: Option<u32>) -> u32 {
        let p = self.drawn.points[from as usize];
        let mut at = self.starts[from as usize];
        // The first question of which the answer depends on the other point.
        let mut start = None;
        loop {
            count_step();
            let node = self.nodes[at as usize];
            let above = if let Some([low, high]) = self.drawn.ends.get(node.of as usize) {
                let side = match (orientation(*low, *high, p), to) {
                    // Both start here.
                    (Orientation::Collinear, Some(to)) => {
                        start.get_or_insert(at);
                        orientation(*low, *high, self.drawn.points[to as usize])
                    }
                    (side, _) => side,
                };
                side == Orientation::CounterClockwise
            } else if let Some(vertex) = self.drawn.points.get(self.vertex(node)) {
                !is_before(p, *vertex)
            } else {
                self.starts[from as usize] = start.unwrap_or(at);
                return node.below;
            };
            at = if above { node.above } else { node.below };
        }
    }

    /// Gives a point its walls, if it has none.
    ///
    /// ```text
    ///    _____________        ______:______
    ///        old         ->    left p right
    ///    _____________        ______:______
    /// ```
    fn wall(&mut self, vertex: u32) -> Result<(), GraphError> {
        if core::mem::replace(&mut self.walled[vertex as usize], true) {
            return Ok(());
        }
        // The part on the left keeps the number.
        let left = self.find(vertex, None);
        let old = self.trapezoids[left as usize];
        let bottom = self.nodes[old.node as usize].above;
        let right = self.trapezoids.len() as u32;
        let nodes = [self.push(left, bottom)?, self.push(right, bottom)?];
        self.trapezoids[left as usize] = Trapezoid {
            node: nodes[0],
            right: vertex,
            upper: [old.upper[LEFT], right],
            lower: [old.lower[LEFT], right],
        };
        self.trapezoids.push(Trapezoid {
            node: nodes[1],
            right: old.right,
            upper: [left, old.upper[RIGHT]],
            lower: [left, old.lower[RIGHT]],
        });
        self.trapezoids[old.upper[RIGHT] as usize].upper[LEFT] = right;
        self.trapezoids[old.lower[RIGHT] as usize].lower[LEFT] = right;
        self.ask(old.node, vertex + self.drawn.segments.len() as u32, nodes);
        self.starts[vertex as usize] = nodes[1];
        Ok(())
    }

    /// Draws a segment through the trapezoids, from that on the right of its lower end to that on the left of its higher.
    ///
    /// ```text
    ///    _____________________        _____________________
    ///        :         :                  :  above
    ///    ----:----r    :         ->   ----:----r    _______
    ///        :         :                  :   _____/ above
    ///   p    :         :    q        p____:__/  :         q
    ///        :         :              below     :
    ///    ____r'________:______        ____r'____:__________
    /// ```
    ///
    /// A wall stays on that side of the segment where its vertex is; on the other, the pieces next to it become one. What is
    /// new keeps the number of what is cut.
    fn thread(&mut self, segment: u32, first: u32) -> Result<(), GraphError> {
        let end = self.drawn.segments[segment as usize][RIGHT];
        let mut old = self.trapezoids[first as usize];
        let bottom = self.nodes[old.node as usize].above;
        // The pieces on the right of the lower end.
        let (mut above, mut below) = (first, self.trapezoids.len() as u32);
        let mut nodes = [self.push(below, bottom)?, self.push(above, segment)?];
        self.trapezoids[above as usize] = Trapezoid { node: nodes[1], lower: [NOTHING; 2], ..old };
        self.trapezoids.push(Trapezoid { node: nodes[0], upper: [NOTHING; 2], ..old });
        self.trapezoids[old.lower[LEFT] as usize].lower[RIGHT] = below;
        self.trapezoids[old.lower[RIGHT] as usize].lower[LEFT] = below;
        loop {
            count_step();
            self.ask(old.node, segment, nodes);
            if old.right == end {
                return Ok(());
            }
            let wall = *self.drawn.points.get(old.right as usize).ok_or(GraphError::Clash)?;
            if self.drawn.side(segment, wall) == Orientation::CounterClockwise {
                let at = old.lower[RIGHT];
                old = self.next(at)?;
                // The trapezoid below goes on.
                let piece = &mut self.trapezoids[below as usize];
                (piece.right, piece.lower[RIGHT]) = (old.right, old.lower[RIGHT]);
                self.trapezoids[old.lower[RIGHT] as usize].lower[LEFT] = below;
                nodes[1] = self.push(at, segment)?;
                self.trapezoids[above as usize].lower[RIGHT] = at;
                self.trapezoids[at as usize] = Trapezoid { node: nodes[1], lower: [above, NOTHING], ..old };
                above = at;
            } else {
                let at = old.upper[RIGHT];
                old = self.next(at)?;
                let piece = &mut self.trapezoids[above as usize];
                (piece.right, piece.upper[RIGHT]) = (old.right, old.upper[RIGHT]);
                self.trapezoids[old.upper[RIGHT] as usize].upper[LEFT] = above;
                nodes[0] = self.push(at, self.nodes[old.node as usize].above)?;
                self.trapezoids[below as usize].upper[RIGHT] = at;
                self.trapezoids[at as usize] = Trapezoid { node: nodes[0], upper: [below, NOTHING], ..old };
                below = at;
            }
        }
    }

    /// The trapezoid behind a wall.
    fn next(&self, at: u32) -> Result<Trapezoid, GraphError> {
        if at == NOTHING { Err(GraphError::Clash) } else { Ok(self.trapezoids[at as usize]) }
    }

    /// Adds a node for a trapezoid, with the segment below it.
    fn push(&mut self, trapezoid: u32, bottom: u32) -> Result<u32, GraphError> {
        let number = self.nodes.len();
        if number >= 1 << 31 {
            return Err(GraphError::TooLarge);
        }
        let of = (self.drawn.segments.len() + self.drawn.points.len()) as u32;
        self.nodes.push(Node { of, below: trapezoid, above: bottom });
        Ok(number as u32)
    }

    /// Makes a trapezoid's node a question.
    fn ask(&mut self, at: u32, of: u32, [below, above]: [u32; 2]) {
        self.nodes[at as usize] = Node { of, below, above };
    }
}

/// The numbers below n in an order that looks random (R. A. Fisher and F. Yates, 1938), and is the same in every run.
fn shuffled(n: usize) -> Vec<u32> {
    let mut order: Vec<u32> = (0..n as u32).collect();
    let mut state = 0_u64;
    for i in (1..n).rev() {
        // SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut random = state;
        random = (random ^ (random >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        random = (random ^ (random >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        random ^= random >> 31;
        let below = (u128::from(random) * (i as u128 + 1)) >> 64;
        order.swap(i, below as usize);
    }
    order
}

/// Parts the numbers below n at random in rounds, each of as many as all before it, and says which each is in.
fn rounds(n: usize) -> Vec<u32> {
    // Round 0 has what was drawn first, and round r the draws from 2^(r - 1) to 2^r.
    shuffled(n).into_iter().map(|drawn| drawn.checked_ilog2().map_or(0, |last| last + 1)).collect()
}
