//! From points and segments to a subdivision: rotations, cycles, faces, and what lies in what.
//!
//! ```text
//!   segments ─► rotations, sorted by angle ─► next ─► cycles ─► outer ones get a face each
//!                                                        └───► the outside of each component: one sweep finds the edge
//!                                                              below its lowest vertex, and thereby the face it lies in
//! ```
//!
//! Source: de Berg et al., "Computational Geometry", 3rd edition, section 2.3.

use super::error::BuildError;
use super::gathered::{Dart, origin, target};
use crate::dcel::{Dcel, RecordKind};
use crate::geometry::Point;
use crate::geometry::crossing::Clash;
use crate::geometry::predicates::{compare_angle, compare_lexicographic};
use crate::geometry::sweep::sweep;
use crate::store::SlotStore;
use crate::store::links::{BoundaryStart, Links, Need, VertexLink};
use core::cmp::Ordering;

/// Not yet known.
const NIL: u32 = u32::MAX;

/// What the points and segments make.
pub(super) struct Arranged {
    pub(super) dcel: Dcel,
    /// For each point the index of its vertex.
    pub(super) vertices: Vec<u32>,
    /// For each dart the index of its half-edge.
    pub(super) half_edges: Vec<u32>,
    /// Whether, and where first, the segments do not meet at shared endpoints only.
    pub(super) clash: Option<Clash>,
}

impl Arranged {
    /// The points by index of their vertex.
    pub(super) fn points_by_vertex(&self, points: &[Point]) -> Vec<Point> {
        let end = self.vertices.iter().max().map_or(0, |last| *last as usize + 1);
        let mut by_index = vec![Point::default(); end];
        for (vertex, point) in self.vertices.iter().zip(points) {
            by_index[*vertex as usize] = *point;
        }
        by_index
    }
}

/// The darts that leave each point, counter-clockwise from the positive x axis.
struct Rotations {
    first: Vec<u32>,
    darts: Vec<Dart>,
}

