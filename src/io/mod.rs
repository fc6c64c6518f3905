//! Reading and writing maps.

#[cfg(feature = "geojson")]
pub mod geojson;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod summary;
#[cfg(feature = "wkt")]
pub mod wkt;

#[cfg(any(feature = "geojson", feature = "wkt"))]
pub use summary::Summary;

/// How many geometry collections a reader accepts around one geometry. RFC 7946 advises against nesting them at all;
/// the bound keeps the stack small.
#[cfg(any(feature = "geojson", feature = "wkt"))]
pub const MAX_NESTED_COLLECTIONS: usize = 32;
