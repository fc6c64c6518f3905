//! PLY (Stanford polygon file format), text and binary: <https://paulbourke.net/dataformats/ply/>.
//!
//! `ply-rs-bw` reads the header. The records are read here, straight into the mesh, so that an error can give its line or byte, a
//! number may be written in any usual form, and dropped parts take no memory.

use super::builder::Builder;
use super::dropped::{Dropped, Drops};
use super::error::{Cause, Failure, Position, excerpt};
use super::text::Text;
use crate::IndexedMesh;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, ElementDef, Encoding, Header, PropertyType, ScalarType};

pub(super) fn read(bytes: &[u8]) -> Result<(IndexedMesh, Vec<Dropped>), Failure> {
    let (header, body, line) = header(bytes)?;
    let mut records = match header.encoding {
        Encoding::Ascii => Records::Text(Text::new(bytes).starting_at(body, line)),
        Encoding::BinaryLittleEndian => Records::Binary { bytes, at: body, big_endian: false },
        Encoding::BinaryBigEndian => Records::Binary { bytes, at: body, big_endian: true },
    };
    let missing = |what| Failure::new(Position::Line(line), Cause::Missing(what));
    let vertex = header.elements.get("vertex").ok_or_else(|| missing("element vertex"))?;
    for axis in ["x", "y", "z"] {
        let property = vertex.properties.get(axis).map(|property| &property.data_type);
        if !matches!(property, Some(PropertyType::Scalar(_))) {
            return Err(missing("number x, y or z in element vertex"));
        }
    }
    let mut mesh = Builder::new(0);
    let mut drops = Drops::default();
    let faces = header.elements.get("face").map_or(0, |face| face.count);
    mesh.reserve(vertex.count as u64, faces as u64, 3, bytes.len() - body);
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => points(&mut records, element, &mut mesh, &mut drops)?,
            "face" => {
                let lists = |name: &str| matches!(name, "vertex_indices" | "vertex_index");
                let list = element
                    .properties
                    .iter()
                    .position(|(name, property)| lists(name) && matches!(property.data_type, PropertyType::List(..)));
                let list = list.ok_or_else(|| missing("list vertex_indices in element face"))?;
                read_faces(&mut records, element, list, &mut mesh, &mut drops)?;
            }
            _ => {
                drops.add_owned(format!("elements {name}"), element.count);
                skip(&mut records, element)?;
            }
        }
    }
    drops.add("values after the last element", records.after());
    Ok((mesh.finish()?, drops.into_list()))
}

/// Returns the header, and the byte and the line after it.
fn header(bytes: &[u8]) -> Result<(Header, usize, u64), Failure> {
    let mut reader = Reader::new(bytes);
    let header = Parser::<DefaultElement>::new().read_header(&mut reader).map_err(|error| {
        // The first line has the message; the others repeat the input.
        let message = error.to_string();
        let first = message.lines().next().unwrap_or_default();
        let first =
            first.split_once(": ").filter(|(place, _)| place.starts_with("Line ")).map_or(first, |(_, say)| say);
        let line = error.line().unwrap_or(reader.line()).max(1) as u64;
        Failure::new(Position::Line(line), Cause::Header(first.into()))
    })?;
    let body = bytes.len() - reader.get_ref().len();
    let text = &bytes[..body];
    // A second definition of the same name has replaced the first.
    let (mut line, mut defined) = (0, 0);
    for words in text.split_inclusive(|byte| *byte == b'\n') {
        line += 1;
        defined += usize::from(words.starts_with(b"element") || words.starts_with(b"property"));
    }
    let kept: usize = header.elements.values().map(|element| 1 + element.properties.len()).sum();
    if defined > kept {
        return Err(Failure::new(Position::Line(line), Cause::DefinedTwice));
    }
    Ok((header, body, line + 1))
}

fn points(
    records: &mut Records<'_>,
    element: &ElementDef,
    mesh: &mut Builder,
    drops: &mut Drops,
) -> Result<(), Failure> {
    let kinds: Vec<_> = element.properties.values().map(|property| &property.data_type).collect();
    let axes: Vec<_> =
        element.properties.keys().map(|name| ["x", "y", "z"].iter().position(|axis| axis == name)).collect();
    for _ in 0..element.count {
        let mut point = [0.0; 3];
        for (kind, axis) in kinds.iter().zip(&axes) {
            match (kind, axis) {
                (PropertyType::Scalar(kind), Some(axis)) => point[*axis] = records.coordinate(kind)?,
                (kind, _) => records.skip(kind)?,
            }
        }
        mesh.point(point, records.position())?;
    }
    drop_properties(element, drops, |name| matches!(name, "x" | "y" | "z"));
    Ok(())
}

