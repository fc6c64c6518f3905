//! The numbers of live records that determine components and the genus.

use super::surface_counts::SurfaceCounts;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub(super) half_edges: usize,
    pub(super) rotations: usize,
    /// Boundary components that start at a half-edge.
    pub(super) cycles: usize,
    pub(super) roots: usize,
    pub(super) unbounded: usize,
    /// Boundary components without a face, of an open surface.
    pub(super) holes: usize,
}

impl Sums {
    /// Euler's formula.
    pub(super) const fn fit(self, genus: usize) -> bool {
        let orbits = self.rotations as u128 + self.cycles as u128;
        2 * orbits + 4 * genus as u128 == self.half_edges as u128 + 4 * self.roots as u128
    }

    /// Computes the counts, with the genus that fits, if there is one.
    pub(super) const fn counts(self) -> SurfaceCounts {
        let edge_side = self.half_edges as u128 + 4 * self.roots as u128;
        let orbits = self.rotations as u128 + self.cycles as u128;
        SurfaceCounts {
            genus: (edge_side.saturating_sub(2 * orbits) / 4) as usize,
            components: self.roots,
            holes: self.holes,
            vertices: self.rotations,
            edges: self.half_edges / 2,
            faces: self.cycles.saturating_sub(self.holes),
        }
    }
}
