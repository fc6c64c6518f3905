//! The result of an edit.

use crate::FeatureId;
use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};

/// The changes made by an edit, for data stored alongside the map. Attributes of a `PlanarMap` follow automatically.
///
/// An edge is named by one of its half-edges. Keys of removed records are already stale; they name the entries to drop. To follow
/// an edit, process the lists in the order of these fields, and the entries of each list in order: later entries may split a new
/// face again, or merge a face that has absorbed another one.
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
    /// The vertices at the given points, in order, new or existing.
    pub vertices: Vec<VertexKey>,
    /// The half-edges along the drawn path from its first point to its last, new or existing.
    pub way: Vec<HalfEdgeKey>,
    /// New vertices.
    pub vertices_made: Vec<VertexKey>,
    /// Removed vertices.
    pub vertices_dropped: Vec<VertexKey>,
    /// Split edges: a half-edge of the old edge, which now ends at a new vertex, and the new half-edge that continues from there.
    /// Both edges have the features of the old one.
    pub edges_split: Vec<(HalfEdgeKey, HalfEdgeKey)>,
    /// Removed edges.
    pub edges_dropped: Vec<HalfEdgeKey>,
    /// Merged faces: the kept face and the removed face.
    pub faces_merged: Vec<(FaceKey, FaceKey)>,
    /// Features that covered only one of two merged faces: that face, and the feature, which does not cover the merged face.
    pub features_dropped: Vec<(FaceKey, FeatureId)>,
    /// New edges, other than parts of old edges.
    pub edges_made: Vec<HalfEdgeKey>,
    /// Split faces: the old face, now reduced to one part, and the new face. The features of the old face cover both.
    pub faces_split: Vec<(FaceKey, FaceKey)>,
    /// Faces whose features differ from the result of the lists above. Only
    /// [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) fills it, if rounding moves an edge onto vertices.
    pub faces_relabelled: Vec<FaceKey>,
    /// Edges whose features differ from the result of the lists above, for the same reason.
    pub edges_relabelled: Vec<HalfEdgeKey>,
}
