//! The formats of maps and layers, and their detection.

use super::json_head::JsonHead;
use core::fmt;
use std::path::Path;

/// A format of maps and layers. [`read`](crate::read()) reads all, with attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(clippy::exhaustive_enums, reason = "the compiler names what a new format needs, in other crates, too")]
pub enum Format {
    /// GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)): one object, with the feature `geojson`.
    GeoJson,
    /// Successive GeoJSON objects, usually one per line: newline-delimited GeoJSON, or text sequences ([RFC
    /// 8142](https://www.rfc-editor.org/rfc/rfc8142)), with the feature `geojson`.
    GeoJsonSeq,
    /// Well-known text, a geometry per line, with the feature `wkt`.
    Wkt,
    /// Well-known binary: one geometry per line in hexadecimal digits, or successive geometries as bytes.
    Wkb,
    /// Esri Shapefile: several files with one name.
    Shapefile,
    /// OGC `GeoPackage`.
    GeoPackage,
    /// `TopoJSON`.
    TopoJson,
    /// `FlatGeobuf`.
    FlatGeobuf,
    /// `GeoParquet`, and Parquet with its own geometry type.
    GeoParquet,
}

struct Row {
    format: Format,
    name: &'static str,
    extensions: &'static [&'static str],
    /// The feature that reads it, here or in `twinedge-meshes`.
    feature: &'static str,
}

const fn row(format: Format, name: &'static str, extensions: &'static [&'static str], feature: &'static str) -> Row {
    Row { format, name, extensions, feature }
}

const ROWS: [Row; Format::ALL.len()] = [
    row(Format::GeoJson, "GeoJSON", &["geojson"], "geojson"),
    row(
        Format::GeoJsonSeq,
        "newline-delimited GeoJSON",
        &["geojsonl", "geojsons", "geojsonseq", "ndgeojson", "ndjson", "jsonl"],
        "geojson",
    ),
    row(Format::Wkt, "well-known text", &["wkt"], "wkt"),
    row(Format::Wkb, "well-known binary", &["wkb"], "wkb"),
    row(Format::Shapefile, "Shapefile", &["shp", "shx", "dbf"], "shapefile"),
    row(Format::GeoPackage, "GeoPackage", &["gpkg"], "geopackage"),
    row(Format::TopoJson, "TopoJSON", &["topojson"], "topojson"),
    row(Format::FlatGeobuf, "FlatGeobuf", &["fgb"], "flatgeobuf"),
    row(Format::GeoParquet, "GeoParquet", &["parquet", "geoparquet"], "geoparquet"),
];

impl Format {
    /// All formats.
    pub const ALL: [Self; 9] = [
        Self::GeoJson,
        Self::GeoJsonSeq,
        Self::Wkt,
        Self::Wkb,
        Self::Shapefile,
        Self::GeoPackage,
        Self::TopoJson,
        Self::FlatGeobuf,
        Self::GeoParquet,
    ];

    const fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Returns the format for the extension of a file name; `None` if the content must decide, as for `.json`.
    ///
    /// ```
    /// use twinedge_layers::io::Format;
    ///
    /// assert_eq!(Format::of_path("parcels.WKT"), Some(Format::Wkt));
    /// assert_eq!(Format::of_path("parcels.geojsonl"), Some(Format::GeoJsonSeq));
    /// assert_eq!(Format::of_path("parcels.SHP"), Some(Format::Shapefile));
    /// assert_eq!(Format::of_path("parcels.json"), None);
    /// ```
    #[must_use]
    pub fn of_path(path: impl AsRef<Path>) -> Option<Self> {
        let extension = path.as_ref().extension()?.to_str()?.to_ascii_lowercase();
        ROWS.iter().find(|row| row.extensions.contains(&&*extension)).map(|row| row.format)
    }

    /// Returns the format of data that begins with these bytes. They must include the end of the first object to distinguish a
    /// sequence of objects from a single one. O(bytes).
    ///
    /// ```
    /// use twinedge_layers::io::Format;
    ///
    /// assert_eq!(Format::of_content(br#"{"type": "Feature", "#), Some(Format::GeoJson));
    /// assert_eq!(Format::of_content(b"{\"type\": \"Feature\"}\n{\"type\": "), Some(Format::GeoJsonSeq));
    /// assert_eq!(Format::of_content(b"# parcels\nPolygon ((0 0, 1 0, 1 1, 0 0))"), Some(Format::Wkt));
    /// assert_eq!(Format::of_content(b"\0\0\x27\x0A"), Some(Format::Shapefile));
    /// assert_eq!(Format::of_content(b"id,name\n1,a\n"), None);
    /// ```
    #[must_use]
    pub fn of_content(head: &[u8]) -> Option<Self> {
        if head.starts_with(b"\x00\x00\x27\x0A") {
            return Some(Self::Shapefile);
        }
        if is_sqlite(head) && is_geopackage(head) {
            return Some(Self::GeoPackage);
        }
        // "fgb", a version, "fgb", a patch level.
        if head.starts_with(b"fgb") && head.get(4..7) == Some(b"fgb") {
            return Some(Self::FlatGeobuf);
        }
        if head.starts_with(b"PAR1") {
            return Some(Self::GeoParquet);
        }
        if is_wkb(head) {
            return Some(Self::Wkb);
        }
        let text = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
        let json = || JsonHead::scan(text);
        match text.first()? {
            b'{' if json().member("type") == Some("Topology") => Some(Self::TopoJson),
            b'{' if json().goes_on() => Some(Self::GeoJsonSeq),
            // An array is no map, but the reader reports the expected input.
            b'{' | b'[' => Some(Self::GeoJson),
            0x1E => Some(Self::GeoJsonSeq),
            b'#' => Some(Self::Wkt),
            _ => starts_with_geometry(text).then_some(Self::Wkt),
        }
    }

    /// Returns the format of a file, by its content and its name. Content of several GeoJSON objects is newline-delimited,
    /// whatever the extension.
    ///
    /// ```
    /// use twinedge_layers::io::Format;
    ///
    /// let (one, many) = (Some(Format::GeoJson), Some(Format::GeoJsonSeq));
    /// assert_eq!(Format::of_file(many, one), many);
    /// assert_eq!(Format::of_file(one, many), many);
    /// assert_eq!(Format::of_file(Some(Format::FlatGeobuf), one), Some(Format::FlatGeobuf));
    /// ```
    #[must_use]
    pub fn of_file(by_content: Option<Self>, by_name: Option<Self>) -> Option<Self> {
        match (by_content, by_name) {
            (Some(Self::GeoJsonSeq), Some(Self::GeoJson)) => by_content,
            (Some(certain), _) if certain.is_certain() => by_content,
            _ => by_name.or(by_content),
        }
    }

    /// Returns true if the content determines the format with certainty, independent of the file name.
    #[must_use]
    pub const fn is_certain(self) -> bool {
        !matches!(self, Self::GeoJson | Self::GeoJsonSeq | Self::Wkt)
    }

    /// Returns true if the format defines the direction of rings. RFC 7946 does, and so does Esri's description of Shapefiles,
    /// whose rings are turned on reading. "Simple feature access" (OGC 06-103r4 and 06-104r4), the basis of well-known text,
    /// well-known binary and `GeoPackage`, leaves it open, and so do `FlatGeobuf`, `GeoParquet` and `TopoJSON`.
    ///
    /// ```
    /// use twinedge_layers::io::Format;
    ///
    /// assert!(Format::Shapefile.orients_rings() && !Format::Wkt.orients_rings());
    /// ```
    #[must_use]
    pub const fn orients_rings(self) -> bool {
        matches!(self, Self::GeoJson | Self::GeoJsonSeq | Self::Shapefile)
    }

    /// Returns the feature of the crate that reads it.
    #[must_use]
    pub const fn feature(self) -> &'static str {
        self.row().feature
    }
}

