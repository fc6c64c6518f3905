//! The language of edits: arguments are small numbers and points, so any bytes decode to a program that runs.
//!
//! ```text
//! twinedge edits 1
//! insert_ring 0,0 4,0 4,4 0,4
//! insert_segment v0 4,4
//! insert_segment_snapped 0,3 5,1.5@h0 0.25   # a point near h0; a grid with cells of 0.25, or `auto`
//! move_vertex v1 5,0
//! remove_edge !h0                            # !v, !h, !f: a key that was removed
//! add_feature
//! set_features_of f1 0,2                     # or `none`
//! ```

use super::arguments::{
    AtPick, FeaturesPick, GridPick, List, MapFacePick, MapHalfEdgePick, MapVertexPick, RingPick, Spot,
};
use twinedge::language;

// The only table of edits. A row reads: variant, name, frequency, and arguments.
language! {
    header "twinedge edits 1" EditsHeader,
    /// One edit with its arguments.
    #[allow(missing_docs, reason = "the arguments are those of the methods of `PlanarMap` of the same names")]
    op EditOp over List,
    /// The kinds of edits, for a [`Generator`](twinedge::program::Generator).
    kind EditKind,
    /// A sequence of edits for an [`EditRunner`](crate::program::EditRunner).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::program::{EditProgram, EditRunner};
    ///
    /// let program = EditProgram::from_bytes(b"any bytes are a program of edits, and each edit leaves a valid map");
    /// let mut runner = EditRunner::new(PlanarMap::new());
    /// runner.run_checked(&program)?;
    /// // It can be written down, and read again.
    /// assert_eq!(program.to_string().parse(), Ok(program));
    /// # Ok::<(), twinedge_map::program::EditFailure>(())
    /// ```
    program EditProgram,
    /// [`PlanarMap::insert_point`](crate::PlanarMap::insert_point).
    InsertPoint insert_point 2 { at: AtPick }
    /// [`PlanarMap::insert_segment`](crate::PlanarMap::insert_segment).
    InsertSegment insert_segment 12 { from: AtPick, to: AtPick }
    /// [`PlanarMap::insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped).
    InsertSegmentSnapped insert_segment_snapped 6 { from: AtPick, to: AtPick, snap: GridPick }
    /// [`PlanarMap::insert_ring`](crate::PlanarMap::insert_ring).
    InsertRing insert_ring 6 { points: RingPick }
    /// [`PlanarMap::remove_edge`](crate::PlanarMap::remove_edge).
    RemoveEdge remove_edge 2 { half_edge: MapHalfEdgePick }
    /// [`PlanarMap::remove_vertex`](crate::PlanarMap::remove_vertex).
    RemoveVertex remove_vertex 1 { vertex: MapVertexPick }
    /// [`PlanarMap::move_vertex`](crate::PlanarMap::move_vertex).
    MoveVertex move_vertex 3 { vertex: MapVertexPick, to: Spot }
    /// [`PlanarMap::add_feature`](crate::PlanarMap::add_feature).
    AddFeature add_feature 2 {}
    /// [`PlanarMap::set_features_of`](crate::PlanarMap::set_features_of).
    SetFeaturesOf set_features_of 2 { face: MapFacePick, features: FeaturesPick }
    /// [`PlanarMap::set_features_along`](crate::PlanarMap::set_features_along).
    SetFeaturesAlong set_features_along 2 { half_edge: MapHalfEdgePick, features: FeaturesPick }
}
