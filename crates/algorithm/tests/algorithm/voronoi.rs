//! Voronoi diagrams and Delaunay triangulations: valid, dual to each other, and true to their definitions.

use quickcheck::{Arbitrary, Gen, QuickCheck};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{FaceKey, HalfEdge};
use twinedge::program::choose::{Choose, Random};
use twinedge_algorithm::area::face_area;
use twinedge_algorithm::voronoi::{Delaunay, Voronoi, VoronoiError, delaunay, voronoi, voronoi_merging};
use twinedge_geometry::Point;
use twinedge_map::Located;

fn points(coordinates: &[[f64; 2]]) -> Vec<Point> {
    coordinates.iter().copied().map(Point::from).collect()
}

/// The number of the first site equal to each.
fn first_at_place(sites: &[Point]) -> Vec<usize> {
    sites.iter().map(|p| sites.iter().position(|q| p == q).unwrap()).collect()
}

/// Both maps of some sites, checked for everything that does not depend on exact distances.
fn checked(sites: &[Point], bounds: Option<[Point; 2]>) -> (Delaunay, Voronoi) {
    let (dual, diagram) = (delaunay(sites).unwrap(), voronoi(sites, bounds).unwrap());
    assert!(dual.map.validate().is_valid(), "{}", dual.map.validate());
    assert!(diagram.map.validate().is_valid(), "{}", diagram.map.validate());
    assert!(dual.map.is_plane() && diagram.map.is_plane());
    let first = first_at_place(sites);
    let different: BTreeSet<usize> = first.iter().copied().collect();
    assert_eq!(dual.map.dcel().vertex_count(), different.len());
    assert_eq!(diagram.map.dcel().face_count(), different.len() + 1);
    for (i, j) in first.iter().enumerate() {
        assert_eq!((dual.vertices[i], diagram.cells[i]), (dual.vertices[*j], diagram.cells[*j]));
        assert_eq!(dual.map.position(dual.vertices[i]), Ok(Point::new(sites[i].x + 0.0, sites[i].y + 0.0)));
    }
    assert_eq!(diagram.cells.iter().collect::<BTreeSet<_>>().len(), different.len());

    // The cells fill the box.
    let [low, high] = diagram.bounds;
    let area: f64 = different.iter().map(|i| face_area(&diagram.map, diagram.cells[*i]).unwrap()).sum();
    let all = (high.x - low.x) * (high.y - low.y);
    assert!((area - all).abs() <= 1e-12 * all, "{area} {all}");

    // A border between two cells corresponds to an edge between their sites.
    let site_of: BTreeMap<FaceKey, usize> = different.iter().map(|i| (diagram.cells[*i], *i)).collect();
    let joined: BTreeSet<[usize; 2]> = { dual.map.dcel().half_edges() }
        .map(|h| [h.origin(), h.target()].map(|v| *different.iter().find(|i| dual.vertices[**i] == v.key()).unwrap()))
        .collect();
    for h in diagram.map.dcel().half_edges() {
        let sides = [h.face(), h.twin().face()].map(|face| site_of.get(&face.key()));
        if let [Some(a), Some(b)] = sides {
            assert!(joined.contains(&[*a, *b]), "{a} {b}");
        }
    }
    (dual, diagram)
}

/// Whole numbers from 0 to 15: most sites are collinear, cocircular or repeated.
#[derive(Clone, Debug)]
struct Few(Vec<[u8; 2]>);

impl Arbitrary for Few {
    fn arbitrary(g: &mut Gen) -> Self {
        let range = [2, 4, 16][usize::from(u8::arbitrary(g) % 3)];
        let count = 1 + usize::from(u8::arbitrary(g) % 24);
        Self((0..count).map(|_| [u8::arbitrary(g) % range, u8::arbitrary(g) % range]).collect())
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        Box::new(self.0.shrink().filter(|sites| !sites.is_empty()).map(Self))
    }
}

/// Returns true if a site lies inside the circle of a triangle: the sign of a determinant of whole numbers.
fn inside_circle(corners: [[i64; 2]; 3], d: [i64; 2]) -> bool {
    let [a, b, c] = corners.map(|p| {
        let [x, y] = [p[0] - d[0], p[1] - d[1]];
        [x, y, x * x + y * y]
    });
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]) > 0
}

