//! Which faces does each feature cover?
//!
//! A point belongs to a polygon if a ray from it crosses the rings an odd number of times, so only segments that a polygon
//! uses an odd number of times matter. These form closed curves; each connected piece of them is taken by itself. At its
//! lexicographically smallest point nothing of it lies to the left, so there it is known which side is inside; walking
//! around its points carries this to all its segments, every one of them having the inside on one side. From the inner
//! sides the faces are flooded, up to the piece. The polygon covers what lies inside an odd number of pieces.
//!
//! Most polygons are simple: no point occurs twice on their rings. Then each ring is a piece, its segments come in order, and
//! all of them have the inside on the same side, so none of this needs looking up.
//!
//! O(segments of the feature · log + sizes of the faces inside); without the logarithm for simple polygons.

use super::arrange::half_edge;
use super::gathered::{Dart, GatheredFeature, origin, target};
use crate::dcel::{Dcel, Face, HalfEdge, Vertex};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, orientation};
use core::cmp::Ordering;

/// Which features cover which faces, and which run along which edges.
#[derive(Clone, Debug, Default)]
pub(super) struct Covered {
    /// Pairs of the index of a face and the number of a feature that covers it, sorted.
    pub(super) faces: Vec<(u32, u32)>,
    /// Pairs of the smaller index of the two half-edges of an edge and the number of a feature that has it, sorted.
    pub(super) edges: Vec<(u32, u32)>,
}

/// Marks per record, by the round in which they were set, so that none has to be taken off.
struct Marks {
    round: u32,
    /// Half-edges of the piece in hand.
    in_piece: Vec<u32>,
    /// Vertices around which the sides are known.
    visited: Vec<u32>,
    /// Points on the rings of the polygon in hand.
    on_rings: Vec<u32>,
    /// Faces inside the piece.
    flooded: Vec<u32>,
    /// Per face whether it lies inside an odd number of pieces of the polygon in hand.
    odd: Vec<bool>,
    /// Per face one more than the last feature found to cover it.
    taken_by: Vec<u32>,
}

pub(super) fn cover(points: &[Point], segments: &[[u32; 2]], dcel: &Dcel, features: &[GatheredFeature]) -> Covered {
    let end = |slots: Option<usize>| slots.map_or(0, |last| last + 1);
    let faces = end(dcel.faces().map(Face::index).max());
    let mut marks = Marks {
        round: 0,
        in_piece: vec![0; end(dcel.half_edges().map(HalfEdge::index).max())],
        visited: vec![0; end(dcel.vertices().map(Vertex::index).max())],
        on_rings: vec![0; points.len()],
        flooded: vec![0; faces],
        odd: vec![false; faces],
        taken_by: vec![0; faces],
    };
    let mut covered = Covered::default();
    let mut touched = Vec::new();
    for (feature, number) in features.iter().zip(0..) {
        for dart in feature.polygons.iter().flatten().chain(&feature.lines) {
            covered.edges.push((half_edge(*dart & !1), number));
        }
        for darts in &feature.polygons {
            if let Some(rings) = marks.simple_rings(points, segments, darts) {
                for (ring, left) in rings {
                    marks.flood_ring(dcel, ring, left, &mut touched);
                }
            } else {
                for piece in pieces(segments, darts) {
                    marks.flood(points, segments, dcel, &piece, &mut touched);
                }
            }
            for face in touched.drain(..) {
                let odd = std::mem::take(&mut marks.odd[face]);
                if odd && std::mem::replace(&mut marks.taken_by[face], number + 1) != number + 1 {
                    covered.faces.push((face as u32, number));
                }
            }
        }
    }
    covered.faces.sort_unstable();
    #[expect(
        clippy::stable_sort_primitive,
        reason = "it makes use of runs, and but for shared borders edges come in order"
    )]
    covered.edges.sort();
    covered.edges.dedup();
    covered
}

/// The segments that occur an odd number of times, as darts by their even number, in connected pieces.
fn pieces(segments: &[[u32; 2]], darts: &[Dart]) -> Vec<Vec<Dart>> {
    let mut odd: Vec<Dart> = darts.iter().map(|d| d & !1).collect();
    odd.sort_unstable();
    let mut kept = Vec::with_capacity(odd.len());
    for same in odd.chunk_by(|a, b| a == b) {
        if same.len() % 2 == 1 {
            kept.push(same[0]);
        }
    }
    // Both darts of each segment, by where they start.
    let mut leaving: Vec<(u32, Dart)> =
        kept.iter().flat_map(|d| [(target(segments, *d ^ 1), *d), (target(segments, *d), *d ^ 1)]).collect();
    leaving.sort_unstable();
    let at = |v: u32| leaving.partition_point(|(w, _)| *w < v);
    let mut taken = vec![false; leaving.len()];
    let mut pieces = Vec::new();
    let mut stack = Vec::new();
    for first in 0..leaving.len() {
        if taken[first] {
            continue;
        }
        let mut piece = Vec::new();
        stack.push(leaving[first].0);
        while let Some(v) = stack.pop() {
            let mut i = at(v);
            while i < leaving.len() && leaving[i].0 == v && !taken[i] {
                taken[i] = true;
                piece.push(leaving[i].1);
                stack.push(target(segments, leaving[i].1));
                i += 1;
            }
        }
        pieces.push(piece);
    }
    pieces
}

