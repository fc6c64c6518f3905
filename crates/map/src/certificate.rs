//! Certificates of drawings: a triangulation that contains the edges of a map.
//!
//! [`draw`] makes a certificate. [`check_drawing`](twinedge_certificate::check_drawing) and the program proved in Coq check it,
//! without relying on any code in this module.

use crate::Embedding;
use crate::numbers::NIL;
use core::iter;
use core::mem::replace;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};
use twinedge::validate::Part;
use twinedge_certificate::{Column, Drawing, Labels};

/// The reason why a map has no certificate of its drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// No grid contains all coordinates: they are not finite, or too large as multiples of a power of two. Snapping to a grid
    /// helps.
    #[error("the coordinates are on no grid on which they are at most 2^51 steps")]
    NoGrid,
    /// An edge has bends.
    #[error("half-edge {half_edge} has bends: only drawings with straight edges have certificates")]
    Bends {
        /// The half-edge.
        half_edge: usize,
    },
    /// Edges cross, touch or overlap, vertices coincide, or links lead nowhere.
    #[error("the map is not plane")]
    NotPlane,
    /// There are more darts than 32 bits can number.
    #[error("the map has more edges than 32 bits can number")]
    TooLarge,
}

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// The largest coordinate in steps, which leaves room for a triangle around all points.
const REACH: i64 = 1 << 51;

/// Triangulates a map, holes and the outside included, for a certificate that it is drawn in the plane.
///
/// Coordinates are doubles, so all of them are integer multiples of some power of two. These integers are the coordinates of the
/// drawing. They must be at most 2^51 in magnitude, as in a map snapped to a grid ([`Noding::Snap`](super::Noding::Snap)).
///
/// Cost: O(n log n), expected, mostly spent in `spade`.
///
/// # Errors
/// [`DrawingError`].
///
/// ```
/// use twinedge_map::{PlanarMap, certificate};
/// use twinedge_certificate::{Labels, Test, check_drawing};
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
/// map.insert_point([1.0, 2.0])?;
/// let labels = Labels::new(&map)?;
/// let mut drawing = certificate::draw(&map)?;
/// assert_eq!(check_drawing(&map, &labels, &drawing), Ok(()));
///
/// // The point inside is moved to a side of the square.
/// let inside = drawing.points.iter().position(|point| *point == [1, 2]).expect("it is a vertex");
/// drawing.points[inside] = [0, 2];
/// let failures = check_drawing(&map, &labels, &drawing).unwrap_err();
/// assert_eq!(failures[0].test(), Test::TriangleOk);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn draw<E: Embedding + ?Sized>(map: &E) -> Result<Drawing, DrawingError> {
    let (points, exponent) = points(map)?;
    let mut darts = Darts::new(map, &points)?;
    darts.place_half_edges(map)?;
    darts.find_faces(map);
    darts.look_ahead();
    Ok(Drawing { columns: darts.into_columns(), points, exponent })
}

/// Returns the points of all vertex slots and a triangle around them, as multiples of a power of two, with its exponent.
fn points<E: Embedding + ?Sized>(map: &E) -> Result<(Vec<[i64; 2]>, i32), DrawingError> {
    let live = (0..map.vertex_slots()).filter(|v| map.is_vertex(*v));
    let coordinates = |v: usize| [map.point(v).x, map.point(v).y].map(Binary::of);
    let exponents = live.flat_map(coordinates).filter(|x| !matches!(x, Ok(Binary { odd: 0, .. })));
    let exponent = exponents.map(|x| x.map(|x| x.exponent)).try_fold(i32::MAX, |least, x| x.map(|x| least.min(x)))?;
    let exponent = if exponent == i32::MAX { 0 } else { exponent };
    let mut points = Vec::with_capacity(map.vertex_slots() + 3);
    for v in 0..map.vertex_slots() {
        let [x, y] = if map.is_vertex(v) { coordinates(v) } else { [Ok(Binary::default()), Ok(Binary::default())] };
        points.push([x?.steps(exponent)?, y?.steps(exponent)?]);
    }
    let reach = points.iter().flatten().map(|x| x.abs()).max().unwrap_or(0).max(1);
    let [near, far] = [2 * reach, 4 * reach - 1];
    points.extend([[-far, -near], [far, -near], [0, far]]);
    Ok((points, exponent))
}

/// A double as a power of two times an odd number or 0.
#[derive(Clone, Copy, Default)]
struct Binary {
    odd: i64,
    exponent: i32,
}

impl Binary {
    fn of(x: f64) -> Result<Self, DrawingError> {
        if !x.is_finite() {
            return Err(DrawingError::NoGrid);
        }
        let (bits, biased) = (x.to_bits() & ((1 << 52) - 1), (x.to_bits() >> 52 & 0x7ff) as i32);
        let mantissa = if biased == 0 { bits } else { bits | 1 << 52 }.cast_signed();
        if mantissa == 0 {
            return Ok(Self::default());
        }
        let zeros = mantissa.trailing_zeros();
        let odd = (mantissa >> zeros) * if x < 0.0 { -1 } else { 1 };
        Ok(Self { odd, exponent: biased.max(1) - 1075 + zeros.cast_signed() })
    }

