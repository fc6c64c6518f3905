//! The adapters, one file per crate.

pub mod dcel;
pub mod halfedge;
pub mod plexus;
mod rotation;
mod shapes;
pub mod soup;
pub mod spade;
pub mod tri_mesh;

use crate::entry::Entry;

/// The audited crates. `halfedge-soup` is the builder and the validator of `halfedge`, on lists of triangles.
pub const PEERS: &[Entry] = &[
    Entry::of::<dcel::Peer>("dcel", "0.8.14"),
    Entry::of::<halfedge::Peer>("halfedge", "0.3.0"),
    Entry::of::<soup::Peer>("halfedge-soup", "0.3.0"),
    Entry::of::<plexus::Peer>("plexus", "0.0.11"),
    Entry::of::<spade::Peer>("spade", "2.15.1"),
    Entry::of::<tri_mesh::Peer>("tri-mesh", "0.6.1"),
];
