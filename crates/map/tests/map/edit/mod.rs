//! Edits of planar maps, held against maps built in bulk, against plain models, and against what they say they did.

mod cut;
mod describe;
mod errors;
mod follow;
mod laws;
mod model;
mod snapped;
mod world;
