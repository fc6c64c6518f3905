//! The formats of maps that are read, and how to tell which one a file has.

use super::json_head::JsonHead;
use core::fmt;
use std::path::Path;

/// A format that [`read`](super::read()) takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)): one object, with the feature `geojson`.
    GeoJson,
    /// GeoJSON objects one after the other, usually one per line: newline-delimited GeoJSON, or text sequences
    /// ([RFC 8142](https://www.rfc-editor.org/rfc/rfc8142)), with the feature `geojson`.
    GeoJsonSeq,
    /// Well-known text, a geometry per line, with the feature `wkt`.
    Wkt,
}

impl Format {
    /// The format that the extension of a file name stands for; none, if the content must tell, as for `.json`.
    ///
    /// ```
    /// use twinedge::io::Format;
    ///
    /// assert_eq!(Format::of_path("parcels.WKT"), Some(Format::Wkt));
    /// assert_eq!(Format::of_path("parcels.geojsonl"), Some(Format::GeoJsonSeq));
    /// assert_eq!(Format::of_path("parcels.shp"), None);
    /// ```
    #[must_use]
    pub fn of_path(path: impl AsRef<Path>) -> Option<Self> {
        let extension = path.as_ref().extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "geojson" => Some(Self::GeoJson),
            "geojsonl" | "geojsons" | "geojsonseq" | "ndgeojson" | "ndjson" | "jsonl" => Some(Self::GeoJsonSeq),
            "wkt" => Some(Self::Wkt),
            _ => None,
        }
    }

    /// The format of a text that starts with these bytes. A sequence of objects is told from a single one if the first object
    /// ends among these bytes. O(bytes).
    ///
    /// ```
    /// use twinedge::io::Format;
    ///
    /// assert_eq!(Format::of_content(br#"{"type": "Feature", "#), Some(Format::GeoJson));
    /// assert_eq!(Format::of_content(b"{\"type\": \"Feature\"}\n{\"type\": "), Some(Format::GeoJsonSeq));
    /// assert_eq!(Format::of_content(b"# parcels\nPolygon ((0 0, 1 0, 1 1, 0 0))"), Some(Format::Wkt));
    /// assert_eq!(Format::of_content(b"id,name\n1,a\n"), None);
    /// ```
    #[must_use]
    pub fn of_content(head: &[u8]) -> Option<Self> {
        let text = head.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(head).trim_ascii_start();
        match text.first()? {
            b'{' if JsonHead::scan(text).goes_on() => Some(Self::GeoJsonSeq),
            // An array is no map, but the reader says what is expected.
            b'{' | b'[' => Some(Self::GeoJson),
            0x1E => Some(Self::GeoJsonSeq),
            b'#' => Some(Self::Wkt),
            _ => starts_with_geometry(text).then_some(Self::Wkt),
        }
    }

    /// The feature of the library that reads it.
    pub(super) const fn feature(self) -> &'static str {
        match self {
            Self::GeoJson | Self::GeoJsonSeq => "geojson",
            Self::Wkt => "wkt",
        }
    }
}

/// Returns true if a text starts with the name of a type of geometry, as well-known text does, perhaps after an `SRID`.
fn starts_with_geometry(text: &[u8]) -> bool {
    const TYPES: [&str; 9] = [
        "POINT",
        "LINESTRING",
        "LINEARRING",
        "POLYGON",
        "MULTIPOINT",
        "MULTILINESTRING",
        "MULTIPOLYGON",
        "GEOMETRYCOLLECTION",
        "SRID",
    ];
    let letters = text.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let word = text[..letters].to_ascii_uppercase();
    // The dimensions may follow without a space.
    TYPES.iter().any(|name| matches!(word.strip_prefix(name.as_bytes()), Some(b"" | b"Z" | b"M" | b"ZM")))
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::GeoJson => "GeoJSON",
            Self::GeoJsonSeq => "a GeoJSON text sequence",
            Self::Wkt => "well-known text",
        })
    }
}
