//! Coverages and layers.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

mod coverage;
mod layers;
mod mismatch;
#[allow(dead_code, reason = "algorithms are tested by all of it")]
#[path = "../../../algorithm/tests/algorithm/planar.rs"]
mod planar;
