//! The sweep and the list of clashes compared with trying every pair.

use std::collections::{BTreeSet, HashMap};

use crate::exact::{Grid, all_clashes, point, segment_below};
use crate::noding::maps::map;
use quickcheck::{Arbitrary, Gen, QuickCheck, Testable};
use twinedge_geometry::Point;
use twinedge_geometry::crossing::{Clash, InvalidSegments, clashes};
use twinedge_geometry::predicates::{MAX_COORDINATE, MIN_COORDINATE};
use twinedge_geometry::sweep::sweep;

fn check(tests: u64, property: impl Testable) {
    let generator = Gen::from_size_and_seed(50, 1976);
    QuickCheck::new().rng(generator).tests(tests).quickcheck(property);
}

/// Points on a small grid, some equal, some isolated; segments between them, some repeated.
#[derive(Clone, Debug)]
struct Embedding {
    points: Vec<Grid>,
    segments: Vec<[u32; 2]>,
}

impl Embedding {
    fn places(&self) -> Vec<Point> {
        self.points.iter().copied().map(point).collect()
    }

    fn all(&self) -> Vec<u32> {
        (0..self.points.len() as u32).collect()
    }

    /// Leaves out all parts that clash with earlier ones. The numbers of the points stay.
    fn plane(mut self) -> Self {
        // A point equal to another one becomes that point; nothing refers to it then, so it moves far away.
        let mut first = HashMap::new();
        let whose: Vec<u32> = (0..).zip(&self.points).map(|(id, &p)| *first.entry(p).or_insert(id)).collect();
        let wanted: Vec<_> = self.segments.drain(..).map(|ends| ends.map(|end| whose[end as usize])).collect();
        for (id, &original) in (0..).zip(&whose) {
            if id != original {
                self.points[id as usize] = (1000 + id.cast_signed(), 0);
            }
        }
        for segment in wanted {
            self.segments.push(segment);
            let clash = |clash: &Clash| !matches!(clash, Clash::Touch { vertex, .. } if self.isolated(*vertex));
            if all_clashes(&self.points, &self.segments).iter().any(clash) {
                self.segments.pop();
            }
        }
        while let Some(Clash::Touch { vertex, .. }) = all_clashes(&self.points, &self.segments).first() {
            self.points[*vertex as usize] = (2000 + vertex.cast_signed(), 0);
        }
        self
    }

    fn isolated(&self, vertex: u32) -> bool {
        !self.segments.as_flattened().contains(&vertex)
    }
}

impl Arbitrary for Embedding {
    fn arbitrary(g: &mut Gen) -> Self {
        fn below(g: &mut Gen, bound: u32) -> u32 {
            u32::arbitrary(g) % bound
        }
        let (width, height, n) = (1 + below(g, 8), 2 + below(g, 8), 2 + below(g, 16));
        let points: Vec<Grid> =
            (0..n).map(|_| (below(g, width).cast_signed(), below(g, height).cast_signed())).collect();
        let segments = (0..below(g, 24))
            .map(|_| [below(g, n), below(g, n)])
            .filter(|&[u, v]| points[u as usize] != points[v as usize])
            .collect();
        Self { points, segments }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let drawing = self.clone();
        let without_segment = (0..self.segments.len()).map(move |i| {
            let mut smaller = drawing.clone();
            smaller.segments.remove(i);
            smaller
        });
        let drawing = self.clone();
        let without_point = (0..self.points.len() as u32).filter(|&i| self.isolated(i)).collect::<Vec<_>>();
        let without_point = without_point.into_iter().map(move |i| {
            let mut smaller = drawing.clone();
            smaller.points.remove(i as usize);
            for end in smaller.segments.as_flattened_mut() {
                *end -= u32::from(*end > i);
            }
            smaller
        });
        Box::new(without_segment.chain(without_point))
    }
}

#[test]
fn the_sweep_finds_a_clash_where_there_is_one() {
    fn property(drawing: Embedding) -> bool {
        let expected = all_clashes(&drawing.points, &drawing.segments);
        let swept = sweep(&drawing.places(), &drawing.segments, &[]).unwrap();
        match swept.clash {
            Some(clash) => expected.contains(&clash),
            None => expected.is_empty(),
        }
    }
    check(20_000, property as fn(Embedding) -> bool);
}

#[test]
fn the_sweep_finds_no_clash_and_all_that_is_below_in_plane_drawings() {
    fn property(drawing: Embedding) -> bool {
        let drawing = drawing.plane();
        let swept = sweep(&drawing.places(), &drawing.segments, &drawing.all()).unwrap();
        let below = drawing.points.iter().map(|&q| segment_below(&drawing.points, &drawing.segments, q));
        swept.clash.is_none() && below.eq(swept.below)
    }
    check(10_000, property as fn(Embedding) -> bool);
}

