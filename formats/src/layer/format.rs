//! The formats of layers, and how to tell which one a file has.

use std::fmt;
use std::path::Path;
use twinedge::io::{ForeignFormat, Format as TextFormat};

/// A format of layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// GeoJSON: one object.
    GeoJson,
    /// GeoJSON objects, one per line.
    GeoJsonSeq,
    /// Well-known text, a geometry per line.
    Wkt,
    /// Well-known binary: a geometry per line in hexadecimal digits, or geometries one after the other as bytes.
    Wkb,
    /// Esri Shapefile: several files of one name.
    Shapefile,
    /// OGC `GeoPackage`.
    GeoPackage,
    /// `TopoJSON`, which is read only.
    TopoJson,
    /// `FlatGeobuf`.
    FlatGeobuf,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 8] = [
        Self::GeoJson,
        Self::GeoJsonSeq,
        Self::Wkt,
        Self::Wkb,
        Self::Shapefile,
        Self::GeoPackage,
        Self::TopoJson,
        Self::FlatGeobuf,
    ];

    /// Whether it says which way rings turn. RFC 7946 does, and so does Esri's description of Shapefiles, whose rings are turned when
    /// they are read. "Simple feature access" (OGC 06-103r4 and 06-104r4), on which well-known text, well-known binary and `GeoPackage`
    /// rest, leaves it open, and so do `FlatGeobuf` and `TopoJSON`.
    ///
    /// ```
    /// use twinedge_formats::layer::Format;
    ///
    /// assert!(Format::Shapefile.orients_rings() && !Format::Wkt.orients_rings());
    /// ```
    #[must_use]
    pub const fn orients_rings(self) -> bool {
        matches!(self, Self::GeoJson | Self::GeoJsonSeq | Self::Shapefile)
    }

    /// The format that the extension of a file name stands for; none, if the content must tell, as for `.json`.
    ///
    /// ```
    /// use twinedge_formats::layer::Format;
    ///
    /// assert_eq!(Format::of_path("parcels.SHP"), Some(Format::Shapefile));
    /// assert_eq!(Format::of_path("parcels.json"), None);
    /// ```
    #[must_use]
    pub fn of_path(path: impl AsRef<Path>) -> Option<Self> {
        let extension = path.as_ref().extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "shp" | "shx" | "dbf" => Some(Self::Shapefile),
            "gpkg" => Some(Self::GeoPackage),
            "wkb" => Some(Self::Wkb),
            "topojson" => Some(Self::TopoJson),
            "fgb" => Some(Self::FlatGeobuf),
            _ => Some(Self::of_text(TextFormat::of_path(path)?)),
        }
    }

    /// The format of data that begins with these bytes. O(bytes).
    ///
    /// # Errors
    /// The format that it has instead, if that is known but not read here.
    ///
    /// ```
    /// use twinedge::io::ForeignFormat;
    /// use twinedge_formats::layer::Format;
    ///
    /// assert_eq!(Format::of_content(b"SQLite format 3\0"), Err(ForeignFormat::Sqlite));
    /// assert_eq!(Format::of_content(b"\0\0\x27\x0A"), Ok(Some(Format::Shapefile)));
    /// assert_eq!(Format::of_content(b"id,name\n1,a\n"), Ok(None));
    /// ```
    pub fn of_content(head: &[u8]) -> Result<Option<Self>, ForeignFormat> {
        match ForeignFormat::of_content(head) {
            Some(ForeignFormat::Shapefile) => Ok(Some(Self::Shapefile)),
            Some(ForeignFormat::GeoPackage) => Ok(Some(Self::GeoPackage)),
            Some(ForeignFormat::Wkb) => Ok(Some(Self::Wkb)),
            Some(ForeignFormat::TopoJson) => Ok(Some(Self::TopoJson)),
            Some(ForeignFormat::FlatGeobuf) => Ok(Some(Self::FlatGeobuf)),
            Some(foreign) => Err(foreign),
            None => Ok(TextFormat::of_content(head).map(Self::of_text)),
        }
    }

    fn of_text(format: TextFormat) -> Self {
        match format {
            TextFormat::GeoJsonSeq => Self::GeoJsonSeq,
            TextFormat::Wkt => Self::Wkt,
            _ => Self::GeoJson,
        }
    }

    /// The feature of this crate that reads and writes it.
    pub(super) const fn feature(self) -> &'static str {
        match self {
            Self::GeoJson | Self::GeoJsonSeq => "geojson",
            Self::Wkt => "wkt",
            Self::Wkb => "wkb",
            Self::Shapefile => "shapefile",
            Self::GeoPackage => "geopackage",
            Self::TopoJson => "topojson",
            Self::FlatGeobuf => "flatgeobuf",
        }
    }

    /// Whether it is read from and written to files only, as it is made of several or is no stream.
    #[must_use]
    pub const fn needs_file(self) -> bool {
        matches!(self, Self::Shapefile | Self::GeoPackage)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::GeoJson => "GeoJSON",
            Self::GeoJsonSeq => "newline-delimited GeoJSON",
            Self::Wkt => "well-known text",
            Self::Wkb => "well-known binary",
            Self::Shapefile => "Shapefile",
            Self::GeoPackage => "GeoPackage",
            Self::TopoJson => "TopoJSON",
            Self::FlatGeobuf => "FlatGeobuf",
        })
    }
}
