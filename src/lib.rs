//! A doubly connected edge list (DCEL, half-edge structure) for planar subdivisions, and a validator for any half-edge structure.
//!
//! ```
//! use twinedge::dcel::Dcel;
//! use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
//!
//! // Build: a triangle around a face.
//! let (dcel, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
//! let inside = dcel.face(keys.face(0).unwrap())?;
//!
//! // Walk: around the face, and across its edges.
//! assert_eq!(inside.half_edges().count(), 3);
//! for h in inside.half_edges() {
//!     assert_eq!((h.face(), h.next().origin()), (inside, h.target()));
//!     assert!(h.twin().face().is_unbounded());
//! }
//!
//! // Break: set one link of a copy wrong, and ask which rule that breaks.
//! assert!(dcel.validate().is_valid());
//! let mut table = Table::copy_of(&dcel).unwrap();
//! let h = inside.outer_half_edge().unwrap().index();
//! table.half_edges[h].as_mut().unwrap().next = Some(h);
//! let report = validate(&table, &Expectation::plane(), Collect::All);
//! assert_eq!(report.first().unwrap().rule(), Rule::L2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The crate has two parts, and the validator does not depend on the structure.
//!
//! The **validator** ([`mod@validate`]) reads any half-edge structure through the trait [`validate::View`], and decides whether it is
//! the topology of a planar subdivision, or which record breaks which rule. It is *complete*: a structure that stores every part is
//! accepted with [`Expectation::plane`](validate::Expectation::plane) if and only if it can be drawn in the plane. It is *total*: on
//! every input it returns, without panic, in time and memory linear in the number of slots. It is *cross-checked*: a second validator,
//! written directly from the rules, agrees with it on every table up to a bound and on every single corruption of every small map
//! (`proofs/README.md` in the repository).
//!
//! The **structure** ([`dcel::Dcel`]) has generational keys, so the key of a removed vertex is an error and never another vertex; links
//! in columns of 32-bit numbers, so traversal is as fast as on plain arrays; and atomic operators, which keep every rule and report the
//! records that they made, kept and dropped. **Programs** ([`program`]) are sequences of operators that drive this structure or any
//! other.
//!
//! Other crates: `twinedge-map` has maps with coordinates, `twinedge-algorithm` queries on maps, `twinedge-coverage` coverages of
//! parcels, and `twinedge-geometry` points and exact predicates.
//!
//! # What to choose
//!
//! | you want to | take | feature |
//! | --- | --- | --- |
//! | validate your own half-edge structure | [`validate::validate`], after implementing [`validate::View`] | none |
//! | validate its coordinates | `validate_embedding` of `twinedge-map` | |
//! | validate after each change, in the time of the change | [`validate::near`]; [`dcel::Audited`] | none; `dcel` |
//! | write a structure as tables, and corrupt them in tests | [`validate::Table`] | none |
//! | convert your own structure into one of this crate | [`dcel::Dcel::from_view`] | `dcel` |
//! | build and edit a subdivision without coordinates | [`dcel::Dcel`] | `dcel` |
//! | undo and redo changes, as an editor does | [`dcel::History`] | `dcel` |
//! | attach owners, taxes, names: values that follow changes | [`dcel::Policy`], [attributes](dcel::Dcel#attributes) | `dcel` |
//! | wrap a `Dcel` in your own structure, such as a map with coordinates | [`dcel::extend`] | `dcel` |
//! | test a structure by random, exhaustive or fuzzed sequences of operators | [`program`] | `dcel`; `quickcheck`, `arbitrary`, `proptest` |
//!
//! # Features
//!
//! | feature | adds | dependencies |
//! | --- | --- | --- |
//! | (none) | [`mod@validate`]: rules R1 … T4, and M1 … M8 on request; [`validate::near`]: validation of changes; `no_std` with `alloc` | none |
//! | `dcel` (default) | [`dcel`], [`program`] | hashbrown, slotmap, thiserror |
//! | `std` (default) | catches panics of a structure under test | none |
//! | `arbitrary`, `quickcheck`, `proptest` | random programs for these three crates, and structures for `proptest` | as for `dcel`, plus the crate of this name |
//! | `serde` | `Serialize` and `Deserialize`; structures are validated when loaded | serde |
//!
//! # Words
//!
//! | word | meaning | also called |
//! | --- | --- | --- |
//! | half-edge | one side of an edge, directed; the face that it bounds is to its left | dart, arc |
//! | twin | the other half-edge of the same edge | opposite, sym, rev |
//! | origin, target | the vertices where a half-edge starts and ends; `target(h) = origin(twin(h))` | source, head |
//! | next, prev | the next and the previous half-edge on the same cycle | |
//! | cycle | an orbit of half-edges under `next` | loop, face cycle |
//! | boundary component | one connected part of the boundary of a face: a cycle, or an isolated vertex | CCB in CGAL, ring in PostGIS |
//! | outer, inner | a bounded face has one outer boundary component (counter-clockwise); all others, holes (clockwise) and isolated vertices, are inner | |
//! | unbounded face | the one face without an outer boundary component | infinite face |
//! | isolated vertex | a vertex without half-edges | |
//! | bridge | an edge with the same face on both sides | |
//! | rotation | the half-edges that leave a vertex, in the order of an orbit under `next∘twin` (clockwise) | umbrella, vertex orbit |
//! | corner | the place between two consecutive half-edges of a rotation, where a new edge can be attached | |
//! | component | a connected part of the vertices and edges | |
//! | planar | drawable in the plane without crossings: a property of the topology (T3) | |
//! | plane | drawn without crossings: a property of coordinates (G1 … G5) | |
//! | embedding | a structure with coordinates of its vertices | drawing |
//! | planar subdivision | the vertices, edges and faces of a plane embedding | planar map, arrangement |
//! | genus | the number of handles of the surface on which a component can be drawn; 0 for the plane | |
//! | noding | cutting segments where they meet, so that they meet at shared endpoints only | |
//! | snapping | rounding coordinates to a grid while noding | snap rounding |
//! | zone | the faces, edges and vertices that a line meets, in order | |
//! | feature | a named input (polygons, lines, points) and the faces and edges that it covers | |
//! | key, index | a key permanently names one record; an index is the number of its slot, which is reused | handle, id |
//! | view | a structure as the validator sees it: slots and links | |
//! | write set | the records written by a change | dirty set |
//! | baseline | the links of a structure when it was last found valid, for comparison with later states | |
//!
//! # The layers
//!
//! Arrows lead from a layer to layers that may import it:
//!
//! ```text
//!   validate ──► store ──► dcel ──► program
//! ```
//!
//! | layer | purpose |
//! | --- | --- |
//! | [`mod@validate`] | the rules, the trait [`validate::View`], the report |
//! | `store` | the records: keys, slots, columns, the log of overwritten values |
//! | [`dcel`] | the structure: accessors, circulators, operators |
//! | [`program`] | sequences of operators as data, conformance tests |
//!
//! # Limits
//!
//! - A structure has exactly one unbounded face. Maps on the sphere and on other surfaces can be validated
//!   ([`validate::Expectation::surface`]), but a [`dcel::Dcel`] cannot hold them.
//! - At most about 2³¹ vertices, half-edges, boundary components and faces each.
//! - The two half-edges of an edge have the same generation. A slot can be used 2³¹ times before a key is reissued.
//!
//! # Rust versions
//!
//! Rust 1.85, as stated by the dependencies; clippy's `incompatible_msrv` finds no newer function of the standard library in this
//! crate, and no condition joins a `let` by `&&`. It is tested with Rust 1.95; no older compiler was tried.
#![cfg_attr(not(feature = "std"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]

extern crate alloc;

#[forbid(unsafe_code)]
mod numbers;

#[forbid(unsafe_code)]
pub mod validate;

#[cfg(feature = "dcel")]
mod store;

#[cfg(feature = "dcel")]
#[forbid(unsafe_code)]
pub mod dcel;

#[cfg(feature = "dcel")]
#[forbid(unsafe_code)]
pub mod program;

// Tests the examples of these pages with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
#[cfg(doctest)]
#[doc = include_str!("../docs/validate.md")]
struct ValidatePage;
