//! The reasons why a layer could not be read or written.

use super::loss::Loss;
use crate::io::{ForeignFormat, Format, TextPlace};
use std::{fmt, io};

/// The reason why a layer could not be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file or stream itself could not be read.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The text is not valid GeoJSON or well-known text.
    #[error(transparent)]
    Text(#[from] crate::io::ReadError),
    /// The content is not valid in its format.
    #[error("{format}: {place}: {cause}")]
    Content {
        /// The format.
        format: Format,
        /// The place.
        place: Place,
        /// The error.
        cause: Cause,
    },
    /// `SQLite` refused the file.
    #[error("GeoPackage: {message}")]
    Database {
        /// The message.
        message: String,
    },
    /// The file has several layers and none was selected, or has no layer of the selected name.
    #[error("{}", choose_layer(wanted.as_deref(), layers))]
    Layers {
        /// The selected name.
        wanted: Option<String>,
        /// The existing layers.
        layers: Vec<String>,
    },
    /// The format consists of several files, or needs random access, but this is a stream.
    #[error("{0} is read from a file, not from a stream")]
    NeedsFile(Format),
    /// The file contains only white space.
    #[error("the input is empty")]
    Empty,
    /// The first bytes belong to a known format that is not supported.
    #[error("this looks like {0}, which is not read here: {advice}", advice = .0.advice())]
    Foreign(ForeignFormat),
    /// The content is of no known format.
    #[error("the format is not recognised: {}", what_is_read())]
    Unrecognised,
    /// The crate was built without the feature that reads this format.
    #[error(
        "{0} is read with the feature `{feature}` of twinedge-layers, which is off (the program has it with `--features full`)",
        feature = .0.feature()
    )]
    FeatureOff(Format),
    /// The layer is in an archive that could not be unpacked.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// The callback for features refused one.
    #[error("{0}")]
    Refused(Box<dyn std::error::Error + Send + Sync>),
}

impl ReadError {
    /// Creates the error by which a callback stops reading.
    pub fn refused(error: impl std::error::Error + Send + Sync + 'static) -> Self {
        Self::Refused(Box::new(error))
    }
}

/// The reason why an archive could not be unpacked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ArchiveError {
    /// The archive is truncated, changed or encrypted, or packed by an unknown method.
    #[error("the archive cannot be unpacked: {0}")]
    Damaged(String),
    /// The archive would fill the disk.
    #[error("the archive expands to more than {times} times its size: unpack it first")]
    Expands {
        /// The allowed factor.
        times: u64,
    },
    /// No file in the archive has the name of a layer.
    #[error("the archive has no layer of a format that is read here")]
    NoLayer,
    /// The crate was built without the feature that unpacks archives.
    #[error(
        "archives are unpacked with the feature `archive` of twinedge-layers, which is off (the program has it with `--features full`)"
    )]
    FeatureOff,
}

/// Lists the formats that this build reads, and the command that converts to one of them.
fn what_is_read() -> String {
    let all = [
        (cfg!(feature = "geojson"), "GeoJSON"),
        (cfg!(feature = "topojson"), "TopoJSON"),
        (cfg!(feature = "wkt"), "well-known text and binary"),
        (cfg!(feature = "shapefile"), "Shapefiles"),
        (cfg!(feature = "geopackage"), "GeoPackages"),
        (cfg!(feature = "geoparquet"), "GeoParquet"),
        (cfg!(feature = "flatgeobuf"), "FlatGeobuf"),
    ];
    let read: Vec<&str> = all.into_iter().filter(|(is_on, _)| *is_on).map(|(_, name)| name).collect();
    let names = match &read[..] {
        [] => "no format is".to_owned(),
        [one] => format!("{one} is"),
        [all @ .., last] => format!("{} and {last} are", all.join(", ")),
    };
    let output = if cfg!(feature = "geopackage") { "GPKG map.gpkg" } else { "GeoJSONSeq map.geojsonl" };
    format!("{names} read; convert others with `ogr2ogr -f {output} FILE`")
}

