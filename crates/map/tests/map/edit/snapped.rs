//! Segments drawn with rounding, compared step by step with noding everything at once.

use crate::edit::describe::{Description, built, describe, dump};
use crate::edit::follow::Shadow;
use crate::support::exact::{Grid, point};
use quickcheck::{Arbitrary, Gen, QuickCheck};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::Face;
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Noded, Snap, node};
use twinedge_map::edit::EditError;
use twinedge_map::{Builder, Feature, PlanarMap, Shape};

const GRID: Snap = Snap::Size(1.0);

/// A drawing as lists of points: rings, each of its own feature; lines; single points.
#[derive(Clone, Debug, Default)]
struct Embedding {
    rings: Vec<Vec<Point>>,
    lines: Vec<Vec<Point>>,
    points: Vec<Point>,
}

impl Embedding {
    /// Nodes everything at once.
    fn node(&mut self) -> Noded {
        let chains = || self.rings.iter().chain(&self.lines);
        let segments: Vec<[Point; 2]> = chains().flat_map(|c| c.windows(2).map(|p| [p[0], p[1]])).collect();
        let noded = node(&segments, &self.points, GRID).expect("small coordinates are in reach of the grid");
        let mut segment = 0;
        for chain in self.rings.iter_mut().chain(&mut self.lines) {
            let mut through: Vec<Point> = Vec::new();
            for _ in 1..chain.len() {
                through.extend(noded.chain(segment).expect("it was given").map(|v| noded.points[v as usize]));
                segment += 1;
            }
            through.dedup();
            *chain = through;
        }
        self.points.clone_from(&noded.points);
        noded
    }

    /// Builds the map at once from the noded drawing.
    fn build(&self) -> PlanarMap {
        let mut builder = Builder::new();
        for ring in &self.rings {
            builder.shape(&Shape::Polygon(vec![ring.clone()])).expect("in range");
        }
        for line in &self.lines {
            builder
                .feature(&Feature { shapes: vec![Shape::Line(line.clone())], ..Feature::default() })
                .expect("in range");
        }
        for p in &self.points {
            builder.shape(&Shape::Point(*p)).expect("in range");
        }
        builder.build().expect("a small map fits")
    }
}

/// The features of rings that cover each face, by its walls, and that run along each edge, by its ends.
type Covers = (BTreeMap<crate::edit::describe::Walls, Vec<usize>>, BTreeMap<[Grid; 2], Vec<usize>>);

fn covers(map: &PlanarMap, rings: usize) -> Covers {
    let of = |f: Face<'_>| {
        let features = map.features_of(f.key()).expect("it is of this map").map(|f| f.index());
        (crate::edit::describe::walls(map, f), features.filter(|f| *f < rings).collect())
    };
    let along = |h: twinedge::dcel::HalfEdge<'_>| {
        let features = map.features_along(h.key()).expect("it is of this map").map(|f| f.index());
        (crate::edit::describe::ends(map, h), features.filter(|f| *f < rings).collect())
    };
    (map.dcel().faces().map(of).collect(), map.dcel().edges().map(along).collect())
}

/// A position in quarters of a cell.
#[derive(Clone, Copy, Debug)]
struct Quarter(u8, u8);

impl Quarter {
    fn point(self, side: u8) -> Point {
        let along = |q: u8| f64::from(q % (4 * side)) / 4.0;
        Point::new(along(self.0), along(self.1))
    }
}

impl Arbitrary for Quarter {
    fn arbitrary(g: &mut Gen) -> Self {
        Self(u8::arbitrary(g), u8::arbitrary(g))
    }
}

fn law(rings: Vec<Vec<Quarter>>, points: Vec<Quarter>, segments: Vec<(Quarter, Quarter)>, wide: bool) -> bool {
    let side = if wide { 40 } else { 9 };
    let mut drawing = Embedding::default();
    for ring in rings.iter().take(4).filter(|ring| ring.len() > 2) {
        let mut ring: Vec<Point> = ring.iter().take(6).map(|q| q.point(side)).collect();
        ring.push(ring[0]);
        drawing.rings.push(ring);
    }
    drawing.points.extend(points.iter().take(6).map(|q| q.point(side)));
    drawing.node();
    // A collapsed ring encloses nothing, and the builder does not count it as a ring.
    drawing.rings.retain(|ring| ring.len() > 3);
    let rings = drawing.rings.len();
    let mut map = drawing.build();
    let mut shadow = Shadow::of(&map);
    for (a, b) in segments {
        let (a, b) = (a.point(side), b.point(side));
        let before = dump(&map);
        let outcome = map.insert_segment_snapped(a, b, GRID);
        if a == b {
            assert!(outcome.is_err() && dump(&map) == before);
            continue;
        }
        let edited = outcome.expect("the map is on the grid");
        drawing.lines.push(vec![a, b]);
        let noded = drawing.node();
        let report = map.validate();
        assert!(report.is_valid(), "{report}");

        let whole = |p: &Point| (p.x as i32, p.y as i32);
        let vertices: BTreeSet<Grid> = noded.points.iter().map(whole).collect();
        let edges: BTreeSet<[Grid; 2]> =
            noded.segments.iter().map(|ends| ends.map(|v| whole(&noded.points[v as usize]))).collect();
        let there = describe(&map);
        assert_eq!(there.edges, edges, "{a:?} {b:?}");
        assert_eq!(there, describe(&built(&vertices, &edges)), "{a:?} {b:?}");
        let at_once = drawing.build();
        assert_eq!(covers(&map, rings), covers(&at_once, rings), "{a:?} {b:?}");

        let way: Vec<Point> = drawing.lines.last().cloned().unwrap_or_default();
        let mut walked: Vec<Point> = edited
            .way
            .iter()
            .map(|h| map.position(map.dcel().half_edge(*h).expect("made").origin().key()).expect("there"))
            .collect();
        walked.extend(map.position(edited.vertices[1]));
        walked.dedup();
        assert_eq!(walked, way);
        shadow.follow(&map, &edited);
        assert_eq!(shadow, Shadow::of(&map));
    }
    true
}

