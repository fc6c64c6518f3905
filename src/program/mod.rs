//! Programs: sequences of operators as data, for testing structures by changing them.
//!
//! A program chooses arguments by small numbers: positions in lists of live elements, modulo the length of the list.
//! Therefore any bytes are a program that runs on any structure, and no argument is out of range. Some arguments are
//! handles of removed records, on purpose: a correct structure refuses them.
//!
//! ```
//! use twinedge::dcel::Dcel;
//! use twinedge::program::{StepOutcome, Program, Refusal, Runner};
//!
//! let program: Program = "twinedge program 1
//!     add_isolated_vertex unbounded
//!     split_vertex i0 i0              # the vertex becomes an edge, h0 and h1,
//!     connect h0 h1 left              # and the edge a face
//!     remove_edge h0
//!     remove_edge !h0                 # once more: a stale handle
//! ".parse()?;
//! let mut runner = Runner::new(Dcel::new());
//! let outcomes = runner.run(&program);
//! assert_eq!(outcomes[3], StepOutcome::Applied);
//! assert_eq!(outcomes[4], StepOutcome::Refused(Refusal::Stale));
//! assert!(runner.subject().validate().is_valid());
//! # Ok::<(), twinedge::program::ParseError>(())
//! ```
//!
//! | to | take |
//! | --- | --- |
//! | drive your own structure | the trait [`Subject`], implemented by [`Dcel`](crate::dcel::Dcel) |
//! | test a structure | [`conformance::check`]: random programs on the structure and [`PointerModel`] in step, compared after every operator |
//! | try operators outside this language | [`choose`]: draw an operator and its arguments from a source, and call [`validate`](crate::validate::validate) after each |
//! | also check the reports of the operators of `Dcel` | `ReportAudit` of the crate `twinedge-trials` |
//! | generate programs | [`Program::from_bytes`]; the features `arbitrary`, `quickcheck` and `proptest` for the crates of these names |
//! | choose the operators, their weights and their number | [`Generator`], for all of these; for bytes, [`Generator::decode`] |
//! | shrink a failing program | [`shrink`]; `quickcheck` and `proptest` do it by themselves |
//! | shrink a program that begins with a mesh or another non-empty structure | [`Generator::beginning_with`] for `proptest`, and for `quickcheck` with [`Generator::candidates`]; [`run_and_shrink`](conformance::Conformance::run_and_shrink) for fuzz targets |
//! | save it | its text ([`Display`](core::fmt::Display), [`FromStr`](core::str::FromStr)), or [`Program::to_rust`] |
//! | test two maps for isomorphism | `canonical` of the crate `twinedge-trials` |
//! | compare with another implementation | [`PointerModel`]: the pointers of the literature, plain and slow |
//!
//! # In step
//!
//! When two faces or vertices are merged, implementations may keep either record. So a [`Runner`] never compares handles of
//! different structures. It lists the handles of each structure in order of creation, without handles of removed records.
//! As long as both structures are correct, the same position in both lists is the same element.

#![cfg_attr(feature = "proptest", doc = include_str!("proptest.md"))]

mod arguments;
pub mod choose;
pub mod conformance;
mod dcel;
mod every;
mod generator;
mod instances;
pub mod language;
pub mod mesh;
mod operators;
#[doc(hidden)]
pub mod panics;
mod pointer_model;
mod runner;
mod shrink;
mod subject;
pub mod text;

pub use crate::dcel::{Corner, Side, Turn};
pub use arguments::{CornerPick, FacePick, HalfEdgePick, InnerPick, SecondPick, VertexPick};
pub use every::{every_mesh_op, every_op, try_every_op};
pub use generator::Generator;
#[cfg(feature = "proptest")]
pub use generator::ProgramTree;
pub use language::Language;
pub use operators::{Call, CountChange, Handle, Op, OpKind, Program};
pub use pointer_model::{
    PointerModel, PointerModelFace, PointerModelHalfEdge, PointerModelStart, PointerModelVertex, StartError,
};
pub use runner::Runner;
pub use shrink::{candidates, extend, follow, shrink};
#[doc(hidden)]
pub use subject::by_index;
pub use subject::{CallOf, CornerOf, HandleOf, Refusal, StepOutcome, Subject};
pub use text::{Expected, ParseError};
