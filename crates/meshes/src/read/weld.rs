//! One point for all corners with the same coordinates.

use super::builder::Builder;
use super::error::{Failure, Position};
use std::collections::HashMap;

#[derive(Default)]
pub(super) struct Weld {
    numbers: HashMap<[u64; 3], u32>,
}

impl Weld {
    /// Adds a corner to the face that is being read, and its point if it is new.
    pub(super) fn corner(&mut self, mesh: &mut Builder, point: [f64; 3], at: Position) -> Result<(), Failure> {
        // Adding 0 turns −0 into 0, which is the same place.
        let place = point.map(|coordinate| (coordinate + 0.0).to_bits());
        let next = mesh.points().len() as u32;
        let number = *self.numbers.entry(place).or_insert(next);
        if number == next {
            mesh.point(point, at)?;
        }
        mesh.corner(i64::from(number), at)
    }
}
