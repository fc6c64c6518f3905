//! From a file to a mesh.
// What the readers share is not all needed by each of them.
#![cfg_attr(
    not(all(feature = "obj", feature = "off", feature = "ply", feature = "stl")),
    allow(dead_code, reason = "some readers are off")
)]

mod builder;
mod error;
mod format;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
#[cfg(feature = "stl")]
mod stl;
mod text;

pub use error::{Cause, Position, ReadError};
pub use format::Format;

use crate::mesh::IndexedMesh;
use error::Failed;
use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Its format.
    pub format: Format,
    /// The points and faces.
    pub mesh: IndexedMesh,
    /// What else it holds, in the order of its first occurrence.
    pub dropped: Vec<Dropped>,
}

/// Something that a file holds and the mesh does not.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Dropped {
    /// What it is: "normals", "property nx of element vertex".
    pub what: Cow<'static, str>,
    /// How many of them.
    pub count: usize,
}

/// Reads a file. Its content says which format it has where that is certain, or else its name.
///
/// The whole file is read into memory. O(length), and no memory for what a header only claims.
///
/// # Errors
///
/// If there is no such file, the format is not known, or the content is malformed.
///
/// ```no_run
/// # use twinedge_formats::mesh::{ReadError, read_path};
/// let file = read_path("bunny.obj")?;
/// println!("{} points, {} faces", file.mesh.points().len(), file.mesh.face_count());
/// for dropped in &file.dropped {
///     println!("not used: {} {}", dropped.count, dropped.what);
/// }
/// # Ok::<(), ReadError>(())
/// ```
pub fn read_path(path: impl AsRef<Path>) -> Result<MeshFile, ReadError> {
    let path = path.as_ref();
    let bytes = std::fs::read(path)?;
    let format = match (Format::of_name(path), Format::of_content(&bytes)) {
        (_, Some(content)) if content.is_certain() => Some(content),
        (name, content) => name.or(content),
    };
    read_bytes(&bytes, format)
}

/// Reads a stream to its end, in this format, or in that which the content says.
///
/// # Errors
///
/// If the stream cannot be read, the format is not known, or the content is malformed.
pub fn read(mut reader: impl Read, format: Option<Format>) -> Result<MeshFile, ReadError> {
    let mut bytes = Vec::new();
    reader.read_to_end(&mut bytes)?;
    read_bytes(&bytes, format)
}

/// Reads the content of a file, in this format, or in that which the content says. O(length).
///
/// # Errors
///
/// If the format is not known, or the content is malformed: truncated, not numbers, coordinates that are not finite, indices
/// out of range, counts that lie.
///
/// ```
/// # #[cfg(feature = "obj")] {
/// use twinedge_formats::mesh::read_bytes;
///
/// let file = read_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n", None)?;
/// assert_eq!(file.mesh.face(0), [0, 1, 2]);
/// assert_eq!(file.dropped[0].what, "normals");
///
/// let error = read_bytes(b"v 0 0 0\nv 1 0 0\nf 1 2 3\n", None).unwrap_err();
/// assert_eq!(error.to_string(), "OBJ, line 3: a face lists point 3, but there are 2 points");
/// # }
/// # Ok::<(), twinedge_formats::mesh::ReadError>(())
/// ```
pub fn read_bytes(bytes: &[u8], format: Option<Format>) -> Result<MeshFile, ReadError> {
    let format = format.or_else(|| Format::of_content(bytes)).ok_or(ReadError::UnknownFormat)?;
    let result = match format {
        #[cfg(feature = "obj")]
        Format::Obj => obj::read(bytes),
        #[cfg(feature = "off")]
        Format::Off => off::read(bytes),
        #[cfg(feature = "ply")]
        Format::Ply => ply::read(bytes),
        #[cfg(feature = "stl")]
        Format::Stl => stl::read(bytes),
    };
    match result {
        Ok((mesh, dropped)) => Ok(MeshFile { format, mesh, dropped }),
        Err(Failed { position, cause }) => Err(ReadError::Content { format, position, cause }),
    }
}

/// Counts what is dropped.
#[derive(Debug, Default)]
pub(super) struct Drops {
    list: Vec<Dropped>,
}

impl Drops {
    pub(super) fn add(&mut self, what: &'static str, count: usize) {
        if count == 0 {
            return;
        }
        // A reader has a handful of things to drop.
        match self.list.iter_mut().find(|dropped| dropped.what == what) {
            Some(dropped) => dropped.count += count,
            None => self.list.push(Dropped { what: Cow::Borrowed(what), count }),
        }
    }

    pub(super) fn add_if(&mut self, condition: bool, what: &'static str) {
        self.add(what, usize::from(condition));
    }

    /// Adds something that is added once only.
    pub(super) fn add_owned(&mut self, what: String, count: usize) {
        if count > 0 {
            self.list.push(Dropped { what: Cow::Owned(what), count });
        }
    }

    pub(super) fn into_list(self) -> Vec<Dropped> {
        self.list
    }
}
