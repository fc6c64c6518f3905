//! The trials: their counts, findings and endings.

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

/// Returns an empty structure with room for these numbers of vertices, edges, boundary components and faces.
fn limited([vertices, edges, boundaries, faces]: [usize; 4]) -> Dcel {
    Dcel::with_limits(Room { vertices, edges, boundaries, faces })
}