pub(super) fn is_sqlite(head: &[u8]) -> bool {
    head.starts_with(b"SQLite format 3\0")
}

/// Returns true if a database has an application id of `GeoPackage` (of version 1.0, 1.1, or later), or the table that every
/// `GeoPackage` has.
pub(super) fn is_geopackage(head: &[u8]) -> bool {
    const TABLE: &[u8] = b"gpkg_contents";
    matches!(head.get(68..72), Some(b"GPKG" | b"GP10" | b"GP11")) || head.windows(TABLE.len()).any(|word| word == TABLE)
}

/// Returns true if a text starts with the name of a geometry type, as well-known text does, perhaps after an `SRID`.
fn starts_with_geometry(text: &[u8]) -> bool {
    const TYPES: [&str; 14] = [
        "POINT",
        "LINESTRING",
        "LINEARRING",
        "POLYGON",
        "MULTIPOINT",
        "MULTILINESTRING",
        "MULTIPOLYGON",
        "GEOMETRYCOLLECTION",
        "SRID",
        // The reader names the type in its error.
        "CIRCULARSTRING",
        "COMPOUNDCURVE",
        "CURVEPOLYGON",
        "MULTICURVE",
        "MULTISURFACE",
    ];
    let letters = text.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let word = text[..letters].to_ascii_uppercase();
    // The dimensions may follow without a space.
    TYPES.iter().any(|name| matches!(word.strip_prefix(name.as_bytes()), Some(b"" | b"Z" | b"M" | b"ZM")))
}

/// Returns true if this is the start of a geometry in well-known binary, as bytes or in hexadecimal digits.
fn is_wkb(head: &[u8]) -> bool {
    let digit = |byte: u8| char::from(byte).to_digit(16).map(|digit| digit as u8);
    let from_hex = |pair: &[u8]| Some(digit(pair[0])? << 4 | digit(pair[1])?);
    let bytes = head.get(..10).and_then(|digits| digits.chunks_exact(2).map(from_hex).collect::<Option<Vec<u8>>>());
    head.get(..5).is_some_and(is_wkb_header) || bytes.is_some_and(|bytes| is_wkb_header(&bytes))
}

/// Returns true if these are a byte order and a type of geometry: 1 to 7, or a curve up to 12, with dimensions as thousands (ISO)
/// or in the three highest bits (EWKB).
fn is_wkb_header(bytes: &[u8]) -> bool {
    const DIMENSIONS: u32 = 0b111 << 29;
    let kind = match *bytes {
        [0, a, b, c, d] => u32::from_be_bytes([a, b, c, d]),
        [1, a, b, c, d] => u32::from_le_bytes([a, b, c, d]),
        _ => return false,
    };
    let kind = kind & !DIMENSIONS;
    kind < 4000 && (1..=12).contains(&(kind % 1000))
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.row().name)
    }
}