    /// Returns the number as a multiple of two to this exponent, which is at most its own.
    fn steps(self, exponent: i32) -> Result<i64, DrawingError> {
        let shift = if self.odd == 0 { 0 } else { (self.exponent - exponent).unsigned_abs() };
        let steps = 1_i64.checked_shl(shift).filter(|_| shift < 52).and_then(|step| self.odd.checked_mul(step));
        steps.filter(|steps| steps.abs() <= REACH).ok_or(DrawingError::NoGrid)
    }
}

/// The darts of the triangulation, by number.
struct Darts {
    twin: Vec<u32>,
    point: Vec<u32>,
    half_edge: Vec<u32>,
    ahead: Vec<u32>,
    face: Vec<u32>,
    rank: Vec<u32>,
    of_half_edge: Vec<u32>,
    of_vertex: Vec<u32>,
    of_face: Vec<u32>,
}

impl Darts {
    /// Triangulates the points by constrained Delaunay triangulation. The outer face is triangle 0.
    fn new<E: Embedding + ?Sized>(map: &E, points: &[[i64; 2]]) -> Result<Self, DrawingError> {
        let slots = map.vertex_slots();
        // Points of vacant slots are left out. `spade` keeps the order of all others.
        let numbers: Vec<usize> = (0..points.len()).filter(|p| *p >= slots || map.is_vertex(*p)).collect();
        let mut of_point = vec![NIL; points.len()];
        for (i, p) in numbers.iter().enumerate() {
            of_point[*p] = i as u32;
        }
        let mut edges = Vec::new();
        for (h, t) in half_edges(map).filter_map(|h| Some((h, map.twin(h)?))).filter(|(h, t)| h < t) {
            let ends = [map.origin(h), map.origin(t)].map(|v| v.and_then(|v| of_point.get(v)).filter(|i| **i != NIL));
            let [Some(a), Some(b)] = ends else { return Err(DrawingError::NotPlane) };
            edges.push([*a as usize, *b as usize]);
        }
        let constraints = edges.len();
        // At most 2^53 in magnitude, so nothing is rounded.
        let inserted = numbers.iter().map(|p| points[*p].map(|x| x as f64)).map(|[x, y]| Point2::new(x, y)).collect();
        let mut conflict = edges.iter().any(|[a, b]| a == b);
        edges.retain(|[a, b]| a != b);
        let cdt = Cdt::try_bulk_load_cdt(inserted, edges, |_| conflict = true).map_err(|_| DrawingError::NotPlane)?;
        if conflict || cdt.num_vertices() != numbers.len() || cdt.num_constraints() != constraints {
            return Err(DrawingError::NotPlane);
        }
        let count = cdt.num_directed_edges();
        if count >= NIL as usize {
            return Err(DrawingError::TooLarge);
        }
        // In the order of the vertices: neighbours in the map are mostly neighbours here, so a checker finds them in the cache.
        let mut is_numbered = vec![false; cdt.num_all_faces()];
        let mut of_edge = vec![NIL; count];
        let mut sides = Vec::with_capacity(count);
        let outer = cdt.outer_face().adjacent_edge().ok_or(DrawingError::NotPlane)?;
        for first in iter::once(outer).chain(cdt.vertices().flat_map(|v| v.out_edges())) {
            if !replace(&mut is_numbered[first.face().fix().index()], true) {
                for side in [first, first.next(), first.prev()] {
                    of_edge[side.fix().index()] = sides.len() as u32;
                    sides.push(side);
                }
            }
        }
        let mut darts = Self {
            twin: sides.iter().map(|side| of_edge[side.rev().fix().index()]).collect(),
            point: sides.iter().map(|side| numbers[side.from().index()] as u32).collect(),
            half_edge: vec![NIL; sides.len()],
            ahead: vec![0; sides.len()],
            face: vec![0; sides.len()],
            rank: vec![NIL; sides.len()],
            of_half_edge: vec![0; map.half_edge_slots()],
            of_vertex: vec![0; slots],
            of_face: vec![0; map.face_slots()],
        };
        for (d, side) in sides.iter().enumerate() {
            let from = numbers[side.from().index()];
            if from < slots {
                darts.of_vertex[from] = d as u32;
            }
        }
        Ok(darts)
    }

