//! Iterated snap rounding by definition, in whole numbers: slow and obvious.

use std::cmp::Ordering;
use std::collections::BTreeSet;

pub(crate) type Whole = [i128; 2];

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

/// Returns true if two segments, or a segment and a point, have a point in common that is not an end of both.
pub(crate) fn clash([a, b]: [Whole; 2], [c, d]: [Whole; 2]) -> bool {
    let signs = [cross(a, b, c), cross(a, b, d), cross(c, d, a), cross(c, d, b)].map(i128::signum);
    let inside = |[p, q]: [Whole; 2], r: Whole| p.min(q) < r && r < p.max(q) && cross(p, q, r) == 0;
    let crossing = signs[0] * signs[1] < 0 && signs[2] * signs[3] < 0;
    let same = [a.min(b), a.max(b)] == [c.min(d), c.max(d)];
    crossing || same || inside([a, b], c) || inside([a, b], d) || inside([c, d], a) || inside([c, d], b)
}

/// Returns the times at which a point moving from `a` to `b` enters and leaves a pixel.
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
        let (at_low, at_high) = ((Fraction::new(low - start, step), true), (Fraction::new(high - start, step), false));
        let (enters, leaves) = if step > 0 { (at_low, at_high) } else { (at_high, at_low) };
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
    let mut visits: Vec<(Whole, [Fraction; 2])> =
        hot.iter().filter_map(|&pixel| Some((pixel, visit(a, b, pixel, size)?))).collect();
    visits.sort_by(|(_, [p, q]), (_, [r, s])| p.order(*r).then(q.order(*s)));
    visits.into_iter().map(|(pixel, _)| pixel).collect()
}

fn pixel(numerators: Whole, denominator: i128, size: i128) -> Whole {
    numerators.map(|n| (2 * n + size * denominator).div_euclid(2 * size * denominator))
}

/// The pixel of the common point of two segments, unless they are parallel.
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
    meets.then(|| pixel([a[0] * whole + along * dx, a[1] * whole + along * dy], whole, size))
}

pub(crate) struct Ideal {
    pub(crate) vertices: BTreeSet<Whole>,
    pub(crate) chains: Vec<Vec<Whole>>,
    pub(crate) crossings: usize,
    pub(crate) rounds: usize,
}

/// Iterated snap rounding by definition, for segments and points in steps, and pixels of `size` steps.
pub(crate) fn node(segments: &[[Whole; 2]], points: &[Whole], size: i128) -> Ideal {
    let ends: BTreeSet<Whole> = segments.iter().flatten().chain(points).map(|&p| pixel(p, 1, size)).collect();
    let pairs = segments.iter().enumerate().flat_map(|(i, s)| segments[..i].iter().map(move |t| (s, t)));
    let meetings = pairs.filter_map(|(&s, &t)| meeting(s, t, size));
    let vertices: BTreeSet<Whole> = ends.iter().copied().chain(meetings).collect();
    let mut chains: Vec<Vec<Whole>> = segments.iter().map(|&s| snapped(&vertices, s, size)).collect();
    let mut rounds = usize::from(chains.iter().any(|chain| chain.len() > 2));
    loop {
        let bent: Vec<Vec<Whole>> = chains
            .iter()
            .map(|chain| {
                let edges = chain.windows(2).map(|edge| snapped(&vertices, [edge[0], edge[1]], 1));
                chain[..1].iter().copied().chain(edges.flat_map(|pieces| pieces[1..].to_vec())).collect()
            })
            .collect();
        if bent == chains {
            let crossings = vertices.len() - ends.len();
            return Ideal { vertices, chains, crossings, rounds };
        }
        rounds += 1;
        chains = bent;
    }
}
