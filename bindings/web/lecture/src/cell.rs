//! A cell of a table, which takes any value, valid or not.

use crate::error::LessonError;
use twinedge::validate::{BoundaryPlace, Link, Record, Start, Table};

/// Returns the number after a letter, as in `h3`.
fn numbered(text: &str, letter: char) -> Option<usize> {
    text.strip_prefix(letter)?.parse().ok()
}

/// The text of a field's value; `-` stands for nil.
struct Value<'a> {
    text: &'a str,
    field: &'a str,
}

impl Value<'_> {
    fn read<T>(&self, expected: &'static str, read: impl Fn(&str) -> Option<T>) -> Result<Option<T>, LessonError> {
        if self.text == "-" || self.text.is_empty() {
            return Ok(None);
        }
        read(self.text).map(Some).ok_or_else(|| LessonError::Value {
            value: self.text.to_owned(),
            field: self.field.to_owned(),
            expected,
        })
    }

    fn vertex(&self) -> Result<Link, LessonError> {
        self.read("a vertex such as v2, or - for nil", |text| numbered(text, 'v'))
    }

    fn half_edge(&self) -> Result<Link, LessonError> {
        self.read("a half-edge such as h2, or - for nil", |text| numbered(text, 'h'))
    }

    fn boundary(&self) -> Result<Link, LessonError> {
        self.read("a boundary component such as b2, or - for nil", |text| numbered(text, 'b'))
    }

    fn face(&self) -> Result<Link, LessonError> {
        self.read("a face such as f2, or - for nil", |text| numbered(text, 'f'))
    }

    fn start(&self) -> Result<Option<Start>, LessonError> {
        self.read("a half-edge or a vertex such as h2 or v2, or - for nil", |text| {
            numbered(text, 'h').map(Start::HalfEdge).or_else(|| numbered(text, 'v').map(Start::Vertex))
        })
    }

    fn place(&self) -> Result<Option<BoundaryPlace>, LessonError> {
        self.read("outer, or a position in the list of inner ones such as 0, or - for nil", |text| match text {
            "outer" => Some(BoundaryPlace::Outer),
            _ => text.parse().ok().map(BoundaryPlace::Inner),
        })
    }

    fn list(&self) -> Result<Vec<Link>, LessonError> {
        self.text.split_whitespace().map(|text| Value { text, field: self.field }.boundary()).collect()
    }
}

/// Sets a field of a record.
///
/// # Errors
/// [`LessonError::NoRecord`], [`LessonError::NoField`] and [`LessonError::Value`]; the table is unchanged.
pub(crate) fn set(table: &mut Table, record: Record, field: &str, text: &str) -> Result<(), LessonError> {
    let value = Value { text: text.trim(), field };
    let missing = LessonError::NoRecord(record);
    let no_field = |kind| Err(LessonError::NoField(kind, field.to_owned()));
    match record {
        Record::Vertex(v) => {
            let row = table.vertices.get_mut(v).and_then(Option::as_mut).ok_or(missing)?;
            match field {
                "leaving" => row.leaving = value.half_edge()?,
                "isolated" => row.isolated = value.boundary()?,
                _ => return no_field("vertex"),
            }
        }
        Record::HalfEdge(h) => {
            let row = table.half_edges.get_mut(h).and_then(Option::as_mut).ok_or(missing)?;
            match field {
                "origin" => row.origin = value.vertex()?,
                "twin" => row.twin = value.half_edge()?,
                "next" => row.next = value.half_edge()?,
                "prev" => row.prev = value.half_edge()?,
                "boundary" => row.boundary = value.boundary()?,
                _ => return no_field("half-edge"),
            }
        }
        Record::Boundary(b) => {
            let row = table.boundaries.get_mut(b).and_then(Option::as_mut).ok_or(missing)?;
            match field {
                "face" => row.face = value.face()?,
                "start" => row.start = value.start()?,
                "place" => row.place = value.place()?,
                _ => return no_field("boundary component"),
            }
        }
        Record::Face(f) => {
            let row = table.faces.get_mut(f).and_then(Option::as_mut).ok_or(missing)?;
            match field {
                "outer" => row.outer = value.boundary()?,
                "inner" => row.inner = value.list()?,
                _ => return no_field("face"),
            }
        }
    }
    Ok(())
}
