//! The one table of edits.
//!
//! From it follow the edits of programs, their names, their text, how they are drawn at random, how they are made simpler, and how
//! their numbers follow what they chose. A row reads: variant, method, how often it is drawn, and its arguments.

/// Calls the macro `$then` with the table.
macro_rules! edits {
    ($then:ident) => {
        $then! {
            InsertPoint insert_point 2 { at: AtPick; }
            InsertSegment insert_segment 12 { from: AtPick; to: AtPick; }
            InsertSegmentSnapped insert_segment_snapped 6 { from: AtPick; to: AtPick; snap: GridPick; }
            InsertRing insert_ring 6 { points: RingPick; }
            RemoveEdge remove_edge 2 { half_edge: MapHalfEdgePick; }
            RemoveVertex remove_vertex 1 { vertex: MapVertexPick; }
            MoveVertex move_vertex 3 { vertex: MapVertexPick; to: Spot; }
            AddFeature add_feature 2 { }
            SetFeaturesOf set_features_of 2 { face: MapFacePick; features: FeaturesPick; }
            SetFeaturesAlong set_features_along 2 { half_edge: MapHalfEdgePick; features: FeaturesPick; }
        }
    };
}
pub(super) use edits;
