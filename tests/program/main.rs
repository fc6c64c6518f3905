//! Operator programs, canonical forms, conformance.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod canonical;
mod census;
mod choose;
mod conformance;
mod counts;
mod generators;
mod in_step;
mod named_mesh;
mod panics;
mod partial;
mod pinned;
mod program;
