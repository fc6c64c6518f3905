//! The doubly connected edge list: accessors, circulators, operators, undo and redo.
//!
//! ```
//! use twinedge::dcel::{Dcel, Side, Split};
//!
//! let mut map = Dcel::new();
//! let outside = map.unbounded_face().key();
//! // A triangle: three vertices, joined one to the next; the third edge splits the face.
//! let a = map.add_isolated_vertex(outside)?.vertex;
//! let b = map.add_isolated_vertex(outside)?.vertex;
//! let c = map.add_isolated_vertex(outside)?.vertex;
//! let ab = map.connect(a, b, Split::default())?.half_edge;
//! let ba = map.half_edge(ab)?.twin().key();
//! let bc = map.connect(ba, c, Split::default())?.half_edge;
//! let cb = map.half_edge(bc)?.twin().key();
//! let ca = map.connect(cb, ab, Split { new_face: Side::Left, inner: &[] })?;
//!
//! let inside = map.half_edge(ab)?.face();
//! assert_eq!(Some(inside.key()), ca.new_face());
//! assert_eq!(inside.outer().unwrap().half_edges().count(), 3);
//! assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (3, 3, 2));
//! assert!(map.validate().is_valid());
//! # Ok::<(), twinedge::dcel::OperatorError>(())
//! ```
//!
//! A lecture for browsers explains the records step by step, and demonstrates these operators on a picture: see `bindings/web/README.md` in
//! the repository.
//!
//! # Reading
//!
//! A key is checked once, where it enters ([`Dcel::half_edge`] and its siblings). The result is a reference ([`HalfEdge`]) that
//! borrows the structure, so nothing can be removed meanwhile. Every further step is one array access.
//!
//! # Changing
//!
//! The operators are Euler operators. Each keeps every rule from R1 to T4. Each is atomic: on error nothing changes. Each reports the
//! records that it made, kept and dropped, so that data stored by key can follow.
//!
//! | operator | inverse | in solid modelling |
//! | --- | --- | --- |
//! | [`add_isolated_vertex`](Dcel::add_isolated_vertex) | [`remove_isolated_vertex`](Dcel::remove_isolated_vertex) | MVFS, KVFS, in a face that exists already |
//! | [`connect`](Dcel::connect) | [`remove_edge`](Dcel::remove_edge) | MEF, KEF if it splits the face; MEKR, KEMR if it bridges two boundary components (R: ring) |
//! | [`split_edge`](Dcel::split_edge) | [`join_edges`](Dcel::join_edges) | MEV, KEV, with one edge to one side |
//! | [`split_vertex`](Dcel::split_vertex) | [`contract_edge`](Dcel::contract_edge) | MEV, KEV |
//! | [`flip_edge`](Dcel::flip_edge) | [`flip_edge`](Dcel::flip_edge), turned the other way | KEF, then MEF |
//! | [`move_inner`](Dcel::move_inner) | [`move_inner`](Dcel::move_inner), back | RINGMV |
//!
//! The names in the last column, also found by the search of this documentation, are from Mäntylä, *An Introduction to Solid
//! Modeling*, 1988: make or kill (M, K) a vertex, edge, face, solid or ring. His operators of genus and of several shells (KFMRH,
//! MFKRH) have no counterpart in the plane.
//!
//! Two methods change a whole structure in linear time: [`retain`](Dcel::retain) removes the elements that fail a condition, with the
//! same result as operators one by one, and [`compact`](Dcel::compact) closes the gaps left by removed records.
//!
//! [`History`] undoes and redoes changes of one or more operators, including keys.
//!
//! # Data of your own
//!
//! The records contain only topology. Store coordinates, names and weights by key in a [`SecondaryMap`], which may accept a key of
//! another structure: see [Keys](Dcel#keys). [Attributes](Dcel#attributes) follow operators by themselves.
//!
//! ```
//! use twinedge::dcel::{Dcel, SecondaryMap};
//!
//! let mut map = Dcel::new();
//! let outside = map.unbounded_face().key();
//! let mut places = SecondaryMap::new();
//! places.insert(map.add_isolated_vertex(outside)?.vertex, [12.5, 41.9]);
//! for vertex in map.vertices() {
//!     assert_eq!(places[vertex.key()], [12.5, 41.9]);
//! }
//! # Ok::<(), twinedge::dcel::OperatorError>(())
//! ```
//!
//! # Existing structures
//!
//! | input | function | refuses |
//! | --- | --- | --- |
//! | any half-edge structure that the validator can read | [`Dcel::from_view`] | structures that break a rule, with the report |
//! | lists of the vertices around each bounded face | [`Dcel::from_faces`] | faces that do not form a plane map, with face or vertex |
//! | the darts around each vertex, counter-clockwise | [`Dcel::from_rotations`] | non-planar rotations, with vertex or dart |
//!
//! With the feature `serde` a `Dcel` can be saved and loaded. Loading validates it and keeps its keys.

