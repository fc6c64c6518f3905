//! The lists of the faces of a topology, as implied by its columns.

use super::error::ReadError;
use super::topology::Topology;
use twinedge::delegate_view;
use twinedge::validate::adapt::FaceLabels;
use twinedge::validate::{Part, Parts, Start, View};
use twinedge_geometry::Point;
use twinedge_map::Embedding;

/// A topology with the outer cycle of each face and the lists of its holes and isolated nodes, as implied by its columns.
/// [`audit`](super::audit) judges this view.
#[derive(Debug)]
pub struct Listed<'a> {
    labels: FaceLabels<&'a Topology>,
    topology: &'a Topology,
}

impl<'a> Listed<'a> {
    /// O(n) for n rows.
    ///
    /// # Errors
    /// [`ReadError::OutOfMemory`].
    pub fn of(topology: &'a Topology) -> Result<Self, ReadError> {
        let labels = FaceLabels::with_holes(topology, topology.universe()).ok_or(ReadError::OutOfMemory)?;
        Ok(Self { labels, topology })
    }
}

impl View for Listed<'_> {
    delegate_view!(|this| &this.labels; except parts, inner_count, inner_start);

    /// Faces with holes, and face 0 as the unbounded one: without a row for it, F1 is broken.
    fn parts(&self) -> Parts {
        Parts::NONE.with(Part::UnboundedFace)
    }

    fn inner_count(&self, face: usize) -> usize {
        self.labels.inner_count(face) + self.topology.contained(face).len()
    }

    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        let holes = self.labels.inner_count(face);
        match position.checked_sub(holes) {
            None => self.labels.inner_start(face, position),
            Some(i) => self.topology.contained(face).get(i).map(|(_, node)| Start::Vertex(*node as usize)),
        }
    }
}

impl Embedding for Listed<'_> {
    fn point(&self, vertex: usize) -> Point {
        self.topology.point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        self.topology.bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        self.topology.bend(half_edge, bend)
    }
}
