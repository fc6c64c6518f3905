//! Errors of triangulations and diagrams.

use thiserror::Error;
use twinedge::dcel::RecordKind;

/// The error of triangulations and diagrams. Sites are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum VoronoiError {
    /// There is no site.
    #[error("there is no site")]
    NoSites,
    /// A coordinate of a site is NaN or infinite.
    #[error("site {site}: the coordinates ({x}, {y}) are not finite")]
    NotFinite {
        /// The site.
        site: usize,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A coordinate of a site is out of the range of exact circle tests.
    #[error(
        "site {site}: the coordinates ({x:?}, {y:?}) are out of range: magnitudes must be zero or from 2^-142 to 2^201"
    )]
    OutOfRange {
        /// The site.
        site: usize,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// No box: a coordinate is not finite or beyond 2^202, or the first corner is not below and to the left of the second.
    #[error("the bounds must be the lower left and the upper right corner of a box, with coordinates up to 2^202")]
    Bounds,
    /// A site lies outside the bounds.
    #[error("site {site} at ({x}, {y}) lies outside the bounds")]
    Outside {
        /// The site.
        site: usize,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// Some sites are so close to each other that doubles cannot distinguish their cells.
    /// [`voronoi_merging`](super::voronoi_merging) merges their cells.
    #[error(
        "some sites are too close to each other for doubles to tell their cells apart; sites {} and {} are the closest", sites[0], sites[1]
    )]
    TooClose {
        /// The two sites closest to each other.
        sites: [usize; 2],
    },
    /// There is no room for more records of this kind.
    #[error("there is no room for more {0}")]
    Full(RecordKind),
}
