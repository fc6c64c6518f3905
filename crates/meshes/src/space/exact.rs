//! Sums of products of three numbers, exactly.
//!
//! Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete &
//! Computational Geometry 18 (1997), 305–363: a sum is kept as an expansion of numbers that do not overlap, the smallest first.

use super::places::{Place, sign};
use std::cmp::Ordering;

#[derive(Default)]
pub(super) struct Sum {
    parts: Vec<f64>,
}

impl Sum {
    /// Adds a number. O(parts), with at most about 40 parts.
    fn add(&mut self, number: f64) {
        let mut carried = number;
        self.parts.retain_mut(|part| {
            let sum = carried + *part;
            let of_part = sum - carried;
            let lost = (carried - (sum - of_part)) + (*part - of_part);
            carried = sum;
            *part = lost;
            lost != 0.0
        });
        if carried != 0.0 {
            self.parts.push(carried);
        }
    }

    /// Adds six times the volume between a triangle and the origin.
    pub(super) fn add_volume(&mut self, [a, b, c]: [Place; 3]) {
        for [x, y, z] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            self.add_product(a[x], b[y], c[z]);
            self.add_product(-a[x], b[z], c[y]);
        }
    }

    fn add_product(&mut self, a: f64, b: f64, c: f64) {
        let [high, low] = product(a, b);
        for part in [high, low] {
            let [high, low] = product(part, c);
            self.add(low);
            self.add(high);
        }
    }

    /// Returns the sign of the largest part, which is the sign of the sum.
    pub(super) fn sign(&self) -> Ordering {
        sign(self.parts.last().copied().unwrap_or_default())
    }
}

/// Returns a product and its rounding error.
fn product(a: f64, b: f64) -> [f64; 2] {
    let high = a * b;
    [high, a.mul_add(b, -high)]
}

/// Returns the sign of the volume inside triangles that face outwards: by rounded numbers, or else exactly. O(triangles).
pub(super) fn sign_of_volume(triangles: &[[Place; 3]]) -> Ordering {
    let (mut sum, mut size) = (0.0, 0.0);
    for [a, b, c] in triangles {
        for [x, y, z] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            let (forth, back) = (a[x] * b[y] * c[z], a[x] * b[z] * c[y]);
            sum += forth - back;
            size += forth.abs() + back.abs();
        }
    }
    // Each of the 6 n products is rounded twice, and each sum of them once.
    let error = size * f64::EPSILON * (6.0 * triangles.len() as f64 + 8.0);
    if sum.abs() > error {
        return sign(sum);
    }
    let mut exact = Sum::default();
    for triangle in triangles {
        exact.add_volume(*triangle);
    }
    exact.sign()
}
