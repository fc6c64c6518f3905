//! G5 inside: each inner boundary component lies in the face that lists it, and a component that no face lists lies in no face.
//!
//! The lowest point may be a bend. Without a record of the unbounded face, unlisted components lie outside everything.

use crate::Embedding;
use crate::drawing::columns::Columns;
use crate::drawing::components::Components;
use crate::drawing::lists::{Listed, Lists};
use crate::drawing::segments::Segments;
use twinedge::validate::{Findings, Flow, Link, Part, Parts, Rule, Start, Violation};

/// The input of G5: the embedding, and the results of earlier steps.
pub(crate) struct Inside<'a, E: ?Sized> {
    pub(crate) embedding: &'a E,
    pub(crate) parts: Parts,
    pub(crate) columns: &'a Columns,
    pub(crate) components: &'a Components,
    pub(crate) segments: &'a Segments,
    /// The segment below the lowest point of each component.
    pub(crate) below: &'a [Option<u32>],
    pub(crate) lists: &'a Lists,
}

impl<E: Embedding + ?Sized> Inside<'_, E> {
    fn face_of(&self, h: usize) -> Link {
        let face = if self.parts.has(Part::BoundaryComponents) {
            let b = self.embedding.boundary(h).filter(|b| *b < self.embedding.boundary_slots())?;
            self.embedding.boundary_face(b)
        } else {
            self.embedding.face(h)
        };
        face.filter(|f| *f < self.embedding.face_slots())
    }

    fn faces_around(&self) -> Vec<Link> {
        let around = |segment: &Option<u32>| match segment {
            Some(segment) => self.segments.above(self.columns, *segment).and_then(|h| self.face_of(h)),
            None => self.lists.unbounded,
        };
        self.below.iter().map(around).collect()
    }

    /// Runs G5. If there is an edge below the lowest point of a component, the component lies in the face above that edge, if
    /// any. Otherwise it lies in the unbounded face, if there is a record of it. The face above the edge is the correct one if
    /// all components that start further to the left are in the correct face; so one pass proves all.
    pub(crate) fn check(&self, findings: &mut Findings) -> Flow {
        let lies_in = self.faces_around();
        let mut is_listed = vec![false; lies_in.len()];
        let mut checked = 0;
        for Listed { face, boundary, start, .. } in self.lists.all.iter().filter(|one| !one.is_outer) {
            checked += 1;
            let vertex = match *start {
                Start::Vertex(v) => v,
                Start::HalfEdge(h) => self.columns.origin(h),
            };
            // By T1, this cycle or vertex is the outside of its component.
            let component = self.components.of[vertex] as usize;
            is_listed[component] = true;
            let found = lies_in[component];
            if found != Some(*face) {
                findings.add(Violation::WrongFace { boundary: *boundary, face: *face, found })?;
            }
        }
        findings.checked(Rule::G5, checked);
        // A component that lies in no face has no inner boundary component. Otherwise the face that contains it must list it.
        for (component, found) in lies_in.into_iter().enumerate() {
            let unlisted = !is_listed[component] && found != self.lists.unbounded;
            if let Some(face) = found.filter(|_| unlisted) {
                findings.add(Violation::Unlisted { vertex: self.components.lowest[component] as usize, face })?;
            }
        }
        Ok(())
    }
}
