//! The format that a file has.

use std::fmt;
use std::path::Path;

/// A format of mesh files. Those whose feature is off are not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Format {
    /// OBJ (Wavefront), text.
    #[cfg(feature = "obj")]
    Obj,
    /// OFF (Geomview), text.
    #[cfg(feature = "off")]
    Off,
    /// PLY (Stanford), text or binary.
    #[cfg(feature = "ply")]
    Ply,
    /// STL (stereolithography), text or binary.
    #[cfg(feature = "stl")]
    Stl,
}

impl Format {
    /// All formats, those first whose content is easiest to tell.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "off")]
        Self::Off,
        #[cfg(feature = "ply")]
        Self::Ply,
        #[cfg(feature = "stl")]
        Self::Stl,
        #[cfg(feature = "obj")]
        Self::Obj,
    ];

    /// The name, which is also the extension of its files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            #[cfg(feature = "obj")]
            Self::Obj => "obj",
            #[cfg(feature = "off")]
            Self::Off => "off",
            #[cfg(feature = "ply")]
            Self::Ply => "ply",
            #[cfg(feature = "stl")]
            Self::Stl => "stl",
        }
    }

    /// The format that the name of a file says, in upper or lower case.
    ///
    /// ```
    /// # #[cfg(feature = "obj")] {
    /// use twinedge_formats::mesh::Format;
    /// assert_eq!(Format::of_name("bunny.OBJ"), Some(Format::Obj));
    /// assert_eq!(Format::of_name("bunny"), None);
    /// # }
    /// ```
    #[must_use]
    pub fn of_name(path: impl AsRef<Path>) -> Option<Self> {
        let extension = path.as_ref().extension()?;
        Self::ALL.iter().copied().find(|format| extension.eq_ignore_ascii_case(format.name()))
    }

    /// The number of the first point in files of the format, from which a message about a file counts: 1 in OBJ, else 0.
    #[must_use]
    pub fn first_number(self) -> usize {
        usize::from(self.name() == "obj")
    }

    /// Returns true if the content says the format for certain. That of an OBJ file may start with anything.
    pub(super) fn is_certain(self) -> bool {
        self.name() != "obj"
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name().to_uppercase())
    }
}
