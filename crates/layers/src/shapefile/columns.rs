//! The limits of a Shapefile: one kind of geometry, and columns of fixed width with names of ten bytes.

use super::super::loss::{Loss, absent};
use super::super::model::{Dimensions, Field, FieldKind, Layer, Shape, Value, kind_of};
use std::collections::HashSet;
use std::sync::Arc;

const NAME: usize = 10;

const TEXT: usize = 254;

/// The bytes of a decimal number, and its digits after the point.
const REAL: (usize, usize) = (24, 15);

/// The kind of geometry of a file, without dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Base {
    Point,
    MultiPoint,
    Line,
    Polygon,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct ShapeKind {
    pub(super) base: Base,
    pub(super) has_z: bool,
    pub(super) has_m: bool,
}

impl ShapeKind {
    pub(super) const fn code(self) -> i32 {
        let base = match self.base {
            Base::Point => 1,
            Base::Line => 3,
            Base::Polygon => 5,
            Base::MultiPoint => 8,
        };
        base + if self.has_z {
            10
        } else if self.has_m {
            20
        } else {
            0
        }
    }
}

/// Returns the one kind that holds all geometries, or else the part that a file cannot hold.
pub(super) fn shape_kind(layer: &Layer) -> Result<ShapeKind, String> {
    let mut kind: Option<ShapeKind> = None;
    for geometry in layer.features.iter().filter_map(|feature| feature.geometry.as_ref()) {
        let base = match geometry.shape {
            _ if geometry.shape.is_empty() => continue,
            Shape::Point(_) => Base::Point,
            Shape::MultiPoint(_) => Base::MultiPoint,
            Shape::Line(_) | Shape::MultiLine(_) => Base::Line,
            Shape::Polygon(_) | Shape::MultiPolygon(_) => Base::Polygon,
            Shape::Collection(_) => return Err("collections of geometries".to_owned()),
        };
        let has_z = matches!(geometry.dimensions, Dimensions::Xyz | Dimensions::Xyzm);
        let has_m = matches!(geometry.dimensions, Dimensions::Xym | Dimensions::Xyzm);
        kind = Some(match kind {
            None => ShapeKind { base, has_z, has_m },
            Some(known) if known.base != base => {
                return Err(format!("{} and {} in one file", name(known.base), name(base)));
            }
            Some(known) => ShapeKind { base, has_z: known.has_z || has_z, has_m: known.has_m || has_m },
        });
    }
    Ok(kind.unwrap_or(ShapeKind { base: Base::Polygon, has_z: false, has_m: false }))
}

const fn name(base: Base) -> &'static str {
    match base {
        Base::Point => "points",
        Base::MultiPoint => "multi-points",
        Base::Line => "lines",
        Base::Polygon => "polygons",
    }
}

#[derive(Clone, Debug)]
pub(super) struct Column {
    pub(super) source: Arc<str>,
    pub(super) name: String,
    /// `C`, `N`, `L` or `D`.
    pub(super) kind: u8,
    pub(super) width: u8,
    pub(super) decimals: u8,
}

/// Returns the columns of the table, and the values that they cannot hold.
pub(super) fn plan(layer: &Layer, fields: &[Field]) -> (Vec<Column>, Vec<Loss>) {
    let mut losses = Vec::new();
    let mut renamed = Vec::new();
    let mut taken = HashSet::new();
    let columns = fields.iter().map(|field| {
        let name = unique(&field.name, &mut taken);
        if name != *field.name {
            renamed.push((field.name.to_string(), name.clone()));
        }
        column(layer, field, name, &mut losses)
    });
    let columns = columns.collect();
    if !renamed.is_empty() {
        losses.insert(0, Loss::Renamed(renamed));
    }
    (columns, losses)
}

/// Returns a name of at most ten bytes that no other column has, ignoring case.
fn unique(name: &str, taken: &mut HashSet<String>) -> String {
    let clean: String = name.chars().filter(|c| *c != '\0').collect();
    let cut = |length: usize| {
        let end = (0..=length.min(clean.len())).rev().find(|end| clean.is_char_boundary(*end)).unwrap_or_default();
        clean[..end].to_owned()
    };
    let mut short = if clean.is_empty() { "field".to_owned() } else { cut(NAME) };
    for number in 1.. {
        if taken.insert(short.to_lowercase()) {
            break;
        }
        let suffix = format!("_{number}");
        short = cut(NAME.saturating_sub(suffix.len())) + &suffix;
    }
    short
}

