//! Reading `FlatGeobuf` from a stream. Lengths and counts are trusted only as far as there is data.

use super::super::crs::Crs;
use super::super::each::Each;
use super::super::error::{Cause, Place, ReadError};
use super::super::model::{Dimensions, Feature, Field, Geometry, Header, Id, Line, Members, Position, Shape};
use super::TEXTS;
use super::properties::{attributes, kind};
use super::tree::Tree;
use crate::io::{Format, unread_geometry};
use ::flatgeobuf::{
    Feature as FeatureTable, Geometry as Table, GeometryType as Kind, Header as HeaderTable,
    size_prefixed_root_as_feature_with_opts, size_prefixed_root_as_header_with_opts,
};
use flatbuffers::{InvalidFlatbuffer, Vector, VerifierOptions};
use std::io::{self, Read};
use std::sync::Arc;

/// The maximum number of collections around a geometry.
const NESTED: usize = 32;

/// The largest header, also the limit of the crate.
const LARGEST_HEADER: u32 = 10 << 20;

/// The newest known version of the format.
const VERSION: u8 = 3;

pub(super) fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::FlatGeobuf, place, cause }
}

pub(super) fn invalid(message: impl Into<String>) -> Cause {
    Cause::Invalid(message.into())
}

/// Reads features, passing each to `each`. An index is skipped.
pub(crate) fn read(reader: &mut dyn Read, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let in_header = |cause| content(Place::Header, cause);
    let buffer = header_bytes(reader)?;
    let header = header_of(&buffer)?;
    let mut fields = Vec::new();
    for column in header.columns().into_iter().flatten() {
        let name: Arc<str> = column.name().into();
        let kind = kind(column.type_()).map_err(in_header)?;
        let width = usize::try_from(column.width()).ok().filter(|width| *width > 0);
        fields.push(Field { name, kind, width, decimals: None });
    }
    skip_index(reader, &header)?;
    let count = header.features_count();
    let mut body = Vec::new();
    for number in 0_u64.. {
        let place = Place::Feature(number as usize);
        if !table(reader, &mut body, place, None)? {
            if number < count {
                let cause = Cause::TooMany { what: "features", count };
                return Err(in_header(cause));
            }
            break;
        }
        if count > 0 && number == count {
            return Err(in_header(invalid(format!("more features follow than the {count} that the header counts"))));
        }
        each(feature(&header, &body, number, &fields).map_err(|cause| content(place, cause))?)?;
    }
    Ok(of_header(&header, fields))
}

/// Reads the table of the header, with the length before it.
pub(super) fn header_bytes(reader: &mut dyn Read) -> Result<Vec<u8>, ReadError> {
    let in_header = |cause| content(Place::Header, cause);
    let mut magic = [0; 8];
    reader.read_exact(&mut magic).map_err(|error| truncated(error, Place::Header, "the first 8 bytes"))?;
    let [b'f', b'g', b'b', version, b'f', b'g', b'b', _] = magic else {
        return Err(in_header(invalid("it does not begin as FlatGeobuf does")));
    };
    if version > VERSION {
        return Err(in_header(invalid(format!("version {version} is not read here"))));
    }
    let mut buffer = Vec::new();
    if !table(reader, &mut buffer, Place::Header, Some(LARGEST_HEADER))? {
        return Err(in_header(Cause::Truncated("the header")));
    }
    Ok(buffer)
}

/// Parses the header of a table. O(columns).
pub(super) fn header_of(buffer: &[u8]) -> Result<HeaderTable<'_>, ReadError> {
    let in_header = |cause| content(Place::Header, cause);
    let header = size_prefixed_root_as_header_with_opts(&options(buffer), buffer);
    let header = header.map_err(|error| in_header(refused(&error)))?;
    if header.has_t() || header.has_tm() {
        return Err(in_header(invalid("positions with times are not read here")));
    }
    Ok(header)
}

fn truncated(error: io::Error, place: Place, what: &'static str) -> ReadError {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => content(place, Cause::Truncated(what)),
        _ => error.into(),
    }
}

fn refused(error: &InvalidFlatbuffer) -> Cause {
    // The rest of the message describes the place in the tables.
    invalid(error.to_string().lines().next().unwrap_or_default())
}

