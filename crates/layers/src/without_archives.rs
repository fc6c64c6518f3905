//! Archives without the feature that unpacks them: an error.

use super::error::{ArchiveError, ReadError};
use crate::io::ForeignFormat;
use std::io::Read;
use std::path::{Path, PathBuf};

/// An unpacked layer. Nothing is unpacked without the feature `archive`.
#[derive(Debug)]
#[non_exhaustive]
pub struct Unpacked {
    /// The path of the layer.
    pub path: PathBuf,
    /// The layer to read from the file, if one must still be chosen.
    pub layer: Option<String>,
}

/// Returns `None` for data that is no archive.
///
/// # Errors
/// [`ArchiveError::FeatureOff`] for an archive.
pub fn unpack(head: &[u8], _: &mut dyn Read, _: Option<&Path>, _: Option<&str>) -> Result<Option<Unpacked>, ReadError> {
    match ForeignFormat::of_content(head) {
        Some(ForeignFormat::Zip | ForeignFormat::Gzip) => Err(ArchiveError::FeatureOff.into()),
        _ => Ok(None),
    }
}
