//! Edits: drawing on a map and erasing, one point, segment or ring after the other.
//!
//! Each edit keeps every rule, from R1 to T4 and from G1 to G5; it is atomic, so that an error leaves the map as it was; and
//! it says what it made, split, merged and dropped ([`Edited`]), so that data kept beside the map can follow. All
//! decisions are exact: an edit does what it says for the very coordinates that it is given, or refuses.
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
//! | edit | what it does | refuses |
//! | --- | --- | --- |
//! | [`insert_point`](crate::PlanarMap::insert_point) | a vertex, on an edge or in a face | |
//! | [`insert_segment`](crate::PlanarMap::insert_segment) | edges along a segment, through what lies exactly on it | to cross an edge |
//! | [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) | the same with crossings, rounded to a grid | a map off the grid |
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
//! Features stay with the area and with the edges that they had. Where a face is split, both parts are covered by what
//! covered it; where an edge is, both parts have its features. New edges have none, and a face that is closed off anew is
//! covered as before: say otherwise with [`set_features_of`](crate::PlanarMap::set_features_of) and
//! [`set_features_along`](crate::PlanarMap::set_features_along). Where two faces become one, it is covered by the features that
//! covered *both*: without the border, the extent of a feature that covered one side only is unknown.
//! [`Edited::features_dropped`] lists the features that were dropped, and the faces.
//!
//! # Costs
//!
//! An edit looks only at what is near its way: at small faces as a whole, and elsewhere at what an index finds there. The map
//! builds this index, O(n log n), when an edit needs it first: for a point without hint ([`At`]), or on a face with more than some
//! dozens of edges or islands, or at a vertex of such a degree. From then on the map keeps it, which takes O(log n) for each edge
//! that is made, split or dropped. So points and bridges take O(log n) on most maps, in an ocean of islands, at a hub, and in
//! a face with a long boundary, too. An edge that splits a face takes the length of the shorter part besides.
//! [`insert_segment_snapped`](crate::PlanarMap::insert_segment_snapped) looks at the *whole* boundary of each face on
//! its way.

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
