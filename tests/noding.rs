//! Noding: against an oracle that tries everything, on families that break noders, and on real maps.
#![cfg(feature = "geometry")]

use quickcheck::{Gen, QuickCheck, Testable};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use twinedge::geometry::Point;
use twinedge::geometry::noding::{Input, Noded, NodingError, Snap, node};

type Segment = [Point; 2];

fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
    [a.into(), b.into()]
}

fn auto(segments: &[Segment]) -> Noded {
    node(segments, &[], Snap::Auto).expect("finite input")
}

/// The number of vertices, of edges and of components.
fn counts(noded: &Noded) -> [usize; 3] {
    let mut parent: Vec<usize> = (0..noded.points.len()).collect();
    let mut components = parent.len();
    for ends in &noded.segments {
        let [a, b] = ends.map(|v| {
            let mut root = v as usize;
            while parent[root] != root {
                parent[root] = parent[parent[root]];
                root = parent[root];
            }
            root
        });
        components -= usize::from(a != b);
        parent[a] = b;
    }
    [noded.points.len(), noded.segments.len(), components]
}

/// Integer geometry, slow and obvious.
mod oracle {
    use std::cmp::Ordering;
    use std::collections::BTreeSet;

    pub(crate) type Whole = [i128; 2];

    /// A fraction with a positive denominator.
    #[derive(Clone, Copy)]
    struct Fraction(i128, i128);

    impl Fraction {
        fn new(numerator: i128, denominator: i128) -> Self {
            Self(numerator * denominator.signum(), denominator.abs())
        }

        fn order(self, other: Self) -> Ordering {
            (self.0 * other.1).cmp(&(other.0 * self.1))
        }
    }

