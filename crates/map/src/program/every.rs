//! Every edit with every argument on one map, with given points.

use super::arguments::{
    AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, Number, RingPick, Spot,
};
use super::edits::EditOp;
use super::runner::EditRunner;

/// Returns every edit with every argument, valid or invalid, on the runner's current map. The arguments are:
///
/// - points: all given points; a point near the first half-edge; the first vertex, and the first removed vertex;
/// - segments: every pair of points, including equal ones; also snapped to whole numbers;
/// - rings: every three different points, starting with the first of them;
/// - edges, vertices, faces: all live ones, and the first removed one;
/// - features: none, the first, one that does not exist.
///
/// O(p³ + p · n) edits for p points and n records.
#[must_use]
pub fn every_edit(map: &EditRunner, points: &[Spot]) -> Vec<EditOp> {
    let live = |count: usize| (0..count).map_while(|k| u32::try_from(k).ok());
    let first = |list: usize| (list > 0).then_some(0);
    let stale_vertex = first(map.vertices.retired.len()).map(MapVertexPick::Retired);
    let stale_half_edge = first(map.half_edges.retired.len()).map(MapHalfEdgePick::Retired);
    let stale_face = first(map.faces.retired.len()).map(MapFacePick::Retired);
    let vertices: Vec<_> = live(map.vertices.len()).map(MapVertexPick::Live).chain(stale_vertex).collect();
    let half_edges: Vec<_> = live(map.half_edges.len()).map(MapHalfEdgePick::Live).chain(stale_half_edge).collect();
    let faces: Vec<_> = live(map.faces.len()).map(MapFacePick::Live).chain(stale_face).collect();

    let mut ops = vec![EditOp::AddFeature {}];
    let known = vertices.first().copied().into_iter().chain(stale_vertex).map(AtPick::Vertex);
    let hints = half_edges.first().copied().into_iter().chain(stale_half_edge);
    let near = points.first().into_iter().flat_map(|spot| hints.clone().map(|hint| AtPick::Near(*spot, hint)));
    let places: Vec<AtPick> = points.iter().copied().map(AtPick::Point).chain(near).chain(known).collect();
    for from in places.iter().copied() {
        ops.push(EditOp::InsertPoint { at: from });
        for to in places.iter().copied() {
            ops.push(EditOp::InsertSegment { from, to });
            let snap = GridPick::Size(Number::from(1.0));
            ops.push(EditOp::InsertSegmentSnapped { from, to, snap });
        }
    }
    let spots = |ring: [usize; 3]| ring.into_iter().map(|i| AtPick::Point(points[i])).collect();
    for i in 0..points.len() {
        for j in (i + 1..points.len()).flat_map(|j| (i + 1..points.len()).map(move |k| [i, j, k])) {
            if j[1] != j[2] {
                ops.push(EditOp::InsertRing { points: RingPick(spots(j)) });
            }
        }
    }
    for vertex in vertices.iter().copied() {
        ops.push(EditOp::RemoveVertex { vertex });
        ops.extend(points.iter().map(|to| EditOp::MoveVertex { vertex, to: *to }));
    }
    let features = [0, 1, 1 << 15].map(FeaturesPick);
    for half_edge in half_edges.iter().copied() {
        ops.push(EditOp::RemoveEdge { half_edge });
        ops.extend(features.map(|features| EditOp::SetFeaturesAlong { half_edge, features }));
    }
    for face in faces.iter().copied() {
        ops.extend(features.map(|features| EditOp::SetFeaturesOf { face, features }));
    }
    ops
}