fn choose_layer(wanted: Option<&str>, layers: &[String]) -> String {
    let there_are = match layers {
        [] => "there are no layers of features".to_owned(),
        layers => format!("there are {}", layers.join(", ")),
    };
    match wanted {
        Some(wanted) => format!("there is no layer {wanted}; {there_are}"),
        None if layers.is_empty() => there_are,
        None => format!("the file has several layers, and one must be chosen (--layer): {there_are}"),
    }
}

/// A place in a non-text file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Place {
    /// The header, or the file as a whole.
    Header,
    /// A feature, counted from 0.
    Feature(usize),
    /// A line, counted from 1.
    Line(usize),
    /// A byte of a text.
    Text(TextPlace),
    /// An arc of TopoJSON, counted from 0.
    Arc(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Header => f.write_str("header"),
            Self::Feature(number) => write!(f, "feature {number}"),
            Self::Line(number) => write!(f, "line {number}"),
            Self::Text(place) => place.fmt(f),
            Self::Arc(number) => write!(f, "arc {number}"),
        }
    }
}

/// A fault in a non-text file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// The data ends where this part should follow.
    #[error("the data ends within {0}")]
    Truncated(&'static str),
    /// Content that the format does not allow, or that is not supported.
    #[error("{0}")]
    Invalid(String),
    /// A count exceeds the data.
    #[error("{count} {what} are more than the data can hold")]
    TooMany {
        /// The noun for the counted items.
        what: &'static str,
        /// The stated number.
        count: u64,
    },
    /// Bytes follow the end of a geometry.
    #[error("{0} bytes follow the end of the geometry")]
    Trailing(usize),
    /// Collections are nested too deep.
    #[error("nested too deep")]
    TooDeep,
    /// The index of an arc of TopoJSON is out of range.
    #[error("the index {index} is none of an arc: there are {arcs} arcs")]
    NoSuchArc {
        /// The index: for a negative one, its complement is the number of the arc.
        index: i64,
        /// The number of arcs.
        arcs: usize,
    },
    /// Arcs of TopoJSON are repeated so often that features would have more positions than this.
    #[error("arcs are repeated so often that there are more than {limit} positions")]
    Expanded {
        /// 2²⁰ plus 16 times the positions of all arcs.
        limit: u64,
    },
    /// A text is not valid in the character set of the file.
    #[error("a text is not {0}")]
    Charset(String),
    /// A text has letters beyond ASCII, and the character set named by the file is unknown.
    #[error("the character set {0:?} is not known here: name another in the file .cpg, such as UTF-8 or 1252")]
    UnknownCharset(String),
    /// A geometry, or a box of an index, reaches out of the enclosing box in the file: reading a window by boxes would miss it.
    #[error("it reaches out of the box that the file has around it, so windows cannot be read by boxes")]
    OutOfBox,
    /// A file that belongs to it is missing.
    #[error("the file {0} is missing")]
    Missing(String),
}

/// The reason why a layer could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The file could not be written.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// `SQLite` could not write it.
    #[error("GeoPackage: {message}")]
    Database {
        /// The message.
        message: String,
    },
    /// The format cannot hold the whole layer, and losses are not allowed.
    #[error("{format} cannot hold all of it: {}", list(losses))]
    Loss {
        /// The format.
        format: Format,
        /// The losses.
        losses: Vec<Loss>,
    },
    /// The format cannot hold this content at all.
    #[error("{format} cannot hold {what}")]
    Impossible {
        /// The format.
        format: Format,
        /// A description.
        what: String,
    },
    /// The crate was built without the feature that writes this format.
    #[error(
        "{0} is written with the feature `{feature}` of twinedge-layers, which is off (the program has it with `--features full`)",
        feature = .0.feature()
    )]
    FeatureOff(Format),
    /// The format can be read but not written.
    #[error("{0} is read here, but not written")]
    ReadOnly(Format),
    /// The format consists of several files, or needs random access, but this is a stream.
    #[error("{0} is written to a file, not to a stream")]
    NeedsFile(Format),
}

fn list(losses: &[Loss]) -> String {
    losses.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
