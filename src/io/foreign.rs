//! Formats that are recognised, but not read: to say what a file looks like, and what to do with it.

use super::json_head::JsonHead;
use core::fmt;

/// A format that is recognised by its first bytes, but not read here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ForeignFormat {
    /// The main file or the index of an Esri Shapefile.
    Shapefile,
    /// An OGC `GeoPackage`.
    GeoPackage,
    /// A database of `SQLite`, perhaps with `SpatiaLite`.
    Sqlite,
    /// `FlatGeobuf`.
    FlatGeobuf,
    /// Apache Parquet, perhaps `GeoParquet`.
    Parquet,
    /// Apache Arrow or Feather.
    Arrow,
    /// `OpenStreetMap` data as protocol buffers.
    OsmPbf,
    /// Well-known binary, as bytes or in hexadecimal digits.
    Wkb,
    /// `TopoJSON`.
    TopoJson,
    /// Esri JSON.
    EsriJson,
    /// Keyhole Markup Language.
    Kml,
    /// Geography Markup Language.
    Gml,
    /// GPS Exchange Format.
    Gpx,
    /// `OpenStreetMap` data as XML.
    OsmXml,
    /// A web page, such as the error message of a server.
    Html,
    /// Other XML.
    Xml,
    /// Text in UTF-16.
    Utf16,
    /// A zip archive.
    Zip,
    /// Data compressed by gzip.
    Gzip,
    /// Data compressed by bzip2.
    Bzip2,
    /// Data compressed by xz.
    Xz,
    /// Data compressed by Zstandard.
    Zstd,
}

impl ForeignFormat {
    /// The format of a file that starts with these bytes, if it is one of these. O(bytes); a few hundred suffice for all but
    /// XML and JSON, whose first elements must be among them.
    ///
    /// ```
    /// use twinedge::io::ForeignFormat;
    ///
    /// assert_eq!(ForeignFormat::of_content(b"\x00\x00\x27\x0A"), Some(ForeignFormat::Shapefile));
    /// assert_eq!(ForeignFormat::of_content(br#"{"type": "Topology"}"#), Some(ForeignFormat::TopoJson));
    /// assert_eq!(ForeignFormat::of_content(br#"{"type": "Feature"}"#), None);
    /// ```
    #[must_use]
    pub fn of_content(head: &[u8]) -> Option<Self> {
        const SQLITE: &[u8] = b"SQLite format 3\0";
        const MAGIC: [(&[u8], ForeignFormat); 11] = [
            (b"\x00\x00\x27\x0A", ForeignFormat::Shapefile),
            (b"PAR1", ForeignFormat::Parquet),
            (b"ARROW1", ForeignFormat::Arrow),
            (b"PK\x03\x04", ForeignFormat::Zip),
            (b"PK\x05\x06", ForeignFormat::Zip),
            (b"\x1F\x8B", ForeignFormat::Gzip),
            (b"BZh", ForeignFormat::Bzip2),
            (b"\xFD7zXZ\x00", ForeignFormat::Xz),
            (b"\x28\xB5\x2F\xFD", ForeignFormat::Zstd),
            (b"\xFF\xFE", ForeignFormat::Utf16),
            (b"\xFE\xFF", ForeignFormat::Utf16),
        ];
        if head.starts_with(SQLITE) {
            // The id of the application that made the database.
            return Some(if head.get(68..72) == Some(b"GPKG") { Self::GeoPackage } else { Self::Sqlite });
        }
        if let Some((_, format)) = MAGIC.iter().find(|(magic, _)| head.starts_with(magic)) {
            return Some(*format);
        }
        // "fgb", a version, "fgb", a patch level.
        if head.starts_with(b"fgb") && head.get(4..7) == Some(b"fgb") {
            return Some(Self::FlatGeobuf);
        }
        // A length, then a blob header with its type as field 1.
        if head.get(4..15) == Some(b"\x0A\x09OSMHeader") {
            return Some(Self::OsmPbf);
        }
        if is_wkb(head) {
            return Some(Self::Wkb);
        }
        let text = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
        match text.first() {
            Some(b'<') => Some(Self::of_xml(text)),
            Some(b'{') => Self::of_json(text),
            _ => None,
        }
    }

