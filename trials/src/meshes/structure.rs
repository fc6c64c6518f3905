//! The structure of triangulations under test.

use super::build::build;
use super::outcome::Shape;
use super::triangulations::Triangulation;
use crate::structure::Structure;
use twinedge::program::conformance::Conformance;
use twinedge::program::{Refusal, Subject};
use twinedge::validate::Expectation;

enum Make<K> {
    Triangles(fn(&Triangulation) -> K),
    Operators(Structure<K>),
}

/// A structure under test on which triangulations are made.
pub struct MeshStructure<K> {
    name: &'static str,
    make: Make<K>,
    asked: Conformance,
    is_open: bool,
}

impl<K> std::fmt::Debug for MeshStructure<K> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MeshStructure").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<K: Subject> MeshStructure<K> {
    /// Returns a structure of this name that is made from triangles. It has spheres, and discs if the expectation is
    /// [open](Expectation::open).
    #[must_use]
    pub fn new(name: &'static str, make: fn(&Triangulation) -> K, expectation: Expectation) -> Self {
        let asked = Conformance::of(&expectation);
        Self { name, make: Make::Triangles(make), asked, is_open: expectation.is_open() }
    }

    /// Returns a structure of planar maps, on which triangulated discs are built by its operators `add_isolated_vertex`,
    /// `split_vertex` and `connect`. The unbounded face surrounds them.
    #[must_use]
    pub fn plane(structure: Structure<K>) -> Self {
        let asked = Conformance::of(&structure.expectation());
        Self { name: structure.name(), make: Make::Operators(structure), asked, is_open: true }
    }

    /// Allows the structure to reuse the handle of a removed record.
    #[must_use]
    pub fn without_stale_handles(mut self) -> Self {
        self.asked = self.asked.without_stale_handles();
        self
    }

    pub(super) const fn name(&self) -> &'static str {
        self.name
    }

    pub(super) const fn asked(&self) -> Conformance {
        self.asked
    }

    pub(super) const fn has(&self, shape: Shape) -> bool {
        match shape {
            Shape::Sphere { .. } => matches!(self.make, Make::Triangles(_)),
            Shape::Disc { .. } => self.is_open,
        }
    }

    pub(super) fn make(&self, map: &Triangulation) -> Result<K, Refusal> {
        match &self.make {
            Make::Triangles(make) => Ok(make(map)),
            Make::Operators(structure) => {
                let mut subject = structure.make();
                build(&mut subject, map)?;
                Ok(subject)
            }
        }
    }
}
