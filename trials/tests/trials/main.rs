//! The trials: what they count, what they find, how they end.

mod corrupt;
mod incomplete;
mod lazy;
mod lazy_certificates;
mod meshes;
mod prove;
mod sample;
mod shards;
mod soak;
