//! Edits of planar maps, held against maps built in bulk, against plain models, and against what they say they did.

#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands over what it makes")]

#[allow(dead_code, reason = "each test of geometry uses its part")]
#[path = "../exact/mod.rs"]
mod exact;

mod describe;
mod errors;
mod follow;
mod laws;
mod model;
mod snapped;
mod world;
