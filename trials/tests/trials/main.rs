//! The trials: what they count, what they find, how they end.

mod corrupt;
mod incomplete;
mod lazy;
mod meshes;
mod prove;
mod sample;
mod shards;
mod soak;
