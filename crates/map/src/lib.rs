//! A `Dcel` with coordinates: building, features, edits, location, and the faces cut by a line.
//!
//! A [`PlanarMap`] is a [`Dcel`](twinedge::dcel::Dcel) whose vertices have coordinates. [`Builder`] makes one from rings, lines
//! and points in O(n log n). [`PlanarMap::from_view`] makes one from an existing half-edge structure.
//!
//! ```
//! use twinedge_geometry::Point;
//! use twinedge_map::{Builder, Located, Shape};
//!
//! let square = |x: f64| [[x, 0.0], [x + 2.0, 0.0], [x + 2.0, 2.0], [x, 2.0]];
//! let mut builder = Builder::new();
//! let west = builder.shape(&Shape::polygon(square(0.0)))?;
//! let east = builder.shape(&Shape::polygon(square(2.0)))?;
//! let mut map = builder.build()?;
//!
//! let Located::Face(face) = map.locate(Point::new(3.0, 1.0))? else { unreachable!("it is inside") };
//! assert!(map.features_of(face)?.eq([east]));
//! // A wall across the eastern square: it splits the edges on which it ends, and the face.
//! let wall = map.insert_segment([2.0, 1.0], [4.0, 1.0])?;
//! assert_eq!((wall.edges_split.len(), wall.faces_split.len()), (2, 1));
//! let east_of_border = map.features_of(wall.faces_split[0].1)?;
//! assert!(east_of_border.eq([east]));
//! assert_ne!(west, east);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`History`](twinedge::dcel::History) undoes and redoes edits, [`Audited`](twinedge::dcel::Audited) validates after each
//! edit, and [attributes](PlanarMap#attributes) follow edits.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`certificate`] | a triangulation that proves a map to be drawn in the plane |
//! | [`edit`] | drawing and erasing points, segments and rings one by one |
//! | [`locate`] | point location by an index |
//! | [`zone`] | the elements along a line, in order |
//! | [`program`] | sequences of edits as data |
//! | [`drawing`], [`near`] | rules G1 … G5 for any structure with coordinates, and after a change |

extern crate alloc;

pub mod certificate;
pub mod drawing;
pub mod edit;
pub mod locate;
pub mod near;
pub mod program;
pub mod zone;

mod attributes;
mod construct;
mod feature;
mod feature_id;
mod feature_sets;
mod feature_tries;
#[cfg(feature = "geo-types")]
mod geo_types;
mod import;
mod index;
mod not_plane;
mod notes;
mod number_table;
mod numbers;
mod planar_map;
mod recorder;
#[cfg(feature = "serde")]
mod saved;
mod summary;

pub use construct::{BuildError, Builder, Noding, UnmatchedVertex, usual_cuts};
pub use drawing::{Embedding, places, validate_embedding};
pub use feature::{Feature, Shape};
pub use feature_id::{FeatureId, Features};
pub use import::MapImportError;
pub use locate::{LocateError, Located};
pub use not_plane::NotPlane;
pub use planar_map::PlanarMap;
pub use summary::{BuildSummary, Irregularity, IrregularityKind, Position};
pub use zone::{QueryLine, ZoneElement};