fn read_faces(
    records: &mut Records<'_>,
    element: &ElementDef,
    list: usize,
    mesh: &mut Builder,
    drops: &mut Drops,
) -> Result<(), Failure> {
    let kinds: Vec<_> = element.properties.values().map(|property| &property.data_type).collect();
    for _ in 0..element.count {
        let mut at = records.position();
        for (i, kind) in kinds.iter().enumerate() {
            match kind {
                PropertyType::List(count, index) if i == list => {
                    let sides = records.length(count, "the number of sides of a face")?;
                    at = records.position();
                    for _ in 0..sides {
                        let point = records.index(index)?;
                        mesh.corner(point, records.position())?;
                    }
                }
                kind => records.skip(kind)?,
            }
        }
        mesh.face(at)?;
    }
    let kept = element.properties.get_index(list).map(|(name, _)| name.as_str());
    drop_properties(element, drops, |name| Some(name) == kept);
    Ok(())
}

fn drop_properties(element: &ElementDef, drops: &mut Drops, keep: impl Fn(&str) -> bool) {
    for name in element.properties.keys().filter(|name| !keep(name)) {
        drops.add_owned(format!("property {name} of element {}", element.name), element.count);
    }
}

fn skip(records: &mut Records<'_>, element: &ElementDef) -> Result<(), Failure> {
    // An element without properties takes no room, regardless of its stated count.
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        for property in element.properties.values() {
            records.skip(&property.data_type)?;
        }
    }
    Ok(())
}

enum Records<'a> {
    Text(Text<'a>),
    Binary { bytes: &'a [u8], at: usize, big_endian: bool },
}

impl Records<'_> {
    fn position(&self) -> Position {
        match self {
            Self::Text(text) => text.position(),
            Self::Binary { at, .. } => Position::Byte(*at as u64),
        }
    }

    /// Reads a number of this type; every one of them is exact as `f64`.
    #[inline]
    fn number(&mut self, kind: &ScalarType, what: &'static str) -> Result<f64, Failure> {
        match self {
            Self::Text(text) => {
                let word = text.any_word();
                text.number(word, what)
            }
            Self::Binary { bytes, at, big_endian } => {
                let size = match kind {
                    ScalarType::Char | ScalarType::UChar => 1,
                    ScalarType::Short | ScalarType::UShort => 2,
                    ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
                    ScalarType::Double => 8,
                };
                let Some(found) = bytes.get(*at..*at + size) else {
                    return Err(Failure::new(Position::Byte(*at as u64), Cause::Truncated { what }));
                };
                // As little-endian bytes, with zeros above them.
                let mut all = [0; 8];
                all[..size].copy_from_slice(found);
                if *big_endian {
                    all[..size].reverse();
                }
                *at += size;
                let [a, b, c, d, ..] = all;
                let four = [a, b, c, d];
                Ok(match kind {
                    ScalarType::Char => f64::from(i8::from_le_bytes([a])),
                    ScalarType::UChar => f64::from(a),
                    ScalarType::Short => f64::from(i16::from_le_bytes([a, b])),
                    ScalarType::UShort => f64::from(u16::from_le_bytes([a, b])),
                    ScalarType::Int => f64::from(i32::from_le_bytes(four)),
                    ScalarType::UInt => f64::from(u32::from_le_bytes(four)),
                    ScalarType::Float => f64::from(f32::from_le_bytes(four)),
                    ScalarType::Double => f64::from_le_bytes(all),
                })
            }
        }
    }

    fn coordinate(&mut self, kind: &ScalarType) -> Result<f64, Failure> {
        let at = self.position();
        let found = self.number(kind, "a coordinate")?;
        // Text knows its line only after reading the word.
        let at = if let Self::Text(text) = self { text.position() } else { at };
        if found.is_finite() { Ok(found) } else { Err(Failure::new(at, Cause::NotFinite { found })) }
    }

    /// Reads the index of a point, which may be negative by mistake.
    fn index(&mut self, kind: &ScalarType) -> Result<i64, Failure> {
        self.whole(kind, "the index of a point", i64::MIN)
    }

    fn length(&mut self, kind: &ScalarType, what: &'static str) -> Result<i64, Failure> {
        self.whole(kind, what, 0)
    }

    fn whole(&mut self, kind: &ScalarType, what: &'static str, least: i64) -> Result<i64, Failure> {
        let number = self.number(kind, what)?;
        let whole = number as i64;
        if number.fract() == 0.0 && whole >= least {
            Ok(whole)
        } else {
            let found = excerpt(number.to_string().as_bytes());
            Err(Failure::new(self.position(), Cause::Expected { what, found }))
        }
    }

    fn skip(&mut self, kind: &PropertyType) -> Result<(), Failure> {
        match kind {
            PropertyType::Scalar(kind) => self.number(kind, "the value of a property").map(drop),
            PropertyType::List(count, kind) => {
                for _ in 0..self.length(count, "the length of a list")? {
                    self.number(kind, "the value of a property")?;
                }
                Ok(())
            }
        }
    }

    /// Returns the number of words or bytes that are left.
    fn after(&mut self) -> usize {
        match self {
            Self::Text(text) => std::iter::from_fn(|| text.any_word()).count(),
            Self::Binary { bytes, at, .. } => bytes.len() - *at,
        }
    }
}