mod access;
mod around;
mod assemble;
mod attributes;
mod audited;
/// Changes to a whole structure at once, in linear time.
mod bulk {
    mod compact;
    mod nest;
    mod retain;

    pub use compact::Renamed;
    pub use retain::{MergedFace, Retained};
}
mod elements;
mod history;
/// Imports existing structures.
mod import {
    mod error;
    mod faces;
    mod from_view;
    pub(super) mod gather;
    mod rotations;
    #[cfg(feature = "serde")]
    mod saved;

    pub use error::{ImportError, Outside};
    pub use faces::FacesError;
    pub use from_view::Keys;
    pub use rotations::{Placement, RotationsError};
}
/// The operators. Each completes all its checks before it changes anything.
mod operators {
    mod connect;
    mod corner;
    mod flip;
    mod following;
    mod inner;
    mod remove;
    mod split_edge;
    mod split_vertex;
    mod walk;

    pub use connect::{Connected, Connection, Side, Split};
    pub use corner::Corner;
    pub use flip::Turn;
    pub use inner::{AddedVertex, RemovedVertex};
    pub use remove::RemovedEdge;
    pub use split_edge::{JoinedEdges, SplitEdge};
    pub use split_vertex::{ContractedEdge, SplitVertex};
}
mod recorder;
mod structure;
mod view;

pub mod extend {
    //! The interface for a structure around a [`Dcel`](super::Dcel), such as a map with coordinates: building it from
    //! columns, undoing its own changes together with changes of links, and attributes of its own records.
    //!
    //! | to | implement or call |
    //! | --- | --- |
    //! | undo and redo with a [`History`](super::History) | [`Recorder`] |
    //! | validate after each change with [`Audited`](super::Audited) | [`Auditable`] |
    //! | roll back an edit of several operators | [`Dcel::begin_log`](super::Dcel::begin_log), [`Dcel::log_place`](super::Dcel::log_place), [`Dcel::roll_back`](super::Dcel::roll_back), [`Rewrite::apply`] |
    //! | build from columns | [`Assembly`] |
    //! | attach attributes to other records | [`Attributed`](super::Attributed) for a type of its own, and the methods of [`Attributes`] |

    pub use super::assemble::{Assembly, AssemblyError};
    pub use super::audited::Auditable;
    pub use super::recorder::{Access, LogPlace, Recorder, Rewrite};
    pub use crate::store::attributes::{Attributes, Kind, Saved, Step};
    pub use crate::store::{BoundaryStart, VertexLink, Way};
}

pub use access::{ElementKey, OperatorError, StaleKey};
pub use audited::Audited;
pub use bulk::{MergedFace, Renamed, Retained};
pub use elements::{Boundary, Cycle, Face, HalfEdge, Rotation, Vertex};
pub use history::{History, Mark};
pub use import::{FacesError, ImportError, Keys, Outside, Placement, RotationsError};
pub use operators::{
    AddedVertex, Connected, Connection, ContractedEdge, Corner, JoinedEdges, RemovedEdge, RemovedVertex, Side, Split,
    SplitEdge, SplitVertex, Turn,
};
pub use structure::Dcel;

pub use crate::store::attributes::{
    Attribute, Attributed, Corners, Edges, Faces, HalfEdges, Policy, Quantity, Value, Vertices,
};
pub use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, RecordKind, Room, VertexKey};
pub use slotmap::{Key, KeyData, SecondaryMap};