/// Limits the size to which tables may expand: they can share vectors, so that a few bytes stand for many.
fn options(bytes: &[u8]) -> VerifierOptions {
    VerifierOptions {
        max_depth: 2 * NESTED,
        max_tables: bytes.len(),
        max_apparent_size: 16 * bytes.len() + 1024,
        ..VerifierOptions::default()
    }
}

/// Reads a table with the length before it. Returns false at the end of the stream. Memory grows only with the available data.
fn table(reader: &mut dyn Read, buffer: &mut Vec<u8>, place: Place, largest: Option<u32>) -> Result<bool, ReadError> {
    buffer.clear();
    reader.take(4).read_to_end(buffer)?;
    if buffer.is_empty() {
        return Ok(false);
    }
    let Some(length) = buffer.first_chunk().map(|bytes| u32::from_le_bytes(*bytes)) else {
        return Err(content(place, Cause::Truncated("a length")));
    };
    if largest.is_some_and(|largest| length > largest) {
        return Err(content(place, Cause::TooMany { what: "bytes of a header", count: length.into() }));
    }
    let found = reader.take(length.into()).read_to_end(buffer)?;
    if found < length as usize {
        return Err(content(place, Cause::Truncated("a table")));
    }
    Ok(true)
}

fn skip_index(reader: &mut dyn Read, header: &HeaderTable<'_>) -> Result<(), ReadError> {
    let tree = Tree::of_header(header).map_err(|cause| content(Place::Header, cause))?;
    let Some(tree) = tree else { return Ok(()) };
    let bytes = tree.bytes();
    let skipped = io::copy(&mut reader.take(bytes), &mut io::sink())?;
    if skipped < bytes { Err(content(Place::Header, Cause::Truncated("the index"))) } else { Ok(()) }
}

pub(super) fn of_header(header: &HeaderTable<'_>, fields: Vec<Field>) -> Header {
    let text = |text: Option<&str>| text.filter(|text| !text.is_empty()).map(str::to_owned);
    let crs = header.crs().map(|crs| Crs {
        code: (crs.code() != 0).then(|| (text(crs.org()).unwrap_or_else(|| "EPSG".to_owned()), crs.code().into())),
        wkt: text(crs.wkt()),
        ..Crs::default()
    });
    let texts = [header.title(), header.description(), header.metadata()];
    let members = TEXTS.into_iter().zip(texts).filter_map(|(name, value)| Some((name.to_owned(), text(value)?.into())));
    Header {
        name: text(header.name()),
        crs: crs.filter(|crs| crs.code.is_some() || crs.wkt.is_some()),
        fields,
        members: members.collect(),
        charset: None,
    }
}

fn feature(header: &HeaderTable<'_>, body: &[u8], number: u64, fields: &[Field]) -> Result<Feature, Cause> {
    let table = feature_table(body)?;
    let bytes = table.properties().map(|bytes| bytes.bytes()).unwrap_or_default();
    Ok(Feature {
        id: Some(Id::Number(number.into())),
        geometry: geometry(header, table)?,
        attributes: attributes(bytes, header.columns(), table.columns(), fields)?,
        members: Members::new(),
    })
}

/// Returns the geometry of a feature, without its attributes.
pub(super) fn geometry_of(header: &HeaderTable<'_>, body: &[u8]) -> Result<Option<Geometry>, Cause> {
    geometry(header, feature_table(body)?)
}

fn feature_table(body: &[u8]) -> Result<FeatureTable<'_>, Cause> {
    size_prefixed_root_as_feature_with_opts(&options(body), body).map_err(|error| refused(&error))
}

fn geometry(header: &HeaderTable<'_>, feature: FeatureTable<'_>) -> Result<Option<Geometry>, Cause> {
    let geometry = feature.geometry().map(|geometry| {
        let kind = Some(header.geometry_type()).filter(|kind| *kind != Kind::Unknown);
        shape(geometry, kind.unwrap_or(geometry.type_()), header, 0)
    });
    geometry.transpose()
}

