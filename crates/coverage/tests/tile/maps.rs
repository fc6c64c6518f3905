//! Maps to cut into tiles.

use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

/// Random numbers by xorshift, equal in every run.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) % n as u64) as usize
    }

    /// A random choice among `n` numbers from `low` on.
    pub(crate) fn from(&mut self, low: i32, n: i32) -> i32 {
        let n = usize::try_from(n).expect("a number of choices");
        low + i32::try_from(self.below(n)).expect("a small number")
    }

    /// Up to two positions of lines, in order: 33 multiples of a fraction of 1.
    pub(crate) fn lines(&mut self, low: i32, parts: f64) -> Vec<f64> {
        let mut at = vec![self.from(low, 33), self.from(low, 33)];
        at.sort_unstable();
        at.dedup();
        at.truncate(self.below(4));
        at.into_iter().map(|at| f64::from(at) / parts).collect()
    }

    /// Up to two different positions, in order.
    pub(crate) fn pair(&mut self, position: impl Fn(&mut Self) -> f64) -> Vec<f64> {
        let mut at = [position(self), position(self)];
        at.sort_by(f64::total_cmp);
        at[..if at[0] < at[1] { self.below(3) } else { 1 }].to_vec()
    }

    pub(crate) fn part(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// All sets of at most two of these positions.
pub(crate) fn sets(at: &[f64]) -> Vec<Vec<f64>> {
    let twos = (0..at.len()).flat_map(|j| (0..j).map(move |i| vec![at[i], at[j]]));
    [Vec::new()].into_iter().chain(at.iter().map(|at| vec![*at])).chain(twos).collect()
}

pub(crate) fn feature(shapes: impl Into<Vec<Shape>>) -> Feature {
    Feature { shapes: shapes.into(), ..Feature::default() }
}

pub(crate) fn area([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Shape {
    Shape::polygon([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
}

pub(crate) fn line(points: &[[f64; 2]]) -> Shape {
    Shape::line(points.iter().copied())
}

pub(crate) fn point(x: f64, y: f64) -> Shape {
    Shape::Point(Point::new(x, y))
}

/// The edges of a lattice of 3 by 3 points, and one diagonal of each of its squares.
pub(crate) fn lattice_edges() -> Vec<[[f64; 2]; 2]> {
    let mut edges = Vec::new();
    for x in 0..3 {
        for y in 0..3 {
            let at = |dx: i32, dy: i32| [f64::from(x + dx), f64::from(y + dy)];
            if x < 2 {
                edges.push([at(0, 0), at(1, 0)]);
            }
            if y < 2 {
                edges.push([at(0, 0), at(0, 1)]);
            }
            if x < 2 && y < 2 {
                edges.push(if (x + y) % 2 == 0 { [at(0, 0), at(1, 1)] } else { [at(1, 0), at(0, 1)] });
            }
        }
    }
    edges
}

/// Nested squares, side by side or apart, with isolated vertices between, on an integer lattice.
pub(crate) fn nested(low: [i32; 2], high: [i32; 2], random: &mut Random, into: &mut Vec<Feature>) {
    let [width, height] = [high[0] - low[0], high[1] - low[1]];
    let at = |[x, y]: [i32; 2]| [f64::from(x), f64::from(y)];
    if width < 3 || height < 3 {
        if width == 2 && height == 2 && random.below(2) == 0 {
            into.push(feature([point(f64::from(low[0] + 1), f64::from(low[1] + 1))]));
        }
        return;
    }
    match random.below(4) {
        0 => {
            let inner = ([low[0] + 1, low[1] + 1], [high[0] - 1, high[1] - 1]);
            let kind = random.below(3);
            let ring = [[inner.0[0], inner.0[1]], [inner.1[0], inner.0[1]], inner.1, [inner.0[0], inner.1[1]]].map(at);
            into.push(feature([if kind == 0 {
                Shape::line(ring.into_iter().chain([ring[0]]))
            } else if kind == 1 && width > 5 && height > 5 {
                area(at(inner.0), at(inner.1)).hole([
                    at([inner.0[0] + 1, inner.0[1] + 1]),
                    at([inner.0[0] + 1, inner.1[1] - 1]),
                    at([inner.1[0] - 1, inner.0[1] + 1]),
                ])
            } else {
                Shape::polygon(ring)
            }]));
            if kind == 1 && width > 5 && height > 5 {
                return;
            }
            nested(inner.0, inner.1, random, into);
        }
        1 if width > 4 => {
            let middle = random.from(low[0] + 1, width - 2);
            nested(low, [middle, high[1]], random, into);
            nested([middle, low[1]], high, random, into);
        }
        2 if height > 4 => {
            let middle = random.from(low[1] + 1, height - 2);
            nested(low, [high[0], middle], random, into);
            nested([low[0], middle], high, random, into);
        }
        _ => {
            let p = [random.from(low[0] + 1, width - 1), random.from(low[1] + 1, height - 1)];
            let q = [random.from(low[0] + 1, width - 1), high[1] - 1];
            into.push(feature([if p == q { Shape::Point(at(p).into()) } else { line(&[p, q].map(at)) }]));
        }
    }
}
