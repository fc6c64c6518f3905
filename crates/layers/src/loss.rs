//! The parts of a layer that a format cannot hold.

use super::model::{FieldKind, Layer};
use std::fmt;

/// A part of a layer that a format cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Loss {
    /// Ids of features.
    Ids(usize),
    /// Attributes: the columns.
    Attributes(Vec<String>),
    /// Foreign members of GeoJSON objects, by name.
    Members(Vec<String>),
    /// The name of the layer.
    Name(String),
    /// The coordinate reference system.
    Crs(String),
    /// Features without geometry, which are read back with an empty one.
    NullGeometries(usize),
    /// Geometries without positions, which are read back without geometry.
    EmptyGeometries(usize),
    /// Measures of positions, which are read back as heights or not at all.
    Measures(usize),
    /// Empty points, lines and rings among others in a geometry.
    EmptyParts(usize),
    /// Open rings, which are closed.
    OpenRings(usize),
    /// Geometries with positions of several dimensions: some lose numbers, or gain zeros.
    MixedDimensions(usize),
    /// Names of columns that are cut or changed: the old and the new name.
    Renamed(Vec<(String, String)>),
    /// Values of a column that are read back as another type.
    Type {
        /// The column.
        column: String,
        /// The type of its values.
        from: FieldKind,
        /// The type that they become.
        to: FieldKind,
    },
    /// Texts of a column that are cut.
    Cut {
        /// The column.
        column: String,
        /// The number of values.
        count: usize,
        /// The maximum number of bytes.
        bytes: usize,
    },
    /// Numbers of a column that are NaN, infinite, or have too many digits.
    Numbers {
        /// The column.
        column: String,
        /// The number of values.
        count: usize,
    },
    /// Attributes that some features don't have, which are read back as null.
    Absent(usize),
}

impl Loss {
    /// Returns true if only the form is lost: another type of a value, null for an absent one, the name of the layer, an open
    /// ring that is closed.
    #[must_use]
    pub const fn is_minor(&self) -> bool {
        matches!(
            self,
            Self::Type { .. }
                | Self::Absent(_)
                | Self::Name(_)
                | Self::NullGeometries(_)
                | Self::EmptyGeometries(_)
                | Self::EmptyParts(_)
                | Self::OpenRings(_)
        )
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ids(n) => write!(f, "the ids of {n} features"),
            Self::Attributes(columns) => write!(f, "attributes ({})", some(columns)),
            Self::Members(names) => write!(f, "foreign members ({})", some(names)),
            Self::Name(name) => write!(f, "the name of the layer ({name})"),
            Self::Crs(name) => write!(f, "the coordinate reference system ({name})"),
            Self::NullGeometries(n) => write!(f, "that {n} features have no geometry"),
            Self::EmptyGeometries(n) => write!(f, "that {n} geometries are empty"),
            Self::Measures(n) => write!(f, "that {n} geometries have measures (M)"),
            Self::EmptyParts(1) => write!(f, "an empty part of a geometry"),
            Self::EmptyParts(n) => write!(f, "{n} empty parts of geometries"),
            Self::OpenRings(1) => write!(f, "an open ring, which is closed"),
            Self::OpenRings(n) => write!(f, "{n} open rings, which are closed"),
            Self::MixedDimensions(n) => write!(f, "that positions of {n} geometries differ in their dimensions"),
            Self::Renamed(names) => {
                let names: Vec<String> = names.iter().map(|(old, new)| format!("{old} becomes {new}")).collect();
                write!(f, "names of columns ({})", some(&names))
            }
            Self::Type { column, from, to } => write!(f, "that {column} is {}: it becomes {}", kind(*from), kind(*to)),
            Self::Cut { column, count, bytes } => {
                write!(f, "{count} texts of {column}, which are cut to {bytes} bytes")
            }
            Self::Numbers { column, count } => write!(f, "{count} numbers of {column}"),
            Self::Absent(n) => write!(f, "that {n} attributes are absent, which become null"),
        }
    }
}

const fn kind(kind: FieldKind) -> &'static str {
    match kind {
        FieldKind::Bool => "a truth value",
        FieldKind::Integer => "a whole number",
        FieldKind::Real => "a number",
        FieldKind::Text => "a text",
        FieldKind::Date => "a date",
        FieldKind::DateTime => "a date with a time",
        FieldKind::Bytes => "bytes",
        FieldKind::Json => "a list, an object or a whole number above 2^63",
    }
}

fn some(names: &[String]) -> String {
    const SHOWN: usize = 8;
    let shown = names.iter().take(SHOWN).map(String::as_str).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(SHOWN) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

/// Returns the number of attributes that features lack, among this number of columns.
pub(super) fn absent(layer: &Layer, columns: usize) -> usize {
    layer.features.iter().map(|feature| columns.saturating_sub(feature.attributes.len())).sum()
}
