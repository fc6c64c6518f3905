//! Writing `FlatGeobuf`, in the order of the features, with an index if each feature has a location.

use super::super::error::WriteError;
use super::super::loss::{Loss, absent};
use super::super::model::{Feature, Field, FieldKind, Geometry, Layer, Line, Position, Shape, Value};
use super::packed::{NODE_SIZE, extents, packed};
use super::properties::{append, column};
use super::{TEXTS, holds_ids};
use crate::io::Format;
use ::flatgeobuf::{
    Column, ColumnArgs, Crs as CrsTable, CrsArgs, Feature as FeatureTable, FeatureArgs, Geometry as Table,
    GeometryArgs, GeometryType as Kind, Header as HeaderTable, HeaderArgs,
};
use flatbuffers::{FlatBufferBuilder, WIPOffset};
use std::borrow::Cow;
use std::io::Write;

const MAGIC: &[u8; 8] = b"fgb\x03fgb\x00";

/// The maximum size of a table; the crate `flatbuffers` panics beyond 2 gigabytes.
const LARGEST: usize = 1 << 30;

/// Returns the columns as written: a column with values of another type becomes text.
fn columns(layer: &Layer) -> Vec<(Field, FieldKind)> {
    let of_field = |field: Field| {
        let mut scratch = Vec::new();
        let fits = layer.features.iter().filter_map(|feature| feature.get(&field.name)).all(|value| {
            scratch.clear();
            append(0, field.kind, value, &mut scratch)
        });
        let kind = if fits { field.kind } else { FieldKind::Text };
        (field, kind)
    };
    layer.fields().into_iter().map(of_field).collect()
}

/// Adds losses other than of geometries and the reference system.
pub(crate) fn losses(layer: &Layer, found: &mut Vec<Loss>) {
    if !holds_ids(layer) {
        found.push(Loss::Ids(layer.features.iter().filter(|feature| feature.id.is_some()).count()));
    }
    let members = layer.header.members.iter();
    let lost =
        members.filter(|(name, value)| *name != "bbox" && !(TEXTS.contains(&name.as_str()) && value.is_string()));
    let lost: Vec<String> = lost.map(|(name, _)| name.clone()).collect();
    if !lost.is_empty() {
        found.push(Loss::Members(lost));
    }
    let columns = columns(layer);
    for (field, to) in columns.iter().filter(|(field, kind)| field.kind != *kind) {
        found.push(Loss::Type { column: field.name.to_string(), from: field.kind, to: *to });
    }
    match absent(layer, columns.len()) {
        0 => {}
        count => found.push(Loss::Absent(count)),
    }
}

pub(crate) fn write(layer: &Layer, out: &mut dyn Write) -> Result<(), WriteError> {
    let impossible = |what: &str| WriteError::Impossible { format: Format::FlatGeobuf, what: what.to_owned() };
    let columns = columns(layer);
    if columns.len() > usize::from(u16::MAX) {
        return Err(impossible("more than 65,535 columns"));
    }
    let kind = common_kind(layer);
    let body = |feature: &Feature| {
        let mut properties = Vec::new();
        for (number, (field, kind)) in columns.iter().enumerate() {
            let value = feature.get(&field.name).unwrap_or(&Value::Null);
            append(number as u16, *kind, value, &mut properties);
        }
        let mut positions = 0_usize;
        feature.geometry.iter().for_each(|geometry| geometry.shape.visit(&mut |_| positions += 1));
        if properties.len() + 32 * positions > LARGEST {
            return Err(impossible("a feature of more than a gigabyte"));
        }
        Ok(body(feature, &properties, kind))
    };
    let extents = extents(layer);
    out.write_all(MAGIC)?;
    out.write_all(&header(layer, &columns, kind, extents.as_ref().map_or(0, |_| NODE_SIZE)))?;
    if let Some(extents) = extents {
        // Bodies are made twice instead of being kept.
        let lengths = layer.features.iter().map(|feature| Ok(body(feature)?.len()));
        out.write_all(&packed(&extents, lengths.collect::<Result<Vec<_>, WriteError>>()?.into_iter()))?;
    }
    layer.features.iter().try_for_each(|feature| Ok(out.write_all(&body(feature)?)?))
}

