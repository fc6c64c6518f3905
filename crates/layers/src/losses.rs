//! Finding the parts of a layer that a format cannot hold.

use super::closed::open_rings;
use super::loss::{Loss, absent};
use super::model::{Dimensions, EDGES, FieldKind, Geometry, Layer, Line, Shape, Value};
use crate::io::Format;
use std::collections::BTreeSet;

/// Returns the losses of writing the layer in this format. O(size of the layer).
///
/// A change of form is no loss: the order of the rings of a Shapefile, a multi-polygon of one polygon that becomes a polygon
/// there, a polygon with heights among multi-polygons that becomes one of these in `FlatGeobuf`, or the number of digits of a
/// number.
///
/// ```
/// use twinedge_layers::{Feature, Format, Id, Layer, Loss, losses};
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
    let has_columns = !matches!(format, Format::Wkt | Format::Wkb);
    let is_json = matches!(format, Format::GeoJson | Format::GeoJsonSeq | Format::TopoJson);

    let holds_ids = match format {
        // It reports lost ids itself.
        Format::FlatGeobuf => true,
        #[cfg(feature = "geopackage")]
        Format::GeoPackage => super::geopackage::holds_ids(layer),
        #[cfg(feature = "geoparquet")]
        Format::GeoParquet => super::geoparquet::id_kind(layer).is_some(),
        _ => is_json,
    };
    if !holds_ids {
        found.extend(some_if(layer.features.iter().filter(|f| f.id.is_some()).count(), Loss::Ids));
    }
    members(layer, format, &mut found);
    if let Some(name) = layer
        .header
        .name
        .as_ref()
        .filter(|_| matches!(format, Format::GeoJsonSeq | Format::Wkt | Format::Wkb | Format::GeoParquet))
    {
        found.push(Loss::Name(name.clone()));
    }
    if let Some(crs) = &layer.header.crs {
        let is_held = match format {
            Format::GeoJson | Format::TopoJson => crs.member.is_some() || crs.code.is_some() || !crs.is_other(),
            Format::GeoJsonSeq | Format::Wkt | Format::Wkb => !crs.is_other(),
            Format::Shapefile => crs.wkt1().is_some(),
            // Its numbers have 32 bits, and 0 stands for none.
            Format::FlatGeobuf => {
                let has_code = crs.code.as_ref().is_some_and(|(_, code)| (1..=i32::MAX.into()).contains(code));
                crs.wkt.is_some() || has_code || !crs.is_other()
            }
            #[cfg(feature = "geoparquet")]
            Format::GeoParquet => super::geoparquet::is_held(crs),
            #[cfg(not(feature = "geoparquet"))]
            Format::GeoParquet => !crs.is_other(),
            Format::GeoPackage => crs.wkt.is_some() || crs.code.is_some() || !crs.is_other(),
        };
        if !is_held {
            found.push(Loss::Crs(crs.name()));
        }
    }
    geometries(layer, format, &mut found);
    found.extend(some_if(open_rings(layer), Loss::OpenRings));
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
        #[cfg(feature = "flatgeobuf")]
        Format::FlatGeobuf => super::flatgeobuf::losses(layer, &mut found),
        #[cfg(feature = "geoparquet")]
        Format::GeoParquet => super::geoparquet::losses(layer, &mut found),
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

fn members(layer: &Layer, format: Format, found: &mut Vec<Loss>) {
    let is_json = matches!(format, Format::GeoJson | Format::GeoJsonSeq | Format::TopoJson);
    let mut of_features = BTreeSet::new();
    for feature in &layer.features {
        if !is_json {
            of_features.extend(feature.members.keys());
        }
        feature.geometry.iter().for_each(|geometry| of_geometry(geometry, is_json, &mut of_features));
    }
    let of_layer: Vec<&String> = match format {
        // FlatGeobuf holds some, and reports the others itself.
        Format::GeoJson | Format::TopoJson | Format::FlatGeobuf => Vec::new(),
        _ => layer.header.members.keys().collect(),
    };
    // A box follows from the geometry.
    let is_lost = |name: &&String| *name != "bbox" && !(format == Format::GeoParquet && *name == EDGES);
    let names = of_layer.into_iter().chain(of_features).filter(is_lost);
    let names: Vec<String> = names.cloned().collect();
    if !names.is_empty() {
        found.push(Loss::Members(names));
    }
}

