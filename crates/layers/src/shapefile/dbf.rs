//! The table of a Shapefile: dBASE III, columns of fixed width.

use super::super::error::{Cause, Place, ReadError};
use super::super::model::{Field, FieldKind, Layer, Value};
use super::charset::Charset;
use super::columns::{Column, text};
use super::failed::{content, truncated};
use std::io::{self, BufRead, Write};
use std::sync::Arc;

const VERSION: u8 = 3;

const END_OF_COLUMNS: u8 = 0x0D;

const END: u8 = 0x1A;

const DELETED: u8 = b'*';

/// The size of the header before the columns, and of each column.
const PART: usize = 32;

/// The largest size of the header and of a record.
const LARGEST: usize = u16::MAX as usize;

struct ReadColumn {
    name: Arc<str>,
    kind: u8,
    width: usize,
    decimals: usize,
}

pub(super) struct Table<R> {
    reader: R,
    columns: Vec<ReadColumn>,
    charset: Charset,
    pub(super) count: usize,
    record: Vec<u8>,
}

impl<R: BufRead> Table<R> {
    pub(super) fn open(mut reader: R, charset: Option<&str>) -> Result<Self, ReadError> {
        let failed = |cause| content(Place::Header, cause);
        let invalid = |message: &str| failed(Cause::Invalid(format!("the table (.dbf): {message}")));
        let mut head = [0; PART];
        reader.read_exact(&mut head).map_err(|error| truncated(error, "the header of the table", failed))?;
        let count = u32::from_le_bytes([head[4], head[5], head[6], head[7]]) as usize;
        let header = usize::from(u16::from_le_bytes([head[8], head[9]]));
        let record = usize::from(u16::from_le_bytes([head[10], head[11]]));
        let charset = Charset::of(charset, head[29]);
        let rest = header.checked_sub(PART).ok_or_else(|| invalid("its header is shorter than any"))?;
        let mut rest = vec![0; rest];
        reader.read_exact(&mut rest).map_err(|error| truncated(error, "the columns of the table", failed))?;
        let mut columns = Vec::new();
        for part in rest.chunks_exact(PART).take_while(|part| part[0] != END_OF_COLUMNS) {
            let name = part[..11].split(|byte| *byte == 0).next().unwrap_or_default();
            let name = charset.decode(name.trim_ascii()).map_err(failed)?;
            let kind = part[11].to_ascii_uppercase();
            // The width of a text may have two bytes.
            let (width, decimals) = match kind {
                b'C' => (usize::from(u16::from_le_bytes([part[16], part[17]])), 0),
                _ => (usize::from(part[16]), usize::from(part[17])),
            };
            if !matches!(kind, b'C' | b'N' | b'F' | b'L' | b'D' | b'I' | b'O') {
                let kind = char::from(kind).escape_default();
                return Err(invalid(&format!("the column {name} is of the type {kind}, which is not read here")));
            }
            let fixed = match kind {
                b'I' => 4,
                b'O' => 8,
                _ => width,
            };
            if width != fixed {
                return Err(invalid(&format!("the column {name} has {width} bytes, and its type {fixed}")));
            }
            columns.push(ReadColumn { name: name.into(), kind, width, decimals });
        }
        let widths: usize = columns.iter().map(|column| column.width).sum();
        if widths + 1 != record {
            return Err(invalid(&format!(
                "its records have {record} bytes, and its columns with the mark {}",
                widths + 1
            )));
        }
        Ok(Self { reader, columns, charset, count, record: vec![0; record] })
    }

    pub(super) fn fields(&self) -> Vec<Field> {
        let field = |column: &ReadColumn| Field {
            name: column.name.clone(),
            kind: match column.kind {
                b'L' => FieldKind::Bool,
                b'D' => FieldKind::Date,
                b'I' => FieldKind::Integer,
                b'N' | b'F' if column.decimals == 0 && column.kind == b'N' => FieldKind::Integer,
                b'N' | b'F' | b'O' => FieldKind::Real,
                _ => FieldKind::Text,
            },
            width: Some(column.width),
            decimals: matches!(column.kind, b'N' | b'F').then_some(column.decimals),
        };
        self.columns.iter().map(field).collect()
    }

    /// Returns the deletion mark and the values of the next record; none after the last.
    #[allow(clippy::type_complexity, reason = "a name for it would say no more")]
    pub(super) fn next(&mut self, number: usize) -> Result<Option<(bool, Vec<(Arc<str>, Value)>)>, ReadError> {
        if number >= self.count {
            return Ok(None);
        }
        let failed = |cause| content(Place::Feature(number), cause);
        self.reader.read_exact(&mut self.record).map_err(|error| truncated(error, "a record of the table", failed))?;
        let Some((mark, mut rest)) = self.record.split_first() else { return Ok(None) };
        let mut values = Vec::with_capacity(self.columns.len());
        for column in &self.columns {
            let (bytes, others) = rest.split_at(column.width);
            rest = others;
            values.push((column.name.clone(), column.value(bytes, &self.charset).map_err(failed)?));
        }
        Ok(Some((*mark == DELETED, values)))
    }
}

