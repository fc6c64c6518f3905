//! Every operator with every argument, on one map.

use super::arguments::{CornerPick, FacePick, HalfEdgePick, InnerPick, SecondPick, VertexPick};
use super::operators::Op;
use super::runner::Runner;
use super::subject::{StepOutcome, Subject};
use crate::dcel::{Corner, Side, Turn};
use alloc::vec::Vec;

/// Every operator with every argument, valid or not, on the runner's current map. Operators of meshes are in [`every_mesh_op`].
/// The arguments are:
///
/// - corners and half-edges: all live ones, the first removed one, and a vertex that is wrongly taken for isolated;
/// - faces: one corner of each, the unbounded face, and the first removed one;
/// - boundary components: one corner of each;
/// - [`Op::Connect`]: both sides, and every set of the inner boundary components that may go to the new face; then, with the
///   new face to the left, each boundary component that may not.
///
/// With n half-edges and k boundary components in the fullest face, there are O(n² · (2ᵏ + n)) operators. Finding them takes
/// O(n²) more. At most 16 inner boundary components of a face are distinguished.
pub fn every_op<K: Subject>(map: &Runner<K>) -> Vec<Op> {
    let picks = Picks::of(map);
    let mut ops = Vec::new();
    for face in &picks.faces {
        ops.push(Op::AddIsolatedVertex { face: *face });
        ops.extend(picks.boundaries.iter().map(|inner| Op::MoveInner { inner: inner.corner, face: *face }));
        ops.extend(picks.wrong_corners.iter().map(|inner| Op::MoveInner { inner: *inner, face: *face }));
    }
    ops.extend(picks.vertices.iter().map(|vertex| Op::RemoveIsolatedVertex { vertex: *vertex }));
    for half_edge in picks.half_edges.iter().copied() {
        ops.extend([
            Op::RemoveEdge { half_edge },
            Op::SplitEdge { half_edge },
            Op::JoinEdges { half_edge },
            Op::ContractEdge { half_edge },
            Op::FlipEdge { half_edge, turn: Turn::CounterClockwise },
            Op::FlipEdge { half_edge, turn: Turn::Clockwise },
        ]);
    }
    let split = |from, to| Op::SplitVertex { from, to: SecondPick::Any(to) };
    let connect = |from, to| Op::Connect {
        from,
        to: SecondPick::Any(to),
        new_face: Side::Left,
        inner: InnerPick { mask: 0, also: None },
    };
    for from in &picks.corners {
        for to in &picks.corners {
            ops.push(split(from.corner, to.corner));
            picks.connect(from, to, &mut ops);
        }
        for wrong in picks.wrong_corners.iter().copied() {
            ops.extend([split(from.corner, wrong), split(wrong, from.corner)]);
            ops.extend([connect(from.corner, wrong), connect(wrong, from.corner)]);
        }
    }
    ops
}

/// Every operator of triangle meshes on every live half-edge and the first removed one. O(n).
pub fn every_mesh_op<K: Subject>(map: &Runner<K>) -> Vec<Op> {
    let picks = Picks::of(map).half_edges.into_iter();
    picks
        .flat_map(|half_edge| {
            [
                Op::MeshFlipEdge { half_edge },
                Op::MeshSplitEdge { half_edge },
                Op::MeshSplitFace { half_edge },
                Op::MeshCollapseEdge { half_edge },
            ]
        })
        .collect()
}

/// Applies [every operator](every_op) to the current map, one at a time, and passes each outcome to `visit`: with the new map
/// if the operator was applied, otherwise with the map, which should be unchanged.
pub fn try_every_op<K: Subject + Clone>(map: &Runner<K>, mut visit: impl FnMut(Op, StepOutcome, &Runner<K>)) {
    let mut attempt = map.clone();
    for op in every_op(map) {
        let outcome = attempt.step(op);
        visit(op, outcome, &attempt);
        if outcome == StepOutcome::Applied {
            attempt = map.clone();
        }
    }
}

#[derive(Clone, Copy)]
struct NumberedCorner {
    corner: CornerPick,
    face: usize,
    boundary: usize,
}

struct Picks {
    corners: Vec<NumberedCorner>,
    boundaries: Vec<NumberedCorner>,
    faces: Vec<FacePick>,
    half_edges: Vec<HalfEdgePick>,
    vertices: Vec<VertexPick>,
    wrong_corners: Vec<CornerPick>,
}

