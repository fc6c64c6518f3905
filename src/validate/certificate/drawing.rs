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
    let darts = Darts::new(&s, drawing);
    let mut failures = Failures::new();
    let is_readable = s.readable() && darts.readable();
    failures.note(Test::Readable, 0, is_readable);
    if is_readable {
        scan(&s, &mut failures).note(&mut failures);
        darts.scan(&mut failures);
    }
    failures.into_result()
}

/// The columns of a drawing.
struct Darts<'a, V: ?Sized> {
    s: &'a Answers<'a, V>,
    points: &'a [[i64; 2]],
    twin: &'a [u32],
    point: &'a [u32],
    half_edge: &'a [u32],
    ahead: &'a [u32],
    face: &'a [u32],
    rank: &'a [u32],
    of_half_edge: &'a [u32],
    of_vertex: &'a [u32],
    of_face: &'a [u32],
}

/// A dart, and the darts that are looked at from there.
#[derive(Clone, Copy)]
struct Dart {
    number: usize,
    /// The next dart of the triangle.
    next: usize,
    twin: usize,
    /// The next dart counter-clockwise around the same point.
    turn: usize,
    /// The half-edge that lies on it; nil if its edge is added.
    half_edge: Link,
}

impl<'a, V: View + ?Sized> Darts<'a, V> {
    fn new(s: &'a Answers<'a, V>, drawing: &'a Drawing) -> Self {
        let column = |column| drawing.columns.column(column);
        Self {
            s,
            points: &drawing.points,
            twin: column(Column::DartTwin),
            point: column(Column::DartPoint),
            half_edge: column(Column::DartHalfEdge),
            ahead: column(Column::DartAhead),
            face: column(Column::DartFace),
            rank: column(Column::DartRank),
            of_half_edge: column(Column::HalfEdgeDart),
            of_vertex: column(Column::VertexDart),
            of_face: column(Column::FaceDart),
        }
    }

    fn count(&self) -> usize {
        self.twin.len()
    }

    /// Columns have the right lengths, points of darts are there, and coordinates are in range.
    fn readable(&self) -> bool {
        let per_dart = [self.point, self.half_edge, self.ahead, self.face, self.rank];
        self.count() % 3 == 0
            && per_dart.iter().all(|column| column.len() == self.count())
            && self.of_half_edge.len() == self.s.half_edges
            && self.of_vertex.len() == self.s.vertices
            && self.of_face.len() == self.s.faces
            && self.s.vertices <= self.points.len()
            && self.point.iter().all(|p| (*p as usize) < self.points.len())
            && self.points.iter().flatten().all(|x| (-REACH..REACH).contains(x))
    }

    fn scan(&self, failures: &mut Failures) {
        for first in (0..self.count()).step_by(3) {
            let [second, third] = [first + 1, first + 2];
            for [number, next, before] in [[first, second, third], [second, third, first], [third, first, second]] {
                let [twin, turn] = [number, before].map(|d| at(self.twin, d));
                let d = Dart { number, next, twin, turn, half_edge: self.half_edge(number) };
                failures.note(Test::DartTwinOk, number, self.twin_ok(d));
                failures.note(Test::DartPointOk, number, at(self.point, next) == at(self.point, twin));
                failures.note(Test::DartHalfEdgeOk, number, self.half_edge_ok(d));
                failures.note(Test::DartAheadOk, number, self.ahead_ok(d));
                failures.note(Test::DartFaceOk, number, self.face_ok(d));
                failures.note(Test::DartRankOk, number, self.rank_ok(d));
            }
            failures.note(Test::TriangleOk, first / 3, self.triangle_ok(first));
        }
        for h in (0..self.s.half_edges).filter(|h| self.s.is_half_edge(*h)) {
            failures.note(Test::HalfEdgeDartOk, h, self.half_edge_dart_ok(h));
            failures.note(Test::RotationOk, h, self.rotation_ok(h));
        }
        for v in (0..self.s.vertices).filter(|v| self.s.is_vertex(*v)) {
            failures.note(Test::VertexDartOk, v, self.vertex_dart_ok(v));
        }
    }

    fn half_edge(&self, d: usize) -> Link {
        Some(at(self.half_edge, d)).filter(|h| *h != NIL as usize)
    }

    fn twin_ok(&self, d: Dart) -> bool {
        d.twin < self.count() && at(self.twin, d.twin) == d.number
    }

    fn half_edge_ok(&self, d: Dart) -> bool {
        match d.half_edge {
            Some(h) => self.s.is_half_edge(h) && at(self.of_half_edge, h) == d.number,
            None => self.half_edge(d.twin).is_none(),
        }
    }

    fn ahead_ok(&self, d: Dart) -> bool {
        at(self.ahead, d.number) == d.half_edge.unwrap_or_else(|| at(self.ahead, d.turn))
    }

    fn face_ok(&self, d: Dart) -> bool {
        let face = at(self.face, d.number);
        let beyond = match d.half_edge {
            Some(h) => self.s.boundary(h).and_then(|b| self.s.boundary_face(b)) == Some(face),
            None => at(self.face, d.twin) == face,
        };
        at(self.face, d.next) == face && beyond
    }

    fn rank_ok(&self, d: Dart) -> bool {
        let rank = at(self.rank, d.number);
        at(self.rank, d.next) < rank
            || d.half_edge.is_none() && at(self.rank, d.twin) < rank
            || at(self.of_face, at(self.face, d.number)) == d.number
    }

    /// Differences of coordinates fit into 64 bits, since these are in range.
    fn triangle_ok(&self, first: usize) -> bool {
        let corner = |d| self.points.get(at(self.point, d)).copied().unwrap_or([0, 0]);
        let ([ax, ay], [bx, by], [cx, cy]) = (corner(first), corner(first + 1), corner(first + 2));
        let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
        let turn = product(ax - cx, by - cy) - product(bx - cx, ay - cy);
        if first == 0 { turn < 0 } else { turn > 0 }
    }

    fn half_edge_dart_ok(&self, h: usize) -> bool {
        let d = at(self.of_half_edge, h);
        d < self.count()
            && self.half_edge(d) == Some(h)
            && self.s.origin(h) == Some(at(self.point, d))
            && self.s.twin(h).is_some_and(|twin| at(self.of_half_edge, twin) == at(self.twin, d))
    }

    fn rotation_ok(&self, h: usize) -> bool {
        let turn = at(self.twin, before(at(self.of_half_edge, h)));
        self.s.prev(h).and_then(|prev| self.s.twin(prev)) == Some(at(self.ahead, turn))
    }

    fn vertex_dart_ok(&self, v: usize) -> bool {
        let d = at(self.of_vertex, v);
        let in_its_face = |b| self.s.boundary_face(b) == Some(at(self.face, d));
        d < self.count() && at(self.point, d) == v && self.s.isolated(v).is_none_or(in_its_face)
    }
}

/// The entry of a column; 0 beyond its end.
fn at(column: &[u32], i: usize) -> usize {
    column.get(i).copied().unwrap_or(0) as usize
}

/// The dart before in the triangle.
const fn before(d: usize) -> usize {
    if d.is_multiple_of(3) { d.saturating_add(2) } else { d - 1 }
}
