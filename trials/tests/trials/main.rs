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

use twinedge::dcel::{Dcel, Room};

/// An empty structure with room for so many vertices, edges, boundary components and faces.
fn limited([vertices, edges, boundaries, faces]: [usize; 4]) -> Dcel {
    Dcel::with_limits(Room { vertices, edges, boundaries, faces })
}
