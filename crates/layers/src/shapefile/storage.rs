//! The files of a Shapefile, on disk or in memory.

use super::super::files::Files;
use std::fs::File;
use std::io::{self, Cursor, ErrorKind, Read, Seek};
use std::path::Path;

#[derive(Clone, Copy, Debug)]
pub(crate) enum Storage<'a> {
    Memory(&'a Files),
    Disk,
}

/// Bytes that can be read in any order.
pub(crate) trait ReadSeek: Read + Seek {}

impl<T: Read + Seek> ReadSeek for T {}

impl<'a> Storage<'a> {
    pub(crate) fn of(files: Option<&'a Files>) -> Self {
        files.map_or(Self::Disk, Self::Memory)
    }

    pub(crate) fn has(self, path: &Path) -> bool {
        match self {
            Self::Memory(files) => files.get(path).is_some(),
            Self::Disk => path.exists(),
        }
    }

    pub(crate) fn open(self, path: &Path) -> io::Result<(Box<dyn ReadSeek>, u64)> {
        match self {
            Self::Memory(files) => {
                let bytes = files.share(path).ok_or_else(|| io::Error::from(ErrorKind::NotFound))?;
                let length = bytes.len() as u64;
                Ok((Box::new(Cursor::new(bytes)), length))
            }
            Self::Disk => {
                let file = File::open(path)?;
                let length = file.metadata()?.len();
                Ok((Box::new(file), length))
            }
        }
    }
}