    fn of_xml(text: &[u8]) -> Self {
        const SIGNS: [(&[u8], ForeignFormat); 8] = [
            (b"<!doctype html", ForeignFormat::Html),
            (b"<html", ForeignFormat::Html),
            (b"<kml", ForeignFormat::Kml),
            (b"<gpx", ForeignFormat::Gpx),
            (b"<osm", ForeignFormat::OsmXml),
            (b"<gml:", ForeignFormat::Gml),
            (b"opengis.net/gml", ForeignFormat::Gml),
            (b"opengis.net/kml", ForeignFormat::Kml),
        ];
        let text = text.to_ascii_lowercase();
        let found = SIGNS.iter().find(|(sign, _)| text.windows(sign.len()).any(|part| part == *sign));
        found.map_or(Self::Xml, |(_, format)| *format)
    }

    fn of_json(text: &[u8]) -> Option<Self> {
        let head = JsonHead::scan(text);
        if head.member("type") == Some("Topology") {
            Some(Self::TopoJson)
        } else if head.member("geometryType").is_some_and(|kind| kind.starts_with("esriGeometry")) {
            Some(Self::EsriJson)
        } else {
            None
        }
    }

    /// Returns advice on how to convert such a file.
    #[must_use]
    pub const fn advice(self) -> &'static str {
        match self {
            Self::Zip | Self::Gzip | Self::Bzip2 | Self::Xz | Self::Zstd => "unpack it first",
            Self::Html => "download the data file that the page links to",
            Self::Utf16 => "convert it with `iconv -f UTF-16 -t UTF-8 FILE`",
            Self::Wkb => "convert it to well-known text, with `ST_AsText` in PostGIS",
            _ => "convert it with `ogr2ogr -f GeoJSONSeq map.geojsonl FILE`",
        }
    }
}

/// Returns true if this is the start of a geometry in well-known binary, as bytes or in hexadecimal digits.
fn is_wkb(head: &[u8]) -> bool {
    let digit = |byte: u8| char::from(byte).to_digit(16).map(|digit| digit as u8);
    let from_hex = |pair: &[u8]| Some(digit(pair[0])? << 4 | digit(pair[1])?);
    let bytes = head.get(..10).and_then(|digits| digits.chunks_exact(2).map(from_hex).collect::<Option<Vec<u8>>>());
    head.get(..5).is_some_and(is_wkb_header) || bytes.is_some_and(|bytes| is_wkb_header(&bytes))
}

/// Returns true if these are a byte order and a type of geometry: 1 to 7, with dimensions as thousands (ISO) or in the three
/// highest bits (EWKB).
fn is_wkb_header(bytes: &[u8]) -> bool {
    const DIMENSIONS: u32 = 0b111 << 29;
    let kind = match *bytes {
        [0, a, b, c, d] => u32::from_be_bytes([a, b, c, d]),
        [1, a, b, c, d] => u32::from_le_bytes([a, b, c, d]),
        _ => return false,
    };
    let kind = kind & !DIMENSIONS;
    kind < 4000 && (1..=7).contains(&(kind % 1000))
}

impl fmt::Display for ForeignFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Shapefile => "a Shapefile",
            Self::GeoPackage => "a GeoPackage",
            Self::Sqlite => "a SQLite database",
            Self::FlatGeobuf => "FlatGeobuf",
            Self::Parquet => "Parquet",
            Self::Arrow => "Arrow",
            Self::OsmPbf => "OpenStreetMap data (PBF)",
            Self::Wkb => "well-known binary",
            Self::TopoJson => "TopoJSON",
            Self::EsriJson => "Esri JSON",
            Self::Kml => "KML",
            Self::Gml => "GML",
            Self::Gpx => "GPX",
            Self::OsmXml => "OpenStreetMap data (XML)",
            Self::Html => "a web page",
            Self::Xml => "XML",
            Self::Utf16 => "text in UTF-16",
            Self::Zip => "a zip archive",
            Self::Gzip => "gzip data",
            Self::Bzip2 => "bzip2 data",
            Self::Xz => "xz data",
            Self::Zstd => "Zstandard data",
        })
    }
}
