//! Queries on a map.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[allow(dead_code, reason = "maps are tested by all of it")]
#[path = "../../../map/tests/map/support/oracle.rs"]
mod oracle;

mod contour;
mod convex;
mod dual;
mod homework;
mod lattice;
mod neighbours;
mod overlay;
mod planar;
mod voronoi;