/// Returns the kind of all geometries; unknown if they differ, and then each has its own. With heights or measures, single and
/// multiple geometries get the kind of the latter, as in GDAL, whose users have no type for mixed kinds with heights.
fn common_kind(layer: &Layer) -> Kind {
    let all = || layer.features.iter().filter_map(|feature| feature.geometry.as_ref());
    let is_flat = all().all(|geometry| numbers(geometry) == (None, None));
    let common = |kind: fn(&Shape) -> Kind| {
        let mut kinds = all().map(|geometry| kind(&geometry.shape));
        let first = kinds.next()?;
        kinds.all(|kind| kind == first).then_some(first)
    };
    common(kind_of).or_else(|| common(kind_of_several).filter(|_| !is_flat)).unwrap_or(Kind::Unknown)
}

/// Returns the kind of several such geometries combined.
const fn kind_of_several(shape: &Shape) -> Kind {
    match shape {
        Shape::Point(_) | Shape::MultiPoint(_) => Kind::MultiPoint,
        Shape::Line(_) | Shape::MultiLine(_) => Kind::MultiLineString,
        Shape::Polygon(_) | Shape::MultiPolygon(_) => Kind::MultiPolygon,
        Shape::Collection(_) => Kind::GeometryCollection,
    }
}

/// Returns the geometry as one with several parts, if that is the kind of the file.
fn of_kind(geometry: &Geometry, kind: Kind) -> Cow<'_, Geometry> {
    let shape = match (&geometry.shape, kind) {
        (Shape::Point(point), Kind::MultiPoint) => Shape::MultiPoint(point.iter().cloned().map(Some).collect()),
        (Shape::Line(line), Kind::MultiLineString) => Shape::MultiLine(vec![line.clone()]),
        (Shape::Polygon(rings), Kind::MultiPolygon) => Shape::MultiPolygon(vec![rings.clone()]),
        _ => return Cow::Borrowed(geometry),
    };
    Cow::Owned(Geometry::new(geometry.dimensions, shape))
}

const fn kind_of(shape: &Shape) -> Kind {
    match shape {
        Shape::Point(_) => Kind::Point,
        Shape::MultiPoint(_) => Kind::MultiPoint,
        Shape::Line(_) => Kind::LineString,
        Shape::MultiLine(_) => Kind::MultiLineString,
        Shape::Polygon(_) => Kind::Polygon,
        Shape::MultiPolygon(_) => Kind::MultiPolygon,
        Shape::Collection(_) => Kind::GeometryCollection,
    }
}

fn header(layer: &Layer, columns: &[(Field, FieldKind)], geometry_type: Kind, index_node_size: u16) -> Vec<u8> {
    let mut builder = FlatBufferBuilder::new();
    let tables: Vec<_> = columns
        .iter()
        .map(|(field, kind)| {
            let name = Some(builder.create_string(&field.name));
            let width = field.width.and_then(|width| i32::try_from(width).ok()).unwrap_or(-1);
            Column::create(&mut builder, &ColumnArgs { name, type_: column(*kind), width, ..ColumnArgs::default() })
        })
        .collect();
    let columns = (!tables.is_empty()).then(|| builder.create_vector(&tables));
    let crs = layer.header.crs.as_ref().map(|crs| {
        let code = crs.code.as_ref().and_then(|(org, code)| Some((org, i32::try_from(*code).ok()?)));
        let args = CrsArgs {
            org: code.map(|(org, _)| builder.create_string(org)),
            code: code.map_or(0, |(_, code)| code),
            wkt: crs.wkt.as_ref().map(|wkt| builder.create_string(wkt)),
            ..CrsArgs::default()
        };
        CrsTable::create(&mut builder, &args)
    });
    let (mut has_z, mut has_m, mut bounds) = (false, false, None);
    for geometry in layer.features.iter().filter_map(|feature| feature.geometry.as_ref()) {
        look(geometry, &mut has_z, &mut has_m, &mut bounds);
    }
    let texts = TEXTS.map(|name| layer.header.members.get(name).and_then(|value| value.as_str()));
    let [title, description, metadata] = texts.map(|text| text.map(|text| builder.create_string(text)));
    let args = HeaderArgs {
        name: layer.header.name.as_ref().map(|name| builder.create_string(name)),
        envelope: bounds.map(|bounds: [f64; 4]| builder.create_vector(&bounds)),
        geometry_type,
        has_z,
        has_m,
        columns,
        features_count: layer.features.len() as u64,
        index_node_size,
        crs,
        title,
        description,
        metadata,
        ..HeaderArgs::default()
    };
    let table = HeaderTable::create(&mut builder, &args);
    builder.finish_size_prefixed(table, None);
    builder.finished_data().to_vec()
}

