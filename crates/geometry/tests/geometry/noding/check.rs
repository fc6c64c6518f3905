//! Laws for all input.

use crate::noding::oracle::{self, Whole};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Noded, Snap, node};

pub(crate) type Segment = [Point; 2];

pub(crate) fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
    [a.into(), b.into()]
}

pub(crate) fn auto(segments: &[Segment]) -> Noded {
    node(segments, &[], Snap::Auto).expect("finite input")
}

pub(crate) fn counts(noded: &Noded) -> [usize; 3] {
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

/// The vertices as whole numbers of cells. Panics if a vertex is off the grid.
pub(crate) fn cells(noded: &Noded) -> Vec<Whole> {
    let whole = |x: f64| {
        let cells = (x / noded.summary.cell).round();
        let is_on = noded.summary.snapped(Point::new(x, x)) == Point::new(x, x);
        assert!(is_on && cells.abs() <= (1_u64 << 53) as f64, "{x} is not on the grid");
        cells as i128
    };
    noded.points.iter().map(|p| [whole(p.x), whole(p.y)]).collect()
}

pub(crate) fn check(segments: &[Segment], points: &[Point], snap: Snap) -> Noded {
    let noded = node(segments, points, snap).expect("finite input within reach");
    let cells = cells(&noded);
    assert!(cells.is_sorted_by(|p, q| p < q), "vertices are distinct and in order");
    assert!(noded.segments.is_sorted_by(|s, t| s < t), "edges are distinct and in order");
    assert!(noded.segments.iter().all(|&[a, b]| a < b && (b as usize) < cells.len()));

    // Noding again changes nothing.
    for snap in [Snap::Size(noded.summary.cell), Snap::Auto] {
        let edges: Vec<Segment> = noded.segments.iter().map(|ends| ends.map(|v| noded.points[v as usize])).collect();
        let again = node(&edges, &noded.points, snap).expect("it was on the grid");
        let [cell, of_first] = [again.summary.cell, noded.summary.cell];
        let order = cell.total_cmp(&of_first);
        if order.is_gt() || order.is_lt() && of_first.log2().fract() != 0.0 {
            // The automatic grid can be coarser than a requested size, and lacks the points of a decimal grid.
            continue;
        }
        assert_eq!((&again.points, &again.segments), (&noded.points, &noded.segments));
        assert_eq!((again.summary.rounds, again.summary.largest_move), (0, [0.0, 0.0]));
    }

    // Neither order nor direction matters.
    let mut turned: Vec<Segment> = segments.iter().rev().map(|&[a, b]| [b, a]).collect();
    turned.rotate_left(segments.len() / 3);
    let turned = node(&turned, points, snap).expect("the same input");
    assert_eq!((&turned.points, &turned.segments), (&noded.points, &noded.segments));

    // Points move at most half a cell, chains stay near their segments and run along edges.
    let cell = noded.summary.cell;
    let near = |p: Point, v: u32| {
        let to = noded.points[v as usize];
        // The centre of a cell is rounded, unless the width is a power of two.
        let most = cell / 2.0 + if cell.log2().fract() == 0.0 { 0.0 } else { 1e-14 * to.x.abs().max(to.y.abs()) };
        (p.x - to.x).abs() <= most && (p.y - to.y).abs() <= most
    };
    assert!((0..).zip(points).all(|(i, &p)| near(p, noded.vertex_of_point(i).unwrap())));
    let mut used = vec![false; noded.segments.len()];
    for (i, &[a, b]) in segments.iter().enumerate() {
        let chain: Vec<u32> = noded.chain(i).unwrap().collect();
        assert!(near(a, chain[0]) && near(b, chain[chain.len() - 1]));
        for edge in chain.windows(2) {
            let ends = [edge[0].min(edge[1]), edge[0].max(edge[1])];
            used[noded.segments.binary_search(&ends).expect("chains go along edges")] = true;
        }
        let reach = (noded.summary.rounds + 1) as f64 / 2.0;
        for &v in &chain {
            assert!(is_near(noded.points[v as usize], [a, b], cell, reach), "chain {i} strays");
        }
    }
    assert!(used.into_iter().all(|used| used), "every edge is of some segment");
    noded
}

/// Returns true if a vertex is within `cells` cells of a segment, in each direction, to within an eighth.
pub(crate) fn is_near(p: Point, [a, b]: Segment, cell: f64, cells: f64) -> bool {
    let eighths = |p: Point| [p.x, p.y].map(|x| (x / cell * 8.0).round() as i128);
    let ([p, a, b], reach) = ([p, a, b].map(eighths), (8.0 * cells) as i128 + 1);
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let overlaps =
        (0..2).all(|axis| a[axis].min(b[axis]) - reach <= p[axis] && p[axis] <= a[axis].max(b[axis]) + reach);
    overlaps && oracle::cross(a, b, p).abs() <= reach * (dx.abs() + dy.abs())
}

/// Edges meet only at common ends: every pair is tried.
pub(crate) fn is_plane(noded: &Noded) -> bool {
    let cells = cells(noded);
    let edges: Vec<[Whole; 2]> = noded.segments.iter().map(|ends| ends.map(|v| cells[v as usize])).collect();
    let boxes: Vec<[Whole; 2]> =
        edges.iter().map(|[a, b]| [[a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]]).collect();
    let apart = |[low, high]: [Whole; 2], [other_low, other_high]: [Whole; 2]| {
        high[0] < other_low[0] || high[1] < other_low[1] || other_high[0] < low[0] || other_high[1] < low[1]
    };
    // Edges are in the order of their left ends.
    (0..edges.len()).all(|i| {
        let reachable = (i + 1..edges.len()).take_while(|&j| boxes[j][0][0] <= boxes[i][1][0]);
        reachable.filter(|&j| !apart(boxes[i], boxes[j])).all(|j| !oracle::clash(edges[i], edges[j]))
    }) && (0..edges.len()).all(|i| {
        let from = cells.partition_point(|p| p[0] < boxes[i][0][0]);
        let reachable = cells[from..].iter().take_while(|p| p[0] <= boxes[i][1][0]);
        reachable
            .filter(|&&p| !apart(boxes[i], [p, p]))
            .all(|&p| edges[i].contains(&p) || !oracle::clash(edges[i], [p, p]))
    })
}
