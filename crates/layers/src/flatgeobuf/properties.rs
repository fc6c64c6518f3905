//! Attributes in `FlatGeobuf`: the number of a column, then a value of its type.

use super::super::error::Cause;
use super::super::model::{Field, FieldKind, Value};
use ::flatgeobuf::{Column, ColumnType as Type};
use flatbuffers::{ForwardsUOffset, Vector};
use std::sync::Arc;

type Columns<'a> = Option<Vector<'a, ForwardsUOffset<Column<'a>>>>;

pub(super) fn kind(column: Type) -> Result<FieldKind, Cause> {
    Ok(match column {
        Type::Bool => FieldKind::Bool,
        Type::Byte | Type::UByte | Type::Short | Type::UShort | Type::Int | Type::UInt | Type::Long | Type::ULong => {
            FieldKind::Integer
        }
        Type::Float | Type::Double => FieldKind::Real,
        Type::String => FieldKind::Text,
        Type::Json => FieldKind::Json,
        Type::DateTime => FieldKind::DateTime,
        Type::Binary => FieldKind::Bytes,
        Type(other) => return Err(Cause::Invalid(format!("{other} is no type of columns"))),
    })
}

/// Reads the values of a feature: of the columns of the header, with null for missing ones, or of its own columns.
pub(super) fn attributes(
    bytes: &[u8],
    of_header: Columns<'_>,
    own: Columns<'_>,
    fields: &[Field],
) -> Result<Vec<(Arc<str>, Value)>, Cause> {
    let names: Vec<Arc<str>> = match own {
        Some(own) => own.iter().map(|column| column.name().into()).collect(),
        None => fields.iter().map(|field| field.name.clone()).collect(),
    };
    let columns = own.or(of_header);
    let mut all: Vec<(Arc<str>, Value)> = names.into_iter().map(|name| (name, Value::Null)).collect();
    let mut rest = Bytes(bytes);
    // Some writers leave a byte at the end.
    while rest.0.len() > 1 {
        let number = usize::from(u16::from_le_bytes(rest.take()?));
        let column = columns.filter(|columns| number < columns.len()).map(|columns| columns.get(number));
        let (Some(column), Some((_, value))) = (column, all.get_mut(number)) else {
            return Err(Cause::Invalid(format!("a value of column {number}, and there is no such column")));
        };
        *value = rest.value(column.type_())?;
    }
    Ok(all)
}

/// The unread part.
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Cause> {
        let (first, rest) = self.0.split_first_chunk().ok_or(Cause::Truncated("a value"))?;
        self.0 = rest;
        Ok(*first)
    }

    /// Reads bytes preceded by their number.
    fn counted(&mut self) -> Result<&'a [u8], Cause> {
        let count = u32::from_le_bytes(self.take()?);
        let too_many = Cause::TooMany { what: "bytes of a value", count: count.into() };
        let (first, rest) = self.0.split_at_checked(count as usize).ok_or(too_many)?;
        self.0 = rest;
        Ok(first)
    }

    fn text(&mut self) -> Result<String, Cause> {
        let bytes = self.counted()?;
        std::str::from_utf8(bytes).map(str::to_owned).map_err(|_| Cause::Charset("UTF-8".to_owned()))
    }

    fn value(&mut self, column: Type) -> Result<Value, Cause> {
        Ok(match column {
            Type::Byte => Value::Integer(i8::from_le_bytes(self.take()?).into()),
            Type::UByte => Value::Integer(u8::from_le_bytes(self.take()?).into()),
            Type::Bool => Value::Bool(self.take::<1>()? != [0]),
            Type::Short => Value::Integer(i16::from_le_bytes(self.take()?).into()),
            Type::UShort => Value::Integer(u16::from_le_bytes(self.take()?).into()),
            Type::Int => Value::Integer(i32::from_le_bytes(self.take()?).into()),
            Type::UInt => Value::Integer(u32::from_le_bytes(self.take()?).into()),
            Type::Long => Value::Integer(i64::from_le_bytes(self.take()?)),
            Type::ULong => Value::of_json(u64::from_le_bytes(self.take()?).into()),
            Type::Float => Value::Real(f32::from_le_bytes(self.take()?).into()),
            Type::Double => Value::Real(f64::from_le_bytes(self.take()?)),
            Type::String => Value::Text(self.text()?),
            Type::Json => {
                let json = serde_json::from_slice(self.counted()?);
                Value::Json(json.map_err(|error| Cause::Invalid(format!("a value that is not JSON: {error}")))?)
            }
            // A day without a time has ten characters.
            Type::DateTime => match self.text()? {
                day if day.len() == "2026-01-31".len() => Value::Date(day),
                time => Value::DateTime(time),
            },
            Type::Binary => Value::Bytes(self.counted()?.to_vec()),
            Type(other) => return Err(Cause::Invalid(format!("{other} is no type of columns"))),
        })
    }
}

pub(super) const fn column(kind: FieldKind) -> Type {
    match kind {
        FieldKind::Bool => Type::Bool,
        FieldKind::Integer => Type::Long,
        FieldKind::Real => Type::Double,
        FieldKind::Text => Type::String,
        FieldKind::Date | FieldKind::DateTime => Type::DateTime,
        FieldKind::Bytes => Type::Binary,
        FieldKind::Json => Type::Json,
    }
}

/// Appends a non-null value of a column. Returns false if the value is of another kind.
pub(super) fn append(number: u16, kind: FieldKind, value: &Value, out: &mut Vec<u8>) -> bool {
    let begin = out.len();
    out.extend(number.to_le_bytes());
    let mut counted = |bytes: &[u8]| {
        // Values are shorter than 4 gigabytes, since the total size of a feature is checked.
        out.extend((bytes.len() as u32).to_le_bytes());
        out.extend(bytes);
    };
    match (kind, value) {
        (_, Value::Null) => out.truncate(begin),
        (FieldKind::Bool, Value::Bool(value)) => out.push(u8::from(*value)),
        (FieldKind::Integer, Value::Integer(value)) => out.extend(value.to_le_bytes()),
        (FieldKind::Real, Value::Real(value)) => out.extend(value.to_le_bytes()),
        (FieldKind::Real, Value::Integer(value)) => out.extend((*value as f64).to_le_bytes()),
        (FieldKind::Date | FieldKind::DateTime, Value::Date(text) | Value::DateTime(text))
        | (FieldKind::Text, Value::Text(text)) => counted(text.as_bytes()),
        (FieldKind::Bytes, Value::Bytes(bytes)) => counted(bytes),
        (FieldKind::Json, Value::Json(json)) => counted(json.to_string().as_bytes()),
        (FieldKind::Text, other) => counted(other.text().unwrap_or_default().as_bytes()),
        _ => {
            out.truncate(begin);
            return false;
        }
    }
    true
}
