//! Rules between two layers, such as counties and the states that contain them, or between parts and their parents in one layer.
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
//! | X1 within | features that are not within one feature of the other layer |
//! | X2 cover | areas that only one of the layers covers |
//! | X3 border | borders between features of the other layer, or around it, along which no border of the audited layer runs |
//! | X4 parent | parts outside their parents, areas of parents that no part covers, and parts with unknown parents |
//! | X5 line | lines of the audited layer that do not run along borders of the other layer |
//! | X6 point | points of the audited layer that do not lie inside a feature of the other layer |
//!
//! Both layers are features of one map whose edges are noded together; the features of the audited layer come first. All rules
//! read only the sets of features of faces and edges, without measurements, so they are as exact as the map. [`check`] checks all
//! rules except X4, [`check_parents`] checks X4. [`pieces`] returns the pieces into which two layers cut each other.

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

/// Returns the features of each layer that cover a face, in order. The first `count` features are the first layer.
fn split(map: &PlanarMap, face: Face<'_>, count: usize) -> [Vec<FeatureId>; 2] {
    let (here, there) = features_of(map, face).partition(|one| one.index() < count);
    [here, there]
}
