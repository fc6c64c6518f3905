//! Memory use of readers, counted by the allocator.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../../../tests/memory/counting.rs"]
mod counting;
mod geojson;
