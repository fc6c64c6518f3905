//! A `Dcel` with coordinates: building, features, edits, location, the faces cut by a line.
//!
//! A [`PlanarMap`] is a [`Dcel`](crate::dcel::Dcel) whose vertices have coordinates. [`Builder`] makes one from rings, lines
//! and points in O(n log n).
//!
//! | module | purpose |
//! | --- | --- |
//! | [`edit`] | drawing and erasing points, segments and rings on a map, one after the other |
//! | [`locate`] | where a point lies, by an index or by walking there |
//! | [`zone`] | what a line meets, in order |

pub mod edit;
pub mod locate;
pub mod zone;

mod construct;
mod feature;
mod feature_sets;
mod planar_map;
mod record_tree;
mod summary;

pub use construct::{BuildError, Builder, Noding};
pub use feature::{Feature, FeatureId, Shape};
pub use locate::{LocateError, Located, Locator};
pub use planar_map::PlanarMap;
pub use summary::{BuildSummary, Irregularity, IrregularityKind, Position};
pub use zone::{QueryLine, ZoneElement};
