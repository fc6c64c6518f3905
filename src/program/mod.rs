//! Programs: sequences of operators as data, for everything that tests a structure by changing it.
//!
//! A program chooses its arguments by small numbers: positions in lists of what exists, modulo the length of the list. So
//! any bytes are a program that runs on any structure, and no argument is out of range. Some arguments are handles of
//! removed records, on purpose: a correct structure refuses them.
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
//! | drive a structure of your own | the trait [`Subject`]; [`Dcel`](crate::dcel::Dcel) has it |
//! | test a structure | [`conformance::check`]: the structure and [`PointerModel`] in step, compared after every operator of random programs |
//! | try operators that are not in this language | [`choose`]: draw an operator and its arguments from a source, and call [`validate`](crate::validate::validate) after each |
//! | also check the reports of the operators of `Dcel` | `ReportAudit` of the crate `twinedge-trials` |
//! | get programs | [`Program::from_bytes`]; the features `arbitrary`, `quickcheck` and `proptest` for the crates of these names |
//! | say which operators, how often and how many | [`Generator`], for all of these; of bytes, [`Generator::decode`] |
//! | make a failing one small | [`shrink`]; `quickcheck` and `proptest` do it by themselves |
//! | make one small that begins with a mesh, or another structure that is not empty | [`Generator::beginning_with`], for `proptest`, and for `quickcheck` by [`Generator::candidates`]; [`run_and_shrink`](conformance::Conformance::run_and_shrink) for fuzz targets |
//! | keep it | its text ([`Display`](core::fmt::Display), [`FromStr`](core::str::FromStr)), or [`Program::to_rust`] |
//! | tell whether two maps are the same | [`canonical`] |
//! | compare with another implementation | [`PointerModel`], the pointers of the literature, simple and slow |
//!
//! # In step
//!
//! When two faces or vertices are merged, implementations may keep either record. So a [`Runner`] never compares handles of
//! different structures. It lists the handles of each structure in order of creation, and drops those of removed records.
//! As long as both structures are right, the same position in two such lists is the same element.

#![cfg_attr(feature = "proptest", doc = include_str!("proptest.md"))]

mod arguments;
pub mod canonical;
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
