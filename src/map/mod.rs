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

mod arrange;
mod build;
mod cover;
mod cut;
mod features;
mod planar_map;
mod rings;
mod shape;

pub use build::{BuildError, BuildSummary, Builder, Position};
pub use cut::Noding;
pub use locate::{LocateError, Located, Locator};
pub use planar_map::{FeatureId, PlanarMap};
pub use rings::{Irregularity, IrregularityKind};
pub use shape::{Feature, Shape};
pub use zone::{QueryLine, ZoneElement};
