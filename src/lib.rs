//! A doubly connected edge list (DCEL, half-edge structure) for planar subdivisions, and a validator for anybody's.
//!
//! ```
//! use twinedge::map::{Builder, Shape};
//! use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
//!
//! // Build: a square with a square hole in it.
//! let square = Shape::polygon([[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]]);
//! let mut builder = Builder::new();
//! builder.shape(&square.hole([[3.0, 3.0], [3.0, 6.0], [6.0, 6.0], [6.0, 3.0]]))?;
//! let map = builder.build()?;
//!
//! // Walk: around the face between the squares, and across its edges.
//! let dcel = map.dcel();
//! let between = dcel.faces().find(|face| !face.is_unbounded() && face.inner_count() == 1).unwrap();
//! assert_eq!(between.outer().unwrap().half_edges().count(), 4);
//! for h in between.half_edges() {
//!     assert_eq!((h.face(), h.next().origin()), (between, h.target()));
//!     assert_ne!(h.twin().face(), between);
//! }
//!
//! // Break: set one link of a copy wrong, and ask which rule that breaks.
//! assert!(map.validate().is_valid());
//! let mut table = Table::copy_of(dcel).unwrap();
//! let h = between.outer_half_edge().unwrap().index();
//! table.half_edges[h].as_mut().unwrap().next = Some(h);
//! let report = validate(&table, &Expectation::plane(), Collect::All);
//! assert_eq!(report.first().unwrap().rule(), Rule::L2);
//! # Ok::<(), twinedge::map::BuildError>(())
//! ```
//!
//! The crate has two halves that do not need each other.
//!
//! The **validator** ([`mod@validate`]) takes any half-edge structure through the trait [`validate::View`] and says whether it is
//! the topology of a planar subdivision, or which record breaks which rule. It is *complete*: a structure that stores every part is
//! accepted with [`Expectation::plane`](validate::Expectation::plane) if and only if it can be drawn in the plane. It is *total*: on every
//! input it returns, without panic, in time and memory linear in the number of slots. It is *cross-checked*: a second validator, written
//! directly from the rules, agrees with it on every table up to a bound and on every single corruption of every small map
//! (`proofs/README.md` in the repository).
//!
//! The **structure** ([`dcel::Dcel`], and [`map::PlanarMap`] with coordinates) has generational keys, so a key of a removed
//! vertex is an error and never another vertex; links in columns of 32-bit numbers, so a traversal costs what it costs on plain
//! arrays; and atomic operators, which keep every rule and say what they made, kept and dropped.
//!
//! # What to choose
//!
//! | you want to | take | feature |
//! | --- | --- | --- |
//! | validate a half-edge structure of your own | [`validate::validate`], after implementing [`validate::View`] | none |
//! | validate its coordinates, too | [`validate::validate_embedding`], after implementing [`validate::Embedding`] | `geometry` |
//! | validate after each change, in the time that the change took | [`validate::near`]; [`dcel::Audited`] | none; `dcel` |
//! | write down a structure as tables, and corrupt them in tests | [`validate::Table`] | none |
//! | convert a structure of your own into one of this crate | [`dcel::Dcel::from_view`] | `dcel` |
//! | build and edit a subdivision without coordinates | [`dcel::Dcel`] | `dcel` |
//! | build one from rings, lines and points | [`map::Builder`] | `map` (default) |
//! | insert and remove points and segments, step by step | [`map::edit`] | `map` (default) |
//! | undo and redo changes, as an editor does | [`dcel::History`], of a structure or a map | `dcel` |
//! | keep owners, taxes, names: values that follow changes | [`dcel::Policy`], [attributes](map::PlanarMap#attributes) | `dcel` |
//! | save and load, with the keys; certified, if you like | [`map::PlanarMap`] by serde | `serde` |
//! | compare two edited copies of a map, and merge them | [`mod@map::diff`] | `map` (default) |
//! | find where points lie and what lines meet | [`map::Locator`] | `map` (default) |
//! | compute neighbours, outlines, areas, centroids, overlays; check Pick's theorem | [`algorithm`] | `map` (default) |
//! | find overlaps, gaps, slivers, duplicates, polygons that are not valid by the OGC | [`algorithm::coverage`] | `map` (default) |
//! | audit a map that is too large for one machine, in tiles | [`tile`] | `map` (default) |
//! | cut faces into convex pieces, make Voronoi diagrams and Delaunay triangulations | `algorithm::convex`, `algorithm::voronoi` | `spade` |
//! | walk from face to face, as on a graph | `algorithm::dual` | `petgraph` |
//! | read and write the tables of a textbook | `textbook` of the package `twinedge-formats` | |
//! | draw a map, with half-edges if you like | `svg` of the package `twinedge-formats` | |
//! | read and write maps | [`io`] | `geojson`, `wkt`, `geo-types` |
//! | test a structure by random, exhaustive or fuzzed sequences of operators | `program` | `program`, `quickcheck`, `arbitrary`, `proptest` |
//! | test what is computed from a map, by random or fuzzed edits | `map::program` | the same, and `map` |
//!
//! # Features
//!
//! | feature | what it adds | dependencies |
//! | --- | --- | --- |
//! | (none) | [`mod@validate`]: rules R1 … T4, and M1 … M8 if asked for; [`validate::near`]: validation of what has changed; `no_std` with `alloc` | none |
//! | `dcel` | [`dcel`] | hashbrown, slotmap, thiserror |
//! | `std` (default) | with `program`, panics of a structure under test are caught | none |
//! | `geometry` | rules G1 … G5 in [`mod@validate`] | `std`; twinedge-geometry, rstar, rustc-hash, thiserror |
//! | `map` (default) | [`map`], [`algorithm`], [`tile`] | those of `dcel` and `geometry` |
//! | `geojson` | `io::geojson` | those of `map`; geojson, serde, `serde_json` |
//! | `wkt` | `io::wkt` | those of `map`; wkt |
//! | `geo-types` | `io::geo_types` | those of `map`; geo-types |
//! | `program` | `program`; with `map`, `map::program` | those of `dcel` |
//! | `spade` | `algorithm::convex`, `algorithm::voronoi` | those of `map`; spade |
//! | `petgraph` | `algorithm::dual`: a map as a graph for the crate of that name | those of `map`; petgraph |
//! | `rayon` | building, noding, coverages and batches of locations use the threads of the current pool, with the same results; needs `std` | rayon |
//! | `arbitrary`, `quickcheck`, `proptest` | random programs for these three crates, and for `proptest` structures and maps | those of `program`; the crate of the name |
//! | `serde` | `Serialize` and `Deserialize`; structures are validated on the way in | those of the other features; serde |
//!
//! # Words
//!
//! | word | meaning | also called |
//! | --- | --- | --- |
//! | half-edge | one side of an edge, directed; the face that it bounds is to its left | dart, arc |
//! | twin | the other half-edge of the same edge | opposite, sym, rev |
//! | origin, target | the vertices where a half-edge starts and ends; `target(h) = origin(twin(h))` | source, head |
//! | next, prev | the half-edges after and before it on the same cycle | |
//! | cycle | an orbit of half-edges under `next` | loop, face cycle |
//! | boundary component | one connected part of the boundary of a face: a cycle, or an isolated vertex | CCB in CGAL, ring in PostGIS |
//! | outer, inner | a bounded face has one outer boundary component (counter-clockwise); the others, holes (clockwise) and isolated vertices, are inner ones | |
//! | unbounded face | the one face without an outer boundary component | infinite face |
//! | isolated vertex | a vertex without half-edges | |
//! | bridge | an edge with the same face on both sides | |
//! | rotation | the half-edges that leave a vertex, in the order of an orbit under `next∘twin` (clockwise) | umbrella, vertex orbit |
//! | corner | the place between two consecutive half-edges of a rotation, where a new edge can be attached | |
//! | component | a connected part of the vertices and edges | |
//! | planar | drawable in the plane without crossings: a property of the topology (T3) | |
//! | plane | drawn so: a property of coordinates (G1 … G5) | |
//! | embedding | a structure with coordinates of its vertices | drawing |
//! | planar subdivision | the vertices, edges and faces of a plane embedding | planar map, arrangement |
//! | genus | the number of handles of the surface on which a component can be drawn; 0 for the plane | |
//! | noding | cutting segments where they meet, so that they meet at shared endpoints only | |
//! | snapping | rounding coordinates to a grid while noding | snap rounding |
//! | zone | the faces, edges and vertices that a line meets, in order | |
//! | feature | a named input (polygons, lines, points) and the faces and edges that it covers | |
//! | key, index | a key names one record for ever; an index is the number of its slot, which is used again | handle, id |
//! | view | a structure as the validator sees it: slots and links | |
//! | write set | the records that a change has written | dirty set |
//! | baseline | the links of a structure when it was last found right, to compare a later state with | |
//!
//! # The layers
//!
//! An arrow leads from a layer to one that may import it:
//!
//! ```text
//!   validate ──► store ──► dcel ──► program
//!                            │
//!                            ▼
//!                           map ──► algorithm ──► io
//!                                       └───────► tile
//! ```
//!
//! | layer | purpose |
//! | --- | --- |
//! | [`mod@validate`] | the rules, the trait [`validate::View`], the report |
//! | `store` | where records live: keys, slots, columns, the log of what is overwritten |
//! | [`dcel`] | the structure: accessors, circulators, operators |
//! | `program` | sequences of operators as data, canonical forms, conformance tests |
//! | [`map`] | a [`dcel::Dcel`] with coordinates: building, editing, location |
//! | [`algorithm`] | outlines, neighbours, areas, overlays |
//! | [`tile`] | maps in tiles, whose summaries add up |
//! | [`io`] | GeoJSON, WKT, geo-types |
//!
//! # Limits
//!
//! - Edges are straight. Curves are chains of edges.
//! - [`map::Builder`] expects segments that meet at shared endpoints only. Other input is cut and snapped on request
//!   ([`map::Noding`]); otherwise the map is built as far as possible, and [`validate::validate_embedding`] says where edges
//!   cross.
//! - A structure has exactly one unbounded face. Maps on the sphere and on other surfaces can be validated
//!   ([`validate::Expectation::surface`]), but a [`dcel::Dcel`] cannot hold them.
//! - [`map::edit`] finds its place from a hint (a vertex or half-edge nearby), or without one by a walk from outside the map.
//!   [`map::Locator`] is an index of a map that does not change.
//! - Polygons nested thousands deep, and vertices with thousands of edges, take quadratic time in some functions; the
//!   documentation of each says so.
//! - Coordinates are zero or of magnitude from 2⁻⁴⁰⁰ to 2⁵⁰⁰: there the predicates are exact.
//! - At most about 2³¹ vertices, half-edges, boundary components and faces each.
//! - The two half-edges of an edge have the same generation. A slot can be used 2³¹ times before a key comes again.
//!
//! # Rust versions
//!
//! Rust 1.85 without the feature `geometry` and what builds on it, 1.90 with it: the crate `rstar` needs that. The dependencies
//! state these versions; in this crate clippy's `incompatible_msrv` finds no function of the standard library that is newer, and
//! no condition joins a `let` by `&&`. It is tested with Rust 1.95; no older compiler was tried.
#![cfg_attr(not(feature = "std"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]

extern crate alloc;

#[forbid(unsafe_code)]
mod slots;

#[forbid(unsafe_code)]
pub mod validate;

#[cfg(feature = "dcel")]
mod store;

#[cfg(feature = "dcel")]
#[forbid(unsafe_code)]
pub mod dcel;

#[cfg(feature = "program")]
#[forbid(unsafe_code)]
pub mod program;

// `rstar` needs Rust 1.90, and so does all that builds on it.
#[cfg(feature = "map")]
#[clippy::msrv = "1.90"]
#[forbid(unsafe_code)]
pub mod map;

#[cfg(feature = "map")]
#[clippy::msrv = "1.90"]
#[forbid(unsafe_code)]
pub mod algorithm;

#[cfg(feature = "map")]
#[clippy::msrv = "1.90"]
#[forbid(unsafe_code)]
pub mod tile;

#[cfg(feature = "map")]
#[clippy::msrv = "1.90"]
#[forbid(unsafe_code)]
pub mod io;

/// The code in the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
