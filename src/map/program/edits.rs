//! The language of edits: arguments are small numbers and points, so that any bytes are a program that runs.
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

use super::arguments::{AtPick, FeaturesPick, GridPick, List, MapFacePick, MapHalfEdgePick, MapVertexPick, RingPick};
use super::numbers::Spot;
use crate::program::choose::Choose;
use crate::program::language::instances::instances;
use crate::program::language::table::language;
use crate::program::{Generator, Language};

// The one table of edits. A row reads: variant, method, how often it is drawn, and its arguments, which depend on no others: `()`.
language! {
    header "twinedge edits 1" EditsHeader,
    methods of "PlanarMap" "crate::map::PlanarMap",
    /// One edit with its arguments.
    #[allow(missing_docs, reason = "the arguments are those of the methods of `PlanarMap` of the same names")]
    op EditOp over List,
    /// The kinds of edits, for a [`Generator`].
    kind EditKind,
    /// A sequence of edits, to be run by an [`EditRunner`](crate::map::program::EditRunner).
    ///
    /// ```
    /// use twinedge::map::PlanarMap;
    /// use twinedge::map::program::{EditProgram, EditRunner};
    ///
    /// let program = EditProgram::from_bytes(b"any bytes are a program of edits, and each edit leaves a valid map");
    /// let mut runner = EditRunner::new(PlanarMap::new());
    /// runner.run_checked(&program)?;
    /// // It can be written down, and read again.
    /// assert_eq!(program.to_string().parse(), Ok(program));
    /// # Ok::<(), twinedge::map::program::EditFailure>(())
    /// ```
    program EditProgram,
    InsertPoint insert_point 2 { at: AtPick, (); }
    InsertSegment insert_segment 12 { from: AtPick, (); to: AtPick, (); }
    InsertSegmentSnapped insert_segment_snapped 6 { from: AtPick, (); to: AtPick, (); snap: GridPick, (); }
    InsertRing insert_ring 6 { points: RingPick, (); }
    RemoveEdge remove_edge 2 { half_edge: MapHalfEdgePick, (); }
    RemoveVertex remove_vertex 1 { vertex: MapVertexPick, (); }
    MoveVertex move_vertex 3 { vertex: MapVertexPick, (); to: Spot, (); }
    AddFeature add_feature 2 { }
    SetFeaturesOf set_features_of 2 { face: MapFacePick, (); features: FeaturesPick, (); }
    SetFeaturesAlong set_features_along 2 { half_edge: MapHalfEdgePick, (); features: FeaturesPick, (); }
}

impl EditProgram {
    /// The program that these bytes encode: every choice takes as few as it needs, and those that end too early are followed by
    /// zeros. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        Self::generator().decode(bytes)
    }

    /// A generator of programs, to be told which edits, how often, and how many.
    ///
    /// ```
    /// use twinedge::map::program::{EditKind, EditOp, EditProgram};
    /// use twinedge::program::choose::Bytes;
    ///
    /// let drawing = EditProgram::generator().only(&[EditKind::InsertSegment]).length(3..=3);
    /// let program = drawing.generate(&mut Bytes::new(b"choices"));
    /// assert!(program.0.iter().all(|edit| matches!(edit, EditOp::InsertSegment { .. })));
    /// assert_eq!(program.0.len(), 3);
    /// ```
    #[must_use]
    pub fn generator() -> Generator<Self> {
        Generator::default()
    }
}

impl Language for EditProgram {
    type Kind = EditKind;

    const KINDS: &'static [(EditKind, u32)] = EditKind::SHARES;

    fn op(kind: EditKind, source: &mut impl Choose) -> EditOp {
        EditOp::draw(kind, source, 0)
    }
}

instances!(EditProgram);

#[cfg(feature = "arbitrary")]
impl<'a> arbitrary::Arbitrary<'a> for EditOp {
    fn arbitrary(u: &mut arbitrary::Unstructured<'a>) -> arbitrary::Result<Self> {
        if u.is_empty() {
            return Err(arbitrary::Error::NotEnoughData);
        }
        EditProgram::generator().length(1..=1).generate(u).0.pop().ok_or(arbitrary::Error::NotEnoughData)
    }
}
