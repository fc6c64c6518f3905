//! What a format cannot hold of a layer.

use super::format::Format;
use super::model::{Dimensions, FieldKind, Geometry, Layer, Shape, Value};
use std::collections::BTreeSet;
use std::fmt;

/// Something that a format cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Loss {
    /// Ids of features.
    Ids(usize),
    /// Attributes: the columns.
    Attributes(Vec<String>),
    /// Members of objects that mean nothing to GeoJSON, by name.
    Members(Vec<String>),
    /// The name of the layer.
    Name(String),
    /// The coordinate reference system.
    Crs(String),
    /// Features without geometry, which come back with an empty one.
    NullGeometries(usize),
    /// Geometries without positions, which come back without geometry.
    EmptyGeometries(usize),
    /// Measures of positions, which come back as heights or not at all.
    Measures(usize),
    /// Geometries with positions of several dimensions: some lose numbers, or gain zeros.
    MixedDimensions(usize),
    /// Names of columns that are cut or changed: the old and the new one.
    Renamed(Vec<(String, String)>),
    /// Values of a column that come back as another type.
    Type {
        /// The column.
        column: String,
        /// What its values are.
        from: FieldKind,
        /// What they become.
        to: FieldKind,
    },
    /// Texts of a column that are cut.
    Cut {
        /// The column.
        column: String,
        /// How many values.
        count: usize,
        /// To how many bytes.
        bytes: usize,
    },
    /// Numbers of a column that are no number, infinite, or have more digits than there is room for.
    Numbers {
        /// The column.
        column: String,
        /// How many values.
        count: usize,
    },
    /// Attributes that some features do not have at all, which come back as null.
    Absent(usize),
}

