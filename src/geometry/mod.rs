//! Points, exact predicates, and the maps they draw.
//!
//! A [`PlanarMap`] is a [`Dcel`](crate::dcel::Dcel) whose vertices have coordinates. [`Builder`] makes one from rings, lines
//! and points in O(n log n); [`validate_drawing`] checks, for this or any other structure with coordinates, that they draw
//! what its links say.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`predicates`] | exact answers about points, directions and segments |
//! | [`mod@sweep`] | one pass that tells whether a drawing is plane, and what lies below what |
//! | [`crossing`] | all places where it is not |
//! | [`noding`] | snap rounding: any segments made to meet at shared endpoints only |
//! | [`edit`] | drawing and erasing points, segments and rings on a map, one after the other |
//! | [`locate`] | where a point lies, by an index or by walking there |
//! | [`zone`] | what a line meets, in order |

pub mod crossing;
pub mod edit;
pub mod locate;
pub mod noding;
pub mod predicates;
pub mod sweep;
pub mod zone;

mod arrange;
mod build;
mod cover;
mod cut;
mod drawing;
mod features;
mod planar_map;
mod point;
mod rings;
mod shape;
mod status;

pub use build::{BuildError, BuildSummary, Builder, Position};
pub use cut::Noding;
pub use drawing::{Drawing, places, validate_drawing};
pub use locate::{LocateError, Located, Locator};
pub use planar_map::{FeatureId, PlanarMap};
pub use point::Point;
pub use predicates::{MAX_COORDINATE, MIN_COORDINATE};
pub use rings::{Irregularity, Kind as IrregularityKind};
pub use shape::{Feature, Shape};
pub use zone::{Met, Stretch};
