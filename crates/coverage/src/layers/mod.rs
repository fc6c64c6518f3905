//! Rules between two layers: counties and the states that they are in, or parts and their parents in one layer.
//!
//! ```text
//!   ┌───────┬───────┐      ┌───────┬───────┐      ┌───────┬───────┐      ┌───────┬───────┐
//!   │   P   │   Q   │      │ a │ b │ c  ███│      │ a  ┌┼─┐     │      │ a │   │   c   │
//!   │       │       │      │   │   │    ███│      │    └┼─┘  c  │      │   │   │       │
//!   └───────┴───────┘      └───┴───┴───────┘      └───────┴───────┘      └───┴───┴───────┘
//!     the other layer      X2: the place ███      X1: a lies in P        X4: b was dropped, and
//!                          is covered by Q only   and in Q               its parts do not make up P
//! ```
//!
//! | rule | finds |
//! | --- | --- |
//! | X1 within | features that do not lie within one feature of the other layer |
//! | X2 cover | places that one of the layers covers and the other does not |
//! | X3 border | borders between features of the other layer, or around it, along which no border of the audited layer runs |
//! | X4 parent | parts outside their parents, places of parents that no part covers, and parts whose parents are not known |
//! | X5 line | lines of the audited layer that do not run along borders of the other layer |
//! | X6 point | points of the audited layer that do not lie inside a feature of the other layer |
//!
//! Both layers are features of one map, whose edges are noded together: those of the audited layer first. All is read from the sets of
//! features of its faces and edges, and nothing is measured, so that the rules are as exact as the map. [`check`] asks all rules but X4,
//! [`check_parents`] asks that one. [`pieces`] are the places that two layers cut each other into.

mod check;
mod finding;
mod parents;
mod pieces;

pub use check::check;
pub use finding::{Deviation, LayerFinding, LayerRule};
pub use parents::{Parent, check_parents};
pub use pieces::{Piece, pieces};

use twinedge::dcel::Face;
use twinedge_algorithm::claims::features_of;
use twinedge_map::{FeatureId, PlanarMap};

/// The features of each layer that cover a face, in order. The first `count` features of the map are those of the first layer.
fn split(map: &PlanarMap, face: Face<'_>, count: usize) -> [Vec<FeatureId>; 2] {
    let (here, there) = features_of(map, face).partition(|one| one.index() < count);
    [here, there]
}