    pub(crate) fn cross(a: Whole, b: Whole, c: Whole) -> i128 {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /// Do two segments, or a segment and a point, have a point in common that is not an end of both?
    pub(crate) fn clash([a, b]: [Whole; 2], [c, d]: [Whole; 2]) -> bool {
        let signs = [
            cross(a, b, c),
            cross(a, b, d),
            cross(c, d, a),
            cross(c, d, b),
        ]
        .map(i128::signum);
        let inside =
            |[p, q]: [Whole; 2], r: Whole| p.min(q) < r && r < p.max(q) && cross(p, q, r) == 0;
        let crossing = signs[0] * signs[1] < 0 && signs[2] * signs[3] < 0;
        let same = [a.min(b), a.max(b)] == [c.min(d), c.max(d)];
        crossing
            || same
            || inside([a, b], c)
            || inside([a, b], d)
            || inside([c, d], a)
            || inside([c, d], b)
    }

    /// When a point that goes from `a` to `b` is in a pixel: from, until.
    fn visit(a: Whole, b: Whole, pixel: Whole, size: i128) -> Option<[Fraction; 2]> {
        let (mut from, mut until) = ((Fraction(0, 1), true), (Fraction(1, 1), true));
        for axis in 0..2 {
            let (start, step) = (2 * a[axis], 2 * (b[axis] - a[axis]));
            let (low, high) = ((2 * pixel[axis] - 1) * size, (2 * pixel[axis] + 1) * size);
            if step == 0 {
                if start < low || high <= start {
                    return None;
                }
                continue;
            }
            // The low side belongs to the pixel, the high side does not.
            let (at_low, at_high) = (
                (Fraction::new(low - start, step), true),
                (Fraction::new(high - start, step), false),
            );
            let (enters, leaves) = if step > 0 {
                (at_low, at_high)
            } else {
                (at_high, at_low)
            };
            from = match from.0.order(enters.0) {
                Ordering::Less => enters,
                Ordering::Equal => (from.0, from.1 && enters.1),
                Ordering::Greater => from,
            };
            until = match until.0.order(leaves.0) {
                Ordering::Greater => leaves,
                Ordering::Equal => (until.0, until.1 && leaves.1),
                Ordering::Less => until,
            };
        }
        match from.0.order(until.0) {
            Ordering::Less => Some([from.0, until.0]),
            Ordering::Equal if from.1 && until.1 => Some([from.0, until.0]),
            _ => None,
        }
    }

    /// The hot pixels that a segment visits, in order.
    fn snapped(hot: &BTreeSet<Whole>, [a, b]: [Whole; 2], size: i128) -> Vec<Whole> {
        let mut visits: Vec<(Whole, [Fraction; 2])> = hot
            .iter()
            .filter_map(|&pixel| Some((pixel, visit(a, b, pixel, size)?)))
            .collect();
        visits.sort_by(|(_, [p, q]), (_, [r, s])| p.order(*r).then(q.order(*s)));
        visits.into_iter().map(|(pixel, _)| pixel).collect()
    }

    fn pixel(numerators: Whole, denominator: i128, size: i128) -> Whole {
        numerators.map(|n| (2 * n + size * denominator).div_euclid(2 * size * denominator))
    }

    /// The pixel of the point that two segments have in common, unless they are parallel.
    fn meeting([a, b]: [Whole; 2], [c, d]: [Whole; 2], size: i128) -> Option<Whole> {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (ex, ey) = (d[0] - c[0], d[1] - c[1]);
        let whole = dx * ey - dy * ex;
        if whole == 0 {
            return None;
        }
        let along = (c[0] - a[0]) * ey - (c[1] - a[1]) * ex;
        let other = (c[0] - a[0]) * dy - (c[1] - a[1]) * dx;
        let (along, other, whole) = (along * whole.signum(), other * whole.signum(), whole.abs());
        let meets = (0..=whole).contains(&along) && (0..=whole).contains(&other);
        meets.then(|| {
            pixel(
                [a[0] * whole + along * dx, a[1] * whole + along * dy],
                whole,
                size,
            )
        })
    }

    pub(crate) struct Ideal {
        pub(crate) vertices: BTreeSet<Whole>,
        pub(crate) chains: Vec<Vec<Whole>>,
        pub(crate) crossings: usize,
        pub(crate) rounds: usize,
    }

    /// Iterated snap rounding by definition, for segments and points in steps, and pixels of `size` steps.
    pub(crate) fn node(segments: &[[Whole; 2]], points: &[Whole], size: i128) -> Ideal {
        let ends: BTreeSet<Whole> = segments
            .iter()
            .flatten()
            .chain(points)
            .map(|&p| pixel(p, 1, size))
            .collect();
        let pairs = segments
            .iter()
            .enumerate()
            .flat_map(|(i, s)| segments[..i].iter().map(move |t| (s, t)));
        let meetings = pairs.filter_map(|(&s, &t)| meeting(s, t, size));
        let vertices: BTreeSet<Whole> = ends.iter().copied().chain(meetings).collect();
        let mut chains: Vec<Vec<Whole>> = segments
            .iter()
            .map(|&s| snapped(&vertices, s, size))
            .collect();
        let mut rounds = usize::from(chains.iter().any(|chain| chain.len() > 2));
        loop {
            let bent: Vec<Vec<Whole>> = chains
                .iter()
                .map(|chain| {
                    let edges = chain
                        .windows(2)
                        .map(|edge| snapped(&vertices, [edge[0], edge[1]], 1));
                    chain[..1]
                        .iter()
                        .copied()
                        .chain(edges.flat_map(|pieces| pieces[1..].to_vec()))
                        .collect()
                })
                .collect();
            if bent == chains {
                let crossings = vertices.len() - ends.len();
                return Ideal {
                    vertices,
                    chains,
                    crossings,
                    rounds,
                };
            }
            rounds += 1;
            chains = bent;
        }
    }
}

use oracle::Whole;

/// The vertices as whole numbers of cells. Fails if one is not on the grid.
fn cells(noded: &Noded) -> Vec<Whole> {
    let whole = |x: f64| {
        let cells = x / noded.summary.cell;
        assert!(
            cells.fract() == 0.0 && cells.abs() <= (1_u64 << 53) as f64,
            "{x} is not on the grid"
        );
        cells as i128
    };
    noded
        .points
        .iter()
        .map(|p| [whole(p.x), whole(p.y)])
        .collect()
}

/// Everything that holds for any input.
fn check(segments: &[Segment], points: &[Point], snap: Snap) -> Noded {
    let noded = node(segments, points, snap).expect("finite input within reach");
    let cells = cells(&noded);
    assert!(
        cells.is_sorted_by(|p, q| p < q),
        "vertices are distinct and in order"
    );
    assert!(
        noded.segments.is_sorted_by(|s, t| s < t),
        "edges are distinct and in order"
    );
    assert!(
        noded
            .segments
            .iter()
            .all(|&[a, b]| a < b && (b as usize) < cells.len())
    );

    // Noding again changes nothing.
    for snap in [Snap::Size(noded.summary.cell), Snap::Auto] {
        let edges: Vec<Segment> = noded
            .segments
            .iter()
            .map(|ends| ends.map(|v| noded.points[v as usize]))
            .collect();
        let again = node(&edges, &noded.points, snap).expect("it was on the grid");
        if again.summary.cell > noded.summary.cell {
            // The automatic grid can be coarser than a size that was asked for.
            continue;
        }
        assert_eq!(
            (&again.points, &again.segments),
            (&noded.points, &noded.segments)
        );
        assert_eq!(
            (again.summary.rounds, again.summary.largest_move),
            (0, [0.0, 0.0])
        );
    }

    // Neither order nor direction matters.
    let mut turned: Vec<Segment> = segments.iter().rev().map(|&[a, b]| [b, a]).collect();
    turned.rotate_left(segments.len() / 3);
    let turned = node(&turned, points, snap).expect("the same input");
    assert_eq!(
        (&turned.points, &turned.segments),
        (&noded.points, &noded.segments)
    );

    // Points move half a cell at most, chains stay near their segments, and go along edges.
    let cell = noded.summary.cell;
    let near = |p: Point, v: u32| {
        let to = noded.points[v as usize];
        (p.x - to.x).abs() <= cell / 2.0 && (p.y - to.y).abs() <= cell / 2.0
    };
    assert!(
        (0..)
            .zip(points)
            .all(|(i, &p)| near(p, noded.vertex_of_point(i).unwrap()))
    );
    let mut used = vec![false; noded.segments.len()];
    for (i, &[a, b]) in segments.iter().enumerate() {
        let chain: Vec<u32> = noded.chain(i).unwrap().collect();
        assert!(near(a, chain[0]) && near(b, chain[chain.len() - 1]));
        for edge in chain.windows(2) {
            let ends = [edge[0].min(edge[1]), edge[0].max(edge[1])];
            used[noded
                .segments
                .binary_search(&ends)
                .expect("chains go along edges")] = true;
        }
        let reach = (noded.summary.rounds + 1) as f64 / 2.0;
        for &v in &chain {
            assert!(
                is_near(noded.points[v as usize], [a, b], cell, reach),
                "chain {i} strays"
            );
        }
    }
    assert!(
        used.into_iter().all(|used| used),
        "every edge is of some segment"
    );
    noded
}

/// Is a vertex within so many cells of a segment, in each direction? To within an eighth.
fn is_near(p: Point, [a, b]: Segment, cell: f64, cells: f64) -> bool {
    let eighths = |p: Point| [p.x, p.y].map(|x| (x / cell * 8.0).round() as i128);
    let ([p, a, b], reach) = ([p, a, b].map(eighths), (8.0 * cells) as i128 + 1);
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let overlaps = (0..2).all(|axis| {
        a[axis].min(b[axis]) - reach <= p[axis] && p[axis] <= a[axis].max(b[axis]) + reach
    });
    overlaps && oracle::cross(a, b, p).abs() <= reach * (dx.abs() + dy.abs())
}

/// Edges meet only at common ends: every pair is tried.
fn is_plane(noded: &Noded) -> bool {
    let cells = cells(noded);
    let edges: Vec<[Whole; 2]> = noded
        .segments
        .iter()
        .map(|ends| ends.map(|v| cells[v as usize]))
        .collect();
    let boxes: Vec<[Whole; 2]> = edges
        .iter()
        .map(|[a, b]| {
            [
                [a[0].min(b[0]), a[1].min(b[1])],
                [a[0].max(b[0]), a[1].max(b[1])],
            ]
        })
        .collect();
    let apart = |[low, high]: [Whole; 2], [other_low, other_high]: [Whole; 2]| {
        high[0] < other_low[0]
            || high[1] < other_low[1]
            || other_high[0] < low[0]
            || other_high[1] < low[1]
    };
    // Edges are in the order of their left ends.
    (0..edges.len()).all(|i| {
        let reachable = (i + 1..edges.len()).take_while(|&j| boxes[j][0][0] <= boxes[i][1][0]);
        reachable
            .filter(|&j| !apart(boxes[i], boxes[j]))
            .all(|j| !oracle::clash(edges[i], edges[j]))
    }) && (0..edges.len()).all(|i| {
        let from = cells.partition_point(|p| p[0] < boxes[i][0][0]);
        let reachable = cells[from..].iter().take_while(|p| p[0] <= boxes[i][1][0]);
        reachable
            .filter(|&&p| !apart(boxes[i], [p, p]))
            .all(|&p| edges[i].contains(&p) || !oracle::clash(edges[i], [p, p]))
    })
}

fn quickcheck(size: usize, tests: u64, property: impl Testable) {
    QuickCheck::new()
        .rng(Gen::from_size_and_seed(size, 1))
        .tests(tests)
        .quickcheck(property);
}

/// Numbers are eighths, and cells an eighth to four.
fn agrees_with_oracle(raw: Vec<(i8, i8, i8, i8)>, single: Vec<(i8, i8)>, exponent: u8) -> bool {
    let size = 1_i128 << (exponent % 6);
    let of = |x: i8, y: i8| Point::new(f64::from(x) / 8.0, f64::from(y) / 8.0);
    let segments: Vec<Segment> = raw
        .iter()
        .map(|&(a, b, c, d)| [of(a, b), of(c, d)])
        .collect();
    let points: Vec<Point> = single.iter().map(|&(x, y)| of(x, y)).collect();
    let noded = check(&segments, &points, Snap::Size(size as f64 / 8.0));
    assert!(is_plane(&noded));

    let whole_segments: Vec<[Whole; 2]> = raw
        .iter()
        .map(|&(a, b, c, d)| [[a.into(), b.into()], [c.into(), d.into()]])
        .collect();
    let whole_points: Vec<Whole> = single.iter().map(|&(x, y)| [x.into(), y.into()]).collect();
    let ideal = oracle::node(&whole_segments, &whole_points, size);
    let cells = cells(&noded);
    assert!(cells.iter().eq(&ideal.vertices));
    let edges: BTreeSet<[Whole; 2]> = ideal
        .chains
        .iter()
        .flat_map(|chain| chain.windows(2))
        .map(|e| [e[0].min(e[1]), e[0].max(e[1])])
        .collect();
    assert!(
        noded
            .segments
            .iter()
            .map(|ends| ends.map(|v| cells[v as usize]))
            .eq(edges)
    );
    for (i, chain) in ideal.chains.iter().enumerate() {
        assert!(
            noded
                .chain(i)
                .unwrap()
                .map(|v| &cells[v as usize])
                .eq(chain)
        );
        assert!(
            noded
                .chain(i)
                .unwrap()
                .rev()
                .map(|v| &cells[v as usize])
                .eq(chain.iter().rev())
        );
    }
    let summary = noded.summary;
    assert_eq!(
        (summary.crossings, summary.rounds),
        (ideal.crossings, ideal.rounds)
    );
    assert_eq!(
        summary.split,
        ideal.chains.iter().filter(|chain| chain.len() > 2).count()
    );
    assert_eq!(
        summary.collapsed,
        ideal.chains.iter().filter(|chain| chain.len() == 1).count()
    );
    let distinct: BTreeSet<Whole> = whole_segments
        .iter()
        .flatten()
        .chain(&whole_points)
        .copied()
        .collect();
    assert_eq!(
        summary.merged,
        distinct.len() + ideal.crossings - cells.len()
    );
    true
}

#[test]
fn every_result_is_that_of_an_oracle() {
    for (size, tests) in [(4, 400), (12, 200), (50, 25)] {
        quickcheck(size, tests, agrees_with_oracle as fn(_, _, _) -> bool);
    }
}

#[test]
fn crowded_input_agrees_with_the_oracle() {
    // All in a square of 4 by 4, so that most pixels are hot and chains are bent many times.
    fn crowded(raw: Vec<(i8, i8, i8, i8)>, exponent: u8) -> bool {
        let near = |x: i8| x % 16;
        agrees_with_oracle(
            raw.iter()
                .map(|&(a, b, c, d)| (near(a), near(b), near(c), near(d)))
                .collect(),
            Vec::new(),
            exponent,
        )
    }
    quickcheck(20, 200, crowded as fn(_, _) -> bool);
}

#[test]
fn any_finite_numbers_are_noded() {
    // Whatever bits, those of infinities and NaN excepted.
    fn any(raw: Vec<(u64, u64, u64, u64)>) -> bool {
        let number = |bits: u64| {
            let x = f64::from_bits(bits);
            if x.is_finite() { x } else { 0.0 }
        };
        let segments: Vec<Segment> = raw
            .iter()
            .map(|&(a, b, c, d)| segment([number(a), number(b)], [number(c), number(d)]))
            .collect();
        is_plane(&check(&segments, &[], Snap::Auto))
    }
    // Numbers of full length and similar size, near parallels, coarse and fine cells.
    fn long(raw: Vec<(u32, u32, u32, i8)>, exponent: u8) -> bool {
        let number = |bits: u32| f64::from(bits) / 3.0;
        let segments: Vec<Segment> = raw
            .iter()
            .map(|&(a, b, c, d)| {
                segment(
                    [number(a), number(b)],
                    [number(c), number(b.wrapping_add(c)) + f64::from(d)],
                )
            })
            .collect();
        let coarse = Snap::Size(2.0_f64.powi(i32::from(exponent % 30)));
        is_plane(&check(&segments, &[], Snap::Auto)) && is_plane(&check(&segments, &[], coarse))
    }
    quickcheck(30, 100, any as fn(_) -> bool);
    quickcheck(30, 40, long as fn(_, _) -> bool);
}

#[test]
fn a_star_through_one_point_has_one_crossing() {
    let n = 3000_i32;
    let ray = |i: i32| [f64::from(i), f64::from(n - i)];
    let star: Vec<Segment> = (0..n)
        .map(|i| segment(ray(i).map(|x| -x), ray(i)))
        .collect();
    let noded = check(&star, &[], Snap::Auto);
    assert_eq!(counts(&noded), [6001, 6000, 1]);
    assert_eq!((noded.summary.crossings, noded.summary.split), (1, 3000));
}

#[test]
fn a_star_whose_lines_nearly_meet_is_plane() {
    // Sines and cosines are not exact, and neither is the point where the lines should meet.
    let star = |n: i32, [x, y]: [f64; 2]| -> Vec<Segment> {
        let ray = |i: i32| (TAU * f64::from(i) / f64::from(n) / 2.0).sin_cos();
        (0..n)
            .map(|i| (i, ray(i)))
            .map(|(_, (s, c))| segment([x - c, y - s], [x + c, y + s]))
            .collect()
    };
    assert!(is_plane(&check(&star(500, [0.1, 0.7]), &[], Snap::Auto)));
    let noded = check(&star(3000, [0.1, 0.7]), &[], Snap::Size(1e-9));
    assert_eq!(counts(&noded), [6001, 6000, 1]);
}

#[test]
fn overlaps_on_the_lines_of_a_grid_become_unit_edges() {
    let piece = |line: i32, from: i32, across: bool| {
        let [y, x, to] = [line, from, from + 3].map(f64::from);
        if across {
            segment([y, to], [y, x])
        } else {
            segment([x, y], [to, y])
        }
    };
    let pieces = (0..40).flat_map(|line| {
        (0..50).flat_map(move |from| [false, true].map(|across| piece(line, from, across)))
    });
    let noded = check(&pieces.collect::<Vec<_>>(), &[], Snap::Auto);
    // 40 lines each way, from 0 to 52.
    assert_eq!(counts(&noded), [2 * 40 * 53 - 40 * 40, 2 * 40 * 52, 1]);
    assert!(is_plane(&noded));
}

#[test]
fn thousands_of_segments_on_one_line_cost_and_give_thousands_of_edges() {
    let n = 5000_i32;
    let at = |i: i32| [3.0 * f64::from(i), 5.0 * f64::from(i)];
    // Nested: the chains have 25 million edges between them.
    let nested: Vec<Segment> = (0..n).map(|i| segment(at(i), at(2 * n - 1 - i))).collect();
    let noded = auto(&nested);
    assert_eq!(counts(&noded), [10_000, 9_999, 1]);
    assert_eq!((noded.summary.split, noded.summary.duplicates), (4_999, 0));
    assert!((0..5000).all(|i| noded.chain(i).unwrap().len() == 10_000 - 2 * i));
    assert!(noded.chain(4_000).unwrap().eq(4_000..6_000));
    // Overlapping, the same way and the other way, with repetitions.
    let overlapping: Vec<Segment> = (0..n)
        .flat_map(|i| [segment(at(i), at(i + 3)), segment(at(i + 3), at(i))])
        .collect();
    let noded = check(&overlapping, &[], Snap::Auto);
    assert_eq!(counts(&noded), [5_003, 5_002, 1]);
    assert_eq!(
        (noded.summary.split, noded.summary.duplicates),
        (10_000, 5_000)
    );
}

#[test]
fn a_fan_of_near_parallels_keeps_its_blades() {
    let n = 3000_i32;
    let fan: Vec<Segment> = (0..n)
        .map(|i| segment([0.0, 0.0], [1000.0, 1000.0 + f64::from(i) * 1e-7]))
        .collect();
    let noded = check(&fan, &[], Snap::Auto);
    assert_eq!((counts(&noded), noded.summary.rounds), ([3001, 3000, 1], 0));
    // A cell is far more than two blades are apart, all the way.
    let coarse = check(&fan, &[], Snap::Size(1.0));
    assert_eq!(counts(&coarse), [2, 1, 1]);
    // Blades with ends at different lengths cut each other's corners.
    let ragged: Vec<Segment> = (0..600)
        .map(|i| {
            segment(
                [0.0, 0.0],
                [1000.0 + f64::from(i * 37 % 100), 1000.0 + f64::from(i)],
            )
        })
        .collect();
    assert!(is_plane(&check(&ragged, &[], Snap::Size(4.0))));
}

#[test]
fn a_bundle_of_parallels_stays_apart_from_what_is_between() {
    // Long slanted lines beside each other, and short segments strewn between them over the whole length.
    let n = 2000_i32;
    let mut bundle: Vec<Segment> = (0..n)
        .map(f64::from)
        .map(|i| segment([i, -i], [1e9 + i, 1e9 - i]))
        .collect();
    let strewn = (0..n).map(|i| {
        (
            1e9 * (f64::from(i) + 0.5) / f64::from(n),
            f64::from(i * 7 % n) + 0.3,
        )
    });
    bundle.extend(
        strewn
            .clone()
            .map(|(t, o)| segment([t + o, t - o], [t + o + 0.2, t - o + 0.1])),
    );
    let noded = check(&bundle, &[], Snap::Auto);
    assert_eq!(counts(&noded), [8000, 4000, 4000]);
    // Longer ones cross one line each, the one at the next whole number, or none.
    bundle.truncate(n as usize);
    bundle.extend(strewn.map(|(t, o)| segment([t + o, t - o], [t + o + 1.0, t - o - 1.0])));
    let noded = check(&bundle, &[], Snap::Auto);
    // All cross but the one beyond the last line.
    assert_eq!(counts(&noded), [8000 + 1999, 4000 + 2 * 1999, 2000 + 1]);
}

#[test]
fn spirals_stay_as_they_are_and_cross_as_often_as_they_should() {
    let corner = |i: i32, turn: f64| {
        let (s, c) = (TAU / 4.0 * (f64::from(i) + turn)).sin_cos();
        let r = f64::from(i) + 1.0;
        Point::new(c * r, s * r)
    };
    let spiral = |turn: f64| -> Vec<Segment> {
        (0..4000)
            .map(|i| [corner(i, turn), corner(i + 1, turn)])
            .collect()
    };
    let noded = check(&spiral(0.2), &[], Snap::Auto);
    assert_eq!(counts(&noded), [4001, 4000, 1]);
    // Two of them, one turned by an eighth.
    let both: Vec<Segment> = spiral(0.2)[..300]
        .iter()
        .chain(&spiral(0.7)[..300])
        .copied()
        .collect();
    assert!(is_plane(&check(&both, &[], Snap::Auto)));
    assert!(is_plane(&check(&both, &[], Snap::Size(2.0))));
}

#[test]
fn nested_squares_stay_apart_or_touch_at_corners() {
    let square =
        |corners: [[f64; 2]; 4]| [0, 1, 2, 3].map(|i| segment(corners[i], corners[(i + 1) % 4]));
    let upright = |r: f64| [[r, r], [-r, r], [-r, -r], [r, -r]];
    let slanted = |r: f64| [[r, 0.0], [0.0, r], [-r, 0.0], [0.0, -r]];
    for nest in [upright, slanted] {
        let squares: Vec<Segment> = (1..=1000)
            .flat_map(|r| square(nest(f64::from(r) / 3.0)))
            .collect();
        assert_eq!(
            counts(&check(&squares, &[], Snap::Auto)),
            [4000, 4000, 1000]
        );
    }
    // Each inscribed in the last one, with its corners on the middles of the sides.
    let inscribed: Vec<Segment> = (0..40)
        .flat_map(|i| {
            let r = 2.0_f64.powi(45 - i);
            square(upright(r)).into_iter().chain(square(slanted(r)))
        })
        .collect();
    let noded = check(&inscribed, &[], Snap::Size(1.0));
    assert_eq!(counts(&noded), [4 * 80, 4 * 80 + 4 * 79, 1]);
    assert_eq!(noded.summary.crossings, 0);
}

#[test]
fn coordinates_at_the_extremes_are_noded_or_refused() {
    // The largest and the smallest doubles, on the grid that fits them.
    for r in [f64::MAX, 2.0_f64.powi(1023), f64::MIN_POSITIVE, 5e-324] {
        let noded = check(
            &[segment([-r, -r], [r, r]), segment([-r, r], [r, -r])],
            &[],
            Snap::Auto,
        );
        assert_eq!(counts(&noded), [5, 4, 1], "{r:e}");
        assert_eq!(noded.points[2], Point::new(0.0, 0.0));
    }
    // Beside the largest, the small ones are one point.
    let mixed = [
        segment([1e300, 0.0], [-1e300, 1.0]),
        segment([1e-300, 1.0], [-1.0, 1e100]),
    ];
    assert_eq!(counts(&check(&mixed, &[], Snap::Auto)), [3, 2, 1]);
    // 2^53 cells are in reach, and more are not.
    let far = 2.0_f64.powi(53);
    let reaching = [
        segment([-far, far], [far, -far]),
        segment([-far, -far], [far, far - 1.0]),
    ];
    let noded = check(&reaching, &[], Snap::Size(1.0));
    assert_eq!(counts(&noded), [5, 4, 1]);
    let out = |at| Some(NodingError::OutOfRange { at });
    let error = |segments: &[Segment], points: &[Point], snap| node(segments, points, snap).err();
    let [inside, beyond] = [
        segment([0.0, 0.0], [1.0, 1.0]),
        segment([0.0, 0.0], [far + 2.0, 0.0]),
    ];
    assert_eq!(
        error(&[inside, beyond], &[], Snap::Size(1.0)),
        out(Input::Segment(1))
    );
    assert_eq!(
        error(&[inside], &[Point::new(0.0, -1e300)], Snap::Size(1.0)),
        out(Input::Point(0))
    );
    assert_eq!(
        error(&[inside], &[], Snap::Size(1e-300)),
        out(Input::Segment(0))
    );
    // The nearest multiple of 2^1000 is infinite.
    assert_eq!(
        error(
            &[segment([0.0, 0.0], [0.0, f64::MAX])],
            &[],
            Snap::Size(2.0_f64.powi(1000))
        ),
        out(Input::Segment(0))
    );
    assert_eq!(
        error(
            &[segment([0.0, 0.0], [0.0, 1e300])],
            &[],
            Snap::Size(2.0_f64.powi(1000))
        ),
        None
    );
}

#[test]
fn what_is_not_finite_is_refused_with_its_place() {
    let good = segment([0.0, 0.0], [1.0, 1.0]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for broken in [
            segment([bad, 0.0], [0.0, 0.0]),
            segment([0.0, 0.0], [0.0, bad]),
        ] {
            let error = node(&[good, good, broken, broken], &[], Snap::Auto).unwrap_err();
            assert_eq!(
                error,
                NodingError::NotFinite {
                    at: Input::Segment(2)
                }
            );
        }
        let error = node(
            &[good],
            &[Point::default(), Point::new(1.0, bad)],
            Snap::Auto,
        )
        .unwrap_err();
        assert_eq!(
            error,
            NodingError::NotFinite {
                at: Input::Point(1)
            }
        );
        assert_eq!(
            error.to_string(),
            "point 1 has a coordinate that is not a finite number"
        );
        assert_eq!(
            node(&[good], &[], Snap::Size(bad)).unwrap_err(),
            NodingError::Size
        );
    }
    for size in [0.0, -0.0, -1.0] {
        assert_eq!(
            node(&[good], &[], Snap::Size(size)).unwrap_err(),
            NodingError::Size
        );
    }
}

#[test]
fn sizes_are_rounded_down_to_powers_of_two() {
    let one = [segment([0.0, 0.0], [1.0, 1.0])];
    for (size, cell) in [
        (1.0, 1.0),
        (1.9, 1.0),
        (0.1, 0.0625),
        (3e-5, 2.0_f64.powi(-16)),
        (1000.0, 512.0),
    ] {
        assert_eq!(
            node(&one, &[], Snap::Size(size)).unwrap().summary.cell,
            cell
        );
    }
}

#[test]
fn nothing_comes_of_nothing_and_points_of_points() {
    let nothing = auto(&[]);
    assert_eq!((counts(&nothing), nothing.summary.cell), ([0, 0, 0], 1.0));
    assert!(nothing.chain(0).is_none() && nothing.vertex_of_point(0).is_none());
    let p = Point::new(0.25, -0.0);
    let noded = check(
        &[[p, p]],
        &[p, Point::new(0.3, 0.1), Point::new(2.0, 2.0)],
        Snap::Size(1.0),
    );
    assert_eq!(noded.points, [Point::new(0.0, 0.0), Point::new(2.0, 2.0)]);
    assert!(noded.points.iter().all(|p| p.y.is_sign_positive()));
    assert_eq!(
        [0, 1, 2, 3].map(|i| noded.vertex_of_point(i)),
        [Some(0), Some(0), Some(1), None]
    );
    assert!(noded.chain(0).unwrap().eq([0]));
    assert_eq!((noded.summary.collapsed, noded.summary.merged), (1, 1));
    assert_eq!(noded.summary.largest_move, [0.3, 0.1]);
}

#[test]
fn a_point_on_a_segment_splits_it_and_one_beside_it_bends_it() {
    let long = [segment([0.0, 0.0], [10.0, 0.0])];
    let on = check(&long, &[Point::new(4.0, 0.0)], Snap::Size(1.0));
    assert!(on.chain(0).unwrap().eq([0, 1, 2]));
    // The pixel of a vertex half a cell above a line has the line on its lower side; half a cell below, on its upper side.
    let slanted = [segment([0.0, 0.0], [2.0, 1.0])];
    let above = check(&slanted, &[Point::new(1.0, 1.0)], Snap::Size(1.0));
    assert_eq!(counts(&above), [3, 2, 1]);
    let below = check(&slanted, &[Point::new(1.0, 0.0)], Snap::Size(1.0));
    assert_eq!(counts(&below), [3, 2, 1]);
    let away = check(&slanted, &[Point::new(1.0, -1.0)], Snap::Size(1.0));
    assert_eq!(counts(&away), [3, 1, 2]);
}

#[test]
fn a_vertex_near_a_coarsely_rounded_segment_does_not_change_sides() {
    // The tip is just above the long side. Were the ends rounded first, it would get below, and there would be crossings.
    let long = segment([0.4, 0.4], [100.4, 33.6]);
    let tip = Point::new(50.4, 17.01);
    let spike = [
        long,
        [tip, Point::new(49.0, 30.0)],
        [tip, Point::new(52.0, 30.0)],
    ];
    let noded = check(&spike, &[], Snap::Size(1.0));
    assert_eq!(noded.summary.crossings, 0);
    // The long side goes through the tip's vertex or stays below it.
    let at_tip = noded.points[noded.chain(1).unwrap().next().unwrap() as usize];
    let way: Vec<Point> = noded
        .chain(0)
        .unwrap()
        .map(|v| noded.points[v as usize])
        .collect();
    assert!(way.contains(&at_tip));
}

/// The segments of all rings, ring after ring.
fn map(text: &str) -> Vec<Segment> {
    let value: serde_json::Value = serde_json::from_str(text).expect("JSON");
    let mut segments = Vec::new();
    let mut stack: Vec<&serde_json::Value> = value["features"]
        .as_array()
        .expect("features")
        .iter()
        .map(|feature| &feature["geometry"]["coordinates"])
        .collect();
    while let Some(list) = stack.pop().and_then(serde_json::Value::as_array) {
        let points: Vec<Point> = list
            .iter()
            .filter_map(|p| Some(Point::new(p.get(0)?.as_f64()?, p.get(1)?.as_f64()?)))
            .collect();
        if points.is_empty() {
            stack.extend(list);
        }
        segments.extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    segments
}

#[test]
fn two_crossings_of_the_small_world_are_cut() {
    let noded = check(
        &map(include_str!("data/world-110m-crossing.geojson")),
        &[],
        Snap::Auto,
    );
    assert_eq!(counts(&noded), [7_493, 7_655, 125]);
    let summary = noded.summary;
    assert_eq!(
        (summary.crossings, summary.rounds, summary.merged),
        (2, 1, 0)
    );
    // The two points where the borders cross, as GEOS and others have them.
    for [x, y] in [[24.038_88, 8.673_2], [33.964, 9.463]] {
        assert!(
            noded
                .points
                .iter()
                .any(|p| (p.x - x).abs() < 0.5 && (p.y - y).abs() < 0.5)
        );
    }
}

#[test]
fn the_small_world_is_plane_as_it_stands() {
    let noded = check(
        &map(include_str!("../cli/data/world-110m.geojson")),
        &[],
        Snap::Auto,
    );
    assert_eq!(counts(&noded), [7_493, 7_655, 125]);
    assert_eq!(
        (
            noded.summary.crossings,
            noded.summary.split,
            noded.summary.merged
        ),
        (0, 0, 0)
    );
}

#[test]
fn the_large_world_is_plane_as_it_stands() {
    let rings = map(include_str!("data/world-50m.geojson"));
    let noded = check(&rings, &[], Snap::Auto);
    assert_eq!(counts(&noded), [75_685, 75_863, 1_438]);
    assert_eq!(
        (
            noded.summary.crossings,
            noded.summary.split,
            noded.summary.merged
        ),
        (0, 0, 0)
    );
    assert_eq!(noded.summary.duplicates, rings.len() - 75_863);
    // On a coarse grid much is merged, and the rest is plane.
    let coarse = check(&rings, &[], Snap::Size(0.1));
    assert!(is_plane(&coarse) && coarse.summary.merged > 0 && coarse.points.len() < 70_000);
}