impl Rotations {
    fn new(points: &[Point], segments: &[[u32; 2]]) -> Self {
        let mut first = vec![0_u32; points.len() + 1];
        for [a, b] in segments {
            first[*a as usize + 1] += 1;
            first[*b as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut free = first.clone();
        let mut darts = vec![NIL; 2 * segments.len()];
        for (dart, from) in segments.iter().flatten().enumerate() {
            let place = &mut free[*from as usize];
            darts[*place as usize] = dart as u32;
            *place += 1;
        }
        let mut rotations = Self { first, darts };
        for v in 0..points.len() {
            let range = rotations.range(v);
            let leaving = &mut rotations.darts[range];
            if leaving.len() > 1 {
                let head = |d: &Dart| points[target(segments, *d) as usize];
                leaving.sort_unstable_by(|a, b| compare_angle(points[v], head(a), head(b)));
            }
        }
        rotations
    }

    fn range(&self, v: usize) -> core::ops::Range<usize> {
        self.first[v] as usize..self.first[v + 1] as usize
    }

    fn leaving(&self, v: usize) -> &[Dart] {
        &self.darts[self.range(v)]
    }
}

/// The cycles of `next`.
struct Cycles {
    next: Vec<Dart>,
    of: Vec<u32>,
    starts: Vec<Dart>,
}

impl Cycles {
    fn new(rotations: &Rotations, points: usize) -> Self {
        let count = rotations.darts.len();
        let mut next = vec![NIL; count];
        for v in 0..points {
            let leaving = rotations.leaving(v);
            let Some(last) = leaving.last() else { continue };
            // Next after arriving is the dart clockwise of the one that goes back.
            let mut clockwise = *last;
            for dart in leaving {
                next[*dart as usize ^ 1] = clockwise;
                clockwise = *dart;
            }
        }
        let mut of = vec![NIL; count];
        let mut starts = Vec::new();
        for start in 0..count {
            let mut dart = start;
            if of[dart] != NIL {
                continue;
            }
            while of[dart] == NIL {
                of[dart] = starts.len() as u32;
                dart = next[dart] as usize;
            }
            starts.push(start as u32);
        }
        Self { next, of, starts }
    }
}

/// Connected components, by their lexicographically smallest point each, smallest component first.
fn lowest_points(points: &[Point], segments: &[[u32; 2]]) -> Vec<u32> {
    // Each set is a tree that hangs from its lowest point.
    let mut parent: Vec<u32> = (0..points.len() as u32).collect();
    let root = |parent: &mut Vec<u32>, mut v: u32| {
        while parent[v as usize] != v {
            let above = parent[parent[v as usize] as usize];
            parent[v as usize] = above;
            v = above;
        }
        v
    };
    for [a, b] in segments {
        let (a, b) = (root(&mut parent, *a), root(&mut parent, *b));
        if a != b {
            let less = compare_lexicographic(points[a as usize], points[b as usize]) == Ordering::Less;
            let (low, high) = if less { (a, b) } else { (b, a) };
            parent[high as usize] = low;
        }
    }
    let mut lowest: Vec<u32> = (0..points.len() as u32).filter(|v| parent[*v as usize] == *v).collect();
    lowest.sort_unstable_by(|a, b| compare_lexicographic(points[*a as usize], points[*b as usize]));
    lowest
}

/// The dart at the lowest point of a component whose corner holds the direction straight to the left: it lies on the
/// outside of the component.
fn outside_dart(rotations: &Rotations, points: &[Point], segments: &[[u32; 2]], low: u32) -> Option<Dart> {
    let at = points[low as usize];
    let leaving = rotations.leaving(low as usize);
    // Everything lies to the right, first upwards from the axis, then from straight down to the axis.
    let upper = leaving.partition_point(|d| {
        let head = points[target(segments, *d) as usize];
        head.y >= at.y
    });
    leaving.get(upper.wrapping_sub(1)).or(leaving.last()).copied()
}

/// Arranges the points and segments, which are distinct and in range, into a subdivision. O(n log n).
pub(super) fn arrange(points: &[Point], segments: &[[u32; 2]]) -> Result<Arranged, BuildError> {
    let rotations = Rotations::new(points, segments);
    let cycles = Cycles::new(&rotations, points.len());
    let lowest = lowest_points(points, segments);
    let swept = sweep(points, segments, &lowest).map_err(|_| BuildError::Full(RecordKind::Vertex))?;

    // The cycles that are the outside of their component, and for each the face where that lies.
    let mut outside = vec![false; cycles.starts.len()];
    let outside_darts: Vec<_> = lowest.iter().map(|v| outside_dart(&rotations, points, segments, *v)).collect();
    for dart in outside_darts.iter().flatten() {
        outside[cycles.of[*dart as usize] as usize] = true;
    }
    let isolated = outside_darts.iter().filter(|dart| dart.is_none()).count();
    let bounded = outside.iter().filter(|outside| !**outside).count();
    let need = Need {
        vertices: points.len(),
        edges: segments.len(),
        boundaries: cycles.starts.len() + isolated,
        faces: bounded,
    };
    let mut dcel: Dcel<SlotStore> = Dcel::with_room(need);
    let store = dcel.store_mut();
    store.room_for(need).map_err(BuildError::Full)?;

    let unbounded = store.unbounded();
    let mut vertices = Vec::with_capacity(points.len());
    let mut slots = Vec::with_capacity(points.len());
    let mut boundary_of = Vec::with_capacity(cycles.starts.len());
    let mut half_edges = Vec::with_capacity(2 * segments.len());
    // Records refer to each other, so half-edges come first, from a vertex and a component that stand in for the right ones.
    if !segments.is_empty() {
        let (stand_in, component) = store.add_isolated(unbounded);
        for _ in segments {
            let h = store.add_edge(stand_in, stand_in, component);
            half_edges.push(h);
            half_edges.push(store.twin(h));
        }
        store.unlist(component);
        store.remove_boundary(component);
        store.remove_vertex(stand_in);
    }
    for v in 0..points.len() {
        let slot = match rotations.leaving(v).first() {
            Some(dart) => store.add_vertex(VertexLink::Leaving(half_edges[*dart as usize])),
            // Its face is found below, with those of the other components.
            None => store.add_isolated(unbounded).0,
        };
        slots.push(slot);
        vertices.push(store.vertex_index(slot) as u32);
    }
    for (start, outside) in cycles.starts.iter().zip(&outside) {
        let face = if *outside { unbounded } else { store.add_face() };
        let b = store.add_boundary(face, BoundaryStart::HalfEdge(half_edges[*start as usize]));
        if !*outside {
            store.list_outer(face, b);
        }
        boundary_of.push(b);
    }
    for (dart, h) in half_edges.iter().enumerate() {
        store.set_origin(*h, slots[origin(segments, dart as u32) as usize]);
        store.set_boundary(*h, boundary_of[cycles.of[dart] as usize]);
        store.join(*h, half_edges[cycles.next[dart] as usize]);
    }
    // From left to right, so that what lies below a component is already where it belongs.
    for (i, dart) in outside_darts.iter().enumerate() {
        let face = match swept.below[i] {
            Some(segment) => {
                let [a, b] = segments[segment as usize];
                let rises = compare_lexicographic(points[a as usize], points[b as usize]) == Ordering::Less;
                let above = half_edges[(segment << 1 | u32::from(!rises)) as usize];
                store.face(store.boundary(above))
            }
            None => unbounded,
        };
        match dart {
            Some(dart) => store.list_inner(face, boundary_of[cycles.of[*dart as usize] as usize]),
            None => {
                if let VertexLink::Isolated(b) = store.vertex_link(slots[lowest[i] as usize]) {
                    store.unlist(b);
                    store.list_inner(face, b);
                }
            }
        }
    }
    let half_edges = half_edges.iter().map(|h| store.half_edge_index(*h) as u32).collect();
    Ok(Arranged { dcel, vertices, half_edges, clash: swept.clash })
}
