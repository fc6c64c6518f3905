//! The choices that topology leaves open when a face is split: the side of the new face, and its inner boundary components.
//!
//! ```text
//!    outer cycle: either will do                inner cycle: the new face is the one inside
//!   ┌─────────────b────┐                           ┌─────┐          f
//!   │   f         ┃ new│                           │     a━━━┓
//!   │  ·     ┌─┐  ┃ ·  │                           └──┐  new ┃   ·
//!   │        └─┘  ┃    │                              └────b━┛
//!   └─────────────a────┘
//! ```

use super::error::EditError;
use crate::index::{BoxedRecord, TreeRecord, is_small};
use crate::planar_map::PlanarMap;
use core::cmp::Ordering;
use rustc_hash::FxHashMap;
use twinedge::dcel::{Boundary, BoundaryKey, Face, HalfEdge, OperatorError, RecordKind, Side, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};
use twinedge_geometry::sweep::sweep;

/// One of the two cycles into which a new edge splits a cycle.
struct CyclePart<'a> {
    /// The side of the new edge on which this cycle lies.
    side: Side,
    /// The old half-edges, in order. The new half-edge leads from the target of the last to the origin of the first.
    old: Vec<HalfEdge<'a>>,
}

impl<'a> CyclePart<'a> {
    /// Returns the shorter part of a cycle split between the corners of `from` and `to`; on a tie, the left part. O(its length).
    fn shorter(from: HalfEdge<'a>, to: HalfEdge<'a>) -> Self {
        let (mut left, mut right) = (to, from);
        let mut length = 1;
        let side = loop {
            (left, right, length) = (left.next(), right.next(), length + 1);
            if left == from {
                break Side::Left;
            }
            if right == to {
                break Side::Right;
            }
        };
        let start = if side == Side::Left { to } else { from };
        Self { side, old: start.boundary_cycle().take(length - 1).collect() }
    }

    /// Returns the origins of the cycle's half-edges: first of the old half-edges, then of the new one.
    fn vertices(&self) -> impl Iterator<Item = Vertex<'a>> {
        self.old.iter().map(|h| h.origin()).chain(self.old.last().map(|h| h.target()))
    }
}

impl PlanarMap {
    /// Determines the split of a face by an edge from the corner of `from` to the corner of `to`, on the same cycle: the side of
    /// the new face, and the inner boundary components that move to it.
    ///
    /// The shorter part of an outer cycle bounds the new face; on a tie, the left part. For an inner cycle, geometry decides.
    ///
    /// O(length s of the shorter part + k), where k is the smaller of the face's other inner boundary components and the edges in
    /// the box around that part. If j of these components meet the box, a sweep takes O((s + j) log (s + j)).
    pub(super) fn sides(&self, from: HalfEdge<'_>, to: HalfEdge<'_>) -> Result<(Side, Vec<BoundaryKey>), EditError> {
        let split = from.boundary();
        let part = CyclePart::shorter(from, to);
        let places: Vec<Point> = part.vertices().map(|v| self.at(v)).collect();
        let around = !split.is_outer() && turns_clockwise(&places);
        let side = match part.side {
            Side::Left if !around => Side::Left,
            Side::Right if around => Side::Left,
            Side::Left | Side::Right => Side::Right,
        };
        Ok((side, self.enclosed(&part, &places, around, split)?))
    }