impl ReadColumn {
    fn value(&self, bytes: &[u8], charset: &Charset) -> Result<Value, Cause> {
        let blank = |byte: &u8| matches!(byte, b' ' | 0);
        let trimmed = bytes.trim_ascii();
        let end = bytes.iter().rposition(|byte| !blank(byte)).map_or(0, |last| last + 1);
        Ok(match self.kind {
            b'I' => bytes.try_into().map_or(Value::Null, |bytes| Value::Integer(i32::from_le_bytes(bytes).into())),
            b'O' => bytes.try_into().map_or(Value::Null, |bytes| Value::Real(f64::from_le_bytes(bytes))),
            _ if end == 0 => Value::Null,
            b'L' => match trimmed {
                b"T" | b"t" | b"Y" | b"y" | b"1" => Value::Bool(true),
                b"F" | b"f" | b"N" | b"n" | b"0" => Value::Bool(false),
                _ => Value::Null,
            },
            b'D' => match std::str::from_utf8(trimmed) {
                Ok("00000000") => Value::Null,
                Ok(text) if text.len() == 8 && text.bytes().all(|byte| byte.is_ascii_digit()) => {
                    Value::Date(format!("{}-{}-{}", &text[..4], &text[4..6], &text[6..]))
                }
                _ => Value::Text(charset.decode(&bytes[..end])?),
            },
            b'N' | b'F' => self.number(&bytes[..end])?,
            _ => Value::Text(charset.decode(&bytes[..end])?),
        })
    }

    fn number(&self, bytes: &[u8]) -> Result<Value, Cause> {
        // A value too long for its column is written as stars.
        if bytes.contains(&b'*') {
            return Ok(Value::Null);
        }
        let wrong = |text: &str| Cause::Invalid(format!("{} is {text:?}, which is no number", self.name));
        let text = std::str::from_utf8(bytes).map_err(|_| wrong(&String::from_utf8_lossy(bytes)))?.trim();
        if self.decimals == 0 && self.kind == b'N' {
            if let Ok(value) = text.parse() {
                return Ok(Value::Integer(value));
            }
            if let Ok(value) = text.parse::<u64>() {
                return Ok(Value::Json(value.into()));
            }
        }
        text.parse().map(Value::Real).map_err(|_| wrong(text))
    }
}

pub(super) fn check_size(columns: &[Column]) -> Result<(), String> {
    let record: usize = columns.iter().map(|column| usize::from(column.width)).sum();
    match (columns.len() + 1) * PART + 1 {
        header if header > LARGEST => Err(format!("{} columns", columns.len())),
        _ if record + 1 > LARGEST => Err(format!("records of {record} bytes")),
        _ => Ok(()),
    }
}

pub(super) fn write(layer: &Layer, columns: &[Column], out: &mut impl Write) -> io::Result<()> {
    // A table has at least one column.
    let alone = [Column { source: "".into(), name: "FID".to_owned(), kind: b'N', width: 10, decimals: 0 }];
    let numbers_only = columns.is_empty();
    let columns = if numbers_only { &alone } else { columns };
    let width: usize = columns.iter().map(|column| usize::from(column.width)).sum();
    // The date of the last change is not part of the content.
    let mut header = vec![VERSION, 126, 1, 1];
    header.extend((layer.features.len() as u32).to_le_bytes());
    header.extend((((columns.len() + 1) * PART + 1) as u16).to_le_bytes());
    header.extend(((width + 1) as u16).to_le_bytes());
    header.resize(PART, 0);
    for column in columns {
        let start = header.len();
        header.extend(column.name.as_bytes());
        header.resize(start + 11, 0);
        header.push(column.kind);
        header.resize(start + 16, 0);
        header.extend([column.width, column.decimals]);
        header.resize(start + PART, 0);
    }
    header.push(END_OF_COLUMNS);
    out.write_all(&header)?;
    for (number, feature) in layer.features.iter().enumerate() {
        out.write_all(b" ")?;
        for column in columns {
            let width = usize::from(column.width);
            let value = if numbers_only {
                number.to_string()
            } else {
                feature.get(&column.source).map(|value| text(column, value)).unwrap_or_default()
            };
            // The width counts bytes; padding by `format!` counts characters.
            let padding = " ".repeat(width.saturating_sub(value.len()));
            let (before, after) = if column.kind == b'N' { (&*padding, "") } else { ("", &*padding) };
            write!(out, "{before}{value}{after}")?;
        }
    }
    out.write_all(&[END])
}
