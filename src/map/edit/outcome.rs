//! What an edit did.

use crate::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use crate::map::feature::FeatureId;

/// What an edit did, so that data kept beside the map can follow.
///
/// An edge is named by one of its half-edges. Keys of what is gone are stale by now, and say which entries to drop. To
/// follow, take the lists in the order in which they stand here; in each, what comes first happened first. So a face that
/// was split off may itself be split by a later entry, and one that swallowed a face may be swallowed by a later one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Edited {
    /// The vertices at the points that were given, in their order, whether made or there before.
    pub vertices: Vec<VertexKey>,
    /// The half-edges along what was drawn, from its first point to its last, whether made or there before.
    pub way: Vec<HalfEdgeKey>,
    /// New vertices.
    pub vertices_made: Vec<VertexKey>,
    /// Vertices that are gone.
    pub vertices_dropped: Vec<VertexKey>,
    /// Edges that were split: a half-edge that was there and ends at a new vertex now, and the new one that goes on from
    /// there. Both have the features of the edge that was there.
    pub edges_split: Vec<(HalfEdgeKey, HalfEdgeKey)>,
    /// Edges that are gone.
    pub edges_dropped: Vec<HalfEdgeKey>,
    /// Faces that became one: the face that has everything now, and the one that is gone.
    pub faces_merged: Vec<(FaceKey, FaceKey)>,
    /// Features that covered one of two faces that became one: the face, and the feature, which does not cover what they
    /// became.
    pub features_dropped: Vec<(FaceKey, FeatureId)>,
    /// New edges, other than parts of old ones.
    pub edges_made: Vec<HalfEdgeKey>,
    /// Faces that were split: the face that was there and has the rest of itself now, and the new one. Both are covered by
    /// the features of the face that was there.
    pub faces_split: Vec<(FaceKey, FaceKey)>,
    /// Faces whose features are others than the lists above make them. Only
    /// [`insert_segment_snapped`](crate::map::PlanarMap::insert_segment_snapped) fills this, and only where rounding
    /// brings an edge onto vertices that were there.
    pub faces_relabelled: Vec<FaceKey>,
    /// Edges whose features are others than the lists above make them, for the same reason.
    pub edges_relabelled: Vec<HalfEdgeKey>,
}
