//! Formats that are recognised but not supported, so that messages can name them and suggest a remedy.

use super::format::{is_geopackage, is_sqlite};
use super::json_head::JsonHead;
use core::fmt;
use std::path::Path;

/// A format recognised by its first bytes that is not one of [`Format`](super::Format).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ForeignFormat {
    /// A database of `SQLite`, perhaps with `SpatiaLite`.
    Sqlite,
    /// Apache Arrow or Feather.
    Arrow,
    /// `OpenStreetMap` data as protocol buffers.
    OsmPbf,
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
    /// A file geodatabase of Esri, which is a folder.
    FileGeodatabase,
    /// glTF, as text or binary.
    Gltf,
    /// PLY: a mesh, and no map.
    Ply,
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
    /// Returns the format of a file that starts with these bytes, if it is one of these. O(bytes); a few hundred suffice except
    /// for XML and JSON, whose first elements must be included.
    ///
    /// ```
    /// use twinedge_layers::io::ForeignFormat;
    ///
    /// assert_eq!(ForeignFormat::of_content(b"ARROW1"), Some(ForeignFormat::Arrow));
    /// assert_eq!(ForeignFormat::of_content(br#"{"type": "Feature"}"#), None);
    /// ```
    #[must_use]
    pub fn of_content(head: &[u8]) -> Option<Self> {
        const MAGIC: [(&[u8], ForeignFormat); 12] = [
            (b"ARROW1", ForeignFormat::Arrow),
            (b"glTF", ForeignFormat::Gltf),
            (b"ply\n", ForeignFormat::Ply),
            (b"ply\r", ForeignFormat::Ply),
            (b"PK\x03\x04", ForeignFormat::Zip),
            (b"PK\x05\x06", ForeignFormat::Zip),
            (b"\x1F\x8B", ForeignFormat::Gzip),
            (b"BZh", ForeignFormat::Bzip2),
            (b"\xFD7zXZ\x00", ForeignFormat::Xz),
            (b"\x28\xB5\x2F\xFD", ForeignFormat::Zstd),
            (b"\xFF\xFE", ForeignFormat::Utf16),
            (b"\xFE\xFF", ForeignFormat::Utf16),
        ];
        if is_sqlite(head) && !is_geopackage(head) {
            return Some(Self::Sqlite);
        }
        if let Some((_, format)) = MAGIC.iter().find(|(magic, _)| head.starts_with(magic)) {
            return Some(*format);
        }
        // A length, then a blob header with its type as field 1.
        if head.get(4..15) == Some(b"\x0A\x09OSMHeader") {
            return Some(Self::OsmPbf);
        }
        let text = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
        match text.first() {
            Some(b'<') => Some(Self::of_xml(text)),
            Some(b'{') => Self::of_json(text),
            _ => None,
        }
    }

    /// Returns the format of a folder, by its name.
    ///
    /// ```
    /// use twinedge_layers::io::ForeignFormat;
    ///
    /// assert_eq!(ForeignFormat::of_folder("cadastre.gdb"), Some(ForeignFormat::FileGeodatabase));
    /// ```
    #[must_use]
    pub fn of_folder(path: impl AsRef<Path>) -> Option<Self> {
        let is_gdb = path.as_ref().extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gdb"));
        is_gdb.then_some(Self::FileGeodatabase)
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
        const OF_GLTF: &[u8] = b"\"bufferViews\"";
        let is_esri = |kind: &str| kind.starts_with("esriGeometry");
        let head = JsonHead::scan(text);
        if head.member("geometryType").is_some_and(is_esri) {
            return Some(Self::EsriJson);
        }
        let is_gltf = head.member("type").is_none() && text.windows(OF_GLTF.len()).any(|word| word == OF_GLTF);
        is_gltf.then_some(Self::Gltf)
    }

    /// Returns advice on converting such a file.
    #[must_use]
    pub const fn advice(self) -> &'static str {
        match self {
            Self::Zip | Self::Gzip | Self::Bzip2 | Self::Xz | Self::Zstd => "unpack it first",
            Self::Gltf => "export it as OBJ, PLY or STL",
            Self::Ply => {
                "a mesh is audited, by `twinedge audit FILE`, with the feature `ply` of twinedge-meshes (the program has it with `--features full`)"
            }
            Self::Html => "download the data file that the page links to",
            Self::Utf16 => "convert it with `iconv -f UTF-16 -t UTF-8 FILE`",
            Self::OsmPbf => "only the boundaries in it are, by `twinedge audit FILE --boundaries admin_level=6`",
            _ => "convert it with `ogr2ogr -f GeoJSONSeq map.geojsonl FILE`",
        }
    }
}

impl fmt::Display for ForeignFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sqlite => "a SQLite database",
            Self::Ply => "a mesh in PLY",
            Self::Arrow => "Arrow",
            Self::OsmPbf => "OpenStreetMap data (PBF)",
            Self::EsriJson => "Esri JSON",
            Self::Kml => "KML",
            Self::Gml => "GML",
            Self::Gpx => "GPX",
            Self::OsmXml => "OpenStreetMap data (XML)",
            Self::Html => "a web page",
            Self::Xml => "XML",
            Self::FileGeodatabase => "a file geodatabase of Esri",
            Self::Gltf => "glTF",
            Self::Utf16 => "text in UTF-16",
            Self::Zip => "a zip archive",
            Self::Gzip => "gzip data",
            Self::Bzip2 => "bzip2 data",
            Self::Xz => "xz data",
            Self::Zstd => "Zstandard data",
        })
    }
}
