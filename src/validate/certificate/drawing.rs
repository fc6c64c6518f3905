//! The certificate of a drawing: a triangulation that has the edges of the structure among its own; and its checker.
//!
//! Each function is a row of the tables in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/Coordinates.v`, under the same name. What
//! is beyond the end of a column is 0, as it is there.

use super::answers::Answers;
use super::check::scan;
use super::columns::{Column, Labels};
use super::test::{Failure, Failures, Test};
use crate::slots::NIL;
use crate::validate::structure::{Link, View};
use alloc::vec::Vec;

/// Coordinates are from `-2^53` to `2^53 - 1`.
const REACH: i64 = 1 << 53;

/// A triangulation: darts in the [columns of drawings](Column::of_drawing), and the coordinates of points.
///
/// Darts `3 i`, `3 i + 1` and `3 i + 2` are the sides of triangle `i`. Triangle 0 is what is outside a big triangle around everything.
/// Nothing is assumed of the numbers. `map::certificate` makes it (feature `spade`).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Drawing {
    /// Its columns. Those that are not [of drawings](Column::of_drawing) are not looked at.
    pub columns: Labels,
    /// The coordinates of points, in units of some grid. The first points are the vertices.
    pub points: Vec<[i64; 2]>,
    /// The grid: a unit is two to this exponent. For whoever wants the coordinates as they were; nothing is checked of it.
    pub exponent: i32,
}

/// Checks the labels of a structure and a drawing of it. If all tests pass, the structure keeps R1 … T4, and is drawn in the plane
/// with straight edges between the points that have the numbers of its vertices.
///
/// Cost: O(n) for n slots, list entries and darts. Orientations are exact, in 128 bits. It is total, as [`check`](super::check()) is.
///
/// # Errors
/// The tests that fail.
pub fn check_drawing<V: View + ?Sized>(view: &V, labels: &Labels, drawing: &Drawing) -> Result<(), Vec<Failure>> {
    let s = Answers::new(view, labels);
    let d = Darts { s: &s, drawing };
    let mut failures = Failures::new();
    failures.note(Test::Readable, 0, s.readable() && d.readable());
    if s.readable() && d.readable() {
        scan(&s, &mut failures).note(&mut failures);
        d.scan(&mut failures);
    }
    failures.into_result()
}

struct Darts<'a, V: ?Sized> {
    s: &'a Answers<'a, V>,
    drawing: &'a Drawing,
}

