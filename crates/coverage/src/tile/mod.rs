//! Maps in tiles: each tile of a grid is audited alone, and the summaries add up to the audit of the whole map.
//!
//! A [`Grid`] divides a map that is too large for one machine, or shared by several workers. [`Cuts::pieces`] divides each feature
//! into the pieces that tiles need. [`Summary::new`] summarizes a tile from its pieces. [`Summary::merge`] combines two summaries, in any
//! order. [`Summary::finish`] turns the summary of all tiles into the audit of the whole map: the counts, whether the map is a planar
//! subdivision, and the findings of C1 … C7, with the same features and locations and, up to rounding, the same areas, widths and lengths.
//! [`audit`] does this on one machine.
//!
//! ```
//! use twinedge_coverage::{CoverageRule, Limits};
//! use twinedge_map::{Feature, Shape};
//! use twinedge_coverage::tile::{Cuts, Grid, Summary};
//!
//! // Two parcels with a gap between them, which is closed above and below.
//! let parcel = |ring: &[[f64; 2]]| Feature { shapes: vec![Shape::polygon(ring.to_vec())], ..Feature::default() };
//! let west = parcel(&[[0.0, 0.0], [4.0, 0.0], [3.0, 2.0], [4.0, 4.0], [0.0, 4.0]]);
//! let east = parcel(&[[4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0], [5.0, 2.0]]);
//!
//! // Four tiles meet in the middle of the gap. No coordinate is larger than 8.
//! let (grid, cuts) = (Grid::new([0.0, 0.0], [8.0, 4.0], 2, 2)?, Cuts::new(8.0)?);
//! let pieces = [cuts.pieces(&grid, 0, &west)?, cuts.pieces(&grid, 1, &east)?].concat();
//! let limits = Limits::default();
//! let mut tiles = grid.tiles().map(|tile| Summary::new(&grid, tile, &pieces, &limits));
//! let first = tiles.next().unwrap()?;
//! let whole = tiles.try_fold(first, |sum, tile| Ok::<_, Box<dyn std::error::Error>>(sum.merge(tile?)?))?;
//!
//! let outcome = whole.finish()?;
//! assert!(outcome.is_valid());
//! let coverage = outcome.coverage.unwrap();
//! let [gap] = &coverage.findings[..] else { unreachable!("nothing else is wrong") };
//! assert_eq!((gap.rule, gap.area, gap.features.len()), (CoverageRule::Gap, 4.0, 2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What a tile is given
//!
//! A [`Piece`] has the edges of a feature that meet the tile or come very near it, and says which polygons of the feature contain the
//! tile's lower left corner. So all tiles together are given little more than the map, and a tile inside a feature is given its number.
//! Each feature needs a number of its own in the map. [`Summary::new`] takes edges as they are: they should meet only at shared endpoints.
//! If they do not, this is detected, and the map is audited with cut edges: [`Cuts`] are found tile by tile, and [`Summary::cut`] makes
//! the summaries that determine the coverage.
//!
//! # What a summary holds
//!
//! Records inside a tile are counted. Records cut by the border are listed: *contacts*, where an edge passes a side of a tile, in
//! order along the side, with the component and the two cycles of the edge; and the pieces of faces between them. Contacts of a
//! shared side are matched, and components, cycles and faces are joined by union-find. Records no longer cut are counted.
//!
//! | also listed | reason | dropped |
//! | --- | --- | --- |
//! | the edges of unclaimed faces, and of faces that two features claim | they form gaps, overlaps and duplicates, or the spaces between near misses | never |
//! | the edges of a part of a feature that a border cuts | it may be a sliver | as soon as a tile has more of it than twice the given area of slivers |
//! | features that a border cuts, and features that claim the same faces | they may be duplicates | when all their tiles are merged |
//! | unmatched vertices, if edges are cut | all vertices of two features form one mismatch, across tiles | never |
//! | the lengths of all edges; the areas of all parts of features | [`Limits`] that are not given are medians of these | never; not listed if `gap_width` and `sliver_area` are given |
//!
//! So if both limits are given and features form a coverage, the size of a summary is proportional to its border and its
//! findings. With islands in a sea, it contains all coasts, since each may have a near miss.
//!
//! Equal tiles have equal summaries, independent of the order of merging: classes are numbered as the borders first name them,
//! and lists are sorted. A [`Portion`] has what tiles were made of besides, and with the feature `serde` it is saved as bytes, equal
//! ones for equal tiles.
//!
//! # Exactness
//!
//! The crossing of an edge and a line of the grid has coordinates that doubles cannot represent, so it is never computed: a
//! contact is identified by the ends of its edge, known to both tiles, and exact predicates order contacts. The lines are treated
//! as if moved to the left and downwards by less than any distance of the drawing, so that no vertex lies on a line and no edge
//! runs along one: a vertex or an edge on a line belongs to the tile on its right or above it.
//!
//! # Rules of seams
//!
//! | rule | sentence |
//! | --- | --- |
//! | S1 contact | both tiles see the same edges at their border |
//! | S2 order | both tiles see these edges in the same order |
//! | S3 features | both tiles see the same features along each edge, and on each face between two |
//!
//! They are broken if tiles were made from different data, or a piece of a feature was not given to its tile. If a contact is
//! missing, both sides are joined only as far as they agree, and the counts follow from that.
//!
//! # What is checked
//!
//! Most rules hold for every map built from features: exact predicates sort rotations, and cycles, faces and nesting follow. G4
//! is checked in each tile, T3 for each component and for the sums. If edges cross (G4), faces are unknown: then G3 and G5 are
//! not checked ([`Outcome::rules`]), and C1 … C5 and C7 describe the map with its edges cut ([`Outcome::coverage`]).
//! [`Outcome::uncut`] reports edges that are cut too often, or bend so often that they drift into other tiles.
//!
//! Source for tiles of subdivisions: L. Calderón-Romero, A. Magdy, V. J. Tsotras, "Scalable overlay operations over DCEL polygon
//! layers", SSTD 2023. It joins cells in a second phase; here they are joined by merging.
//!
//! [`Limits`]: crate::Limits

mod audit;
mod bounds;
#[cfg(feature = "serde")]
mod bytes;
mod claimed;
mod cuts;
mod divide;
mod ends;
mod error;
mod faces;
mod fault;
mod findings;
mod finish;
mod grid;
mod large;
mod local;
mod merge;
mod piece;
mod portion;
mod region;
#[cfg(feature = "serde")]
mod saved;
mod side;
mod summary;
mod tally;

pub use audit::audit;
#[cfg(feature = "serde")]
pub use bytes::BytesError;
pub use cuts::{Cuts, Found, Source};
pub use error::{AuditError, FinishError, MergeError, TileError};
pub use fault::{Crossing, CrossingKind, SeamFault, SeamRule, Uneven};
pub use finish::Outcome;
pub use grid::{Grid, GridError, Tile};
pub use piece::Piece;
pub use portion::Portion;
pub use summary::Summary;

const NIL: u32 = u32::MAX;
