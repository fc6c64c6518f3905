//! From a file to a mesh.
// Not every reader needs all of the shared code.
#![cfg_attr(
    not(all(feature = "obj", feature = "off", feature = "ply", feature = "stl")),
    allow(dead_code, reason = "some readers are off")
)]

mod builder;
mod content;
mod dropped;
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
#[cfg(feature = "stl")]
mod weld;

pub use dropped::Dropped;
pub use error::{Cause, Position, ReadError};
pub use format::Format;

use crate::IndexedMesh;
use error::Failure;
use std::io::Read;
use std::path::Path;

/// The content of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Its format.
    pub format: Format,
    /// The points and faces.
    pub mesh: IndexedMesh,
    /// All other content, in the order of its first occurrence.
    pub dropped: Vec<Dropped>,
}

/// Reads a file. The content decides the format if it is certain, or else the name.
///
/// The whole file is read into memory. O(length); a header with false counts claims no memory.
///
/// # Errors
///
/// If there is no such file, the format is not known, or the content is malformed.
///
/// ```no_run
/// # use twinedge_meshes::{ReadError, read_path};
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

/// Reads a stream to its end, in this format, or in the format of its content.
///
/// # Errors
///
/// If the stream cannot be read, the format is not known, or the content is malformed.
pub fn read(mut reader: impl Read, format: Option<Format>) -> Result<MeshFile, ReadError> {
    let mut bytes = Vec::new();
    reader.read_to_end(&mut bytes)?;
    read_bytes(&bytes, format)
}

/// Reads the content of a file, in this format, or in the format that it indicates. O(length).
///
/// # Errors
///
/// If the format is not known, or the content is malformed: truncated, not numeric, or with coordinates that are not finite,
/// indices out of range or false counts. Text may be in UTF-16, if it begins with a byte order mark.
///
/// ```
/// # #[cfg(feature = "obj")] {
/// use twinedge_meshes::read_bytes;
///
/// let file = read_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n", None)?;
/// assert_eq!(file.mesh.face(0), [0, 1, 2]);
/// assert_eq!(file.dropped[0].what, "normals");
///
/// let error = read_bytes(b"v 0 0 0\nv 1 0 0\nf 1 2 3\n", None).unwrap_err();
/// assert_eq!(error.to_string(), "OBJ, line 3: a face lists point 3, but there are 2 points");
/// # }
/// # Ok::<(), twinedge_meshes::ReadError>(())
/// ```
pub fn read_bytes(bytes: &[u8], format: Option<Format>) -> Result<MeshFile, ReadError> {
    let utf8 = text::of_utf16(bytes);
    let bytes = utf8.as_deref().map_or(bytes, str::as_bytes);
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
        Err(Failure { position, cause }) => Err(ReadError::Content { format, position, cause }),
    }
}
