//! The boxes around the edges and isolated vertices of a map, in an R-tree.

use rstar::{AABB, Envelope, PointDistance, RTree, RTreeNode, RTreeObject, SelectionFunction};
use twinedge::dcel::{HalfEdge, Vertex};
use twinedge_geometry::Point;

/// Edges and isolated vertices by the boxes around them.
#[derive(Clone)]
pub(super) struct RecordTree {
    tree: RTree<BoxedRecord>,
}

/// An edge, by the smaller index of its half-edges, or an isolated vertex, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum TreeRecord {
    Edge(u32),
    Vertex(u32),
}

/// An edge or isolated vertex with its ends, so that the map is accessed only for records that are met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BoxedRecord {
    pub(crate) record: TreeRecord,
    pub(crate) ends: [Point; 2],
}

impl BoxedRecord {
    pub(super) fn edge(h: HalfEdge<'_>, points: &[Point]) -> Self {
        let h = if h.index() < h.twin().index() { h } else { h.twin() };
        let ends = [h.origin(), h.target()].map(|v| points[v.index()]);
        Self { record: TreeRecord::Edge(h.index() as u32), ends }
    }

    pub(super) fn vertex(v: Vertex<'_>, points: &[Point]) -> Self {
        Self { record: TreeRecord::Vertex(v.index() as u32), ends: [points[v.index()]; 2] }
    }
}

impl BoxedRecord {
    /// Returns the approximate position (0 to 1, or NaN) of a point's projection on the segment.
    fn along(&self, p: Point) -> f64 {
        let [a, b] = self.ends;
        let (x, y) = (b.x - a.x, b.y - a.y);
        (((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y)).clamp(0.0, 1.0)
    }

    /// Returns the end that is nearer to a point, approximately.
    pub(crate) fn nearest_end(&self, p: Point) -> Point {
        self.ends[usize::from(self.along(p) > 0.5)]
    }

    /// Returns a point about as far behind the edge as the given point is before it, or `None` if an end is nearest.
    pub(crate) fn across(&self, p: Point) -> Option<Point> {
        let [a, b] = self.ends;
        let along = self.along(p);
        let on = Point::new(a.x + (b.x - a.x) * along, a.y + (b.y - a.y) * along);
        (along > 0.0 && along < 1.0).then(|| Point::new(2.0 * on.x - p.x, 2.0 * on.y - p.y))
    }
}

impl PointDistance for BoxedRecord {
    fn distance_2(&self, point: &[f64; 2]) -> f64 {
        let p = Point::from(*point);
        let [a, b] = self.ends;
        // An isolated vertex has no direction.
        let along = Some(self.along(p)).filter(|along| !along.is_nan()).unwrap_or(0.0);
        let (x, y) = (a.x + (b.x - a.x) * along - p.x, a.y + (b.y - a.y) * along - p.y);
        x * x + y * y
    }
}

impl RTreeObject for BoxedRecord {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b] = self.ends.map(<[f64; 2]>::from);
        AABB::from_corners(a, b)
    }
}

impl RecordTree {
    /// O(n log n).
    pub(super) fn new(records: Vec<BoxedRecord>) -> Self {
        Self { tree: RTree::bulk_load(records) }
    }

    /// O(log n).
    pub(super) fn insert(&mut self, record: BoxedRecord) {
        self.tree.insert(record);
    }

    /// Removes a record. Returns false if it was absent. O(log n), plus the time to find it in an R-tree.
    pub(super) fn remove(&mut self, record: &BoxedRecord) -> bool {
        self.tree.remove(record).is_some()
    }

    /// Returns the records whose boxes match a selection.
    pub(super) fn select(&self, selection: impl SelectionFunction<BoxedRecord>) -> impl Iterator<Item = &BoxedRecord> {
        self.tree.locate_with_selection_function(selection)
    }

    pub(super) fn in_box(&self, low: Point, high: Point) -> impl Iterator<Item = &BoxedRecord> {
        self.tree.locate_in_envelope_intersecting(AABB::from_corners(low.into(), high.into()))
    }

    /// Returns a record near a point, if there are any: descends into the nearest box at each level. O(log n).
    pub(super) fn near(&self, p: Point) -> Option<&BoxedRecord> {
        let p = <[f64; 2]>::from(p);
        let mut node = self.tree.root();
        loop {
            // Among boxes that contain the point, the box whose middle is nearest.
            let distance = |child: &RTreeNode<BoxedRecord>| match child {
                RTreeNode::Leaf(record) => [record.distance_2(&p), 0.0],
                RTreeNode::Parent(node) => {
                    let [x, y] = node.envelope().center();
                    [node.envelope().distance_2(&p), (x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1])]
                }
            };
            let closer = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
            let children = node.children().iter().map(|child| (distance(child), child));
            match children.min_by(|(a, _), (b, _)| closer(a, b))?.1 {
                RTreeNode::Leaf(record) => return Some(record),
                RTreeNode::Parent(nearest) => node = nearest,
            }
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &BoxedRecord> {
        self.tree.iter()
    }
}