    /// Returns the face's other inner boundary components inside a part of the cycle: to its left, or to its right if `around`.
    fn enclosed(
        &self,
        part: &CyclePart<'_>,
        places: &[Point],
        around: bool,
        split: Boundary<'_>,
    ) -> Result<Vec<BoundaryKey>, EditError> {
        let (mut low, mut high) = (places[0], places[0]);
        for p in places {
            low = Point::new(low.x.min(p.x), low.y.min(p.y));
            high = Point::new(high.x.max(p.x), high.y.max(p.y));
        }
        let mut points = Vec::new();
        let mut candidates = Vec::new();
        for component in self.inner_near(split.face(), low, high).into_iter().filter(|b| *b != split) {
            let any = component.start().map(|h| h.origin()).or_else(|| component.isolated_vertex());
            let Some(p) = any.map(|v| self.at(v)) else { continue };
            if low.x < p.x && p.x < high.x && low.y < p.y && p.y < high.y {
                candidates.push(component.key());
                points.push(p);
            }
        }
        if candidates.is_empty() {
            return Ok(Vec::new());
        }
        // A part may pass a vertex twice, and run along both sides of an edge.
        let mut numbers = FxHashMap::default();
        let mut number = |v: Vertex<'_>, p: Point| {
            *numbers.entry(v.index()).or_insert_with(|| {
                points.push(p);
                points.len() as u32 - 1
            })
        };
        let corners: Vec<u32> = part.vertices().zip(places).map(|(v, p)| number(v, *p)).collect();
        let mut rises_on_the_left: FxHashMap<[u32; 2], bool> = FxHashMap::default();
        for (i, from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            let rises = compare_lexicographic(points[*from as usize], points[to as usize]) == Ordering::Less;
            let segment = if rises { [*from, to] } else { [to, *from] };
            *rises_on_the_left.entry(segment).or_default() |= rises;
        }
        let segments: Vec<[u32; 2]> = rises_on_the_left.keys().copied().collect();
        let queries: Vec<u32> = (0..candidates.len() as u32).collect();
        let swept = sweep(&points, &segments, &queries).map_err(|_| OperatorError::Full(RecordKind::Vertex))?;
        // The face above an edge lies to the left of the half-edge that rises along it.
        let lies_inside =
            |below: &Option<u32>| below.is_some_and(|segment| rises_on_the_left[&segments[segment as usize]] != around);
        Ok(candidates.into_iter().zip(&swept.below).filter(|(_, below)| lies_inside(below)).map(|(b, _)| b).collect())
    }
}

impl PlanarMap {
    /// Returns the inner boundary components of a face, or only the ones with an edge in a box. O(lesser of the number of
    /// components and the number of edges in the box), plus the cost of the index.
    fn inner_near<'a>(&'a self, face: Face<'a>, low: Point, high: Point) -> Vec<Boundary<'a>> {
        if is_small(face) {
            return face.inner().collect();
        }
        let of_record = |boxed: &BoxedRecord| match boxed.record {
            TreeRecord::Edge(h) => {
                self.dcel.half_edge_at(h as usize).map_or([None; 2], |h| [h, h.twin()].map(|h| Some(h.boundary())))
            }
            TreeRecord::Vertex(v) => [self.dcel.vertex_at(v as usize).and_then(|v| v.isolated()), None],
        };
        let (mut near, mut all) = (Vec::new(), Vec::new());
        let mut listed = face.inner();
        // Both sources advance in step, as either may be far larger.
        for boxed in self.index().in_box(low, high) {
            near.extend(of_record(boxed).into_iter().flatten().filter(|b| !b.is_outer() && b.face() == face));
            let Some(b) = listed.next() else { return all };
            all.push(b);
        }
        near.sort_by_key(|b| b.index());
        near.dedup();
        near
    }
}

/// Returns true if a closed chain of points, a cycle of a plane map, turns clockwise: at its lexicographically smallest point, a
/// corner is open to the left. The chain may pass that point more than once.
fn turns_clockwise(places: &[Point]) -> bool {
    let mut low = places[0];
    let mut clockwise = false;
    for (i, at) in places.iter().enumerate() {
        let before = places[(i + places.len() - 1) % places.len()];
        let after = places[(i + 1) % places.len()];
        // Everything lies to the right, so the corner is closed if the turn from the next point to the previous is to the left.
        let opens = || orientation(*at, after, before) != Orientation::CounterClockwise;
        match compare_lexicographic(*at, low) {
            Ordering::Less => (low, clockwise) = (*at, opens()),
            Ordering::Equal => clockwise |= opens(),
            Ordering::Greater => {}
        }
    }
    clockwise
}
