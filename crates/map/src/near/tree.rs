//! Edges, isolated vertices and starts, in R-trees of their own: no index that the structure keeps has a part in its validation.

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

/// All edges and isolated vertices, and the places where inner boundary components start.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnTrees {
    drawn: RTree<Drawn>,
    starts: RTree<InnerStart>,
}

impl DrawnTrees {
    /// Of all that an update brings. O(n log n).
    pub(super) fn new(Update { drawn, starts }: Update) -> Self {
        Self { drawn: RTree::bulk_load(drawn.come), starts: RTree::bulk_load(starts.come) }
    }

    /// O(k log n), and what an R-tree takes to find what goes.
    pub(super) fn apply(&mut self, Update { drawn, starts }: &Update) {
        exchange(&mut self.drawn, &drawn.gone, &drawn.come);
        exchange(&mut self.starts, &starts.gone, &starts.come);
    }

    /// Takes an update back.
    pub(super) fn undo(&mut self, Update { drawn, starts }: &Update) {
        exchange(&mut self.drawn, &drawn.come, &drawn.gone);
        exchange(&mut self.starts, &starts.come, &starts.gone);
    }

    /// All whose boxes meet the box of another.
    pub(super) fn beside(&self, drawn: &Drawn) -> impl Iterator<Item = &Drawn> {
        self.drawn.locate_in_envelope_intersecting(drawn.envelope()).inspect(|_| count_step())
    }

    /// The inner boundary components that start in a closed box.
    pub(super) fn starts_in(&self, envelope: AABB<[f64; 2]>) -> impl Iterator<Item = usize> {
        let all = self.starts.locate_in_envelope(envelope);
        all.inspect(|_| count_step()).map(|start| start.data as usize)
    }

    /// Of the edges straight below a point that is lexicographically smaller than all that it is joined to, the highest, and whether
    /// its half-edge leads from its smaller end to the larger. None if there is none.
    pub(super) fn below(&self, p: Point) -> Option<(usize, bool)> {
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
        Some((h as usize, compare_lexicographic(a, b).is_lt()))
    }
}
