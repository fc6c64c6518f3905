//! The boxes around edges and isolated vertices, in an R-tree, and those that a line meets.

use super::QueryLine;
use super::line::{Event, Line};
use crate::dcel::Vertex;
use crate::geometry::Point;
use crate::geometry::predicates::Orientation;
use crate::map::PlanarMap;
use crate::validate::Embedding;
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};

/// The tree.
pub(in crate::map) struct Boxes {
    tree: RTree<Boxed>,
}

/// An edge, by the index of one of its half-edges, or an isolated vertex, by its own.
#[derive(Clone, Copy)]
enum What {
    Edge(u32),
    Vertex(u32),
}

/// With its ends, so that the map need be asked only about what is met.
struct Boxed {
    what: What,
    ends: [Point; 2],
}

impl RTreeObject for Boxed {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b] = self.ends.map(<[f64; 2]>::from);
        AABB::from_corners(a, b)
    }
}

impl Boxes {
    /// O(n log n).
    pub(in crate::map) fn new(map: &PlanarMap) -> Self {
        let place = |v: Vertex<'_>| map.point(v.index());
        let edges = map
            .dcel()
            .edges()
            .map(|h| Boxed { what: What::Edge(h.index() as u32), ends: [place(h.origin()), place(h.target())] });
        let isolated = map
            .dcel()
            .boundaries()
            .filter_map(|b| b.isolated_vertex())
            .map(|v| Boxed { what: What::Vertex(v.index() as u32), ends: [place(v); 2] });
        Self { tree: RTree::bulk_load(edges.chain(isolated).collect()) }
    }

    /// Finds everything that the line of a stretch meets in one point, and that the stretch may meet; some of it twice.
    pub(super) fn each_event<'m>(
        &self,
        map: &'m PlanarMap,
        line: &Line,
        stretch: &QueryLine,
        mut visit: impl FnMut(Event<'m>),
    ) {
        let dcel = map.dcel();
        for boxed in self.tree.locate_with_selection_function(Selection::new(line, stretch)) {
            match boxed.what {
                What::Vertex(_) if line.side(boxed.ends[0]) != Orientation::Collinear => {}
                What::Vertex(vertex) => {
                    if let Some(vertex) = dcel.vertex_at(vertex as usize) {
                        visit(Line::at(map, vertex));
                    }
                }
                What::Edge(half_edge) => {
                    let Some(h) = dcel.half_edge_at(half_edge as usize) else { continue };
                    let [origin, target] = boxed.ends.map(|p| (p, line.side(p)));
                    if origin.1 == Orientation::Collinear {
                        visit(Line::at(map, h.origin()));
                    }
                    if target.1 == Orientation::Collinear {
                        visit(Line::at(map, h.target()));
                    }
                    if let Some(event) = Line::crossing(h, origin, target) {
                        visit(event);
                    }
                }
            }
        }
    }
}

/// Selects the boxes that a stretch meets, and perhaps some that it just misses: what is in them is asked exactly.
struct Selection {
    from: Point,
    /// The direction of the line.
    direction: [f64; 2],
    /// The box around the stretch, perhaps infinite.
    around: AABB<[f64; 2]>,
    /// Whether the line rises to the right, or falls to the left.
    rises: bool,
}

impl Selection {
    fn new(line: &Line, stretch: &QueryLine) -> Self {
        let Line { from, through } = *line;
        // From where to where, in one coordinate.
        let range = |from: f64, through: f64| {
            let (grows, falls) = (from < through, from > through);
            let (low_end, high_end) = match stretch {
                QueryLine::Segment(..) => return [from.min(through), from.max(through)],
                QueryLine::Ray(..) => (!falls, !grows),
                QueryLine::Line(..) => (!falls && !grows, !falls && !grows),
            };
            [if low_end { from } else { f64::NEG_INFINITY }, if high_end { from } else { f64::INFINITY }]
        };
        let ([left, right], [bottom, top]) = (range(from.x, through.x), range(from.y, through.y));
        let around = AABB::from_corners([left, bottom], [right, top]);
        let direction = [through.x - from.x, through.y - from.y];
        Self { from, direction, around, rises: (from.x <= through.x) == (from.y <= through.y) }
    }

    /// Whether two points may be on different sides of the line, or on it.
    ///
    /// Each difference and product is off by at most one part in 2^53, so a side of which the rounded value is so clear is
    /// the right one; most boxes are far away, and need no exact arithmetic.
    fn may_part(&self, a: Point, b: Point) -> bool {
        let [dx, dy] = self.direction;
        let [(a, slack_of_a), (b, slack_of_b)] = [a, b].map(|p| {
            let (left, right) = (dx * (p.y - self.from.y), dy * (p.x - self.from.x));
            (left - right, 1e-15 * (left.abs() + right.abs()))
        });
        !(a > slack_of_a && b > slack_of_b || a < -slack_of_a && b < -slack_of_b)
    }

    fn is_near(&self, [left, bottom]: [f64; 2], [right, top]: [f64; 2]) -> bool {
        let ([first, lowest], [last, highest]) = (self.around.lower(), self.around.upper());
        first <= right && left <= last && lowest <= top && bottom <= highest
    }
}

impl SelectionFunction<Boxed> for Selection {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 2]>) -> bool {
        let (min, max) = (envelope.lower(), envelope.upper());
        // The corners furthest from the line on either side, in one order or the other.
        let (one, other) = if self.rises { ([min[0], max[1]], [max[0], min[1]]) } else { (min, max) };
        self.is_near(min, max) && self.may_part(Point::from(one), Point::from(other))
    }

    fn should_unpack_leaf(&self, leaf: &Boxed) -> bool {
        let envelope = leaf.envelope();
        self.is_near(envelope.lower(), envelope.upper()) && self.may_part(leaf.ends[0], leaf.ends[1])
    }
}
