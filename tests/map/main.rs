//! Maps with coordinates: building, editing, location.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod attributes;
mod audited;
mod certificate;
mod diff;
mod edit;
mod edit_numbers;
mod edit_programs;
mod edited_maps;
mod equality;
mod history;
mod import;
mod location;
mod noding;
mod not_plane;
mod planar_map;
mod rewound;
mod saved;
#[cfg(debug_assertions)]
mod sorting;
mod threads;
