//! Portions, grids, pieces and cuts as bytes: a line that says what follows, a compact form of the fields, and a checksum of both.

use super::cuts::{Cuts, Found};
use super::grid::Grid;
use super::piece::Piece;
use super::portion::Portion;
use crc::{CRC_32_ISO_HDLC, Crc};
use serde::Serialize;
use serde::de::DeserializeOwned;
use thiserror::Error;

/// The beginning of the line, followed by the name of the saved type.
const START: &str = "twinedge ";

/// The version of the form, and the end of the line. Any change of a saved type is a new version.
const VERSION: &str = " 2\n";

const CHECKSUM: Crc<u32> = Crc::<u32>::new(&CRC_32_ISO_HDLC);

/// The error of [`Portion::from_bytes`], and of loading [`Grid`], [`Piece`], [`Cuts`] and [`Found`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum BytesError {
    /// The bytes are something else.
    #[error("these bytes are not {expected}")]
    Foreign {
        /// The expected type, in words.
        expected: &'static str,
    },
    /// The bytes were written by a version of this library with another form.
    #[error("another version of twinedge made this: make all tiles with one version")]
    Version,
    /// The bytes were changed, or are incomplete.
    #[error("this is damaged: its checksum is wrong")]
    Damaged,
    /// The bytes contradict themselves, though they have the right checksum.
    #[error("this contradicts itself: its records are missing, out of order or out of range")]
    Invalid,
}

/// Only a type that does not know its length could fail, and a full memory.
fn to_bytes(name: &'static str, of: &impl Serialize) -> Vec<u8> {
    let mut bytes = postcard::to_extend(of, [START, name, VERSION].concat().into_bytes()).unwrap_or_default();
    bytes.extend(CHECKSUM.checksum(&bytes).to_le_bytes());
    bytes
}

fn from_bytes<T: DeserializeOwned>(name: &'static str, bytes: &[u8]) -> Result<T, BytesError> {
    let of_name = bytes.strip_prefix(START.as_bytes()).and_then(|rest| rest.strip_prefix(name.as_bytes()));
    let of_version = of_name.ok_or(BytesError::Foreign { expected: name })?;
    let saved = of_version.strip_prefix(VERSION.as_bytes()).ok_or(BytesError::Version)?;
    let (saved, checksum) = saved.split_last_chunk::<4>().ok_or(BytesError::Damaged)?;
    if CHECKSUM.checksum(&bytes[..bytes.len() - 4]).to_le_bytes() != *checksum {
        return Err(BytesError::Damaged);
    }
    match postcard::take_from_bytes(saved) {
        Ok((loaded, [])) => Ok(loaded),
        _ => Err(BytesError::Invalid),
    }
}

impl Portion {
    /// Returns the portion as bytes: equal portions have equal bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes("a summary of tiles", self)
    }

    /// Loads a portion. O(bytes).
    ///
    /// ```
    /// use twinedge_coverage::Limits;
    /// use twinedge_coverage::tile::{BytesError, Grid, Portion, Tile};
    ///
    /// let portion = Portion::of_nothing(&Grid::everything(), Tile(0), &Limits::default(), false)?;
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
        from_bytes("a summary of tiles", bytes)
    }
}

impl Grid {
    /// Returns the grid as bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes("a grid of tiles", self)
    }

    /// Loads a grid. O(tiles).
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        from_bytes("a grid of tiles", bytes)
    }
}

impl Piece {
    /// Returns the piece as bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes("a piece of a feature", self)
    }

    /// Loads a piece. O(bytes).
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        from_bytes("a piece of a feature", bytes)
    }
}

impl Cuts {
    /// Returns the cuts as bytes: equal cuts have equal bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes("cuts", self)
    }

    /// Loads cuts. O(bytes).
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        from_bytes("cuts", bytes)
    }
}

impl Found {
    /// Returns what a tile found as bytes: equal finds have equal bytes. O(bytes).
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        to_bytes("found cuts", self)
    }

    /// Loads what a tile found. O(bytes).
    ///
    /// # Errors
    /// [`BytesError`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, BytesError> {
        from_bytes("found cuts", bytes)
    }
}
