//! Programs of edits: sequences of [edits](super::edit) as data, for testing planar maps, and code that uses them, under change.
//!
//! As in the language of [`program`](twinedge::program), small numbers choose records by position in order of creation, so any
//! bytes decode to a program that runs on any map. Points are mostly on a small grid, where they coincide and segments cross;
//! some are close to it, near the ends of the range of coordinates, or arbitrary bits. Some keys are stale on purpose.
//!
//! ```
//! use twinedge_map::PlanarMap;
//! use twinedge_map::program::{EditProgram, EditRunner};
//! use twinedge::program::shrink;
//!
//! /// Whether a program makes a hole in a bounded face.
//! fn makes_hole(program: &EditProgram) -> bool {
//!     let mut runner = EditRunner::new(PlanarMap::new());
//!     runner.run(program);
//!     let map = runner.into_map();
//!     map.dcel().faces().any(|f| !f.is_unbounded() && f.inner().any(|b| b.start().is_some()))
//! }
//!
//! let program: EditProgram = "twinedge edits 1
//!     insert_ring 0,0 7,0 7,7 0,7
//!     insert_point 6,5
//!     insert_segment v0 6,5
//!     insert_ring 1,2 4,2 2,5
//!     insert_segment 3,3 4,6@h1
//! ".parse()?;
//! assert!(makes_hole(&program));
//! let small = shrink(&program, makes_hole);
//! assert_eq!(small.0.len(), 2);
//! # Ok::<(), twinedge::program::ParseError>(())
//! ```
//!
//! | to | use |
//! | --- | --- |
//! | run a program | [`EditRunner`]: with or without a check of every rule, R1 … T4 and G1 … G5, after each edit |
//! | get programs | [`EditProgram::from_bytes`]; the features `arbitrary`, `quickcheck` and `proptest` for the crates of these names |
//! | choose edits, frequencies and length | [`EditProgram::generator`] |
//! | try everything | [`every_edit`] |
//! | shrink a failing program | [`shrink`](twinedge::program::shrink()); `quickcheck` and `proptest` do it automatically |
//! | save it | its text ([`Display`](core::fmt::Display), [`FromStr`](core::str::FromStr)) |
//!
//! There is no instance for a model checker, which could not handle exact predicates on symbolic doubles.

mod arguments;
mod edits;
mod every;
mod instances;
mod runner;

pub use arguments::{
    AtPick, FeaturesPick, GridPick, MapFacePick, MapHalfEdgePick, MapVertexPick, Number, RingPick, Spot,
};
pub use edits::{EditKind, EditOp, EditProgram};
pub use every::every_edit;
pub use runner::{EditFailure, EditOutcome, EditRunner, PastLast};
