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
//! As in the [sweep](mod@crate::geometry::sweep), the walls lean a little, so that vertices are met in lexicographic order and
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

use super::bounds::Bounds;
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, count_step, orientation};

/// No segment, no vertex, no neighbour.
const NIL: u32 = u32::MAX;

/// A plane drawing: distinct points, and segments that meet at shared endpoints only. Both are numbered along a curve that fills
/// the plane.
pub(super) struct Drawn {
    pub(super) points: Vec<Point>,
    /// The numbers of the lower and the higher end, in lexicographic order.
    pub(super) segments: Vec<[u32; 2]>,
    /// The lower and the higher end of each segment.
    pub(super) ends: Vec<[Point; 2]>,
}

impl Drawn {
    /// On which side of a segment a point lies.
    fn side(&self, segment: u32, p: Point) -> Orientation {
        let [low, high] = self.ends[segment as usize];
        orientation(low, high, p)
    }
}

/// A node of the search graph. Its number is smaller than those of the nodes to which it leads, so every search ends.
#[derive(Clone, Copy)]
pub(super) enum Node {
    /// Is it left or right of this vertex, in the lexicographic sense?
    Point { vertex: u32, left: u32, right: u32 },
    /// Is it below or above this segment?
    Segment { segment: u32, below: u32, above: u32 },
    /// The query lies in this trapezoid.
    Trapezoid(Trapezoid),
}

/// A trapezoid. Its neighbours are those with which it shares a wall and the segment above (or below) it: so along each
/// side of a segment there is a list, linked both ways.
#[derive(Clone, Copy)]
pub(super) struct Trapezoid {
    /// The segment below.
    bottom: u32,
    /// The vertex whose wall is the right side.
    right: u32,
    /// To the left and to the right along the segment above.
    upper: [u32; 2],
    /// To the left and to the right along the segment below.
    lower: [u32; 2],
}

impl Trapezoid {
    /// The segment below, if there is one.
    pub(super) fn segment_below(&self) -> Option<u32> {
        Some(self.bottom).filter(|bottom| *bottom != NIL)
    }
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

/// Into how many groups the points of a group are parted that are to be found together.
const PARTS: usize = 4;

/// Why there is no search graph.
pub(super) enum GraphError {
    /// There are too many nodes.
    TooLarge,
    /// The segments cannot have been disjoint.
    Clash,
}

/// The trapezoidal map of what has been put in so far.
struct TrapezoidalMap<'a> {
    drawn: &'a Drawn,
    nodes: Vec<Node>,
    /// A node whose region holds the point; if the point has its walls, what is to the right of it. NIL before its round.
    starts: Vec<u32>,
    /// Which points have their walls.
    walled: Vec<bool>,
}