/// The recursion is as deep as collections are nested, at most [`NESTED`].
fn shape(table: Table<'_>, kind: Kind, header: &HeaderTable<'_>, depth: usize) -> Result<Geometry, Cause> {
    if depth > NESTED {
        return Err(Cause::TooDeep);
    }
    let dimensions = Dimensions::with(header.has_z() && table.z().is_some(), header.has_m() && table.m().is_some());
    let parts = || table.parts().into_iter().flatten();
    let shape = match kind {
        Kind::Point => match &mut positions(table, dimensions)?[..] {
            [] => Shape::Point(None),
            [one] if one.x.is_nan() && one.y.is_nan() => Shape::Point(None),
            [one] => Shape::Point(Some(finite(std::mem::take(one))?)),
            more => return Err(invalid(format!("a point with {} positions", more.len()))),
        },
        Kind::MultiPoint => Shape::MultiPoint(line(table, dimensions)?.into_iter().map(Some).collect()),
        Kind::LineString => Shape::Line(line(table, dimensions)?),
        Kind::MultiLineString => Shape::MultiLine(lines(table, dimensions)?),
        Kind::Polygon => Shape::Polygon(lines(table, dimensions)?),
        Kind::MultiPolygon => {
            if table.xy().is_some_and(|xy| !xy.is_empty()) {
                return Err(invalid("a MultiPolygon with positions outside of its parts"));
            }
            Shape::MultiPolygon(parts().map(|part| lines(part, dimensions_of(header, part))).collect::<Result<_, _>>()?)
        }
        Kind::GeometryCollection => {
            let parts = parts().map(|part| shape(part, part.type_(), header, depth + 1));
            Shape::Collection(parts.collect::<Result<_, _>>()?)
        }
        other => return Err(invalid(unread_geometry(other.0.into()))),
    };
    // Parts have the numbers, but the geometry that contains them doesn't.
    let dimensions = match &shape {
        Shape::MultiPolygon(_) => parts().next().map_or(dimensions, |part| dimensions_of(header, part)),
        _ => dimensions,
    };
    Ok(Geometry::new(dimensions, shape))
}

fn dimensions_of(header: &HeaderTable<'_>, table: Table<'_>) -> Dimensions {
    Dimensions::with(header.has_z() && table.z().is_some(), header.has_m() && table.m().is_some())
}

fn finite(position: Position) -> Result<Position, Cause> {
    if position.x.is_finite() && position.y.is_finite() {
        return Ok(position);
    }
    Err(invalid(format!("the coordinates ({}, {}) are not finite", position.x, position.y)))
}

fn line(table: Table<'_>, dimensions: Dimensions) -> Result<Line, Cause> {
    positions(table, dimensions)?.into_iter().map(finite).collect()
}

fn positions(table: Table<'_>, dimensions: Dimensions) -> Result<Line, Cause> {
    let Some(xy) = table.xy() else { return Ok(Line::new()) };
    let more: Vec<Vector<'_, f64>> = match dimensions {
        Dimensions::Xy => Vec::new(),
        Dimensions::Xyz => table.z().into_iter().collect(),
        Dimensions::Xym => table.m().into_iter().collect(),
        Dimensions::Xyzm => table.z().into_iter().chain(table.m()).collect(),
    };
    let count = xy.len() / 2;
    if xy.len() % 2 == 1 || more.iter().any(|numbers| numbers.len() != count) {
        return Err(invalid("the numbers of coordinates differ"));
    }
    let of = |i: usize| Position {
        x: xy.get(2 * i),
        y: xy.get(2 * i + 1),
        more: more.iter().map(|numbers| numbers.get(i)).collect(),
    };
    Ok((0..count).map(of).collect())
}

/// Returns the positions of a table in parts, by the stated ends; one part if there are none.
fn lines(table: Table<'_>, dimensions: Dimensions) -> Result<Vec<Line>, Cause> {
    let mut rest = line(table, dimensions)?.into_iter();
    let all = rest.len();
    let Some(ends) = table.ends().filter(|ends| !ends.is_empty()) else {
        return Ok(if all == 0 { Vec::new() } else { vec![rest.collect()] });
    };
    let (mut lines, mut begin) = (Vec::new(), 0);
    for end in ends {
        let count = (end as usize).checked_sub(begin).filter(|count| *count <= rest.len());
        let count = count.ok_or_else(|| invalid(format!("a part ends at position {end}, and there are {all}")))?;
        lines.push(rest.by_ref().take(count).collect());
        begin = end as usize;
    }
    match rest.len() {
        0 => Ok(lines),
        more => Err(invalid(format!("{more} positions follow the last part"))),
    }
}
