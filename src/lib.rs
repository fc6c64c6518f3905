//! A doubly connected edge list (DCEL, half-edge structure) for planar subdivisions, and a validator for anybody's.
//!
//! A planar subdivision is what a map is: vertices, edges, faces with holes, islands in the holes, one unbounded face around
//! it all. The structure that the textbooks give it has six links per half-edge and no mercy: set one of them wrong, and a
//! walk around a face never ends, or ends in another face, long after the mistake and far from it. So this crate has two
//! halves that need not know each other.
//!
//! The **validator** takes any half-edge structure, yours included, through a trait of plain questions, and says whether it
//! is the topology of a planar subdivision, or which record breaks which rule. It is *complete*: what it accepts can be
//! drawn in the plane, and what can be drawn it accepts. It is *total*: no input makes it panic, loop or take more than
//! linear time. And it is *itself verified*: a second validator, written as slowly and plainly as can be, agrees with it on
//! every way to link two half-edges and two vertices, on larger tables of which some fields are given, and on every single
//! corruption of every small map.
//!
//! The **structure** is a [`dcel::Dcel`] whose records are named by generational keys, so that a key of a vertex that is
//! gone is an error and never another vertex; whose links are columns of 32-bit numbers, so that walking it costs what
//! walking plain arrays costs; and whose operators are atomic, say what they made, kept and dropped, and keep every rule.
//!
//! # What to choose
//!
//! | you want to | take | feature |
//! | --- | --- | --- |
//! | know whether a half-edge structure of your own is right | [`validate::validate`], after implementing [`validate::View`] | none |
//! | write down a structure as tables, and spoil them for tests | [`validate::Table`] | none |
//! | build and edit a subdivision without coordinates | [`dcel::Dcel`] | `dcel` |
//! | build one from rings and segments, with coordinates | [`map::Builder`], [`map::PlanarMap`] | `map` (default) |
//! | draw and erase on one with coordinates, step by step | [`map::edit`] | `map` (default) |
//! | know where points lie and what lines meet | [`map::Locator`] | `map` (default) |
//! | check that coordinates draw what the links say | [`validate::validate_embedding`] | `map` (default) |
//! | ask who borders whom, what a country's outline is, how large it is | [`algorithm`] | `map` (default) |
//! | draw a map, half-edges and all | [`io::svg`] | `map` (default) |
//! | read and write a map | `io::geojson`, `io::wkt`, `io::geo_types` | `geojson`, `wkt`, `geo-types` |
//! | test a structure by random, exhaustive or fuzzed operator sequences | `program` | `program`, `quickcheck`, `arbitrary` |
//!
//! With no feature on, the crate is the validator alone: no dependency, `no_std` with `alloc`.
//!
//! # The layers
//!
//! Each imports only those above it.
//!
//! ```text
//!   validate   the rules, the View trait, the report
//!   store      where records live: keys, slots, columns
//!   dcel       the structure: accessors, circulators, operators
//!   program    operator sequences as data, canonical forms
//!   geometry   points, exact predicates, maps with coordinates
//!   algorithm  contours, neighbours, areas
//!   io         GeoJSON, WKT, geo-types, SVG
//! ```
//!
//! # Caveats, in plain words
//!
//! - Edges are straight. Curves are chains of them.
//! - [`map::Builder`] takes segments that meet at shared endpoints. Crossing input is built as far as it goes, and the
//!   report says where it crosses.
//! - A half-edge structure for the plane has exactly one unbounded face. Maps on the sphere or on other surfaces can be
//!   *validated* (see [`validate::Expectation::surface`]), but not held in a [`dcel::Dcel`].
//! - The two half-edges of an edge share a generation: they live and die together.
//! - A slot can be used 2³¹ times before a key of it could come again.
//! - At most about two thousand million vertices, half-edges, boundary components and faces each.
#![cfg_attr(not(feature = "geometry"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]

extern crate alloc;

#[forbid(unsafe_code)]
pub mod validate;

#[cfg(feature = "dcel")]
pub mod store;

#[cfg(feature = "dcel")]
#[forbid(unsafe_code)]
pub mod dcel;

#[cfg(feature = "program")]
#[forbid(unsafe_code)]
pub mod program;

// `rstar` needs Rust 1.90, and so does all that builds on it.
#[cfg(feature = "geometry")]
#[clippy::msrv = "1.90"]
#[forbid(unsafe_code)]
pub mod geometry;

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
pub mod io;
