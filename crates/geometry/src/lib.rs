//! Points, exact predicates, crossings, the sweep, and noding: geometry that knows no half-edge.
//!
//! ```
//! use twinedge_geometry::Point;
//! use twinedge_geometry::noding::{Snap, node};
//!
//! // Two segments that cross are cut there.
//! let segments = [[[0.0, 0.0], [4.0, 4.0]], [[0.0, 4.0], [4.0, 0.0]]].map(|ends| ends.map(Point::from));
//! let noded = node(&segments, &[], Snap::Size(1.0))?;
//! assert_eq!((noded.points.len(), noded.segments.len()), (5, 4));
//! # Ok::<(), twinedge_geometry::noding::NodingError>(())
//! ```
//!
//! | module | purpose |
//! | --- | --- |
//! | [`predicates`] | exact answers about points, directions and segments |
//! | [`mod@sweep`] | one pass that tells whether segments meet only at shared endpoints, and which segment lies below a point |
//! | [`crossing`] | all pairs of segments that cross, touch or overlap |
//! | [`noding`] | snap rounding: any segments made to meet at shared endpoints only |
//! | [`bounds`], [`boxes`] | boxes with sides along the axes, and a tree of them |
//! | [`curve`] | an order of the cells of a box in which neighbours are near |
//! | [`threads`] | work that the feature `rayon` divides among threads |
//!
//! # Features
//!
//! | feature | what it adds |
//! | --- | --- |
//! | `geo-types` | points are converted from and to coordinates of that crate |
//! | `rayon` | crossings and noding use the threads of the current pool, with the same results |
//! | `serde` | points are read and written as `[x, y]`, summaries of noding as structures |
#![forbid(unsafe_code)]

pub mod bounds;
pub mod boxes;
pub mod crossing;
pub mod curve;
pub mod noding;
pub mod predicates;
pub mod sweep;
pub mod threads;

mod events;
#[cfg(feature = "geo-types")]
mod geo_types;
mod point;
mod status;
#[doc(hidden)]
pub mod steps;

pub use point::Point;
pub use predicates::{MAX_COORDINATE, MIN_COORDINATE};

/// No segment, in a column.
const NIL: u32 = u32::MAX;
