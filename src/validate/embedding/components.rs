//! G5: each inner boundary component lies in the face that lists it, and what no face lists lies in none.

use super::columns::{Columns, NIL};
use super::cycles::{Listed, Lists};
use super::edges::Segments;
use super::{Embedding, Run};
use crate::geometry::predicates::compare_lexicographic;
use crate::validate::{Flow, Part, Rule, Start, Violation};
use core::cmp::Ordering;

/// The components of a drawing.
pub(super) struct Components {
    /// For each vertex, its component.
    of: Vec<u32>,
    /// For each component, its lexicographically smallest vertex.
    pub(super) lowest: Vec<u32>,
}

impl Components {
    pub(super) fn of(columns: &Columns) -> Self {
        // For each vertex another of its component, until that is itself.
        let mut towards: Vec<u32> = (0..columns.points.len() as u32).collect();
        for h in columns.half_edges() {
            let (a, b) = (find(&mut towards, columns.origin[h]), find(&mut towards, columns.target(h) as u32));
            // The larger index gives way, so chains lead downwards.
            towards[a.max(b) as usize] = a.min(b);
        }
        let mut of = vec![NIL; columns.points.len()];
        let mut lowest: Vec<u32> = Vec::new();
        for v in columns.vertices() {
            let first = find(&mut towards, v as u32) as usize;
            if first == v {
                of[v] = lowest.len() as u32;
                lowest.push(v as u32);
                continue;
            }
            of[v] = of[first];
            let low = &mut lowest[of[v] as usize];
            if compare_lexicographic(columns.points[v], columns.points[*low as usize]) == Ordering::Less {
                *low = v as u32;
            }
        }
        Self { of, lowest }
    }
}

/// The vertex by which the component is known so far, halving the way there.
fn find(towards: &mut [u32], mut v: u32) -> u32 {
    while towards[v as usize] != v {
        towards[v as usize] = towards[towards[v as usize] as usize];
        v = towards[v as usize];
    }
    v
}

impl<D: Embedding + ?Sized> Run<'_, D> {
    /// The face to the left of a half-edge.
    fn face_of(&self, h: usize) -> Option<usize> {
        let face = if self.expectation.has(Part::BoundaryComponents) {
            let b = self.drawing.boundary(h).filter(|b| *b < self.drawing.boundary_slots())?;
            self.drawing.boundary_face(b)
        } else {
            self.drawing.face(h)
        };
        face.filter(|f| *f < self.drawing.face_slots())
    }

    /// Runs G5. Below the lowest vertex of a component there is an edge, and above that edge the face in which the component
    /// lies, or none; or there is no edge, and it lies in the unbounded face, if there is one. If all components that start
    /// further to the left lie where they should, what is above that edge is the right one; so one pass proves it for all.
    pub(super) fn inside(
        &mut self,
        columns: &Columns,
        components: &Components,
        segments: &Segments,
        below: &[Option<u32>],
        lists: &Lists,
    ) -> Flow {
        let lies_in: Vec<Option<usize>> = below
            .iter()
            .map(|segment| match segment {
                Some(segment) => segments.above(columns, *segment).and_then(|h| self.face_of(h)),
                None => lists.unbounded,
            })
            .collect();
        let mut is_listed = vec![false; lies_in.len()];
        let mut checked = 0;
        for Listed { face, boundary, start, .. } in lists.all.iter().filter(|one| !one.is_outer) {
            checked += 1;
            let vertex = match *start {
                Start::Vertex(v) => v,
                Start::HalfEdge(h) => columns.origin(h),
            };
            // Where T1 holds, this is the outside of its component.
            let component = components.of[vertex] as usize;
            is_listed[component] = true;
            let found = lies_in[component];
            if found != Some(*face) {
                self.findings.add(Violation::WrongFace { boundary: *boundary, face: *face, found })?;
            }
        }
        self.findings.checked(Rule::G5, checked);
        // What has no face around it has no inner boundary component. What lies in a face has that face around it.
        for (component, found) in lies_in.into_iter().enumerate() {
            if let Some(face) = found.filter(|_| !is_listed[component] && found != lists.unbounded) {
                self.findings.add(Violation::Unlisted { vertex: components.lowest[component] as usize, face })?;
            }
        }
        Ok(())
    }
}