impl<V: View + ?Sized> Darts<'_, V> {
    fn count(&self) -> usize {
        self.drawing.columns.column(Column::DartTwin).len()
    }

    /// Columns have the right lengths, points of darts are there, and coordinates are in range.
    fn readable(&self) -> bool {
        let length = |column| self.drawing.columns.column(column).len();
        let per_dart = [Column::DartPoint, Column::DartHalfEdge, Column::DartAhead, Column::DartFace, Column::DartRank];
        let points = &self.drawing.points;
        self.count() % 3 == 0
            && per_dart.iter().all(|column| length(*column) == self.count())
            && length(Column::HalfEdgeDart) == self.s.half_edges
            && length(Column::VertexDart) == self.s.vertices
            && length(Column::FaceDart) == self.s.faces
            && self.s.vertices <= points.len()
            && self.drawing.columns.column(Column::DartPoint).iter().all(|p| (*p as usize) < points.len())
            && points.iter().flatten().all(|x| (-REACH..REACH).contains(x))
    }

    fn scan(&self, failures: &mut Failures) {
        for d in 0..self.count() {
            failures.note(Test::DartTwinOk, d, self.twin_ok(d));
            failures.note(Test::DartPointOk, d, self.point(next(d)) == self.point(self.twin(d)));
            failures.note(Test::DartHalfEdgeOk, d, self.half_edge_ok(d));
            let ahead = self.half_edge(d).unwrap_or_else(|| self.ahead(self.turn(d)));
            failures.note(Test::DartAheadOk, d, self.ahead(d) == ahead);
            failures.note(Test::DartFaceOk, d, self.face_ok(d));
            failures.note(Test::DartRankOk, d, self.rank_ok(d));
        }
        for triangle in 0..self.count() / 3 {
            failures.note(Test::TriangleOk, triangle, self.triangle_ok(triangle));
        }
        for h in (0..self.s.half_edges).filter(|h| self.s.is_half_edge(*h)) {
            failures.note(Test::HalfEdgeDartOk, h, self.half_edge_dart_ok(h));
            failures.note(Test::RotationOk, h, self.rotation_ok(h));
        }
        for v in (0..self.s.vertices).filter(|v| self.s.is_vertex(*v)) {
            failures.note(Test::VertexDartOk, v, self.vertex_dart_ok(v));
        }
    }

    fn number(&self, column: Column, i: usize) -> usize {
        self.drawing.columns.column(column).get(i).copied().unwrap_or(0) as usize
    }

    fn twin(&self, d: usize) -> usize {
        self.number(Column::DartTwin, d)
    }

    fn point(&self, d: usize) -> usize {
        self.number(Column::DartPoint, d)
    }

    fn ahead(&self, d: usize) -> usize {
        self.number(Column::DartAhead, d)
    }

    fn face(&self, d: usize) -> usize {
        self.number(Column::DartFace, d)
    }

    /// The half-edge that lies on the dart; nil if its edge is added.
    fn half_edge(&self, d: usize) -> Link {
        Some(self.number(Column::DartHalfEdge, d)).filter(|h| *h != NIL as usize)
    }

    fn dart_of(&self, h: usize) -> usize {
        self.number(Column::HalfEdgeDart, h)
    }

    /// The next dart counter-clockwise around the same point.
    fn turn(&self, d: usize) -> usize {
        self.twin(next(next(d)))
    }

    fn twin_ok(&self, d: usize) -> bool {
        self.twin(d) < self.count() && self.twin(self.twin(d)) == d
    }

    fn half_edge_ok(&self, d: usize) -> bool {
        match self.half_edge(d) {
            Some(h) => self.s.is_half_edge(h) && self.dart_of(h) == d,
            None => self.half_edge(self.twin(d)).is_none(),
        }
    }

    fn face_ok(&self, d: usize) -> bool {
        let beyond = match self.half_edge(d) {
            Some(h) => self.s.boundary(h).and_then(|b| self.s.boundary_face(b)) == Some(self.face(d)),
            None => self.face(self.twin(d)) == self.face(d),
        };
        self.face(next(d)) == self.face(d) && beyond
    }

    fn rank_ok(&self, d: usize) -> bool {
        let lower = |e: usize| self.number(Column::DartRank, e) < self.number(Column::DartRank, d);
        lower(next(d))
            || self.half_edge(d).is_none() && lower(self.twin(d))
            || self.number(Column::FaceDart, self.face(d)) == d
    }

    fn triangle_ok(&self, triangle: usize) -> bool {
        let corner =
            |i| self.drawing.points.get(self.point(3 * triangle + i)).copied().unwrap_or([0, 0]).map(i128::from);
        let ([ax, ay], [bx, by], [cx, cy]) = (corner(0), corner(1), corner(2));
        let turn = (ax - cx) * (by - cy) - (bx - cx) * (ay - cy);
        if triangle == 0 { turn < 0 } else { turn > 0 }
    }

    fn half_edge_dart_ok(&self, h: usize) -> bool {
        let d = self.dart_of(h);
        d < self.count()
            && self.half_edge(d) == Some(h)
            && self.s.origin(h) == Some(self.point(d))
            && self.s.twin(h).is_some_and(|twin| self.dart_of(twin) == self.twin(d))
    }

    fn rotation_ok(&self, h: usize) -> bool {
        self.s.prev(h).and_then(|prev| self.s.twin(prev)) == Some(self.ahead(self.turn(self.dart_of(h))))
    }

    fn vertex_dart_ok(&self, v: usize) -> bool {
        let d = self.number(Column::VertexDart, v);
        let in_its_face = |b| self.s.boundary_face(b) == Some(self.face(d));
        d < self.count() && self.point(d) == v && self.s.isolated(v).is_none_or(in_its_face)
    }
}

/// The next dart of the triangle.
const fn next(d: usize) -> usize {
    if d % 3 == 2 { d - 2 } else { d + 1 }
}
