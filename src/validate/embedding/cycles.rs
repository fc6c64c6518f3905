//! G3: outer cycles turn counter-clockwise, inner ones clockwise.

use super::columns::{Columns, NIL};
use super::{Embedding, Run};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, orientation};
use crate::validate::{Flow, Part, Record, Rule, Start, Violation};
use core::cmp::Ordering;

/// A boundary component, as its face lists it.
pub(super) struct Listed {
    pub(super) face: usize,
    /// The record by which a report names it.
    pub(super) boundary: Record,
    pub(super) start: Start,
    pub(super) is_outer: bool,
}

/// What the faces list.
pub(super) struct Lists {
    pub(super) all: Vec<Listed>,
    /// The face without outer boundary component.
    pub(super) unbounded: Option<usize>,
}

impl<D: Embedding + ?Sized> Run<'_, D> {
    /// What the faces list: no more of it than there can be where F2 holds.
    pub(super) fn lists(&self, columns: &Columns) -> Lists {
        let (vertices, half_edges) = (columns.points.len(), columns.origin.len());
        let by_record = self.expectation.has(Part::BoundaryComponents);
        let boundaries = self.drawing.boundary_slots();
        let most = if by_record { boundaries } else { vertices + half_edges };
        let live = |start: &Start| match *start {
            Start::HalfEdge(h) => columns.origin.get(h).is_some_and(|origin| *origin != NIL),
            Start::Vertex(v) => columns.is_vertex.get(v) == Some(&true),
        };
        let named = |b: usize| (b < boundaries).then(|| (self.drawing.boundary_start(b), Record::Boundary(b)));
        let itself = |start: Start| match start {
            Start::HalfEdge(h) => (Some(start), Record::HalfEdge(h)),
            Start::Vertex(v) => (Some(start), Record::Vertex(v)),
        };
        let mut lists = Lists { all: Vec::new(), unbounded: None };
        for face in (0..self.drawing.face_slots()).filter(|f| self.drawing.is_face(*f)) {
            let outer = if by_record {
                self.drawing.outer(face).and_then(named)
            } else {
                self.drawing.outer_half_edge(face).map(|h| itself(Start::HalfEdge(h)))
            };
            if outer.is_none() && lists.unbounded.is_none() {
                lists.unbounded = Some(face);
            }
            let count = if self.expectation.has(Part::Holes) { self.drawing.inner_count(face) } else { 0 };
            let inner = (0..count.min(most.saturating_sub(lists.all.len()))).filter_map(|i| {
                if by_record {
                    self.drawing.inner(face, i).and_then(named)
                } else {
                    self.drawing.inner_start(face, i).map(itself)
                }
            });
            let all = outer.into_iter().map(|found| (found, true)).chain(inner.map(|found| (found, false)));
            lists.all.extend(all.filter_map(|((start, boundary), is_outer)| {
                Some(Listed { face, boundary, start: start.filter(live)?, is_outer })
            }));
        }
        lists
    }

    /// Runs G3.
    pub(super) fn winding(&mut self, columns: &Columns, lists: &Lists) -> Flow {
        let mut checked = 0;
        let mut seen = vec![false; columns.origin.len()];
        for Listed { boundary, start, is_outer, .. } in &lists.all {
            // Where B1 holds, no two start on one cycle.
            let Start::HalfEdge(h) = *start else { continue };
            if seen[h] {
                continue;
            }
            checked += 1;
            match (is_outer, turns_clockwise(columns, h, &mut seen)) {
                (true, true) => self.findings.add(Violation::OuterClockwise { boundary: *boundary })?,
                (false, false) => self.findings.add(Violation::InnerCounterClockwise { boundary: *boundary })?,
                _ => {}
            }
        }
        self.findings.checked(Rule::G3, checked);
        Ok(())
    }
}

/// Whether the face lies around the cycle, not inside it: whether at the lexicographically smallest vertex it lies to
/// the left. A cycle may pass there more than once.
fn turns_clockwise(columns: &Columns, start: usize, seen: &mut [bool]) -> bool {
    let mut low = columns.tail(start);
    let mut around = false;
    let mut h = start;
    loop {
        seen[h] = true;
        let n = columns.next(h);
        let (before, at, after) = (columns.tail(h), columns.tail(n), columns.head(n));
        match compare_lexicographic(at, low) {
            Ordering::Less => {
                low = at;
                around = corner_opens_left(before, at, after);
            }
            Ordering::Equal => around |= corner_opens_left(before, at, after),
            Ordering::Greater => {}
        }
        h = n;
        if h == start {
            return around;
        }
    }
}

/// Whether the corner to the left of the way `before`, `at`, `after` holds the direction straight to the left, `at`
/// being the smallest of the three.
fn corner_opens_left(before: Point, at: Point, after: Point) -> bool {
    before == after || orientation(at, before, after) == Orientation::CounterClockwise
}