#[test]
fn snapped_segments_one_by_one_give_what_noding_all_at_once_gives() {
    for size in [8, 20] {
        QuickCheck::new()
            .rng(Gen::from_size_and_seed(size, 2026))
            .tests(50)
            .quickcheck(law as fn(Vec<Vec<Quarter>>, Vec<Quarter>, Vec<(Quarter, Quarter)>, bool) -> bool);
    }
}

#[test]
fn what_is_crossed_keeps_its_faces_unless_it_comes_to_lie_on_something() {
    let mut drawing = Embedding::default();
    let ring = [(0, 0), (20, 0), (20, 20), (0, 20), (0, 0)];
    drawing.rings.push(ring.map(point).to_vec());
    let mut map = drawing.build();
    let inside = map.dcel().faces().find(|f| !f.is_unbounded()).expect("a ring has an inside").key();
    let edited = map.insert_segment_snapped([-5.0, 3.3], [25.0, 12.1], GRID).expect("on the grid");
    assert_eq!((edited.edges_split.len(), edited.edges_made.len(), edited.way.len()), (2, 3, 3));
    assert!(edited.edges_dropped.is_empty() && edited.faces_merged.is_empty() && edited.faces_relabelled.is_empty());
    assert_eq!(edited.faces_split.len(), 1);
    assert!(map.features_of(inside).expect("it is still there").eq(map.features()));
    let Description { vertices, .. } = describe(&map);
    assert_eq!(vertices.len(), 8);
}

#[test]
fn the_automatic_grid_is_that_of_the_largest_coordinate() {
    let mut map = PlanarMap::new();
    // A third of a degree is on no grid, and is rounded to the nearest point of a grid of 2^-42.
    let third = 1.0 / 3.0;
    let first = map.insert_segment_snapped([third, 0.0], [170.0, 100.0], Snap::Auto).expect("nothing is there");
    let at = |map: &PlanarMap, v| map.position(v).expect("it is there");
    let rounded = (third * 2_f64.powi(42)).round() / 2_f64.powi(42);
    assert_eq!(at(&map, first.vertices[0]), Point::new(rounded, 0.0));
    // A segment with smaller coordinates uses the same grid: otherwise the crossing would be off it for the next one.
    let second = map.insert_segment_snapped([0.0, third], [1.0, 0.0], Snap::Auto).expect("on the grid");
    assert_eq!(second.edges_split.len(), 1);
    let scaled = at(&map, second.vertices_made[0]).y * 2_f64.powi(42);
    assert!(scaled.fract() == 0.0);
    assert!(map.validate().is_valid());
    // A larger coordinate makes a coarser grid.
    let off = map.insert_segment_snapped([0.0, 0.0], [1e9, 1.0], Snap::Auto);
    assert!(matches!(off, Err(EditError::NotOnGrid(_))));
}

#[test]
fn the_automatic_grid_is_no_finer_than_coordinates_may_be() {
    // These cross at (2^-411, 0), which is on the grid of 2^-430 but out of range.
    let t = 2_f64.powi(-380);
    let mut map = PlanarMap::new();
    map.insert_segment_snapped([-t, 0.0], [t, 0.0], Snap::Auto).expect("nothing is there");
    let near_the_middle = [2_f64.powi(-410) - t / 2.0, t];
    let second = map.insert_segment_snapped([t / 2.0, -t], near_the_middle, Snap::Auto).expect("on the grid of 2^-400");
    let crossing = map.position(second.vertices_made[0]).expect("it is there");
    assert_eq!((crossing, second.edges_split.len()), (Point::new(0.0, 0.0), 1));
    assert!(map.validate().is_valid());
}
