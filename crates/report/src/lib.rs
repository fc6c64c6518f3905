//! The audit of a map, a mesh, a topology or tables, from bytes to a report.
//!
//! ```text
//!   Input ─► InputKind::of ─► audit ─► Audited ─► JSON · text · layer of findings · page
//! ```
//!
//! The program `twinedge`, the package for browsers and the package for Python all call [`audit`], so they report the same. Nothing here opens a file
//! by itself or looks at the time. With threads, features are read on the caller's thread, noted on a second one, and gathered into a map on a third.
//!
//! ```
//! use twinedge_report::{Input, InputKind, Options, audit};
//!
//! let square = r#"{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]}"#;
//! let mut input = Input::new("square.geojson", Box::new(square.as_bytes()), None);
//! let kind = InputKind::of(false, false, &mut input)?;
//! let audited = audit(input, kind, &Options::default(), &mut |_| {})?;
//! assert!(audited.is_valid());
//! assert!(audited.text()?.contains("every rule that applies holds"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod accepted;
mod audit;
mod borders;
mod causes;
pub mod certificate;
pub mod clean;
mod coverage;
mod coverage_words;
pub mod diagnosis_text;
mod diff;
mod error;
mod findings_geojson;
mod identity;
mod imported;
mod input;
mod input_kind;
mod iso_measure;
mod judged;
mod judgement;
mod junit;
mod layers;
mod left_out;
mod map;
mod map_json;
mod map_notes;
mod mesh;
pub mod names;
mod noted;
mod options;
mod options_json;
pub mod outline;
mod packed;
mod page;
mod read_ahead;
mod report;
mod sarif;
mod shelf;
#[cfg(feature = "geodesic")]
mod sphere;
#[cfg(not(feature = "geodesic"))]
#[path = "without_sphere.rs"]
mod sphere;
pub mod svg;
mod tables;

mod text;
pub mod textbook;
mod textbook_audit;
mod tiles;
mod topology;
mod trace;
mod units;
mod verdict;
pub mod voronoi;
pub mod words;

pub use accepted::{Accepted, AcceptedError, AcceptedFinding};
pub use audit::{Audited, OfReader, audit, audit_against, audit_in_tiles, audit_layer, audit_mesh, audit_portion};
pub use borders::{Border, borders};
pub use coverage::{Coverage, Row, row};
pub use diff::{Compared, Difference, DifferenceError};
pub use error::Error;
pub use imported::Imported;
pub use input::Input;
pub use input_kind::InputKind;
pub use judged::{Counted, Counter};
pub use layers::{Shared, shared};
pub use left_out::refuse_without_cuts;
pub use noted::{Condition, Keep, Noted};
pub use options::{
    AcceptedGaps, CoverageOptions, Edges, LimitOptions, MapOptions, Measured, MeshOptions, Options, OptionsError,
    ParentColumn, positive, snap, whole,
};
pub use shelf::{InMemory, Shelf};
pub use tables::EXPECT;
pub use tiles::{Division, TiledLayer, grid_of, merged, no_cuts, refuse_edges};
pub use units::Units;
pub use verdict::{Judged, Verdict};