/// Whether `b` rises more steeply than `a` from a point that lies to the left of both, or straight below.
fn by_steepness(at: Point, a: Point, b: Point) -> Ordering {
    match orientation(at, a, b) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    }
}

impl Marks {
    /// The rings of a polygon, each with whether its inside lies to the left, if no point occurs twice on them.
    fn simple_rings<'d>(
        &mut self,
        points: &[Point],
        segments: &[[u32; 2]],
        darts: &'d [Dart],
    ) -> Option<Vec<(&'d [Dart], bool)>> {
        self.round += 1;
        let mut rings = Vec::new();
        let mut rest = darts;
        while let Some(first) = rest.first() {
            let start = origin(segments, *first);
            let mut at = start;
            let mut lowest = 0;
            let mut length = 0;
            for dart in rest {
                if origin(segments, *dart) != at
                    || std::mem::replace(&mut self.on_rings[at as usize], self.round) == self.round
                {
                    return None;
                }
                let low = points[origin(segments, rest[lowest]) as usize];
                if compare_lexicographic(points[at as usize], low).is_lt() {
                    lowest = length;
                }
                length += 1;
                at = target(segments, *dart);
                if at == start {
                    break;
                }
            }
            if at != start || length < 3 {
                return None;
            }
            let (ring, others) = rest.split_at(length);
            let before = ring[(lowest + length - 1) % length];
            let [a, b, c] = [origin(segments, before), origin(segments, ring[lowest]), target(segments, ring[lowest])]
                .map(|v| points[v as usize]);
            let left = match orientation(a, b, c) {
                Orientation::CounterClockwise => true,
                Orientation::Clockwise => false,
                Orientation::Collinear => return None,
            };
            rings.push((ring, left));
            rest = others;
        }
        Some(rings)
    }

    /// Turns the parity of the faces inside a ring on which no point occurs twice.
    fn flood_ring(&mut self, dcel: &Dcel, ring: &[Dart], left: bool, touched: &mut Vec<usize>) {
        self.round += 1;
        let mut faces = Vec::new();
        for dart in ring {
            let inner = dart ^ u32::from(!left);
            for dart in [inner, inner ^ 1] {
                self.in_piece[half_edge(dart) as usize] = self.round;
            }
            let face = dcel.half_edge_at(half_edge(inner) as usize).map(|h| h.face().index());
            if face.is_some() && face.as_ref() != faces.last() {
                faces.extend(face);
            }
        }
        self.spread(dcel, faces, touched);
    }

    /// Turns the parity of the faces inside a piece, which is given by both darts of each of its segments.
    fn flood(
        &mut self,
        points: &[Point],
        segments: &[[u32; 2]],
        dcel: &Dcel,
        piece: &[Dart],
        touched: &mut Vec<usize>,
    ) {
        self.round += 1;
        let tail = |d: Dart| points[target(segments, d ^ 1) as usize];
        let head = |d: Dart| points[target(segments, d) as usize];
        for dart in piece {
            self.in_piece[half_edge(*dart) as usize] = self.round;
        }
        // What leaves the lowest point least steeply has the outside below and the inside above.
        let seed = piece.iter().copied().min_by(|a, b| {
            compare_lexicographic(tail(*a), tail(*b)).then_with(|| by_steepness(tail(*a), head(*a), head(*b)))
        });
        let Some(seed) = seed.map(|d| half_edge(d) as usize) else { return };

        // Half-edges at vertices still to be visited, with whether the inside lies to their left.
        let mut stack = vec![(seed, true)];
        let mut faces = Vec::new();
        while let Some((from, left)) = stack.pop() {
            let Some(from) = dcel.half_edge_at(from) else { continue };
            if std::mem::replace(&mut self.visited[from.origin().index()], self.round) == self.round {
                continue;
            }
            // Turning counter-clockwise, the side changes at each half-edge of the piece.
            let mut inside = !left;
            for h in from.rotation() {
                if self.in_piece[h.index()] == self.round {
                    inside = !inside;
                    let side = if inside { h } else { h.twin() };
                    faces.push(side.face().index());
                    stack.push((h.twin().index(), !inside));
                }
            }
        }
        self.spread(dcel, faces, touched);
    }

    /// Floods faces across all edges that are not of the piece.
    fn spread(&mut self, dcel: &Dcel, mut faces: Vec<usize>, touched: &mut Vec<usize>) {
        while let Some(index) = faces.pop() {
            if std::mem::replace(&mut self.flooded[index], self.round) == self.round {
                continue;
            }
            touched.push(index);
            self.odd[index] ^= true;
            let Some(face) = dcel.face_at(index) else { continue };
            let others = face.half_edges().filter(|h| self.in_piece[h.index()] != self.round);
            faces.extend(others.map(|h| h.twin().face().index()));
        }
    }
}
