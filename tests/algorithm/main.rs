//! Questions asked of a map.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod contour;
mod convex;
mod coverage;
mod dual;
mod homework;
mod lattice;
mod layers;
mod mismatch;
mod neighbours;
mod overlay;
mod planar;
mod voronoi;
