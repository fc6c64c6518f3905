//! The adapters, a file for each crate.

mod rotation;
pub mod dcel;
pub mod halfedge;
pub mod soup;
pub mod spade;
pub mod tri_mesh;

use crate::peer::Entry;

/// The audited crates. `halfedge-soup` is its builder and its own validator on lists of triangles.
pub const PEERS: &[Entry] = &[
    Entry::of::<dcel::Peer>("dcel", "0.8.14"),
    Entry::of::<halfedge::Peer>("halfedge", "0.3.0"),
    Entry::of::<soup::Peer>("halfedge-soup", "0.3.0"),
    Entry::of::<spade::Peer>("spade", "2.15.1"),
    Entry::of::<tri_mesh::Peer>("tri-mesh", "0.6.1"),
];
