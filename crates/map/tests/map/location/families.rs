//! Families of maps that are hard for one index or another.

use crate::location::maps::{Random, build};
use twinedge_geometry::Point;
use twinedge_map::{Located, PlanarMap, QueryLine, ZoneElement};

type Segments = Vec<[[f64; 2]; 2]>;

fn map(segments: &Segments) -> PlanarMap {
    let points: Vec<Point> = segments.iter().flatten().copied().map(Point::from).collect();
    let ends: Vec<[u32; 2]> = (0..segments.len() as u32).map(|i| [2 * i, 2 * i + 1]).collect();
    let map = build(&points, &ends);
    assert!(map.is_plane());
    map
}

/// Every end is found, and so are the points directly above and below the middle of every segment.
fn check(segments: &Segments) {
    let map = map(segments);
    for [a, b] in segments {
        assert!(matches!(map.locate(Point::from(*a)).unwrap(), Located::Vertex(_)));
        assert!(matches!(map.locate(Point::from(*b)).unwrap(), Located::Vertex(_)));
    }
    let mut random = Random(9);
    for _ in 0..20 {
        let [a, b] = segments[random.index(segments.len())];
        let middle = Point::new(f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1]));
        let from = Point::from(segments[random.index(segments.len())][0]);
        if from == middle {
            continue;
        }
        // The last element of a zone is the location of its end.
        let zone = map.zone(&QueryLine::Segment(from, middle)).unwrap();
        let last = match *zone.last().unwrap() {
            ZoneElement::Face(f) => Located::Face(f),
            ZoneElement::Vertex(v) => Located::Vertex(v),
            ZoneElement::Edge(h) | ZoneElement::Along(h) => {
                let h = map.dcel().half_edge(h).unwrap();
                let [p, q] = [h, h.twin()].map(|h| map.position(h.origin().key()).unwrap());
                Located::Edge(if p < q { h.key() } else { h.twin().key() })
            }
        };
        assert_eq!(map.locate(middle), Ok(last));
    }
}

#[test]
fn fans() {
    check(&(0..1000).map(|i| [[0.0, 0.0], [1.0, f64::from(i)]]).collect());
    check(&(0..1000).map(|i| [[0.0, 0.0], [-f64::from(i), 1.0]]).collect());
}

#[test]
fn long_parallels() {
    check(&(0..1000).map(|i| [[f64::from(i), 0.0], [1e6 + f64::from(i), 1e6]]).collect());
    check(&(0..1000).map(|i| [[0.0, f64::from(i)], [1e9, f64::from(i) + 0.5]]).collect());
    check(&(0..1000).map(|i| [[f64::from(i), 0.0], [f64::from(i), 1e9]]).collect());
}

#[test]
fn collinear_pieces() {
    check(&(0..1000).map(|i| [[f64::from(2 * i), 0.0], [f64::from(2 * i + 1), 0.0]]).collect());
    check(&(0..1000).map(|i| [[0.0, f64::from(2 * i)], [0.0, f64::from(2 * i + 1)]]).collect());
    check(&(0..1000).map(|i| [[f64::from(i), f64::from(i)], [f64::from(i) + 1.0, f64::from(i) + 1.0]]).collect());
}

#[test]
fn stairs_and_combs() {
    check(&(0..1000).map(|i| [[f64::from(i), f64::from(i)], [f64::from(i), f64::from(i) + 1e5]]).collect());
    let teeth = (0..1000).map(|i| [[f64::from(i), 0.0], [f64::from(i), 1e3]]);
    let back = (0..999).map(|i| [[f64::from(i), 0.0], [f64::from(i + 1), 0.0]]);
    check(&teeth.chain(back).collect());
}

#[test]
fn thousands_of_islands() {
    let mut segments = Segments::new();
    for i in 0..32 {
        for j in 0..32 {
            let (x, y) = (f64::from(3 * i), f64::from(3 * j));
            segments.extend([[[x, y], [x + 1.0, y]], [[x + 1.0, y], [x, y + 1.0]], [[x, y + 1.0], [x, y]]]);
        }
    }
    check(&segments);
}

#[test]
fn isolated_vertices() {
    let mut random = Random(4);
    let points: Vec<Point> = (0..1000).map(|_| Point::new(random.unit(), random.unit())).collect();
    let map = build(&points, &[]);
    for v in map.dcel().vertices() {
        let p = map.position(v.key()).unwrap();
        assert_eq!(map.locate(p), Ok(Located::Vertex(v.key())));
        assert_eq!(map.locate(Point::new(p.x, 0.5)), Ok(Located::Face(map.dcel().unbounded_face().key())));
        let up = map.zone(&QueryLine::Ray(Point::new(p.x, -1.0), p)).unwrap();
        assert!(matches!(up[..], [_, ZoneElement::Vertex(w), _] if w == v.key()));
    }
}
