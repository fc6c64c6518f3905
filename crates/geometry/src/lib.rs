//! Points, exact predicates, crossings, the sweep, and noding, independent of half-edges.
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
//! | [`mod@sweep`] | decides in one pass whether segments meet only at shared endpoints, and finds the segment below each point |
//! | [`crossing`] | all pairs of segments that cross, touch or overlap |
//! | [`noding`] | snap rounding: changes any segments so that they meet only at shared endpoints |
//! | [`bounds`], [`boxes`] | axis-aligned boxes, and a tree of them |
//! | [`curve`] | an order of the cells of a box in which neighbours are near |
//! | [`threads`] | work divided among threads by the feature `rayon` |
//!
//! # Features
//!
//! | feature | effect |
//! | --- | --- |
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
mod point;
mod status;
#[doc(hidden)]
pub mod steps;

pub use point::Point;
pub use predicates::{MAX_COORDINATE, MIN_COORDINATE};

const NIL: u32 = u32::MAX;
