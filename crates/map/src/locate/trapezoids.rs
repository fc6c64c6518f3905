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
//! Segments are inserted one by one, in random order. A new end point cuts its trapezoid by its walls. A new segment then cuts
//! the trapezoids that it passes through, and trims the walls that it meets beyond the segment. The search graph keeps the
//! history: a cut trapezoid becomes a question ("left of this vertex?", "above this segment?") whose answers are the pieces. A
//! piece may come from several trapezoids, so the graph is no tree; that keeps its size linear.
//!
//! As in the [sweep](mod@twinedge_geometry::sweep), the walls lean a little, so that vertices are met in lexicographic order and
//! nothing is vertical. There are no special cases.
//!
//! *Cost.* On average over the orders, a segment cuts O(1) trapezoids, and the path to any fixed point has O(log n) questions,
//! for every drawing. The order follows a fixed pseudo-random sequence, so it is the same in every run; a drawing constructed
//! against this sequence could be slow, all others behave like the average.
//!
//! In a large drawing, memory access takes the time, and a random order jumps through memory. So points and segments are numbered
//! along a space-filling curve, and segments are inserted in rounds, each as large as all earlier rounds together. The round of a
//! segment is random; within a round segments follow the curve, so that successive segments are neighbours. A round puts O(1)
//! segments on average through a trapezoid of the earlier rounds, so it adds O(1) questions to a path, and all rounds add O(log
//! n). The points of a round are located together before it: neighbours share the path from the root.
//!
//! Rebuilding a deep graph would gain nothing: in a random order, the chance that any point takes more than 3 λ ln (n + 1)
//! questions is below 2 / (n + 1)^(0.22 λ − 3).
//!
//! Sources: M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, "Computational Geometry", 3rd edition, 2008, chapter 6 (after K.
//! Mulmuley, 1990, and R. Seidel, 1991); N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", Symposium on
//! Computational Geometry 2003, 211-219.

use super::lists::Lists;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::{Bounds, is_before};
use twinedge_geometry::predicates::{Orientation, orientation};
use twinedge_geometry::steps::count_step;

/// No vertex, or no trapezoid. Links of trapezoid 0 are written but meaningless.
const NO_VERTEX: u32 = u32::MAX;
const NOTHING: u32 = 0;

/// Distinct points, and segments that meet only at shared endpoints. Both are in the order of a space-filling curve.
pub(super) struct Drawing {
    pub(super) points: Vec<Point>,
    /// The numbers of the lower and the higher end, in lexicographic order.
    pub(super) segments: Vec<[u32; 2]>,
    /// The lower and the higher end of each segment.
    pub(super) ends: Vec<[Point; 2]>,
}

impl Drawing {
    fn side(&self, segment: u32, p: Point) -> Orientation {
        let [low, high] = self.ends[segment as usize];
        orientation(low, high, p)
    }
}

/// A node of the search graph. Its number is smaller than the numbers of its successors, so every search ends.
#[derive(Clone, Copy)]
pub(super) struct Node {
    /// For a question about a segment (is the point below or above?), its number. For a question about a vertex (left or right,
    /// lexicographically?), its number plus the number of segments. For a trapezoid, the total number of segments and vertices.
    pub(super) of: u32,
    /// The next node below, or on the left. For a trapezoid, its number.
    pub(super) below: u32,
    /// The next node above, or on the right. For a trapezoid, the segment below it, or the number of segments if there is none.
    pub(super) above: u32,
}

/// A trapezoid. Its neighbours share a wall with it and the segment above (or below): a linked list on each side of a segment.
#[derive(Clone, Copy)]
struct Trapezoid {
    node: u32,
    /// The vertex whose wall is the right side.
    right: u32,
    /// The neighbours to the left and right along the segment above.
    upper: [u32; 2],
    /// The neighbours to the left and right along the segment below.
    lower: [u32; 2],
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

/// The number of parts into which a group of points is divided when its paths diverge.
const PARTS: usize = 4;

pub(super) enum GraphError {
    TooLarge,
    /// The segments cannot have been disjoint.
    Clash,
}

/// The trapezoidal map of the points and segments inserted so far.
struct TrapezoidalMap<'a> {
    drawn: &'a Drawing,
    nodes: Vec<Node>,
    /// From number 1 on: one more than there are points with walls and segments.
    trapezoids: Vec<Trapezoid>,
    /// For each point, a node whose region contains it; for a point with walls, the trapezoid or question to its right.
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
    // A point is inserted with the first of its segments.
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
    // Vertices without segments come last, or later segments would cut their walls.
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
    fn insert(&mut self, segment: u32) -> Result<(), GraphError> {
        let [low, high] = self.drawn.segments[segment as usize];
        self.wall(high)?;
        self.wall(low)?;
        let first = self.find(low, Some(high));
        self.thread(segment, first)
    }

    /// Finds start nodes for all points that get their walls in this round, in ascending order.
    ///
    /// They are found in groups of neighbours: a group descends together while all of the box around it goes one way.
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

    /// Descends from a node while all of a box goes one way. Returns the last node, and whether it is a trapezoid.
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

    /// Returns the vertex number of a question about a vertex, or else a number too large.
    fn vertex(&self, node: Node) -> usize {
        (node.of as usize).wrapping_sub(self.drawn.segments.len())
    }

    /// Returns the trapezoid that contains a point without walls, or the trapezoid in which the way to another point, further
    /// right, begins. The next search for the point starts at the first question that depends on that way.
    fn find(&mut self, from: u32, to: Option<u32>) -> u32 {
        let p = self.drawn.points[from as usize];
        let mut at = self.starts[from as usize];
        // The first question whose answer depends on the other point.
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

    /// Adds the walls of a point, if it has none.
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

    /// Draws a segment through the trapezoids, from the right of its lower end to the left of its higher end.
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
    /// A wall survives on the side of the segment where its vertex is; on the other side, the pieces next to the wall are merged.
    /// Pieces reuse the numbers of the cut trapezoids.
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

    /// Turns a trapezoid's node into a question.
    fn ask(&mut self, at: u32, of: u32, [below, above]: [u32; 2]) {
        self.nodes[at as usize] = Node { of, below, above };
    }
}

/// Returns the numbers below n in an order that looks random (R. A. Fisher and F. Yates, 1938), but is the same in every run.
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

/// Divides the numbers below n at random into rounds, each as large as all earlier rounds together. Returns the round of each.
fn rounds(n: usize) -> Vec<u32> {
    // Round 0 has draw 0, and round r the draws from 2^(r - 1) to 2^r.
    shuffled(n).into_iter().map(|drawn| drawn.checked_ilog2().map_or(0, |last| last + 1)).collect()
}
