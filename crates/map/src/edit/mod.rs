//! Edits: drawing and erasing points, segments and rings one by one.
//!
//! Each edit keeps every rule, R1 to T4 and G1 to G5. An error leaves the map unchanged. [`Edited`] lists the records that an
//! edit made, split, merged and dropped, so that data stored alongside the map can follow. All decisions are exact: an edit
//! either applies to the given coordinates exactly, or refuses.
//!
//! ```
//! use twinedge_map::PlanarMap;
//!
//! let mut map = PlanarMap::new();
//! let square = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
//! let [(outside, inside)] = square.faces_split[..] else { unreachable!("a ring splits off one face") };
//! assert_eq!(outside, map.dcel().unbounded_face().key());
//!
//! // Both ends are on edges, which are split, and the inside with them.
//! let wall = map.insert_segment([1.0, 0.0], [3.0, 4.0])?;
//! assert_eq!((wall.edges_split.len(), wall.edges_made.len()), (2, 1));
//! assert_eq!(wall.faces_split[0].0, inside);
//!
//! let opened = map.remove_edge(wall.way[0])?;
//! assert_eq!(opened.faces_merged.len(), 1);
//! assert!(map.validate().is_valid());
//! # Ok::<(), twinedge_map::edit::EditError>(())
//! ```
//!
//! | edit | effect | refuses |
//! | --- | --- | --- |
//! | [`insert_point`](crate::PlanarMap::insert_point) | a vertex, on an edge or in a face | |
//! | [`insert_segment`](crate::PlanarMap::insert_segment) | edges along a segment, through vertices exactly on it | to cross an edge |
//! | [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) | edges along a segment, with crossings, rounded to a grid | a map off the grid |
//! | [`insert_ring`](crate::PlanarMap::insert_ring) | edges along a closed chain | to cross an edge, or itself |
//! | [`remove_edge`](crate::PlanarMap::remove_edge) | erases an edge, and keeps its ends | |
//! | [`remove_vertex`](crate::PlanarMap::remove_vertex) | erases a vertex with its edges | |
//! | [`split_face`](crate::PlanarMap::split_face) | cuts a face by a line, whatever the slant | to pass over anything near the line |
//! | [`merge_faces`](crate::PlanarMap::merge_faces) | erases the edges between two faces | |
//! | [`join_edges`](crate::PlanarMap::join_edges) | drops a vertex between two edges | to sweep over anything |
//! | [`move_vertex`](crate::PlanarMap::move_vertex) | moves a vertex with its edges | to sweep over anything |
//!
//! # Features
//!
//! Features stay with their area and their edges. When a face is split, the features of the face cover both parts; when an edge
//! is split, both parts keep its features. New edges have no features, and a newly enclosed face keeps the features of its area;
//! change them with [`set_features_of`](crate::PlanarMap::set_features_of) and
//! [`set_features_along`](crate::PlanarMap::set_features_along). When two faces are merged, the result is covered by the features
//! that covered *both*: without the border, the extent of a feature that covered only one side is unknown.
//! [`Edited::features_dropped`] lists the dropped features with their faces.
//!
//! # Costs
//!
//! An edit examines only its surroundings: small faces as a whole, and elsewhere the records that an index finds nearby. The map
//! builds this index in O(n log n) when an edit first needs it: for a point without a hint ([`At`]), on a face with more than
//! some dozens of edges or islands, or at a vertex of similarly high degree. From then on the map maintains it in O(log n) for
//! each edge that is made, split or dropped. So points and bridges take O(log n) on most maps, even in an ocean of islands, at a
//! hub, or in a face with a long boundary. An edge that splits a face also takes the length of the shorter part.
//! [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) examines the *whole* boundary of each face on its way.

mod at;
mod chain;
mod corners;
mod cut;
mod draw;
mod error;
mod features;
mod insert;
mod move_vertex;
mod operators;
mod outcome;
mod place;
mod plan;
mod region;
mod relabel;
mod remove;
mod sides;
mod snapped;
pub(crate) mod trace;

pub use at::At;
pub use error::EditError;
pub use outcome::Edited;