fn few_sites_are_right(Few(few): Few) -> bool {
    let whole: Vec<[i64; 2]> = few.iter().map(|p| p.map(i64::from)).collect();
    let sites: Vec<Point> = few.iter().map(|p| Point::from(p.map(f64::from))).collect();
    let (dual, diagram) = checked(&sites, None);
    for face in dual.map.dcel().faces().filter(|face| !face.is_unbounded()) {
        let corners: Vec<[i64; 2]> = { face.half_edges() }
            .map(|h| whole[dual.vertices.iter().position(|v| *v == h.origin().key()).unwrap()])
            .collect();
        let corners = <[[i64; 2]; 3]>::try_from(corners).unwrap();
        assert!(!whole.iter().any(|d| inside_circle(corners, *d)));
    }
    // There is one vertex inside the box for each distinct centre: fractions, in lowest terms. (A centre on the border of the
    // box, or nearly, may be on either side of it.)
    let [low, high] = diagram.bounds;
    let inside = |x: f64, y: f64, margin: f64| {
        low.x + margin < x && x < high.x - margin && low.y + margin < y && y < high.y - margin
    };
    let (mut centres, mut nearly) = (BTreeSet::new(), BTreeSet::new());
    for face in dual.map.dcel().faces().filter(|face| !face.is_unbounded()) {
        let corners: Vec<[i64; 2]> = { face.half_edges() }
            .map(|h| whole[dual.vertices.iter().position(|v| *v == h.origin().key()).unwrap()])
            .collect();
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        let [bx, by, cx, cy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
        let (d, bb, cc) = (2 * (bx * cy - by * cx), bx * bx + by * by, cx * cx + cy * cy);
        let fraction = |n: i64| {
            let (mut p, mut q) = (n.abs(), d.abs());
            while q != 0 {
                (p, q) = (q, p % q);
            }
            (n * d.signum() / p, d.abs() / p)
        };
        let centre = [a[0] * d + cy * bb - by * cc, a[1] * d + bx * cc - cx * bb];
        let [x, y] = centre.map(|n| n as f64 / d as f64);
        if inside(x, y, 1e-9) {
            centres.insert(centre.map(fraction));
        }
        if inside(x, y, -1e-9) {
            nearly.insert(centre.map(fraction));
        }
    }
    let vertices = { diagram.map.dcel().vertices() }
        .map(|v| diagram.map.position(v.key()).unwrap())
        .filter(|p| inside(p.x, p.y, 0.0))
        .count();
    assert!(centres.len() <= vertices && vertices <= nearly.len(), "{vertices}: {centres:?} {nearly:?}");
    // The nearest site of each lattice point is the site of its cell. Different squared distances between a lattice point and two
    // sites of this range differ by at least one, far more than rounding moves a border.
    let distance = |i: usize, x: i64, y: i64| (whole[i][0] - x).pow(2) + (whole[i][1] - y).pow(2);
    for (x, y) in (0..16).flat_map(|x| (0..16).map(move |y| (x, y))) {
        let p = Point::new(x as f64, y as f64);
        let [low, high] = diagram.bounds;
        if !(low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y) {
            continue;
        }
        let least = (0..whole.len()).map(|i| distance(i, x, y)).min().unwrap();
        let nearest: BTreeSet<FaceKey> =
            (0..whole.len()).filter(|i| distance(*i, x, y) == least).map(|i| diagram.cells[i]).collect();
        let at: Vec<FaceKey> = match diagram.map.locate(p).unwrap() {
            Located::Face(face) => vec![face],
            Located::Edge(h) => {
                let h = diagram.map.dcel().half_edge(h).unwrap();
                vec![h.face().key(), h.twin().face().key()]
            }
            Located::Vertex(v) => {
                { diagram.map.dcel().vertex(v).unwrap() }.rotation().map(|h| h.face().key()).collect()
            }
        };
        assert!(at.iter().any(|face| nearest.contains(face)), "{p:?}");
        assert!(nearest.len() > 1 || at == nearest.iter().copied().collect::<Vec<_>>(), "{p:?}");
    }
    true
}

/// The centre of a circle lies on the border of the box, up to rounding.
#[test]
fn a_centre_on_the_border() {
    assert!(few_sites_are_right(Few(vec![[7, 15], [5, 13], [0, 2], [1, 14]])));
    // On a side, and in a corner.
    let four = points(&[[1.0, 1.0], [3.0, 1.0], [1.0, 3.0], [3.0, 3.0]]);
    for high in [[5.0, 2.0], [2.0, 5.0], [2.0, 2.0]] {
        let inside: Vec<Point> = four.iter().copied().filter(|p| p.x <= high[0] && p.y <= high[1]).collect();
        let _ = checked(&inside, Some([Point::new(0.0, 0.0), high.into()]));
    }
    let three = points(&[[1.0, 0.5], [3.0, 0.5], [2.0, 1.5]]);
    let _ = checked(&three, Some([Point::new(0.0, 0.5), Point::new(4.0, 2.0)]));
    let _ = checked(&three, Some([Point::new(1.0, 0.5), Point::new(3.0, 1.5)]));
}

#[test]
fn random_sites_on_a_lattice() {
    QuickCheck::new().tests(2_000).quickcheck(few_sites_are_right as fn(Few) -> bool);
}

fn random(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[test]
fn random_sites_anywhere_and_their_nearest() {
    let mut number = random(7);
    for scale in [1.0, 1e-30, 1e30] {
        let sites: Vec<Point> = (0..500).map(|_| Point::new(scale * number(), scale * number())).collect();
        let (dual, diagram) = checked(&sites, None);
        for _ in 0..1_000 {
            let p = Point::new(scale * number(), scale * number());
            let distance = |q: &Point| (p.x - q.x).hypot(p.y - q.y);
            let least = sites.iter().map(distance).fold(f64::INFINITY, f64::min);
            if let Located::Face(face) = diagram.map.locate(p).unwrap() {
                let site = diagram.cells.iter().position(|cell| *cell == face).unwrap();
                assert!(distance(&sites[site]) <= least * (1.0 + 1e-9));
            }
        }
        // Each triangle whose centre is inside the box is a vertex where the cells of its corners meet.
        let at_vertex: BTreeSet<BTreeSet<FaceKey>> =
            { diagram.map.dcel().vertices() }.map(|v| v.rotation().map(|h| h.face().key()).collect()).collect();
        let [low, high] = diagram.bounds;
        let mut inside = 0;
        for face in dual.map.dcel().faces().filter(|face| !face.is_unbounded()) {
            let corners: Vec<usize> = { face.half_edges() }
                .map(|h| dual.vertices.iter().position(|v| *v == h.origin().key()).unwrap())
                .collect();
            let [a, b, c] = [0, 1, 2].map(|i| sites[corners[i]]);
            let [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
            let (d, bb, cc) = (2.0 * (bx * cy - by * cx), bx * bx + by * by, cx * cx + cy * cy);
            let centre = Point::new(a.x + (cy * bb - by * cc) / d, a.y + (bx * cc - cx * bb) / d);
            if low.x < centre.x && centre.x < high.x && low.y < centre.y && centre.y < high.y {
                assert!(at_vertex.contains(&corners.iter().map(|i| diagram.cells[*i]).collect()));
                inside += 1;
            }
        }
        assert!(inside > 900);
    }
}

#[test]
fn golden_diagrams() {
    // A grid: every cell a square, four at each vertex.
    let grid: Vec<Point> = (0..25).map(|i| Point::new(f64::from(i % 5), f64::from(i / 5))).collect();
    let (dual, diagram) = checked(&grid, Some([Point::new(-0.5, -0.5), Point::new(4.5, 4.5)]));
    assert!(diagram.cells.iter().all(|cell| face_area(&diagram.map, *cell) == Ok(1.0)));
    assert_eq!(diagram.map.dcel().vertex_count(), 36);
    assert_eq!(dual.map.dcel().face_count(), 32 + 1);

    // Sites on a line: strips.
    let line = points(&[[0.0, 0.0], [3.0, 3.0], [1.0, 1.0]]);
    let (dual, diagram) = checked(&line, None);
    assert_eq!((dual.map.dcel().edge_count(), dual.map.dcel().face_count()), (2, 1));
    assert_eq!(diagram.map.dcel().half_edges().filter(|h| !h.face().is_unbounded()).count(), 2 * 2 + 4 + 4);

    // One site, repeated: the box.
    let (dual, diagram) = checked(&points(&[[-2.0, 3.0], [-2.0, 3.0]]), None);
    assert_eq!((dual.map.dcel().vertex_count(), dual.map.dcel().edge_count()), (1, 0));
    assert_eq!(diagram.bounds, [Point::new(-3.5, 1.5), Point::new(-0.5, 4.5)]);
    let (_, diagram) = checked(&points(&[[0.0, -0.0], [0.0, 0.0]]), None);
    assert_eq!(diagram.bounds, [Point::new(-1.0, -1.0), Point::new(1.0, 1.0)]);

    // Sites on the border of the box, and in its corner.
    let _ = checked(&points(&[[0.0, 0.0], [4.0, 2.0], [1.0, 4.0]]), Some([Point::new(0.0, 0.0), Point::new(4.0, 4.0)]));
    // A box far larger than the sites need, and one that cuts centres off.
    let three = points(&[[0.0, 0.0], [1.0, 0.001], [2.0, 0.0]]);
    let _ = checked(&three, Some([Point::new(-1e9, -1e9), Point::new(1e9, 1e9)]));
    let _ = checked(&three, Some([Point::new(-1.0, -1.0), Point::new(3.0, 1.0)]));

    assert_eq!(delaunay(&[]).unwrap().map.dcel().vertex_count(), 0);
}

/// Points nearly on one circle, nearly on one line, nearly equal.
#[test]
fn nearly_degenerate_sites() {
    let circle: Vec<Point> = (0..100).map(|i| f64::from(i) * 0.06).map(|t| Point::new(t.cos(), t.sin())).collect();
    let _ = checked(&circle, None);
    let far: Vec<Point> = circle.iter().map(|p| Point::new(p.x + 1e6, p.y - 1e7)).collect();
    let _ = checked(&far, None);
    let slope: Vec<Point> = (0..60).map(|i| f64::from(i) / 10.0).map(|x| Point::new(x, x / 3.0)).collect();
    let _ = checked(&slope, None);
    let close: Vec<Point> =
        (0..40).map(|i| Point::new(1.0 + f64::from(i % 7) * 1e-9, 1.0 + f64::from(i / 7) * 1e-9)).collect();
    let _ = checked(&close, None);
    let hexagons: Vec<Point> = (0..200)
        .map(|i| Point::new(f64::from(i % 20) + f64::from(i / 20 % 2) / 2.0, f64::from(i / 20) * 0.75_f64.sqrt()))
        .collect();
    let _ = checked(&hexagons, None);
}

#[test]
fn what_has_no_diagram_is_refused() {
    assert_eq!(voronoi(&[], None).unwrap_err(), VoronoiError::NoSites);
    let bad = points(&[[0.0, 0.0], [f64::NAN, 1.0]]);
    assert!(matches!(delaunay(&bad), Err(VoronoiError::NotFinite { site: 1, .. })));
    assert!(matches!(voronoi(&points(&[[1e300, 0.0]]), None), Err(VoronoiError::OutOfRange { site: 0, .. })));
    assert!(matches!(delaunay(&points(&[[0.0, 1e-60]])), Err(VoronoiError::OutOfRange { site: 0, .. })));
    let one = points(&[[1.0, 1.0]]);
    let to = |x: f64, y: f64| Some([Point::new(0.0, 0.0), Point::new(x, y)]);
    for bounds in [to(0.0, 2.0), to(2.0, -1.0), to(f64::INFINITY, 2.0), to(f64::NAN, 2.0), to(1e100, 2.0)] {
        assert_eq!(voronoi(&one, bounds).unwrap_err(), VoronoiError::Bounds);
    }
    assert_eq!(voronoi(&one, to(0.5, 2.0)).unwrap_err(), VoronoiError::Outside { site: 0, x: 1.0, y: 1.0 });

    // Four consecutive numbers: two of the three borders between them round to the same number.
    let after = |steps: u64| [f64::from_bits(1.0_f64.to_bits() + steps), 0.0];
    let close = points(&[[5.0, 0.0], after(0), after(1), after(2), after(3)]);
    assert!(delaunay(&close).is_ok());
    assert!(matches!(voronoi(&close, None), Err(VoronoiError::TooClose { sites: [1..=4, 1..=4] })));
}

/// Points in a square of 10 km at coordinates of UTM, and one more close to the first of them.
fn beside_another(seed: u64, distance: f64) -> Vec<Point> {
    let mut random = Random::seeded(seed);
    let mut number = || random.choose(1 << 30) as f64 / f64::from(1 << 30);
    let mut sites: Vec<Point> =
        (0..100).map(|_| Point::new(500_000.0 + 1e4 * number(), 5_400_000.0 + 1e4 * number())).collect();
    let angle = std::f64::consts::TAU * number();
    sites.push(Point::new(sites[0].x + distance * angle.cos(), sites[0].y + distance * angle.sin()));
    sites
}

/// The determinant of three points nearly vanishes if two of them are close: its rounding moved centres by metres.
#[test]
fn one_pair_of_near_points_refuses_no_diagram() {
    checked(&points(&[[100.0, 100.0], [0.0, 0.0], [200.0, 0.0], [50.0, 180.0], [100.00001, 100.0]]), None);
    for (distance, most) in [(1e-7, 0), (1e-6, 0), (1e-5, 0), (1e-4, 0), (1e-3, 0), (1e-8, 12)] {
        let refused = (0..100).filter(|seed| voronoi(&beside_another(*seed, distance), None).is_err()).count();
        assert!(refused <= most, "{refused} at {distance}");
    }
}

/// On request, points that doubles cannot distinguish share a cell, and no others do.
#[test]
fn points_that_are_too_close_share_a_cell_on_request() {
    let mut shared = 0;
    for seed in 0..100 {
        let sites = beside_another(seed, 2e-9);
        if sites[0] == sites[100] {
            continue;
        }
        let found = voronoi_merging(&sites, None).unwrap();
        assert!(found.map.validate().is_valid());
        let expected: &[[usize; 2]] = if voronoi(&sites, None).is_ok() { &[] } else { &[[100, 0]] };
        assert_eq!(found.merged, expected);
        assert_eq!(found.cells[100] == found.cells[0], !expected.is_empty());
        assert_eq!(found.map.dcel().face_count(), 102 - expected.len());
        shared += expected.len();
    }
    assert!(shared > 5, "{shared}");
    let after = |steps: u64| [f64::from_bits(1.0_f64.to_bits() + steps), 0.0];
    let close = points(&[[5.0, 0.0], after(0), after(1), after(2), after(3), [5.0, 0.0]]);
    let found = voronoi_merging(&close, None).unwrap();
    assert_eq!(found.merged, [[2, 1], [3, 1], [4, 1]]);
    assert_eq!(found.cells[0], found.cells[5]);
    // Two equal sites among merged ones.
    let twice = points(&[[5.0, 0.0], after(0), after(1), after(2), after(2), after(3)]);
    assert_eq!(voronoi_merging(&twice, None).unwrap().merged, [[2, 1], [3, 1], [4, 1], [5, 1]]);
    assert_eq!(voronoi_merging(&[], None).unwrap_err(), VoronoiError::NoSites);
}

/// Rounded to the seventh digit, as much real data is, with a cluster in it.
#[test]
fn sites_of_real_data() {
    let file: serde_json::Value =
        serde_json::from_slice(include_bytes!("../../../cli/data/world-110m.geojson")).unwrap();
    let mut sites = Vec::new();
    for feature in file["features"].as_array().unwrap() {
        let mut stack = vec![&feature["geometry"]["coordinates"]];
        while let Some(value) = stack.pop() {
            match value.as_array().map(Vec::as_slice) {
                Some([x, y, ..]) if x.is_number() => sites.push(Point::new(x.as_f64().unwrap(), y.as_f64().unwrap())),
                Some(list) => stack.extend(list),
                None => {}
            }
        }
    }
    sites.truncate(1_500);
    let (_, diagram) = checked(&sites, None);
    let sides = |face: FaceKey| diagram.map.dcel().face(face).unwrap().half_edges().map(HalfEdge::key).count();
    assert!(diagram.cells.iter().all(|cell| sides(*cell) >= 3));
}