/// Builds the search graph; its root is the first node. Expected time O(n log n), memory O(n).
pub(super) fn search_graph(drawn: &Drawn) -> Result<Vec<Node>, GraphError> {
    let everything = Trapezoid { bottom: NIL, right: NIL, upper: [NIL; 2], lower: [NIL; 2] };
    let (points, segments) = (drawn.points.len(), drawn.segments.len());
    let mut nodes = Vec::with_capacity(2 * points + 6 * segments + 1);
    nodes.push(Node::Trapezoid(everything));
    let mut map = TrapezoidalMap { drawn, nodes, starts: vec![NIL; points], walled: vec![false; points] };
    for round in rounds(segments) {
        map.find_all(round.iter().flat_map(|segment| drawn.segments[*segment as usize]));
        for segment in round {
            map.insert(segment)?;
        }
    }
    // Vertices without segments come last: their walls would be cut by segments later on.
    for round in rounds(points) {
        map.find_all(round.iter().copied());
        for point in round {
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

    /// Finds nodes from which to start for all of some points that are to get their walls in this round.
    ///
    /// They are found in groups of neighbours: as far as all of a box around a group goes one way, the group goes it
    /// together.
    fn find_all(&mut self, points: impl Iterator<Item = u32>) {
        let mut fresh = Vec::new();
        for point in points {
            let start = &mut self.starts[point as usize];
            if *start == NIL {
                *start = 0;
                fresh.push(point);
            }
        }
        fresh.sort_unstable();
        let mut groups = vec![(&fresh[..], 0)];
        while let Some((group, from)) = groups.pop() {
            if let [point] = *group {
                self.starts[point as usize] = from;
                self.find(point, None);
                continue;
            }
            let Some(bounds) = Bounds::around(group.iter().map(|point| self.drawn.points[*point as usize])) else {
                continue;
            };
            let node = self.narrow(from, &bounds);
            if matches!(self.nodes[node as usize], Node::Trapezoid(_)) {
                for point in group {
                    self.starts[*point as usize] = node;
                }
            } else {
                groups.extend(group.chunks(group.len().div_ceil(PARTS)).map(|part| (part, node)));
            }
        }
    }

    /// Goes from a node as far as all of a box goes one way.
    fn narrow(&self, mut at: u32, bounds: &Bounds) -> u32 {
        loop {
            count_step();
            let next = match self.nodes[at as usize] {
                Node::Point { vertex, left, right } => {
                    let after = bounds.after(self.drawn.points[vertex as usize]);
                    after.map(|after| if after { right } else { left })
                }
                Node::Segment { segment, below, above } => {
                    bounds.above(self.drawn.ends[segment as usize]).map(|is_above| if is_above { above } else { below })
                }
                Node::Trapezoid(_) => None,
            };
            let Some(next) = next else { return at };
            at = next;
        }
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
            at = match self.nodes[at as usize] {
                Node::Point { vertex, left, right } => {
                    if compare_lexicographic(p, self.drawn.points[vertex as usize]).is_lt() { left } else { right }
                }
                Node::Segment { segment, below, above } => {
                    let side = match (self.drawn.side(segment, p), to) {
                        // Both start here.
                        (Orientation::Collinear, Some(to)) => {
                            start.get_or_insert(at);
                            self.drawn.side(segment, self.drawn.points[to as usize])
                        }
                        (side, _) => side,
                    };
                    if side == Orientation::CounterClockwise { above } else { below }
                }
                Node::Trapezoid(_) => {
                    self.starts[from as usize] = start.unwrap_or(at);
                    return at;
                }
            };
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
        let at = self.find(vertex, None);
        let old = self.trapezoid(at)?;
        let left = self.push(Trapezoid { right: vertex, ..old })?;
        let right = self.push(old)?;
        self.link_upper(old.upper[LEFT], left);
        self.link_lower(old.lower[LEFT], left);
        self.link_upper(left, right);
        self.link_lower(left, right);
        self.link_upper(right, old.upper[RIGHT]);
        self.link_lower(right, old.lower[RIGHT]);
        self.nodes[at as usize] = Node::Point { vertex, left, right };
        self.starts[vertex as usize] = right;
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
    /// A wall stays on that side of the segment where its vertex is; on the other, the pieces next to it become one.
    fn thread(&mut self, segment: u32, first: u32) -> Result<(), GraphError> {
        let end = self.drawn.segments[segment as usize][RIGHT];
        let mut at = first;
        // The pieces made last, and whether they go on.
        let (mut above, mut below) = (NIL, NIL);
        let (mut above_goes_on, mut below_goes_on) = (false, false);
        loop {
            count_step();
            let old = self.trapezoid(at)?;
            if above_goes_on {
                self.extend(above, old.right);
            } else {
                let new = self.push(Trapezoid { bottom: segment, lower: [NIL; 2], ..old })?;
                self.link_upper(old.upper[LEFT], new);
                self.link_lower(above, new);
                above = new;
            }
            self.link_upper(above, old.upper[RIGHT]);
            if below_goes_on {
                self.extend(below, old.right);
            } else {
                let new = self.push(Trapezoid { upper: [NIL; 2], ..old })?;
                self.link_lower(old.lower[LEFT], new);
                self.link_upper(below, new);
                below = new;
            }
            self.link_lower(below, old.lower[RIGHT]);
            self.nodes[at as usize] = Node::Segment { segment, below, above };
            if old.right == end {
                return Ok(());
            }
            let wall = *self.drawn.points.get(old.right as usize).ok_or(GraphError::Clash)?;
            below_goes_on = self.drawn.side(segment, wall) == Orientation::CounterClockwise;
            above_goes_on = !below_goes_on;
            at = if below_goes_on { old.lower[RIGHT] } else { old.upper[RIGHT] };
        }
    }

    fn push(&mut self, trapezoid: Trapezoid) -> Result<u32, GraphError> {
        let number = self.nodes.len();
        if number >= 1 << 31 {
            return Err(GraphError::TooLarge);
        }
        self.nodes.push(Node::Trapezoid(trapezoid));
        Ok(number as u32)
    }

    fn trapezoid(&self, at: u32) -> Result<Trapezoid, GraphError> {
        match self.nodes.get(at as usize) {
            Some(Node::Trapezoid(trapezoid)) => Ok(*trapezoid),
            _ => Err(GraphError::Clash),
        }
    }

    fn trapezoid_mut(&mut self, at: u32) -> Option<&mut Trapezoid> {
        match self.nodes.get_mut(at as usize) {
            Some(Node::Trapezoid(trapezoid)) => Some(trapezoid),
            _ => None,
        }
    }

    /// Makes a trapezoid go on to another wall.
    fn extend(&mut self, at: u32, right: u32) {
        if let Some(trapezoid) = self.trapezoid_mut(at) {
            trapezoid.right = right;
        }
    }

    /// Makes two trapezoids neighbours along the segment above both; one of them may be NIL.
    fn link_upper(&mut self, left: u32, right: u32) {
        if let Some(trapezoid) = self.trapezoid_mut(left) {
            trapezoid.upper[RIGHT] = right;
        }
        if let Some(trapezoid) = self.trapezoid_mut(right) {
            trapezoid.upper[LEFT] = left;
        }
    }

    /// Makes two trapezoids neighbours along the segment below both; one of them may be NIL.
    fn link_lower(&mut self, left: u32, right: u32) {
        if let Some(trapezoid) = self.trapezoid_mut(left) {
            trapezoid.lower[RIGHT] = right;
        }
        if let Some(trapezoid) = self.trapezoid_mut(right) {
            trapezoid.lower[LEFT] = left;
        }
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

/// Parts the numbers below n at random in rounds, each of as many as all before it, and in ascending order.
fn rounds(n: usize) -> Vec<Vec<u32>> {
    let count = n.checked_ilog2().map_or(0, |last| last + 2);
    let mut rounds: Vec<Vec<u32>> = (0..count).map(|round| Vec::with_capacity(1 << round.saturating_sub(1))).collect();
    for (number, drawn) in (0..).zip(shuffled(n)) {
        // Round 0 has what was drawn first, and round r the draws from 2^(r - 1) to 2^r.
        rounds[drawn.checked_ilog2().map_or(0, |last| last as usize + 1)].push(number);
    }
    rounds
}
