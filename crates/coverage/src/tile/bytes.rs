//! Portions as bytes: a line that says what follows, a compact form of the fields, and a checksum of both.

use super::portion::Portion;
use crc::{CRC_32_ISO_HDLC, Crc};
use thiserror::Error;

/// The name of the form.
const NAME: &[u8] = b"twinedge tiles ";

/// The version of the form, and the end of the line. Any change of a saved type is a new version.
const VERSION: &[u8] = b"1\n";

const CHECKSUM: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// The error of [`Portion::from_bytes`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BytesError {
    /// The bytes are something else.
    #[error("this is not a summary of tiles")]
    Foreign,
    /// The bytes were written by a version of this library with another form.
    #[error("this summary of tiles was made by another version of twinedge: make all tiles with one version")]
    Version,
    /// The bytes were changed, or are incomplete.
    #[error("this summary of tiles is damaged: its checksum is wrong")]
    Damaged,
    /// The bytes contradict themselves, though they have the right checksum.
    #[error("this is no summary of tiles: what it names is missing, or out of order")]
    Invalid,
}

impl Portion {
    /// Returns the portion as bytes: equal portions have equal bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let bytes = [NAME, VERSION].concat();
        // Only a type that does not know its length could fail, and a full memory.
        let mut bytes = postcard::to_extend(self, bytes).unwrap_or_default();
        bytes.extend(CHECKSUM.checksum(&bytes).to_le_bytes());
        bytes
    }

    /// Loads a portion. O(bytes).
    ///
    /// ```
    /// use twinedge_coverage::Limits;
    /// use twinedge_coverage::tile::{BytesError, Grid, Portion, Tile};
    ///
    /// let tile = Tile { column: 0, row: 0 };
    /// let portion = Portion::of_nothing(&Grid::EVERYTHING, tile, &Limits::default(), false)?;
    /// let mut bytes = portion.to_bytes();
    /// assert_eq!(Portion::from_bytes(&bytes), Ok(portion));
    /// bytes[40] ^= 1;
    /// assert_eq!(Portion::from_bytes(&bytes), Err(BytesError::Damaged));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        let of_version = bytes.strip_prefix(NAME).ok_or(BytesError::Foreign)?;
        let saved = of_version.strip_prefix(VERSION).ok_or(BytesError::Version)?;
        let (saved, checksum) = saved.split_last_chunk().ok_or(BytesError::Damaged)?;
        let counted = CHECKSUM.checksum(&bytes[..bytes.len() - checksum.len()]);
        if counted.to_le_bytes() != *checksum {
            return Err(BytesError::Damaged);
        }
        match postcard::take_from_bytes(saved) {
            Ok((portion, [])) => Ok(portion),
            _ => Err(BytesError::Invalid),
        }
    }
}
