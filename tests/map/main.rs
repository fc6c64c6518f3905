//! Maps with coordinates: building, editing, location.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod edit;
mod edited_maps;
mod location;
mod noding;
mod planar_map;
