//! The checker of drawings.
//!
//! Each function is a row of the tables in `proofs/coq/CERTIFICATE.md`, and a definition in `proofs/coq/certificates/Coordinates.v`, under the
//! same name. As there, entries beyond the end of a column are 0.

use super::answers::Answers;
use super::check::scan;
use super::columns::{Column, MOST_SLOTS};
use super::fast;
use super::storage::{Columns, Numbers};
use super::test::{Failure, Failures, Noted as _, Test};
use crate::NIL;
use alloc::vec::Vec;
use twinedge::validate::{Link, View};

/// Coordinates are from `-2^53` to `2^53 - 1`.
const REACH: i64 = 1 << 53;

/// Checks the labels of a structure and a drawing of it. If all tests pass, the structure keeps R1 … T4, and is drawn in the
/// plane with straight edges between the points numbered like its vertices.
///
/// Cost: O(n) for n slots, list entries and darts. Exact orientations in 128 bits. Total, like [`check`](super::check()).
///
/// # Errors
/// The failed tests.
pub fn check_drawing<V: View + ?Sized, C: Columns, D: Columns>(
    view: &V,
    labels: &C,
    drawing: &D,
) -> Result<(), Vec<Failure>> {
    let s = Answers::new(view, labels);
    let darts = Darts::new(&s, drawing);
    let mut failures = Failures::new();
    let is_readable = s.readable() && darts.readable();
    failures.note(Test::Readable, 0, is_readable);
    if is_readable {
        if fast::plane(&s).is_none() {
            scan(&s, &mut failures);
        }
        darts.scan(&mut failures);
    }
    failures.into_result()
}

struct Darts<'a, V: ?Sized, C, D: Columns> {
    s: &'a Answers<'a, V, C>,
    drawing: &'a D,
    count: usize,
    points: usize,
    twin: D::Numbers<'a>,
    point: D::Numbers<'a>,
    half_edge: D::Numbers<'a>,
    ahead: D::Numbers<'a>,
    face: D::Numbers<'a>,
    rank: D::Numbers<'a>,
    of_half_edge: D::Numbers<'a>,
}

#[derive(Clone, Copy)]
struct Dart {
    number: usize,
    next: usize,
    twin: usize,
    /// The next dart counter-clockwise around the same point.
    turn: usize,
    /// The half-edge on it; nil if its edge is added.
    half_edge: Link,
}

impl<'a, V: View + ?Sized, C: Columns, D: Columns> Darts<'a, V, C, D> {
    fn new(s: &'a Answers<'a, V, C>, drawing: &'a D) -> Self {
        let column = |column| drawing.column(column);
        Self {
            s,
            drawing,
            count: column(Column::DartTwin).count(),
            points: drawing.points(),
            twin: column(Column::DartTwin),
            point: column(Column::DartPoint),
            half_edge: column(Column::DartHalfEdge),
            ahead: column(Column::DartAhead),
            face: column(Column::DartFace),
            rank: column(Column::DartRank),
            of_half_edge: column(Column::HalfEdgeDart),
        }
    }

    /// Returns true if columns have the correct lengths, points of darts exist, and coordinates are in range.
    fn readable(&self) -> bool {
        let per_dart = [self.point, self.half_edge, self.ahead, self.face, self.rank];
        [self.count, self.points].iter().all(|n| *n <= MOST_SLOTS)
            && self.count % 3 == 0
            && per_dart.iter().all(|column| column.count() == self.count)
            && self.of_half_edge.count() == self.s.half_edges
            && self.drawing.column(Column::VertexDart).count() == self.s.vertices
            && self.drawing.column(Column::FaceDart).count() == self.s.faces
            && self.s.vertices <= self.points
            && (0..self.count).all(|d| at(self.point, d) < self.points)
            && (0..self.points).all(|p| self.drawing.point(p).iter().flatten().all(|x| (-REACH..REACH).contains(x)))
    }

    fn scan(&self, failures: &mut Failures) {
        for first in (0..self.count).step_by(3) {
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
        d.twin < self.count && at(self.twin, d.twin) == d.number
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
            || at(self.drawing.column(Column::FaceDart), at(self.face, d.number)) == d.number
    }

    /// Differences of coordinates in range fit into 64 bits. (They are out of range only if they change from call to call.)
    fn triangle_ok(&self, first: usize) -> bool {
        let [[ax, ay], [bx, by], [cx, cy]] =
            [first, first + 1, first + 2].map(|d| self.drawing.point(at(self.point, d)).unwrap_or([0, 0]));
        let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
        let turn =
            product(ax.wrapping_sub(cx), by.wrapping_sub(cy)) - product(bx.wrapping_sub(cx), ay.wrapping_sub(cy));
        if first == 0 { turn < 0 } else { turn > 0 }
    }

    fn half_edge_dart_ok(&self, h: usize) -> bool {
        let d = at(self.of_half_edge, h);
        d < self.count
            && self.half_edge(d) == Some(h)
            && self.s.origin(h) == Some(at(self.point, d))
            && self.s.twin(h).is_some_and(|twin| at(self.of_half_edge, twin) == at(self.twin, d))
    }

    fn rotation_ok(&self, h: usize) -> bool {
        let turn = at(self.twin, before(at(self.of_half_edge, h)));
        self.s.prev(h).and_then(|prev| self.s.twin(prev)) == Some(at(self.ahead, turn))
    }

    fn vertex_dart_ok(&self, v: usize) -> bool {
        let d = at(self.drawing.column(Column::VertexDart), v);
        let in_its_face = |b| self.s.boundary_face(b) == Some(at(self.face, d));
        d < self.count && at(self.point, d) == v && self.s.isolated(v).is_none_or(in_its_face)
    }
}

/// Returns the entry of a column, or 0 beyond its end.
fn at(column: impl Numbers, i: usize) -> usize {
    column.at(i).unwrap_or(0) as usize
}

const fn before(d: usize) -> usize {
    if d % 3 == 0 { d.saturating_add(2) } else { d - 1 }
}
