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
use twinedge::validate::Expectation;
use twinedge_trials::planted::Planted;
use twinedge_trials::{RawPointers, Structure};

/// Returns an empty structure with room for these numbers of vertices, edges, boundary components and faces.
fn limited([vertices, edges, boundaries, faces]: [usize; 4]) -> Dcel {
    Dcel::with_limits(Room { vertices, edges, boundaries, faces })
}

fn slots() -> Structure<Dcel> {
    Structure::new("slots", Dcel::new, Expectation::plane())
}

fn pointers() -> Structure<RawPointers> {
    Structure::new("pointers", RawPointers::new, Expectation::plane())
}

fn panics() -> Structure<Planted<true>> {
    Structure::new("panics", Planted::<true>::default, Expectation::plane())
}