/// Collects the dimensions and the box of a geometry. The recursion is as deep as collections are nested.
fn look(geometry: &Geometry, has_z: &mut bool, has_m: &mut bool, bounds: &mut Option<[f64; 4]>) {
    if let Shape::Collection(parts) = &geometry.shape {
        for part in parts {
            look(part, has_z, has_m, bounds);
        }
        return;
    }
    let (z, m) = numbers(geometry);
    (*has_z, *has_m) = (*has_z || z.is_some(), *has_m || m.is_some());
    geometry.shape.visit(&mut |p| {
        let [x0, y0, x1, y1] = bounds.unwrap_or([p.x, p.y, p.x, p.y]);
        *bounds = Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)]);
    });
}

/// Returns the indices of heights and measures among the further numbers.
const fn numbers(geometry: &Geometry) -> (Option<usize>, Option<usize>) {
    use super::super::model::Dimensions;
    match geometry.dimensions {
        Dimensions::Xy => (None, None),
        Dimensions::Xyz => (Some(0), None),
        Dimensions::Xym => (None, Some(0)),
        Dimensions::Xyzm => (Some(0), Some(1)),
    }
}

fn body(feature: &Feature, properties: &[u8], kind: Kind) -> Vec<u8> {
    let mut builder = FlatBufferBuilder::new();
    let geometry = feature.geometry.as_ref().map(|geometry| table(&mut builder, &of_kind(geometry, kind)));
    let properties = (!properties.is_empty()).then(|| builder.create_vector(properties));
    let table = FeatureTable::create(&mut builder, &FeatureArgs { geometry, properties, columns: None });
    builder.finish_size_prefixed(table, None);
    builder.finished_data().to_vec()
}

/// The recursion is as deep as collections are nested.
fn table<'b>(builder: &mut FlatBufferBuilder<'b>, geometry: &Geometry) -> WIPOffset<Table<'b>> {
    let type_ = kind_of(&geometry.shape);
    let parts: Vec<WIPOffset<Table<'b>>> = match &geometry.shape {
        Shape::MultiPolygon(polygons) => {
            polygons.iter().map(|rings| flat(builder, geometry, Kind::Polygon, rings)).collect()
        }
        Shape::Collection(parts) => parts.iter().map(|part| table(builder, part)).collect(),
        Shape::MultiLine(lines) | Shape::Polygon(lines) => return flat(builder, geometry, type_, lines),
        Shape::MultiPoint(points) => {
            return flat(builder, geometry, type_, &[points.iter().flatten().cloned().collect()]);
        }
        Shape::Line(line) => return flat(builder, geometry, type_, std::slice::from_ref(line)),
        Shape::Point(point) => return flat(builder, geometry, type_, &[point.iter().cloned().collect()]),
    };
    let parts = Some(builder.create_vector(&parts));
    Table::create(builder, &GeometryArgs { type_, parts, ..GeometryArgs::default() })
}

/// Writes successive lines, with their ends if there are several or an empty one.
fn flat<'b>(
    builder: &mut FlatBufferBuilder<'b>,
    geometry: &Geometry,
    type_: Kind,
    lines: &[Line],
) -> WIPOffset<Table<'b>> {
    let (z, m) = numbers(geometry);
    let all = || lines.iter().flatten();
    let xy: Vec<f64> = all().flat_map(|p| [p.x, p.y]).collect();
    let further = |i: usize| all().map(|p: &Position| p.more.get(i).copied().unwrap_or_default()).collect::<Vec<f64>>();
    let of_parts = matches!(type_, Kind::MultiLineString | Kind::Polygon);
    let ends = (of_parts && (lines.len() > 1 || lines.first().is_some_and(Vec::is_empty))).then(|| {
        let ends = lines.iter().scan(0, |end, line| {
            *end += line.len() as u32;
            Some(*end)
        });
        ends.collect::<Vec<u32>>()
    });
    let args = GeometryArgs {
        ends: ends.map(|ends| builder.create_vector(&ends)),
        xy: Some(builder.create_vector(&xy)),
        z: z.map(|i| builder.create_vector(&further(i))),
        m: m.map(|i| builder.create_vector(&further(i))),
        type_,
        ..GeometryArgs::default()
    };
    Table::create(builder, &args)
}