/// Collects the lost members of a geometry and its parts. The recursion is as deep as collections are nested.
fn of_geometry<'a>(geometry: &'a Geometry, is_json: bool, names: &mut BTreeSet<&'a String>) {
    names.extend(geometry.members.keys().filter(|name| !is_json || is_reserved_in_json(name)));
    if let Shape::Collection(parts) = &geometry.shape {
        for part in parts {
            of_geometry(part, is_json, names);
        }
    }
}

/// Returns true if a member of a geometry is reserved in GeoJSON (RFC 7946, section 7.1).
pub(super) fn is_reserved_in_json(name: &str) -> bool {
    matches!(name, "type" | "coordinates" | "geometries" | "geometry" | "properties" | "features")
}

fn geometries(layer: &Layer, format: Format, found: &mut Vec<Loss>) {
    let (mut null, mut empty, mut measures, mut mixed, mut parts) = (0, 0, 0, 0, 0);
    for feature in &layer.features {
        let Some(geometry) = &feature.geometry else {
            null += 1;
            continue;
        };
        empty += usize::from(geometry.shape.is_empty());
        measures += usize::from(matches!(geometry.dimensions, Dimensions::Xym | Dimensions::Xyzm));
        mixed += usize::from(is_mixed(geometry));
        parts += empty_parts(geometry, format == Format::Shapefile);
    }
    let some_if = |n: usize, loss: fn(usize) -> Loss| (n > 0).then(|| loss(n));
    match format {
        Format::GeoJson | Format::GeoJsonSeq | Format::TopoJson => {
            found.extend(some_if(parts, Loss::EmptyParts));
            found.extend(some_if(measures, Loss::Measures));
        }
        Format::Wkt | Format::Wkb => {
            found.extend(some_if(null, Loss::NullGeometries));
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
        Format::FlatGeobuf => {
            found.extend(some_if(parts, Loss::EmptyParts));
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
        Format::GeoPackage | Format::GeoParquet => {
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
        Format::Shapefile => {
            found.extend(some_if(parts, Loss::EmptyParts));
            found.extend(some_if(empty, Loss::EmptyGeometries));
            found.extend(some_if(mixed, Loss::MixedDimensions));
        }
    }
}

/// Returns the number of empty points in multi-points and, on request, of empty lines, rings and polygons, in a non-empty
/// geometry. The recursion is as deep as collections are nested.
fn empty_parts(geometry: &Geometry, of_lines: bool) -> usize {
    let lines = |lines: &Vec<Line>| lines.iter().filter(|line| line.is_empty()).count();
    match &geometry.shape {
        shape if shape.is_empty() => 0,
        Shape::MultiPoint(points) => points.iter().filter(|point| point.is_none()).count(),
        Shape::MultiLine(all) | Shape::Polygon(all) if of_lines => lines(all),
        Shape::MultiPolygon(polygons) if of_lines => {
            polygons.iter().map(|rings| lines(rings).max(usize::from(rings.is_empty()))).sum()
        }
        Shape::Collection(parts) => parts.iter().map(|part| empty_parts(part, of_lines)).sum(),
        _ => 0,
    }
}

/// Returns true if positions have another number of dimensions than the geometry states.
fn is_mixed(geometry: &Geometry) -> bool {
    if let Shape::Collection(parts) = &geometry.shape {
        return parts.iter().any(|part| part.dimensions != geometry.dimensions || is_mixed(part));
    }
    let mut found = false;
    geometry.shape.visit(&mut |position| found |= position.more.len() != geometry.dimensions.more());
    found
}
