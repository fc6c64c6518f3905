//! The options of meshes.

use twinedge::validate::Expectation;
use twinedge_meshes::{HalfEdgeMesh, SpaceRule};

/// The properties that a mesh must have.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Meshes")]
#[allow(clippy::struct_excessive_bools, reason = "each is a switch of its own on the command line")]
pub(super) struct MeshOptions {
    /// The mesh has no border.
    #[arg(long, conflicts_with = "borders")]
    closed: bool,

    /// The mesh has exactly N border loops.
    #[arg(long, value_name = "N", value_parser = crate::input::whole, allow_negative_numbers = true)]
    borders: Option<usize>,

    /// The genus of the whole mesh is N: 0 for spheres and discs, 1 for a torus.
    #[arg(long, value_name = "N", value_parser = crate::input::whole, allow_negative_numbers = true)]
    genus: Option<usize>,

    /// The mesh has exactly N components.
    #[arg(long, value_name = "N", value_parser = crate::input::whole, allow_negative_numbers = true)]
    components: Option<usize>,

    /// Every face has three sides.
    #[arg(long, conflicts_with = "sides")]
    triangles: bool,

    /// Every face has N sides.
    #[arg(long, value_name = "N", value_parser = crate::input::whole, allow_negative_numbers = true)]
    sides: Option<usize>,

    /// Every vertex is a corner of a face.
    #[arg(long)]
    no_unused_vertices: bool,

    /// No face has all its corners on one line (M9).
    #[arg(long)]
    no_zero_area: bool,

    /// Faces meet in common corners and edges only (M10). Faces with more than three sides have to be convex for that.
    #[arg(long)]
    no_crossings: bool,

    /// The faces of closed components face outwards, or inwards around a cavity (M11).
    #[arg(long)]
    outward: bool,
}

impl MeshOptions {
    pub(super) fn is_any(&self) -> bool {
        self.expectation() != HalfEdgeMesh::expectation() || !self.space().is_empty()
    }

    pub(super) fn expectation(&self) -> Expectation {
        let mut expectation = HalfEdgeMesh::expectation();
        if self.closed {
            expectation = expectation.closed();
        }
        if let Some(borders) = self.borders {
            expectation = expectation.borders(borders);
        }
        if let Some(genus) = self.genus {
            expectation = expectation.genus(genus);
        }
        if let Some(components) = self.components {
            expectation = expectation.components(components);
        }
        if let Some(sides) = self.sides.or(self.triangles.then_some(3)) {
            expectation = expectation.sides(sides);
        }
        if self.no_unused_vertices {
            expectation = expectation.no_unused_vertices();
        }
        expectation
    }

    /// Returns the requested rules about the places of points.
    pub(super) fn space(&self) -> Vec<SpaceRule> {
        let asked = [
            (self.no_zero_area, SpaceRule::Area),
            (self.no_crossings, SpaceRule::Crossing),
            (self.outward, SpaceRule::Outward),
        ];
        asked.into_iter().filter(|(is_asked, _)| *is_asked).map(|(_, rule)| rule).collect()
    }
}
