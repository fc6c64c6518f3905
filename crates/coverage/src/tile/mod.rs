//! Maps in tiles: each tile of a grid is judged alone, and the summaries add up to the audit of the whole map.
//!
//! A map that is too large for one machine, or that several work on, is cut by a [`Grid`]. [`Summary::new`] makes the summary of a tile from
//! the features that meet it. [`Summary::merge`] makes one summary of two, in whatever order. [`Summary::finish`] says of the summary
//! of all tiles what the audit of the whole map says: the counts, whether the map is a planar subdivision, and the findings of C1 … C7, with the
//! same features and places, and, up to rounding, the same areas, widths and lengths. [`audit`] does all of it on one machine.
//!
//! ```
//! use twinedge_coverage::{CoverageRule, Limits};
//! use twinedge_map::{Feature, Shape};
//! use twinedge_coverage::tile::{Grid, Summary};
//!
//! // Two parcels with a gap between them, which is closed above and below.
//! let parcel = |ring: &[[f64; 2]]| Feature { shapes: vec![Shape::polygon(ring.to_vec())], ..Feature::default() };
//! let west = parcel(&[[0.0, 0.0], [4.0, 0.0], [3.0, 2.0], [4.0, 4.0], [0.0, 4.0]]);
//! let east = parcel(&[[4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0], [5.0, 2.0]]);
//! let features = [(0, &west), (1, &east)];
//!
//! // Four tiles meet in the middle of the gap.
//! let grid = Grid::new([0.0, 0.0], [8.0, 4.0], 2, 2)?;
//! let limits = Limits::default();
//! let mut tiles = grid.tiles().map(|tile| Summary::new(&grid, tile, features, &limits));
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
//! All features whose boxes meet the tile, whole, with their numbers in the map; [`Grid::tiles_of`] says which tiles a feature is to be given to. So a tile knows by
//! itself which features cover its faces, also where there is no edge in it, and neighbours must agree on that.
//! [`Summary::new`] takes edges as they are: they should meet at shared endpoints only. Where they do not, that is found, and the map is then judged
//! once more, with edges that are cut where they meet: [`Cuts`] are found tile by tile, and [`Summary::cut`] makes the summaries from which the
//! coverage is known.
//!
//! # What a summary holds
//!
//! What lies inside is counted. What the border cuts is listed: *contacts*, where an edge passes a side of a tile, in their order along the
//! side, with the component and the two cycles that the edge belongs to; and the pieces of faces between them. Where two tiles have a side
//! in common, their contacts are matched, and components, cycles and faces are joined: that is union-find. What no border cuts any more is
//! counted.
//!
//! | listed besides | why | when it goes |
//! | --- | --- | --- |
//! | the edges of unclaimed faces, and of faces that two features claim | they are gaps, overlaps and duplicates, or the spaces between near misses | never |
//! | the edges of a part of a feature that a border cuts | it may be a sliver | as soon as a tile has more of it than twice the area of slivers, if that was given |
//! | features that a border cuts, and those that claim the same | they may be duplicates | when all their tiles are merged |
//! | vertices that borders lack, if edges are cut | those of two features are one mismatch, in whatever tiles they are | never |
//! | the lengths of all edges; the areas of all parts of features | [`Limits`] that are not given are medians of these | never; not listed if `gap_width` and `sliver_area` are given |
//!
//! So a summary is as large as what its border cuts and what it found, if both limits are given and features are a coverage. Where islands lie in the sea,
//! it has all coasts, because a near miss may be at each of them.
//!
//! Equal tiles have equal summaries, whatever the order of merging: classes are numbered as the borders name them first, and lists are
//! sorted. With the feature `serde` they are saved as equal bytes, by any format that is deterministic, and what is read is checked.
//!
//! # Exactness
//!
//! The point where an edge passes a line of the grid has no coordinates in doubles. So it is never computed: a contact is known by the
//! ends of its edge, which both tiles know, and the order of contacts is decided by exact predicates. The lines are thought of as moved
//! to the left and downwards by less than any distance of the drawing, so that no vertex lies on a line and no edge runs along one: a vertex
//! or an edge on a line belongs to the tile on its right, or above it.
//!
//! # Rules of seams
//!
//! | rule | sentence |
//! | --- | --- |
//! | S1 contact | both tiles see the same edges at their border |
//! | S2 order | both tiles see them in the same order |
//! | S3 features | both tiles see the same features along each edge, and on each face between two |
//!
//! They are broken if tiles were made from different data, or a feature was not given to a tile that it meets. If a contact is missing, what lies on
//! both sides is joined only as far as they agree; counts are what follows from that.
//!
//! # What is checked
//!
//! Most rules hold of every map that is built of features: rotations are sorted by exact predicates, and cycles, faces and what lies in what
//! follow. G4 is checked in each tile, T3 of each component and of the sums. Where edges cross (G4), nothing is known of faces: then G3 and G5
//! are not checked ([`Outcome::rules`]), and C1 … C5 and C7 are those of the map with its edges cut ([`Outcome::coverage`]). Where edges are cut too often, or
//! bend so often that they drift into other tiles, [`Outcome::uncut`] says so.
//!
//! Source for tiles of subdivisions: L. Calderón-Romero, A. Magdy, V. J. Tsotras, "Scalable overlay operations over DCEL polygon layers", SSTD
//! 2023, where cells are joined in a second phase; here they are joined by merging.
//!
//! [`Limits`]: crate::Limits

mod audit;
mod claimed;
mod clip;
mod cuts;
mod ends;
mod error;
mod extent;
mod fault;
mod findings;
mod finish;
mod grid;
mod large;
mod local;
mod merge;
mod pieces;
mod region;
#[cfg(feature = "serde")]
mod saved;
mod side;
mod summary;
mod tally;

pub use audit::audit;
pub use cuts::{Cuts, Found};
pub use error::{AuditError, FinishError, MergeError, TileError};
pub use fault::{Crossing, CrossingKind, SeamFault, SeamRule, Uneven};
pub use finish::Outcome;
pub use grid::{Grid, GridError, Tile};
pub use side::Side;
pub use summary::Summary;

/// No record, in a column.
const NIL: u32 = u32::MAX;
