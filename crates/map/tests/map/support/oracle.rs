//! Slow and obvious results in whole numbers, by trying every vertex, edge and face.

use std::collections::HashMap;
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_map::{Located, PlanarMap, QueryLine, ZoneElement};

/// A point with whole coordinates.
pub(crate) type Whole = [i128; 2];

/// A fraction with a positive denominator.
type Fraction = (i128, i128);

/// The coordinates of a point, which must be whole.
#[expect(clippy::cast_possible_truncation, reason = "they are whole")]
pub(crate) fn whole(p: Point) -> Whole {
    assert!(p.x.fract() == 0.0 && p.y.fract() == 0.0);
    [p.x as i128, p.y as i128]
}

fn minus(a: Whole, b: Whole) -> Whole {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: Whole, b: Whole) -> i128 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: Whole, b: Whole) -> i128 {
    a[0] * b[0] + a[1] * b[1]
}

fn times(a: Whole, factor: i128) -> Whole {
    a.map(|c| c * factor)
}

/// A map as lists.
pub(crate) struct Plain {
    vertices: Vec<(VertexKey, Whole)>,
    half_edges: Vec<HalfEdge>,
    unbounded: FaceKey,
}

struct HalfEdge {
    key: HalfEdgeKey,
    face: FaceKey,
    origin: Whole,
    target: Whole,
}

impl Plain {
    pub(crate) fn new(map: &PlanarMap) -> Self {
        let at = |v: twinedge::dcel::Vertex<'_>| whole(map.position(v.key()).expect("of this map"));
        Self {
            vertices: map.dcel().vertices().map(|v| (v.key(), at(v))).collect(),
            half_edges: map
                .dcel()
                .half_edges()
                .map(|h| HalfEdge {
                    key: h.key(),
                    face: h.face().key(),
                    origin: at(h.origin()),
                    target: at(h.target()),
                })
                .collect(),
            unbounded: map.dcel().unbounded_face().key(),
        }
    }

    /// The location of the point with these coordinates over the scale. An edge is named by the half-edge that runs to the right,
    /// or straight up.
    pub(crate) fn locate(&self, p: Whole, scale: i128) -> Located {
        if let Some((key, _)) = self.vertices.iter().find(|(_, at)| times(*at, scale) == p) {
            return Located::Vertex(*key);
        }
        let mut crossed: HashMap<FaceKey, usize> = HashMap::new();
        for h in &self.half_edges {
            let (a, b) = (times(h.origin, scale), times(h.target, scale));
            let turn = cross(minus(b, a), minus(p, a));
            if turn == 0 && dot(minus(a, p), minus(b, p)) < 0 && a < b {
                return Located::Edge(h.key);
            }
            // A ray straight up crosses the edge; ends to its left count as right of it.
            if (a[0] < p[0]) != (b[0] < p[0]) && (turn < 0) == (a[0] < b[0]) {
                *crossed.entry(h.face).or_default() += 1;
            }
        }
        let mut inside = crossed.into_iter().filter(|(face, count)| count % 2 == 1 && *face != self.unbounded);
        let face = inside.next().map_or(self.unbounded, |(face, _)| face);
        assert!(inside.next().is_none(), "a point is in one face");
        Located::Face(face)
    }

    /// Returns the zone of a stretch: cuts it at every contact, and locates the cuts and the middles of the pieces.
    pub(crate) fn zone(&self, stretch: &QueryLine) -> Vec<ZoneElement> {
        let (QueryLine::Segment(from, to) | QueryLine::Ray(from, to) | QueryLine::Line(from, to)) = *stretch;
        let (from, to) = (whole(from), whole(to));
        let way = minus(to, from);
        let compare = |a: &Fraction, b: &Fraction| (a.0 * b.1).cmp(&(b.0 * a.1));

        let mut cuts: Vec<Fraction> = Vec::new();
        for (_, at) in &self.vertices {
            if cross(way, minus(*at, from)) == 0 {
                cuts.push((dot(minus(*at, from), way), dot(way, way)));
            }
        }
        for h in &self.half_edges {
            let edge = minus(h.target, h.origin);
            let [a, b] = [h.origin, h.target].map(|end| cross(way, minus(end, from)).signum());
            if a * b < 0 {
                let (n, d) = (cross(minus(h.origin, from), edge), cross(way, edge));
                cuts.push((n * d.signum(), d.abs()));
            }
        }
        match stretch {
            QueryLine::Segment(..) => {
                cuts.extend([(0, 1), (1, 1)]);
                cuts.retain(|(n, d)| (0..=*d).contains(n));
            }
            QueryLine::Ray(..) => {
                cuts.push((0, 1));
                cuts.retain(|(n, _)| *n >= 0);
            }
            QueryLine::Line(..) => {}
        }
        cuts.sort_by(compare);
        cuts.dedup_by(|a, b| compare(a, b).is_eq());

        let locate = |(n, d): Fraction| {
            let p = times(from, d);
            self.locate([p[0] + n * way[0], p[1] + n * way[1]], d)
        };
        let piece = |t: Fraction| match locate(t) {
            Located::Face(face) => ZoneElement::Face(face),
            Located::Edge(key) => ZoneElement::Along(self.directed(key, |edge| dot(edge, way) > 0)),
            Located::Vertex(_) => panic!("there would be a cut"),
        };
        let mut met = Vec::new();
        match (stretch, cuts.first()) {
            (QueryLine::Line(..), None) => met.push(piece((0, 1))),
            (QueryLine::Line(..), Some((n, d))) => met.push(piece((n - d, *d))),
            _ => {}
        }
        for (i, &(n, d)) in cuts.iter().enumerate() {
            match locate((n, d)) {
                Located::Vertex(vertex) => met.push(ZoneElement::Vertex(vertex)),
                Located::Edge(key) => {
                    // An end inside an edge along which it runs is no cut.
                    if cross(way, self.edge(key)) != 0 {
                        met.push(ZoneElement::Edge(self.directed(key, |edge| cross(way, edge) < 0)));
                    }
                }
                Located::Face(_) => {}
            }
            match cuts.get(i + 1) {
                Some((m, e)) => met.push(piece((n * e + m * d, 2 * d * e))),
                None if matches!(stretch, QueryLine::Segment(..)) => {}
                None => met.push(piece((n + d, d))),
            }
        }
        met
    }

    fn edge(&self, key: HalfEdgeKey) -> Whole {
        let h = self.half_edges.iter().find(|h| h.key == key).expect("of this map");
        minus(h.target, h.origin)
    }

    /// Returns the half-edge of an edge with this direction.
    fn directed(&self, key: HalfEdgeKey, direction: impl Fn(Whole) -> bool) -> HalfEdgeKey {
        let h = self.half_edges.iter().find(|h| h.key == key).expect("of this map");
        let is_it = |other: &&HalfEdge| {
            let ends = (other.origin, other.target);
            (ends == (h.origin, h.target) || ends == (h.target, h.origin))
                && direction(minus(other.target, other.origin))
        };
        self.half_edges.iter().find(is_it).expect("one of the two has it").key
    }
}
