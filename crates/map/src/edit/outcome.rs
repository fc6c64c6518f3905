//! The result of an edit.

use crate::FeatureId;
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};

/// The changes that an edit made, so that data kept beside the map can follow. Attributes of a `PlanarMap` follow by themselves.
///
/// An edge is named by one of its half-edges. Keys of removed records are stale by now; they say which entries to drop. To
/// follow, take the lists in the order of these fields, and the entries of each in their order. A face that was split off
/// may be split again by a later entry, and a face that took up another one may be taken up itself by a later entry.
///
/// ```
/// use std::collections::HashMap;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
/// let mut owners = HashMap::from([(ring.faces_split[0].1, "Ada")]);
///
/// // Both parts of a split face belong to its owner.
/// let wall = map.insert_segment([0.0, 0.0], [4.0, 4.0])?;
/// for (kept, made) in &wall.faces_split {
///     owners.insert(*made, owners[kept]);
/// }
/// assert_eq!(owners.len(), 2);
/// // Entries of removed faces are dropped.
/// for (_, gone) in &map.remove_edge(wall.way[0])?.faces_merged {
///     owners.remove(gone);
/// }
/// assert_eq!(owners.len(), 1);
/// # Ok::<(), twinedge_map::edit::EditError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Edited {
    /// The vertices at the points that were given, in their order, whether made or there before.
    pub vertices: Vec<VertexKey>,
    /// The half-edges along what was drawn, from its first point to its last, whether made or there before.
    pub way: Vec<HalfEdgeKey>,
    /// New vertices.
    pub vertices_made: Vec<VertexKey>,
    /// Removed vertices.
    pub vertices_dropped: Vec<VertexKey>,
    /// Split edges: a half-edge of the old edge, which ends at a new vertex now, and the new one that goes on from there.
    /// Both edges have the features of the old one.
    pub edges_split: Vec<(HalfEdgeKey, HalfEdgeKey)>,
    /// Removed edges.
    pub edges_dropped: Vec<HalfEdgeKey>,
    /// Merged faces: the one that was kept, and the one that was removed.
    pub faces_merged: Vec<(FaceKey, FaceKey)>,
    /// Features that covered only one of two merged faces: that face, and the feature, which does not cover the merged face.
    pub features_dropped: Vec<(FaceKey, FeatureId)>,
    /// New edges, other than parts of old ones.
    pub edges_made: Vec<HalfEdgeKey>,
    /// Split faces: the old face, which is what remains of it now, and the new one. Both are covered by the features of the old
    /// face.
    pub faces_split: Vec<(FaceKey, FaceKey)>,
    /// Faces whose features are others than the lists above make them. Only
    /// [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) fills this, and only where rounding
    /// brings an edge onto vertices that were there.
    pub faces_relabelled: Vec<FaceKey>,
    /// Edges whose features are others than the lists above make them, for the same reason.
    pub edges_relabelled: Vec<HalfEdgeKey>,
}
