//! Passes over the structure that several rules share, so that each record is read once.
//!
//! A pass only walks. What it finds is judged by the files of the rules.

pub(super) mod cycles;
pub(super) mod half_edges;
pub(super) mod rotations;
