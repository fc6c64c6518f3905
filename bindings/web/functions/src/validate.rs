//! `validate`: half-edges in columns of integers.

use crate::error::CallError;
use crate::source::Buffer;
use serde::Deserialize;
use serde_json::{Value, json};
use twinedge::validate::{Collect, Expectation};
use twinedge_columns::{Column, Columns, ColumnsError};
use twinedge_report::words::json as json_bytes;
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    columns: Given,
    vertices: Option<usize>,
    faces: Option<usize>,
    expectation: String,
    options: Asked,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Given {
    origin: Option<Buffer>,
    target: Option<Buffer>,
    twin: Option<Buffer>,
    next: Option<Buffer>,
    prev: Option<Buffer>,
    face: Option<Buffer>,
    leaving: Option<Buffer>,
    outer_half_edge: Option<Buffer>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Asked {
    list: Option<usize>,
}

impl From<ColumnsError> for CallError {
    fn from(error: ColumnsError) -> Self {
        Self::option(error)
    }
}

/// Returns one more than the greatest index. A negative number is no index.
fn slots(column: &[u32]) -> usize {
    column.iter().filter(|index| i32::try_from(**index).is_ok()).max().map_or(0, |greatest| *greatest as usize + 1)
}

pub(crate) fn answer(asked: Request, buffers: &mut Buffers) -> Result<Value, CallError> {
    let Request { columns: given, vertices, faces, expectation, options } = asked;
    let expectation: Expectation =
        expectation.parse().map_err(|error| CallError::option(format!("expectation: {error}")))?;
    // The columns hold signed numbers. Read as unsigned, −1 is still nil, and other negative numbers still lead
    // nowhere.
    let mut column = |buffer: Option<Buffer>| -> Option<Vec<u32>> {
        let bytes = buffer?.take(buffers);
        Some(bytes.as_chunks().0.iter().copied().map(u32::from_le_bytes).collect())
    };
    let [origin, target, twin, next, prev, face, leaving, outer] = [
        given.origin,
        given.target,
        given.twin,
        given.next,
        given.prev,
        given.face,
        given.leaving,
        given.outer_half_edge,
    ]
    .map(&mut column);
    let next = next.ok_or_else(|| CallError::option("the column `next` is missing"))?;
    let (ends, is_target) = match (origin, target) {
        (Some(origin), None) => (origin, false),
        (None, Some(target)) => (target, true),
        _ => return Err(CallError::option("one of the columns `origin` and `target` must be there, and not both")),
    };
    let of_vertices = leaving.as_ref().map_or_else(|| slots(&ends), Vec::len);
    let vertices = vertices.unwrap_or(of_vertices);
    let mut columns = match &twin {
        Some(twin) => Columns::new(vertices, Column::new(&ends), Column::new(twin), Column::new(&next))?,
        None => Columns::paired(vertices, Column::new(&ends), Column::new(&next))?,
    };
    if is_target {
        columns = columns.by_target();
    }
    if let Some(prev) = &prev {
        columns = columns.with_prev(Column::new(prev))?;
    }
    if let Some(face) = &face {
        let of_faces = outer.as_ref().map_or_else(|| slots(face), Vec::len);
        columns = columns.with_faces(faces.unwrap_or(of_faces), Column::new(face))?;
    }
    if let Some(leaving) = &leaving {
        columns = columns.with_leaving(Column::new(leaving))?;
    }
    if let Some(outer) = &outer {
        columns = columns.with_outer_half_edge(Column::new(outer))?;
    }
    let collect = Collect::AtMost(options.list.unwrap_or(Collect::DEFAULT_CAP));
    let report = columns.validate(expectation, collect);
    let report = report.ok_or_else(|| CallError::new("too-large", "there are more records than memory"))?;
    let bytes = json_bytes(&report)?;
    Ok(json!({ "report": Buffer::put(buffers, bytes) }))
}
