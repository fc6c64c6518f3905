//! The reason why there is no report.

use crate::textbook::TablesError;
use crate::words::{counted, grouped};
use crate::words::{in_words, made_without};
use std::io;
use twinedge_coverage::CoverageError;
use twinedge_coverage::tile::{AuditError, GridError, Tile};
use twinedge_layers::io::ReadSummary;
use twinedge_map::BuildError;
#[cfg(feature = "geodesic")]
use twinedge_sphere::DrawingError;

/// The reason why an input has no report. Messages do not contain the input's name.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The input could not be read.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The input could not be read as a layer.
    #[error(transparent)]
    Layer(#[from] twinedge_layers::ReadError),
    /// No map can be built from the input.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A tile has no summary, or summaries of tiles are missing or cannot be merged.
    #[error(transparent)]
    Tiles(#[from] AuditError<io::Error>),
    /// The summaries do not cover all tiles.
    #[error("{} missing: {}", if *count == 1 { "1 tile is".to_owned() } else { format!("{} tiles are", grouped(*count)) }, in_words(tiles, *count))]
    Missing {
        /// The first missing tiles.
        tiles: Vec<Tile>,
        /// The number of all missing tiles.
        count: u64,
    },
    /// The tiles were made of another layer.
    #[error("the tiles were made of another layer: {0}")]
    OtherLayer(String),
    /// The tiles do not say what features cover.
    #[error("the tiles do not say what features cover: {0}")]
    Unjudged(String),
    /// Some tiles were made with their edges cut, and others without.
    #[error("{}, and others with cuts", made_without(tiles))]
    WithoutCuts {
        /// The tiles without cut edges.
        tiles: Vec<Tile>,
    },
    /// The grid is invalid.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// The input could not be read as a mesh.
    #[error(transparent)]
    Mesh(#[from] twinedge_meshes::ReadError),
    /// The input could not be read as a topology of PostGIS.
    #[error(transparent)]
    Postgis(#[from] twinedge_postgis::ReadError),
    /// The input could not be read as the tables of a textbook.
    #[error(transparent)]
    Textbook(#[from] TablesError),
    /// A line of a file of tables could not be read.
    #[error("line {line}: {message}")]
    Table {
        /// The line, counted from 1.
        line: u64,
        /// The error.
        message: String,
    },
    /// The options name a layer, but the file has only one.
    #[error(
        "there is no layer {layer:?}: this is {what}, and --layer is for files with several layers: GeoPackage, TopoJSON, and zip archives"
    )]
    NoLayer {
        /// The requested layer.
        layer: String,
        /// The input, in words.
        what: String,
    },
    /// No feature has a value in the requested column.
    #[error("no feature has a value in the column {column}; {}", there_are(known))]
    NoColumn {
        /// The column.
        column: String,
        /// The first known columns.
        known: Vec<String>,
    },
    /// No feature can receive the gaps.
    #[error("--gaps-to: {0}")]
    GapsTo(#[from] twinedge_layers::clean::GapsToError),
    /// The layer could not be cleaned.
    #[error(transparent)]
    Clean(#[from] twinedge_layers::clean::CleanError),
    /// No feature has one of the values that name parents.
    #[error(
        "no feature has one of the values of {column} as its {key}, so that no parent is known; COLUMN=KEY says in which column parents \
have them, and --against which layer they are in"
    )]
    NoParents {
        /// The column of the parts.
        column: String,
        /// The key of the parents.
        key: String,
    },
    /// Two features have the same key, so the parent is ambiguous.
    #[error("two features have the {key} {value}, by which parts name their parents")]
    TwoParents {
        /// The key of the parents.
        key: String,
        /// The value.
        value: String,
    },
    /// The other layer has no polygons.
    #[error("{0} has no polygons, and the rules between layers are about these")]
    NoAreas(String),
    /// The other layer could not be read.
    #[error("{input}: {why}")]
    Against {
        /// The layer's name.
        input: String,
        /// The reason.
        why: Box<Self>,
    },
    /// The layers cannot be compared.
    #[error("the layers cannot be compared: {0}")]
    Layers(#[from] CoverageError),
    /// The file has no lines or polygons to make a map of.
    #[error("a map is made of lines and polygons, and this file has {}; --allow-empty accepts it", instead(.0))]
    NoMap(Box<ReadSummary>),
    /// The tiles contain only points: there are no lines or polygons to make a map of.
    #[error("a map is made of lines and polygons, and these tiles have none; --allow-empty accepts it")]
    NoEdges,
    /// Lengths along the earth were requested, but the coordinates are not longitudes and latitudes.
    #[error(
        "--geodesic and --edges geodesic are for longitudes and latitudes, and the coordinates are not in their range, or the file names another coordinate \
reference system"
    )]
    NotDegrees,
    /// Edges along great circles do not go together with another option.
    #[error("--edges geodesic and {0} do not go together")]
    NotGeodesic(&'static str),
    /// The file says that its edges are great circles, and tiles cannot judge them.
    #[error("edges are {0} by the file, and straight in tiles: --edges straight judges them so")]
    NotStraight(String),
    /// Great circles cannot be drawn.
    #[cfg(feature = "geodesic")]
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// The edges are great circles, and the crate was built without the feature that judges them.
    #[error(
        "edges along great circles are judged with the feature `geodesic` of twinedge-report, which is off (the program has it with `--features full`); \
`--edges straight` judges the edges as straight on the map"
    )]
    GeodesicOff,
    /// Meshes and files of tables are not drawn.
    #[error("{0} is not drawn, so that there is no page and no layer of findings")]
    NoPicture(&'static str),
    /// The input is a file of tables: each table has its own verdict.
    #[error("a file of tables has a report in text and JSON only")]
    NoReport,
    /// The findings could not be written as a layer.
    #[error(transparent)]
    Write(#[from] twinedge_layers::WriteError),
    /// The report could not be written as JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

fn there_are(columns: &[String]) -> String {
    if columns.is_empty() { "there are no columns".to_owned() } else { format!("there are {}", columns.join(", ")) }
}

/// The contents of a file from which no map can be built.
fn instead(read: &ReadSummary) -> String {
    let features = counted(read.features, "feature");
    match (read.features, read.points) {
        (0, _) => "no features".to_owned(),
        (_, 0) => format!("{features}, none with a geometry"),
        (_, points) => format!("{features} with {} and nothing else", counted(points, "point")),
    }
}

impl From<twinedge_layers::FileError> for Error {
    fn from(error: twinedge_layers::FileError) -> Self {
        match error {
            twinedge_layers::FileError::Io(error) => error.into(),
            twinedge_layers::FileError::Read(error) => error.into(),
            twinedge_layers::FileError::Clean(error) => error.into(),
            // A variant for these would enlarge programs that never read files.
            other => io::Error::other(other).into(),
        }
    }
}
