//! Selection of the records that a line may meet, in an R-tree.

use super::QueryLine;
use super::line::{Line, LineEvent};
use crate::index::{BoxedRecord, TreeRecord};
use crate::planar_map::PlanarMap;
use rstar::{AABB, RTreeObject, SelectionFunction};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::Orientation;

/// Visits every record that the line meets in one point and whose box the query meets. Some records are visited twice, and some
/// may lie beyond the ends of the query. The edges of hubs at certain points may be left out.
pub(crate) fn each_event<'m>(
    map: &'m PlanarMap,
    line: &Line,
    query: &QueryLine,
    but_hubs_at: [Option<Point>; 2],
    mut visit: impl FnMut(LineEvent<'m>),
) {
    let dcel = map.dcel();
    for boxed in map.index().select(Selection::new(line, query), but_hubs_at) {
        match boxed.record {
            TreeRecord::Vertex(_) if line.side(boxed.ends[0]) != Orientation::Collinear => {}
            TreeRecord::Vertex(vertex) => {
                if let Some(vertex) = dcel.vertex_at(vertex as usize) {
                    visit(Line::at(map, vertex));
                }
            }
            TreeRecord::Edge(half_edge) => {
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

/// Selects all boxes that a query meets, and perhaps a few that it narrowly misses; their contents are tested exactly afterwards.
#[derive(Clone)]
struct Selection {
    from: Point,
    direction: [f64; 2],
    /// The box around the query, perhaps infinite.
    around: AABB<[f64; 2]>,
    /// True if the line rises to the right, or falls to the left.
    rises: bool,
}

impl Selection {
    fn new(line: &Line, query: &QueryLine) -> Self {
        let Line { from, through } = *line;
        // The range of the query in one coordinate.
        let range = |from: f64, through: f64| {
            let (grows, falls) = (from < through, from > through);
            let (low_end, high_end) = match query {
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

    /// Returns true if two points may be on different sides of the line, or on it.
    ///
    /// Each difference and product has a relative error of at most 2^-53, so a rounded value beyond the slack has the correct
    /// sign. Most boxes are far away and need no exact arithmetic.
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

impl SelectionFunction<BoxedRecord> for Selection {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 2]>) -> bool {
        let (min, max) = (envelope.lower(), envelope.upper());
        // The corners furthest from the line on either side, in one order or the other.
        let (one, other) = if self.rises { ([min[0], max[1]], [max[0], min[1]]) } else { (min, max) };
        self.is_near(min, max) && self.may_part(Point::from(one), Point::from(other))
    }

    fn should_unpack_leaf(&self, leaf: &BoxedRecord) -> bool {
        let envelope = leaf.envelope();
        self.is_near(envelope.lower(), envelope.upper()) && self.may_part(leaf.ends[0], leaf.ends[1])
    }
}
