//! Values of attributes: conversion from Parquet to a layer.

use super::super::error::Cause;
use super::super::model::{FieldKind, Value, hex};
use super::moment;
use parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type as Physical};
use parquet::record::Field;
use parquet::schema::types::Type;
use serde_json::Value as Json;

/// Decimal numbers of up to this number of digits become 64-bit numbers, which preserve these digits. Longer ones become texts.
const DIGITS: i32 = 15;

pub(super) fn kind(column: &Type) -> FieldKind {
    if column.is_group() {
        return FieldKind::Json;
    }
    let info = column.get_basic_info();
    match (info.converted_type(), info.logical_type_ref()) {
        (_, Some(LogicalType::Timestamp(_)))
        | (ConvertedType::TIMESTAMP_MILLIS | ConvertedType::TIMESTAMP_MICROS, _) => FieldKind::DateTime,
        (_, Some(LogicalType::Time(_)))
        | (ConvertedType::UTF8 | ConvertedType::ENUM | ConvertedType::TIME_MILLIS | ConvertedType::TIME_MICROS, _) => {
            FieldKind::Text
        }
        (ConvertedType::DATE, _) => FieldKind::Date,
        (ConvertedType::JSON, _) => FieldKind::Json,
        (ConvertedType::DECIMAL, _) if column.get_precision() <= DIGITS => FieldKind::Real,
        (ConvertedType::DECIMAL, _) => FieldKind::Text,
        (_, Some(LogicalType::Float16)) => FieldKind::Real,
        _ => match column.get_physical_type() {
            Physical::BOOLEAN => FieldKind::Bool,
            Physical::INT32 | Physical::INT64 => FieldKind::Integer,
            Physical::INT96 => FieldKind::DateTime,
            Physical::FLOAT | Physical::DOUBLE => FieldKind::Real,
            Physical::BYTE_ARRAY | Physical::FIXED_LEN_BYTE_ARRAY => FieldKind::Bytes,
        },
    }
}

/// Returns true if a column, or a part of it, is of an unsupported type.
pub(super) fn is_interval(column: &Type) -> bool {
    column.get_basic_info().converted_type() == ConvertedType::INTERVAL
        || column.is_group() && column.get_fields().iter().any(|part| is_interval(part))
}

pub(super) fn value(field: Field, column: &Type) -> Result<Value, Cause> {
    let info = column.get_basic_info();
    match (field, info.logical_type_ref()) {
        (Field::Long(number), Some(LogicalType::Timestamp(of))) if of.unit == TimeUnit::NANOS => {
            moment_of(number.into(), of.is_adjusted_to_u_t_c)
        }
        (Field::TimestampMillis(number), of) => moment_of(i128::from(number) * 1_000_000, is_utc(of)),
        (Field::TimestampMicros(number), of) => moment_of(i128::from(number) * 1_000, is_utc(of)),
        (Field::Str(text), _) if info.converted_type() == ConvertedType::JSON => {
            let json = serde_json::from_str(&text);
            json.map(Value::Json).map_err(|error| Cause::Invalid(format!("a value that is not JSON: {error}")))
        }
        (Field::Bytes(bytes), _) => Ok(Value::Bytes(bytes.data().to_vec())),
        (Field::Date(days), _) => moment::day(days.into()).map(Value::Date).ok_or_else(beyond),
        (field @ Field::Decimal(_), _) if kind(column) == FieldKind::Real => {
            field.to_string().parse().map(Value::Real).map_err(|_| Cause::Invalid("a decimal number".to_owned()))
        }
        // A non-finite number remains one in a column of numbers. In lists it becomes null, as JSON cannot represent it.
        (Field::Float16(number), _) => Ok(Value::Real(number.to_f64())),
        (Field::Float(number), _) => Ok(Value::Real(number.into())),
        (Field::Double(number), _) => Ok(Value::Real(number)),
        (field @ (Field::Group(_) | Field::ListInternal(_) | Field::MapInternal(_)), _) => {
            Ok(Value::Json(json(&field)?))
        }
        (field, _) => Ok(Value::of_json(json(&field)?)),
    }
}

/// Returns true for UTC, the default of types without a mark.
fn is_utc(logical: Option<&LogicalType>) -> bool {
    !matches!(logical, Some(LogicalType::Timestamp(of)) if !of.is_adjusted_to_u_t_c)
}

fn moment_of(nanoseconds: i128, is_utc: bool) -> Result<Value, Cause> {
    moment::moment(nanoseconds, is_utc).map(Value::DateTime).ok_or_else(beyond)
}

fn beyond() -> Cause {
    Cause::Invalid("a day or a time beyond the years 0 to 9999".to_owned())
}

/// Converts a value inside a list, a map or a structure to JSON. The recursion is as deep as the schema.
fn json(field: &Field) -> Result<Json, Cause> {
    let moment = |nanoseconds| moment::moment(nanoseconds, true).map(Json::from).ok_or_else(beyond);
    Ok(match field {
        Field::Null => Json::Null,
        Field::Bool(value) => (*value).into(),
        Field::Byte(number) => (*number).into(),
        Field::Short(number) => (*number).into(),
        Field::Int(number) => (*number).into(),
        Field::Long(number) => (*number).into(),
        Field::UByte(number) => (*number).into(),
        Field::UShort(number) => (*number).into(),
        Field::UInt(number) => (*number).into(),
        Field::ULong(number) => (*number).into(),
        Field::Float16(number) => number.to_f64().into(),
        Field::Float(number) => f64::from(*number).into(),
        Field::Double(number) => (*number).into(),
        Field::Str(text) => text.as_str().into(),
        Field::Bytes(bytes) => hex(bytes.data()).into(),
        Field::Date(days) => moment::day((*days).into()).ok_or_else(beyond)?.into(),
        Field::TimestampMillis(number) => moment(i128::from(*number) * 1_000_000)?,
        Field::TimestampMicros(number) => moment(i128::from(*number) * 1_000)?,
        Field::TimeMillis(number) => clock(i128::from(*number) * 1_000_000)?,
        Field::TimeMicros(number) => clock(i128::from(*number) * 1_000)?,
        Field::Decimal(_) => field.to_string().into(),
        Field::Group(row) => {
            let members = row.get_column_iter().map(|(name, field)| Ok((name.clone(), json(field)?)));
            Json::Object(members.collect::<Result<_, Cause>>()?)
        }
        Field::ListInternal(list) => list.elements().iter().map(json).collect::<Result<_, Cause>>()?,
        Field::MapInternal(map) => {
            let member = |(key, field): &(Field, Field)| {
                let key = match json(key)? {
                    Json::String(text) => text,
                    other => other.to_string(),
                };
                Ok((key, json(field)?))
            };
            Json::Object(map.entries().iter().map(member).collect::<Result<_, Cause>>()?)
        }
    })
}

/// Returns a time of day, such as `12:30:00`.
fn clock(nanoseconds: i128) -> Result<Json, Cause> {
    let text = moment::moment(nanoseconds, false).ok_or_else(beyond)?;
    Ok(text.split_once('T').map(|(_, time)| time).unwrap_or_default().into())
}