#[test]
fn a_plane_drawing_with_one_more_segment_clashes_or_not() {
    /// The single fault in an otherwise plane drawing is found, of every kind.
    fn property(drawing: Embedding, u: usize, v: usize) -> bool {
        let mut drawing = drawing.plane();
        let n = drawing.points.len();
        let (u, v) = (u % n, v % n);
        if u == v {
            return true;
        }
        drawing.segments.push([u as u32, v as u32]);
        let expected = all_clashes(&drawing.points, &drawing.segments);
        let swept = sweep(&drawing.places(), &drawing.segments, &[]).unwrap();
        swept.clash.map_or(expected.is_empty(), |clash| expected.contains(&clash))
    }
    check(10_000, property as fn(Embedding, usize, usize) -> bool);
}

#[test]
fn what_clashes_leaves_nothing_behind() {
    /// To the right of all clashes, the status is valid again.
    fn property(left: Embedding, right: Embedding) -> bool {
        let (right, shift) = (right.plane(), left.points.len() as u32);
        let moved: Vec<Grid> = right.points.iter().map(|&(x, y)| (x + 100, y)).collect();
        let points: Vec<Point> = left.points.iter().chain(&moved).copied().map(point).collect();
        let mut segments: Vec<[u32; 2]> = right.segments.iter().map(|ends| ends.map(|end| end + shift)).collect();
        segments.extend(&left.segments);
        let queries: Vec<u32> = (shift..points.len() as u32).collect();
        let swept = sweep(&points, &segments, &queries).unwrap();
        let below = moved.iter().map(|&q| segment_below(&moved, &right.segments, q));
        below.eq(swept.below)
    }
    check(10_000, property as fn(Embedding, Embedding) -> bool);
}

#[test]
fn all_sets_of_four_segments_on_nine_points_are_judged_rightly() {
    let grid: Vec<Grid> = (0..9).map(|i| (i / 3, i % 3)).collect();
    let every: Vec<[u32; 2]> = (0..9).flat_map(|v| (0..v).map(move |u| [u, v])).collect();
    let mut plane = 0;
    for i in 0..every.len() {
        for j in 0..i {
            for k in 0..j {
                for l in 0..k {
                    // Only the points used by the segments.
                    let mut points = Vec::new();
                    let segments = [i, j, k, l].map(|s| {
                        every[s].map(|p| {
                            let p = grid[p as usize];
                            points.iter().position(|&q| q == p).unwrap_or_else(|| {
                                points.push(p);
                                points.len() - 1
                            }) as u32
                        })
                    });
                    let expected = all_clashes(&points, &segments);
                    let places: Vec<Point> = points.iter().copied().map(point).collect();
                    let all: Vec<u32> = (0..points.len() as u32).collect();
                    let swept = sweep(&places, &segments, &all).unwrap();
                    if expected.is_empty() {
                        plane += 1;
                        let below = points.iter().map(|&q| segment_below(&points, &segments, q));
                        assert!(swept.clash.is_none() && below.eq(swept.below), "{points:?} {segments:?}");
                    } else {
                        let found = swept.clash.is_some_and(|clash| expected.contains(&clash));
                        assert!(found, "{points:?} {segments:?} {:?}", swept.clash);
                    }
                }
            }
        }
    }
    assert_eq!(plane, 17_398, "of the 58,905 sets, as whole numbers say");
}

#[test]
fn clashes_lists_what_all_pairs_say() {
    fn property(drawing: Embedding, cap: usize) -> bool {
        let expected = all_clashes(&drawing.points, &drawing.segments);
        let cap = cap % (expected.len() + 2);
        let (places, total) = (drawing.places(), expected.len() as u64);
        let all = clashes(&places, &drawing.segments, usize::MAX).unwrap();
        let some = clashes(&places, &drawing.segments, cap).unwrap();
        let kept = expected[..cap.min(expected.len())].to_vec();
        all == (expected, total) && some == (kept, total)
    }
    check(10_000, property as fn(Embedding, usize) -> bool);
}

#[test]
fn neither_the_scale_nor_the_order_of_the_endpoints_matters() {
    fn property(drawing: Embedding) -> bool {
        let places = drawing.places();
        let swept = sweep(&places, &drawing.segments, &drawing.all()).unwrap();
        let listed = clashes(&places, &drawing.segments, 1000).unwrap();
        let turned: Vec<[u32; 2]> = drawing.segments.iter().map(|&[u, v]| [v, u]).collect();
        // The largest coordinate is below 2^3, the smallest 1.
        [MAX_COORDINATE / 8.0, MIN_COORDINATE].into_iter().all(|scale| {
            let scaled: Vec<Point> = places.iter().map(|p| Point::new(p.x * -scale, p.y * -scale)).collect();
            let back: Vec<Point> = scaled.iter().map(|p| Point::new(-p.x, -p.y)).collect();
            let judged = sweep(&scaled, &turned, &[]).unwrap();
            // Half a turn changes the segments below points, and which clash comes first, but not whether there is one.
            judged.clash.is_some() == swept.clash.is_some()
                && clashes(&scaled, &turned, 1000).unwrap() == listed
                && sweep(&back, &turned, &drawing.all()).unwrap() == swept
        })
    }
    check(3000, property as fn(Embedding) -> bool);
}