impl Loss {
    /// Whether it is only of form: a value that comes back as another type, an absent one as null, the name of the layer.
    #[must_use]
    pub const fn is_minor(&self) -> bool {
        matches!(
            self,
            Self::Type { .. } | Self::Absent(_) | Self::Name(_) | Self::NullGeometries(_) | Self::EmptyGeometries(_)
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
        FieldKind::Json => "a list or an object",
    }
}

/// The first names.
fn some(names: &[String]) -> String {
    const SHOWN: usize = 8;
    let shown = names.iter().take(SHOWN).map(String::as_str).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(SHOWN) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

/// What would be lost if the layer were written in this format. O(size of the layer).
///
/// What a format holds in another form is no loss: the order of the rings of a Shapefile, a multi-polygon of one polygon that
/// becomes a polygon there, or how many digits a number is written with.
///
/// ```
/// use twinedge_formats::layer::{Feature, Format, Id, Layer, Loss, losses};
///
/// let feature = Feature { id: Some(Id::Text("A-1".into())), ..Feature::default() };
/// let layer = Layer { features: vec![feature], ..Layer::default() };
/// assert!(losses(&layer, Format::GeoJson).is_empty());
/// assert_eq!(losses(&layer, Format::Wkt), [Loss::Ids(1), Loss::NullGeometries(1)]);
/// ```
#[must_use]
pub fn losses(layer: &Layer, format: Format) -> Vec<Loss> {
    let mut found = Vec::new();
    let some_if = |n: usize, loss: fn(usize) -> Loss| (n > 0).then(|| loss(n));
    let has_columns = matches!(format, Format::GeoJson | Format::GeoJsonSeq | Format::Shapefile | Format::GeoPackage);
    let is_json = matches!(format, Format::GeoJson | Format::GeoJsonSeq);

    #[cfg(feature = "geopackage")]
    let holds_ids = is_json || (format == Format::GeoPackage && super::geopackage::holds_ids(layer));
    #[cfg(not(feature = "geopackage"))]
    let holds_ids = is_json;
    if !holds_ids {
        found.extend(some_if(layer.features.iter().filter(|f| f.id.is_some()).count(), Loss::Ids));
    }
    members(layer, format, &mut found);
    if let Some(name) =
        layer.header.name.as_ref().filter(|_| matches!(format, Format::GeoJsonSeq | Format::Wkt | Format::Wkb))
    {
        found.push(Loss::Name(name.clone()));
    }
    if let Some(crs) = &layer.header.crs {
        let is_held = match format {
            Format::GeoJson => crs.member.is_some() || crs.code.is_some() || !crs.is_other(),
            Format::GeoJsonSeq | Format::Wkt | Format::Wkb => !crs.is_other(),
            Format::Shapefile => crs.wkt.is_some() || !crs.is_other(),
            Format::GeoPackage => crs.wkt.is_some() || crs.code.is_some() || !crs.is_other(),
        };
        if !is_held {
            found.push(Loss::Crs(crs.name()));
        }
    }
    geometries(layer, format, &mut found);
    let fields = layer.fields();
    if !has_columns {
        let columns: Vec<String> = fields.iter().map(|field| field.name.to_string()).collect();
        if !columns.is_empty() {
            found.push(Loss::Attributes(columns));
        }
        return found;
    }
    match format {
        #[cfg(feature = "shapefile")]
        Format::Shapefile => super::shapefile::losses(layer, &fields, &mut found),
        Format::GeoPackage => {
            let mut taken = BTreeSet::new();
            let repeated = fields.iter().filter(|field| !taken.insert(field.name.to_lowercase()));
            let renamed: Vec<_> = repeated.map(|field| (field.name.to_string(), format!("{}_1", field.name))).collect();
            if !renamed.is_empty() {
                found.push(Loss::Renamed(renamed));
            }
            for field in fields.iter().filter(|field| field.kind == FieldKind::Json) {
                found.push(Loss::Type { column: field.name.to_string(), from: FieldKind::Json, to: FieldKind::Text });
            }
            found.extend(some_if(absent(layer, fields.len()), Loss::Absent));
        }
        _ => {
            for field in &fields {
                if matches!(field.kind, FieldKind::Date | FieldKind::DateTime | FieldKind::Bytes) {
                    let column = field.name.to_string();
                    found.push(Loss::Type { column, from: field.kind, to: FieldKind::Text });
                }
                let values = layer.features.iter().filter_map(|feature| feature.get(&field.name));
                let count = values.filter(|value| matches!(value, Value::Real(x) if !x.is_finite())).count();
                if count > 0 {
                    found.push(Loss::Numbers { column: field.name.to_string(), count });
                }
            }
        }
    }
    found
}

/// How many attributes features lack of so many columns.
pub(super) fn absent(layer: &Layer, columns: usize) -> usize {
    layer.features.iter().map(|feature| columns.saturating_sub(feature.attributes.len())).sum()
}

fn members(layer: &Layer, format: Format, found: &mut Vec<Loss>) {
    let of_features: BTreeSet<&String> = match format {
        Format::GeoJson | Format::GeoJsonSeq => BTreeSet::new(),
        // A box says nothing that the geometry does not say.
        _ => layer.features.iter().flat_map(|f| f.members.keys()).filter(|name| *name != "bbox").collect(),
    };
    let of_layer: Vec<&String> = match format {
        Format::GeoJson => Vec::new(),
        _ => layer.header.members.keys().filter(|name| *name != "bbox").collect(),
    };
    let names: Vec<String> = of_layer.into_iter().chain(of_features).cloned().collect();
    if !names.is_empty() {
        found.push(Loss::Members(names));
    }
}

fn geometries(layer: &Layer, format: Format, found: &mut Vec<Loss>) {
    let (mut null, mut empty, mut measures, mut mixed) = (0, 0, 0, 0);
    for feature in &layer.features {
        let Some(geometry) = &feature.geometry else {
            null += 1;
            continue;
        };
        empty += usize::from(geometry.shape.is_empty());
        measures += usize::from(matches!(geometry.dimensions, Dimensions::Xym | Dimensions::Xyzm));
        mixed += usize::from(is_mixed(geometry));
    }
    let some_if = |n: usize, loss: fn(usize) -> Loss| (n > 0).then(|| loss(n));
    match format {
        Format::GeoJson | Format::GeoJsonSeq => found.extend(some_if(measures, Loss::Measures)),
        Format::Wkt | Format::Wkb => {
            found.extend(some_if(null, Loss::NullGeometries));
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
        Format::GeoPackage => found.extend(some_if(mixed, Loss::MixedDimensions)),
        Format::Shapefile => {
            found.extend(some_if(empty, Loss::EmptyGeometries));
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
    }
}

/// Whether positions have another number of dimensions than the geometry says.
fn is_mixed(geometry: &Geometry) -> bool {
    if let Shape::Collection(parts) = &geometry.shape {
        return parts.iter().any(|part| part.dimensions != geometry.dimensions || is_mixed(part));
    }
    let mut found = false;
    geometry.shape.visit(&mut |position| found |= position.more.len() != geometry.dimensions.more());
    found
}
