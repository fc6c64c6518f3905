//! Readers and audits for files that hold half-edge structures, or data that becomes one.
//!
//! [`mesh`] reads OBJ, OFF, PLY and STL, joins the faces to half-edges, reports in the user's terms the parts that cannot be
//! joined, and lets the validator of `twinedge` judge the rest. `postgis` reads a topology of PostGIS as the database keeps it.
//! `layer` reads, writes and repairs layers of features; `layer::topojson` audits arcs. `svg` draws maps. `textbook` has the
//! textbooks' tables.
//!
//! ```
//! # #[cfg(feature = "off")] {
//! use twinedge::validate::Collect;
//! use twinedge_formats::mesh::{Format, HalfEdgeMesh, audit, read_bytes};
//!
//! let tetrahedron = "OFF
//! 4 4 6
//! 0 0 0
//! 1 0 0
//! 0 1 0
//! 0 0 1
//! 3 0 2 1
//! 3 0 1 3
//! 3 1 2 3
//! 3 2 0 3
//! ";
//! let file = read_bytes(tetrahedron.as_bytes(), Some(Format::Off))?;
//! let audit = audit(&file.mesh, &HalfEdgeMesh::expectation().closed().triangles().genus(0), Collect::All);
//! assert!(audit.is_valid());
//! assert_eq!(audit.counts().edges, 6);
//! # }
//! # Ok::<(), twinedge_formats::mesh::ReadError>(())
//! ```
//!
//! # Features
//!
//! | feature | adds | dependencies |
//! | --- | --- | --- |
//! | `obj`, `off`, `stl` (default) | a reader each | none |
//! | `ply` | the reader for PLY | ply-rs-bw |
//! | `geojson`, `shapefile`, `wkb`, `wkt` (default) | the module `layer`, with a reader and a writer each | geojson, codepage with `encoding_rs` and `oem_cp`, none, wkt |
//! | `flatgeobuf`, `geopackage`, `geoparquet` | a reader and a writer each | flatgeobuf, rusqlite, parquet with chrono |
//! | `topojson` (default) | a reader | serde |
//! | `archive` | layers in zip archives and in gzip data | zip, tempfile |
//! | `epsg` (default) | the definitions of the reference systems of the EPSG; without them only WGS 84 is known by its number | none |
//! | `osm` | boundaries of `OpenStreetMap`, read by `layer::osm` | osmpbf |
//! | `postgis` (default) | the module `postgis` | robust, rstar, rustc-hash |
//! | `svg` (default) | the module `svg` | none |
//! | `textbook` (default) | the module `textbook` | rustc-hash |
//! | `full` | all features | all |
//! | `serde` (default) | [`mesh::MeshAudit`], `postgis::TopologyAudit` and their parts are `Serialize` | serde |
#![cfg_attr(docsrs, feature(doc_cfg))]

pub mod diagnosis;
#[cfg(feature = "layer")]
pub mod io;
#[cfg(feature = "layer")]
pub mod layer;
pub mod mesh;
#[cfg(feature = "postgis")]
pub mod postgis;
#[cfg(feature = "svg")]
pub mod svg;
#[cfg(feature = "textbook")]
pub mod textbook;
#[cfg(any(feature = "postgis", feature = "topojson"))]
mod topology_audit;
