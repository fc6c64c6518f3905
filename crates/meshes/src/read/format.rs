//! The format of a file.

use std::fmt;
use std::path::Path;

/// A format of mesh files. Formats whose feature is off are absent.
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
    /// All formats, those with the most distinctive content first.
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

    /// Returns the name, which is also the extension of its files.
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

    /// Returns the format that the name of a file indicates, ignoring case.
    ///
    /// ```
    /// # #[cfg(feature = "obj")] {
    /// use twinedge_meshes::Format;
    /// assert_eq!(Format::of_name("bunny.OBJ"), Some(Format::Obj));
    /// assert_eq!(Format::of_name("bunny"), None);
    /// # }
    /// ```
    #[must_use]
    pub fn of_name(path: impl AsRef<Path>) -> Option<Self> {
        let extension = path.as_ref().extension()?;
        Self::ALL.iter().copied().find(|format| extension.eq_ignore_ascii_case(format.name()))
    }

    /// Returns the number of the first point in files of the format, from which messages count: 1 in OBJ, else 0.
    #[must_use]
    pub fn first_number(self) -> usize {
        usize::from(self.name() == "obj")
    }

    /// Returns true if the content identifies the format reliably. An OBJ file may start with anything.
    pub(super) fn is_certain(self) -> bool {
        self.name() != "obj"
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name().to_uppercase())
    }
}
