//! Edges, isolated vertices and starts in separate R-trees: validation does not rely on any index of the structure.

use super::drawn::{Drawn, InnerStart, Thing, Update};
use rstar::{AABB, ParentNode, RTree, RTreeNode, RTreeObject};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_geometry::steps::count_step;

fn exchange<T: RTreeObject<Envelope = AABB<[f64; 2]>> + PartialEq + Copy>(tree: &mut RTree<T>, gone: &[T], come: &[T]) {
    for one in gone {
        tree.remove(one);
    }
    for one in come {
        tree.insert(*one);
    }
}

/// All edges and isolated vertices, and the starting points of inner boundary components.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnTrees {
    drawn: RTree<Drawn>,
    starts: RTree<InnerStart>,
}

impl DrawnTrees {
    /// Builds the trees from the added entries of an update. O(n log n).
    pub(super) fn new(Update { drawn, starts }: Update) -> Self {
        Self { drawn: RTree::bulk_load(drawn.come), starts: RTree::bulk_load(starts.come) }
    }

    /// Applies an update. O(k log n), plus the cost of finding the removed entries in an R-tree.
    pub(super) fn apply(&mut self, Update { drawn, starts }: &Update) {
        exchange(&mut self.drawn, &drawn.gone, &drawn.come);
        exchange(&mut self.starts, &starts.gone, &starts.come);
    }

    pub(super) fn undo(&mut self, Update { drawn, starts }: &Update) {
        exchange(&mut self.drawn, &drawn.come, &drawn.gone);
        exchange(&mut self.starts, &starts.come, &starts.gone);
    }

    /// Returns all entries whose boxes meet the box of another entry.
    pub(super) fn beside(&self, drawn: &Drawn) -> impl Iterator<Item = &Drawn> {
        self.drawn.locate_in_envelope_intersecting(drawn.envelope()).inspect(|_| count_step())
    }

    /// Returns the inner boundary components that start in a closed box.
    pub(super) fn starts_in(&self, envelope: AABB<[f64; 2]>) -> impl Iterator<Item = usize> {
        let all = self.starts.locate_in_envelope(envelope);
        all.inspect(|_| count_step()).map(|start| start.data as usize)
    }

    /// Returns the highest edge straight below a point, and whether its half-edge runs from its smaller end to the larger. The
    /// point must be lexicographically smaller than its neighbours. Returns `None` if there is no edge below.
    pub(super) fn below(&self, p: Point) -> Option<(usize, bool)> {
        let mut best: Option<&Drawn> = None;
        // Boxes entirely below the lower end of the best edge so far cannot contain a higher one.
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
            // The highest box comes next.
            nodes[from..].sort_by(|a, b| {
                let top = |node: &ParentNode<Drawn>| node.envelope().upper()[1].min(p.y);
                top(a).total_cmp(&top(b)).then(a.envelope().lower()[1].total_cmp(&b.envelope().lower()[1]))
            });
        }
        let Drawn { thing: Thing::Edge(h), ends: [a, b], .. } = *best? else { return None };
        Some((h as usize, compare_lexicographic(a, b).is_lt()))
    }
}