    /// Places each half-edge on the dart between its ends, passing half-edges and darts together clockwise around each vertex.
    fn place_half_edges<E: Embedding + ?Sized>(&mut self, map: &E) -> Result<(), DrawingError> {
        // Only the half-edge with the smaller index is asked.
        let is_bent = |h: &usize| map.twin(*h).is_none_or(|twin| *h <= twin) && map.bends(*h) > 0;
        if let Some(half_edge) = half_edges(map).find(is_bent) {
            return Err(DrawingError::Bends { half_edge });
        }
        // Passes each vertex twice, to find its first half-edge and to place them all. An invalid rotation can take longer.
        let mut steps = 3 * self.twin.len();
        let mut step = || -> Result<(), DrawingError> {
            steps = steps.checked_sub(1).ok_or(DrawingError::NotPlane)?;
            Ok(())
        };
        for first in half_edges(map) {
            let from = map.origin(first).ok_or(DrawingError::NotPlane)?;
            let mut d = self.dart_from(from)?;
            let mut h = first;
            while !self.is_placed(h) && map.origin(h) == Some(from) {
                step()?;
                let twin = map.twin(h).filter(|t| map.is_half_edge(*t)).ok_or(DrawingError::NotPlane)?;
                let to = map.origin(twin).ok_or(DrawingError::NotPlane)?;
                while self.point[next(d)] as usize != to {
                    step()?;
                    d = next(self.twin[d] as usize);
                }
                self.of_half_edge[h] = d as u32;
                self.half_edge[d] = h as u32;
                let next = map.next(twin).filter(|next| *next < self.of_half_edge.len() && map.is_half_edge(*next));
                h = next.ok_or(DrawingError::NotPlane)?;
            }
        }
        Ok(())
    }

    fn dart_from(&self, v: usize) -> Result<usize, DrawingError> {
        let dart = self.of_vertex.get(v).map(|d| *d as usize);
        dart.filter(|d| self.point[*d] as usize == v).ok_or(DrawingError::NotPlane)
    }

    fn is_placed(&self, h: usize) -> bool {
        self.half_edge[self.of_half_edge[h] as usize] as usize == h
    }

    /// Finds the faces of the darts, and ranks: from the outer triangle across the unbounded face, and from a half-edge across
    /// others.
    fn find_faces<E: Embedding + ?Sized>(&mut self, map: &E) {
        let by_record = map.parts().has(Part::BoundaryComponents);
        let is_unbounded =
            |f: &usize| map.is_face(*f) && if by_record { map.outer(*f) } else { map.outer_half_edge(*f) }.is_none();
        let mut rank = 0;
        if let Some(unbounded) = (0..map.face_slots()).find(is_unbounded) {
            self.fill(0, unbounded, &mut rank);
        }
        for h in half_edges(map) {
            let dart = self.of_half_edge[h] as usize;
            let face = if by_record { map.boundary(h).and_then(|b| map.boundary_face(b)) } else { map.face(h) };
            if let Some(face) = face.filter(|_| self.rank[dart] == NIL) {
                self.fill(dart, face, &mut rank);
            }
        }
    }

    fn fill(&mut self, from: usize, face: usize, rank: &mut u32) {
        if let Some(of_face) = self.of_face.get_mut(face) {
            *of_face = from as u32;
        }
        let mut stack = vec![from];
        while let Some(d) = stack.pop() {
            if self.rank[d] != NIL {
                continue;
            }
            self.rank[d] = *rank;
            self.face[d] = face as u32;
            *rank += 1;
            // Both further neighbours have this triangle as a lower neighbour.
            stack.push(next(next(d)));
            if self.half_edge[d] == NIL {
                stack.push(self.twin[d] as usize);
            }
        }
    }

    /// Follows the added edges clockwise from each half-edge to the previous half-edge.
    fn look_ahead(&mut self) {
        for dart in (0..self.twin.len()).filter(|d| self.half_edge[*d] != NIL).collect::<Vec<_>>() {
            let mut d = dart;
            loop {
                self.ahead[d] = self.half_edge[dart];
                d = next(self.twin[d] as usize);
                if self.half_edge[d] != NIL {
                    break;
                }
            }
        }
    }

    fn into_columns(self) -> Labels {
        let mut columns = Labels::default();
        for (column, numbers) in [
            (Column::DartTwin, self.twin),
            (Column::DartPoint, self.point),
            (Column::DartHalfEdge, self.half_edge),
            (Column::DartAhead, self.ahead),
            (Column::DartFace, self.face),
            (Column::DartRank, self.rank),
            (Column::HalfEdgeDart, self.of_half_edge),
            (Column::VertexDart, self.of_vertex),
            (Column::FaceDart, self.of_face),
        ] {
            *columns.column_mut(column) = numbers;
        }
        columns
    }
}

fn half_edges<E: Embedding + ?Sized>(map: &E) -> impl Iterator<Item = usize> {
    (0..map.half_edge_slots()).filter(|h| map.is_half_edge(*h))
}

const fn next(d: usize) -> usize {
    if d % 3 == 2 { d - 2 } else { d + 1 }
}
