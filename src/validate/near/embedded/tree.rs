//! What is drawn, in R-trees of its own: no index that the structure keeps has a part in its validation.

use super::drawing::{Drawing, Line, Time, Update};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, count_step, orientation};
use core::cmp::Ordering;
use rstar::{AABB, ParentNode, RTree, RTreeNode, RTreeObject};

/// An edge, by the smaller of its half-edges, or an isolated vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thing {
    Edge(u32),
    Vertex(u32),
}

/// An edge or isolated vertex, and where its ends lie.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drawn {
    pub(super) thing: Thing,
    pub(super) vertices: [u32; 2],
    pub(super) ends: [Point; 2],
}

impl Drawn {
    pub(super) fn edge(h: usize, line: Line) -> Self {
        Self { thing: Thing::Edge(h as u32), vertices: line.vertices, ends: line.points }
    }

    pub(super) fn vertex(v: usize, at: Point) -> Self {
        Self { thing: Thing::Vertex(v as u32), vertices: [v as u32; 2], ends: [at; 2] }
    }

    /// From the lexicographically smaller end to the larger.
    fn rising(&self) -> [Point; 2] {
        let [a, b] = self.ends;
        if compare_lexicographic(a, b).is_gt() { [b, a] } else { [a, b] }
    }

    /// Whether it passes below a point, where the sweep line through that point has it between its ends.
    fn passes_below(&self, p: Point) -> bool {
        let [low, high] = self.rising();
        let spans = compare_lexicographic(low, p).is_lt() && compare_lexicographic(p, high).is_lt();
        spans && orientation(low, high, p) == Orientation::CounterClockwise
    }

    /// Of two that a sweep line meets, and that meet at most at an end, whether this is above.
    fn is_above(&self, other: &Self) -> bool {
        let ([low, high], [other_low, other_high]) = (self.rising(), other.rising());
        match compare_lexicographic(low, other_low) {
            Ordering::Less => orientation(low, high, other_low) == Orientation::Clockwise,
            Ordering::Equal => orientation(low, high, other_high) == Orientation::Clockwise,
            Ordering::Greater => orientation(other_low, other_high, low) == Orientation::CounterClockwise,
        }
    }
}

impl RTreeObject for Drawn {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b] = self.ends.map(<[f64; 2]>::from);
        AABB::from_corners(a, b)
    }
}

/// An inner boundary component, by the place where it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Start {
    pub(super) label: u32,
    pub(super) at: Point,
}

impl RTreeObject for Start {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_point(self.at.into())
    }
}

fn exchange<T: RTreeObject<Envelope = AABB<[f64; 2]>> + PartialEq + Copy>(tree: &mut RTree<T>, gone: &[T], come: &[T]) {
    for one in gone {
        tree.remove(one);
    }
    for one in come {
        tree.insert(*one);
    }
}

/// All edges and isolated vertices, and the places where inner boundary components start.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnTrees {
    drawn: RTree<Drawn>,
    starts: RTree<Start>,
}

impl DrawnTrees {
    /// Of all that an update brings. O(n log n).
    pub(super) fn new(update: Update) -> Self {
        Self { drawn: RTree::bulk_load(update.come), starts: RTree::bulk_load(update.starts_come) }
    }

    /// O(k log n), and what an R-tree takes to find what goes.
    pub(super) fn apply(&mut self, update: &Update) {
        exchange(&mut self.drawn, &update.gone, &update.come);
        exchange(&mut self.starts, &update.starts_gone, &update.starts_come);
    }

    /// Takes an update back.
    pub(super) fn undo(&mut self, update: &Update) {
        exchange(&mut self.drawn, &update.come, &update.gone);
        exchange(&mut self.starts, &update.starts_come, &update.starts_gone);
    }

    /// What has a box that meets the box of another.
    pub(super) fn beside(&self, drawn: &Drawn) -> impl Iterator<Item = &Drawn> {
        self.drawn.locate_in_envelope_intersecting(drawn.envelope()).inspect(|_| count_step())
    }

    /// The inner boundary components that start in a closed box.
    pub(super) fn starts_in(&self, [low, high]: [Point; 2]) -> impl Iterator<Item = usize> {
        let all = self.starts.locate_in_envelope(AABB::from_corners(low.into(), high.into()));
        all.inspect(|_| count_step()).map(|start| start.label as usize)
    }

    /// The half-edge that has the region just below a point to its left, of a point that is lexicographically smaller than all that
    /// it is joined to: of the edges straight below it the highest, from its smaller end to the larger. None if there is none.
    pub(super) fn below(&self, p: Point, drawing: &Drawing<'_>) -> Option<usize> {
        let mut best: Option<&Drawn> = None;
        // None of what is lower than the lower end of the best so far is above that.
        let floor = |best: Option<&Drawn>| best.map_or(f64::NEG_INFINITY, |best| best.ends[0].y.min(best.ends[1].y));
        let mut nodes: Vec<&ParentNode<Drawn>> = vec![self.drawn.root()];
        while let Some(node) = nodes.pop() {
            if node.envelope().upper()[1] < floor(best) {
                continue;
            }
            let from = nodes.len();
            for child in node.children() {
                count_step();
                let (low, high) = (child.envelope().lower(), child.envelope().upper());
                if p.x < low[0] || high[0] < p.x || p.y < low[1] || high[1] < floor(best) {
                    continue;
                }
                match child {
                    RTreeNode::Parent(node) => nodes.push(node),
                    RTreeNode::Leaf(drawn) => {
                        let passes = matches!(drawn.thing, Thing::Edge(_)) && drawn.passes_below(p);
                        if passes && best.is_none_or(|best| drawn.is_above(best)) {
                            best = Some(drawn);
                        }
                    }
                }
            }
            // The highest comes next.
            nodes[from..].sort_by(|a, b| {
                let top = |node: &ParentNode<Drawn>| node.envelope().upper()[1].min(p.y);
                top(a).total_cmp(&top(b)).then(a.envelope().lower()[1].total_cmp(&b.envelope().lower()[1]))
            });
        }
        let Drawn { thing: Thing::Edge(h), ends: [a, b], .. } = *best? else { return None };
        if compare_lexicographic(a, b).is_lt() { Some(h as usize) } else { drawing.twin(Time::After, h as usize) }
    }
}