fn column(layer: &Layer, field: &Field, name: String, losses: &mut Vec<Loss>) -> Column {
    let source = field.name.clone();
    let values = || layer.features.iter().filter_map(|feature| feature.get(&field.name));
    let mut becomes = |to: FieldKind| {
        if to != field.kind {
            losses.push(Loss::Type { column: field.name.to_string(), from: field.kind, to });
        }
    };
    // A column with values that do not fit its type becomes a text column.
    let fits = |value: &Value| match kind_of(value) {
        None => true,
        Some(FieldKind::Integer) => matches!(field.kind, FieldKind::Integer | FieldKind::Real),
        Some(kind) => kind == field.kind,
    };
    let kind = if values().all(fits) { field.kind } else { FieldKind::Text };
    match kind {
        FieldKind::Bool => Column { source, name, kind: b'L', width: 1, decimals: 0 },
        FieldKind::Date if values().all(|value| digits_of_date(value).is_some()) => {
            Column { source, name, kind: b'D', width: 8, decimals: 0 }
        }
        FieldKind::Integer => {
            let longest = values().filter_map(Value::text).map(|text| text.len()).max().unwrap_or(1);
            let width = field.width.unwrap_or(0).clamp(longest.max(1), longest.max(REAL.0)) as u8;
            Column { source, name, kind: b'N', width, decimals: 0 }
        }
        FieldKind::Real => {
            let count = values().filter(|value| matches!(value, Value::Real(x) if !x.is_finite())).count();
            if count > 0 {
                losses.push(Loss::Numbers { column: field.name.to_string(), count });
            }
            let given = field.width.zip(field.decimals).filter(|(width, decimals)| *width <= TEXT && decimals < width);
            let fits = |(width, decimals): &(usize, usize)| {
                values().all(|value| fixed(value, *width, *decimals).is_some_and(|text| text.len() <= *width))
            };
            let (width, decimals) = given.filter(fits).unwrap_or(REAL);
            Column { source, name, kind: b'N', width: width as u8, decimals: decimals as u8 }
        }
        _ => {
            becomes(FieldKind::Text);
            let longest = values().filter_map(Value::text).map(|text| text.len()).max().unwrap_or(1);
            let count = values().filter_map(Value::text).filter(|text| text.len() > TEXT).count();
            if count > 0 {
                losses.push(Loss::Cut { column: field.name.to_string(), count, bytes: TEXT });
            }
            let width = field.width.unwrap_or(0).max(longest).clamp(1, TEXT) as u8;
            Column { source, name, kind: b'C', width, decimals: 0 }
        }
    }
}

/// Returns a number with `decimals` digits after the point, if that is exactly the number.
fn fixed(value: &Value, width: usize, decimals: usize) -> Option<String> {
    let number = match value {
        Value::Real(number) => *number,
        Value::Integer(number) => return Some(format!("{number}.{:0decimals$}", 0)).filter(|text| text.len() <= width),
        _ => return Some(String::new()),
    };
    let text = format!("{number:.decimals$}");
    (text.len() <= width && text.parse() == Ok(number)).then_some(text)
}

/// Returns the digits of a date, as in the table; empty for null.
fn digits_of_date(value: &Value) -> Option<String> {
    let Value::Date(date) = value else { return Some(String::new()) };
    let digits: String = date.split('-').collect();
    let is_date = date.len() == 10 && digits.len() == 8 && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_date.then_some(digits)
}

/// Returns the text of a value in its column, at most as wide as the column.
pub(super) fn text(column: &Column, value: &Value) -> String {
    let width = usize::from(column.width);
    match (column.kind, value) {
        (_, Value::Null) => String::new(),
        (b'L', Value::Bool(value)) => if *value { "T" } else { "F" }.to_owned(),
        (b'D', date) => digits_of_date(date).unwrap_or_default(),
        (b'N', Value::Real(number)) if !number.is_finite() => String::new(),
        (b'N', Value::Real(number)) => {
            let plain = || Some(number.to_string()).filter(|text| text.len() <= width);
            fixed(value, width, usize::from(column.decimals)).or_else(plain).unwrap_or_else(|| format!("{number:e}"))
        }
        (_, value) => {
            let mut text = value.text().unwrap_or_default();
            if text.len() > width {
                let end = (0..=width).rev().find(|end| text.is_char_boundary(*end)).unwrap_or_default();
                text.truncate(end);
            }
            text
        }
    }
}

/// Adds the columns and geometries that a Shapefile cannot hold.
pub(crate) fn losses(layer: &Layer, fields: &[Field], found: &mut Vec<Loss>) {
    found.extend(plan(layer, fields).1);
    let absent = absent(layer, fields.len());
    if absent > 0 {
        found.push(Loss::Absent(absent));
    }
    if let Ok(kind) = shape_kind(layer) {
        let of_file = Dimensions::with(kind.has_z, kind.has_m);
        let geometries = layer.features.iter().filter_map(|feature| feature.geometry.as_ref());
        let others = geometries.filter(|geometry| !geometry.shape.is_empty() && geometry.dimensions != of_file).count();
        if others > 0 {
            found.push(Loss::MixedDimensions(others));
        }
    }
}
