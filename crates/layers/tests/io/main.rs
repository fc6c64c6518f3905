//! Formats and drawings.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

use quickcheck::{Gen, QuickCheck};
use twinedge_layers::io::geojson::{Documents, read_parts};
use twinedge_layers::io::{ReadError, ReadSummary};
use twinedge_layers::{Format, ReadOptions, read_for_map};
use twinedge_map::Feature;

mod export;
mod geojson;
mod geojson_properties;
mod import;
mod reading;
mod wkt;

/// The options to read a format, whatever the content looks like.
fn options(format: Format) -> ReadOptions {
    ReadOptions { format: Some(format), ..ReadOptions::default() }
}

/// Reads GeoJSON for a map, or returns the error of its parts.
fn read_geojson(text: impl AsRef<[u8]>) -> Result<(Vec<Feature>, ReadSummary), ReadError> {
    read_parts(text.as_ref(), Documents::One, |_| Ok::<_, ReadError>(()))?;
    Ok(read_for_map(&mut text.as_ref(), &options(Format::GeoJson)).expect("its parts were read"))
}

/// A `QuickCheck` with a fixed seed.
fn check(tests: u64, seed: u64) -> QuickCheck {
    QuickCheck::new().tests(tests).rng(Gen::from_size_and_seed(8, seed))
}