#[test]
fn what_describes_no_drawing_is_refused() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [1.0, 1.0]].map(Point::from);
    let refused = |points: &[Point], segments: &[[u32; 2]]| {
        let refused = sweep(points, segments, &[]).unwrap_err();
        assert_eq!(clashes(points, segments, 1).unwrap_err(), refused);
        refused
    };
    assert_eq!(refused(&points, &[[0, 1], [3, 4]]), InvalidSegments::NoSuchPoint { segment: 1, point: 4 });
    assert_eq!(refused(&points, &[[u32::MAX, 0]]), InvalidSegments::NoSuchPoint { segment: 0, point: u32::MAX });
    assert_eq!(refused(&points, &[[0, 1], [1, 1]]), InvalidSegments::NoLength { segment: 1 });
    assert_eq!(refused(&points, &[[0, 2]]), InvalidSegments::NoLength { segment: 0 });
    assert_eq!(refused(&[], &[[0, 0]]), InvalidSegments::NoSuchPoint { segment: 0, point: 0 });
    for bad in [f64::NAN, f64::INFINITY, 2.0 * MAX_COORDINATE, MIN_COORDINATE / 2.0] {
        assert_eq!(refused(&[points[0], Point::new(0.0, bad)], &[]), InvalidSegments::OutOfRange { point: 1 });
    }
    let missing = sweep(&points, &[], &[3, 4]).unwrap_err();
    assert_eq!(missing, InvalidSegments::NoSuchQuery { query: 1, point: 4 });
    assert_eq!(missing.to_string(), "query 1 names the missing point 4");
}

#[test]
fn zeros_of_either_sign_are_the_same_place() {
    let points = [[0.0, -0.0], [-0.0, 0.0], [1.0, 0.0], [-1.0, -0.0]].map(Point::from);
    let same = Clash::SamePlace { a: 0, b: 1 };
    assert_eq!(sweep(&points, &[], &[]).unwrap().clash, Some(same));
    let through = [Clash::Touch { vertex: 0, segment: 0 }, Clash::Touch { vertex: 1, segment: 0 }];
    assert_eq!(clashes(&points, &[[2, 3]], 9).unwrap(), (vec![same, through[0], through[1]], 3));
}

/// The distinct points of a map, and its distinct ring segments.
fn world(text: &str) -> (Vec<Point>, Vec<[u32; 2]>) {
    let (mut points, mut numbers, mut segments) = (Vec::new(), HashMap::new(), BTreeSet::new());
    for ends in map(text) {
        let mut ends = ends.map(|p| {
            let p = Point::new(p.x + 0.0, p.y + 0.0);
            *numbers.entry([p.x.to_bits(), p.y.to_bits()]).or_insert_with(|| {
                points.push(p);
                points.len() as u32 - 1
            })
        });
        ends.sort_unstable();
        segments.extend((ends[0] != ends[1]).then_some(ends));
    }
    (points, segments.into_iter().collect())
}

#[test]
fn the_map_of_the_world_is_plane() {
    let (points, segments) = world(include_str!("../../../cli/data/world-110m.geojson"));
    assert_eq!((points.len(), segments.len()), (7493, 7655));
    assert_eq!(sweep(&points, &segments, &[]).unwrap().clash, None);
    assert_eq!(clashes(&points, &segments, 9).unwrap(), (vec![], 0));
}

#[test]
fn the_two_crossings_of_the_published_map_are_found() {
    let published = [
        [[23.80524, 8.66648], [24.56845, 8.22980], [23.88804, 8.61908], [24.19404, 8.72910]],
        [[33.96094, 9.58384], [33.97534, 8.68509], [33.82414, 9.48398], [33.96454, 9.46367]],
    ];
    let (points, segments) = world(include_str!("../../../../tests/data/world-110m-crossing.geojson"));
    assert_eq!(segments.len(), 7651);
    let (found, count) = clashes(&points, &segments, 9).unwrap();
    let first = sweep(&points, &segments, &[]).unwrap().clash.unwrap();
    assert!(count == 2 && found.contains(&first), "{found:?}");
    for corners in published {
        let is_it = |clash: &Clash| {
            let Clash::Cross { a, b } = *clash else { return false };
            let ends = [a, b].map(|segment| segments[segment as usize]).concat();
            let near = |[x, y]: [f64; 2]| {
                ends.iter().any(|p| (points[*p as usize].x - x).hypot(points[*p as usize].y - y) < 1e-4)
            };
            corners.into_iter().all(near)
        };
        assert_eq!(found.iter().filter(|clash| is_it(clash)).count(), 1);
    }
}