impl Picks {
    fn of<K: Subject>(map: &Runner<K>) -> Self {
        let subject = map.subject();
        let mut faces = Vec::new();
        let mut boundary_of: Vec<Option<usize>> = alloc::vec![None; map.half_edges().len()];
        let (mut corners, mut boundaries): (Vec<NumberedCorner>, Vec<NumberedCorner>) = (Vec::new(), Vec::new());
        let half_edges = (0..).zip(map.half_edges()).map(|(k, h)| (Corner::At(HalfEdgePick::Live(k)), Corner::At(*h)));
        let isolated = (0..).zip(map.isolated());
        let isolated = isolated.map(|(k, v)| (Corner::Isolated(VertexPick::Isolated(k)), Corner::Isolated(*v)));
        for (position, (pick, corner)) in half_edges.chain(isolated).enumerate() {
            let Ok(face) = subject.face_of(corner) else { continue };
            let number = faces.iter().position(|other| *other == face).unwrap_or(faces.len());
            if number == faces.len() {
                faces.push(face);
            }
            let known = boundary_of.get(position).copied().flatten();
            let place = NumberedCorner { corner: pick, face: number, boundary: known.unwrap_or(boundaries.len()) };
            if known.is_none() {
                boundaries.push(place);
                if let Corner::At(h) = corner {
                    mark_cycle(map, h, place.boundary, &mut boundary_of);
                }
            }
            corners.push(place);
        }
        let first_in = |number| boundaries.iter().find(|place: &&NumberedCorner| place.face == number);
        let bounded_faces = (0..faces.len()).filter(|number| Some(faces[*number]) != subject.unbounded_face());
        let bounded_faces = bounded_faces.filter_map(first_in).map(|place| FacePick::Of(place.corner));
        let gone = |list: usize| list > 0;
        let stale_half_edge = gone(map.retired_half_edges().len()).then_some(HalfEdgePick::Retired(0));
        let stale_vertex = gone(map.retired_vertices().len()).then_some(VertexPick::Retired(0));
        let stale_face = gone(map.retired_faces().len()).then_some(FacePick::Retired(0));
        let busy_vertex = (!map.half_edges().is_empty()).then_some(VertexPick::OriginOf(0));
        let live = (0..).zip(map.half_edges()).map(|(k, _)| HalfEdgePick::Live(k));
        let vertices = (0..).zip(map.isolated()).map(|(k, _)| VertexPick::Isolated(k));
        Self {
            faces: subject
                .unbounded_face()
                .map(|_| FacePick::Unbounded)
                .into_iter()
                .chain(bounded_faces)
                .chain(stale_face)
                .collect(),
            half_edges: live.chain(stale_half_edge).collect(),
            vertices: vertices.chain(busy_vertex).chain(stale_vertex).collect(),
            wrong_corners: stale_half_edge
                .map(Corner::At)
                .into_iter()
                .chain([stale_vertex, busy_vertex].into_iter().flatten().map(Corner::Isolated))
                .collect(),
            corners,
            boundaries,
        }
    }

    fn connect(&self, from: &NumberedCorner, to: &NumberedCorner, ops: &mut Vec<Op>) {
        let mut push = |new_face, inner| {
            ops.push(Op::Connect { from: from.corner, to: SecondPick::Any(to.corner), new_face, inner });
        };
        let splits = from.boundary == to.boundary;
        // The components that the interpreter counts, in its order: the rest of the face's boundary. Sets that contain the
        // outer boundary component are invalid.
        let others = self.boundaries.iter().filter(|place| place.face == from.face && place.boundary != from.boundary);
        let sets = if splits { 1_u32 << others.count().min(16) } else { 1 };
        for mask in (0..sets).map(|mask| mask as u16) {
            push(Side::Left, InnerPick { mask, also: None });
            push(Side::Right, InnerPick { mask, also: None });
        }
        if splits {
            let elsewhere = self.boundaries.iter().filter(|place| place.face != from.face);
            let own = self.boundaries.get(from.boundary);
            let wrong = own.into_iter().chain(elsewhere).map(|place| place.corner);
            for also in wrong.chain(self.wrong_corners.iter().copied()) {
                push(Side::Left, InnerPick { mask: 0, also: Some(also) });
            }
        }
    }
}

/// Records the boundary component of all half-edges of a cycle. Stops after the number of half-edges, even if the cycle does
/// not close.
fn mark_cycle<K: Subject>(map: &Runner<K>, start: K::HalfEdge, boundary: usize, boundary_of: &mut [Option<usize>]) {
    let mut h = start;
    for _ in 0..boundary_of.len() {
        if let Some(position) = map.half_edges().iter().position(|other| *other == h) {
            boundary_of[position] = Some(boundary);
        }
        match map.subject().next_of(h) {
            Ok(next) if next != start => h = next,
            _ => return,
        }
    }
}
