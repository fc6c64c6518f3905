//! Checks that the features of a map form a coverage: areas side by side, without overlaps and gaps.
//!
//! ```text
//!   ┌──────┬──┬─────┐    ┌──────┐┌─────┐    ┌──────┐┌─────┐    ┌──────┬┬─────┐
//!   │  a   │ab│  b  │    │  a   ││  b  │    │  a   ││  b  │    │  a   ││  b  │  ││ belongs to a
//!   │      │  │     │    │      └┴─────┤    │      ││     │    │      ││     │  third part of b,
//!   └──────┴──┴─────┘    └──────┴──────┘    └──────┘└─────┘    └──────┴┴─────┘  or to c
//!      C1 overlap             C2 gap          C3 near miss        C4 sliver
//!
//!   ┌──────┬─────┐
//!   │  a  v○  b  │    v is a vertex of a on its border with b, which lacks it
//!   └──────┴─────┘
//!     C7 mismatch
//! ```
//!
//! | rule | finds | file |
//! | --- | --- | --- |
//! | C1 overlap | faces that two features claim | `overlap.rs` |
//! | C2 gap | faces that no feature claims, with claimed faces all around them | `gap.rs` |
//! | C3 near miss | borders of two features that face each other across a narrow space that is open to the outside or to a wider gap | `near_miss.rs` |
//! | C4 sliver | small and thin parts of a feature | `sliver.rs` |
//! | C5 duplicate | features that claim the same faces | `duplicate.rs` |
//! | C6 OGC validity | polygons that are invalid by the rules of the OGC, in its terms | `validity.rs` |
//! | C7 mismatch | vertices of a feature on a border of another feature, or of another of its own rings, that lacks them | `mismatch.rs` |
//!
//! [`check`] checks C1 … C5 on a map, [`defects`] checks C6 on the shapes of a feature, which a map no longer has, and
//! [`mismatches`] checks C7 on a map and its input. [`insert_touches`] first adds vertices where rings of one feature touch as
//! the OGC allows. A finding is no error of the structure: a map with overlaps is a valid planar subdivision. The rules are
//! independent: any single one can be broken alone.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`clean`](mod@clean) | one owner for each face: resolves overlaps, and assigns gaps and slivers to neighbours |
//! | [`layers`] | relations between layers: features within features, equal cover, parents made up of parts |
//! | [`tile`] | maps in tiles, whose summaries add up |
//!
//! On a map that is not plane, the inside of a feature whose edges cross others may seem to extend to the unbounded face: the
//! feature leaks ([`leaks`](twinedge_algorithm::claims::leaks)). Its extent is unknown, so [`check`] refuses the map.

mod apart;
mod check;
pub mod clean;
mod finding;
mod gap;
pub mod layers;
mod mismatch;
mod near_miss;
mod overlap;
mod region;
mod rings;
mod sliver;
pub mod tile;
mod touches;
mod validity;

pub use check::{Coverage, CoverageError, check};
pub use finding::{CoverageRule, Finding, Limits, MissingVertex};
pub use mismatch::mismatches;
pub use touches::insert_touches;
pub use validity::{Defect, DefectKind, defects};
