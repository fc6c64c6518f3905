//! Edits of planar maps, compared with maps built in bulk, with plain models, and with their own reports.

mod cut;
mod describe;
mod errors;
mod follow;
mod laws;
mod model;
mod snapped;
mod world;
