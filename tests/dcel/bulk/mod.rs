//! Whole structures at once: from faces, from rotations, retained, compacted.

mod compact;
mod faces;
mod retain;
mod rotations;
