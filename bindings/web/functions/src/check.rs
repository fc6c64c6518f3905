//! `check`: a certificate.

use crate::error::CallError;
use crate::source::NamedFile;
use serde::Deserialize;
use serde_json::{Value, json};
use twinedge_certificate::{Column, Columns, Numbers, Test};
use twinedge_report::certificate::{Claimed, POINT_FILES, file_name};
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    files: Vec<NamedFile>,
}

/// The columns of a certificate, as bytes.
struct Folder {
    columns: Vec<Vec<u8>>,
    points: [Vec<u8>; 2],
}

/// Numbers of 32 bits, the least significant byte first.
#[derive(Clone, Copy)]
struct Bytes<'a>(&'a [u8]);

impl Numbers for Bytes<'_> {
    fn count(self) -> usize {
        self.0.len() / 4
    }

    fn at(self, i: usize) -> Option<u32> {
        self.0.as_chunks().0.get(i).copied().map(u32::from_le_bytes)
    }
}

impl Columns for Folder {
    type Numbers<'a> = Bytes<'a>;

    fn column(&self, column: Column) -> Bytes<'_> {
        Bytes(self.columns.get(column as usize).map(Vec::as_slice).unwrap_or_default())
    }

    fn points(&self) -> usize {
        self.points[0].len() / 8
    }

    fn point(&self, i: usize) -> Option<[i64; 2]> {
        let coordinate = |axis: usize| self.points[axis].as_chunks().0.get(i).copied().map(i64::from_le_bytes);
        Some([coordinate(0)?, coordinate(1)?])
    }
}

pub(crate) fn answer(asked: Request, buffers: &mut Buffers) -> Result<Value, CallError> {
    // The files may be given with folders: only the file name counts.
    let mut files: Vec<(String, Vec<u8>)> = asked
        .files
        .into_iter()
        .map(|file| (file.name.rsplit('/').next().unwrap_or_default().to_owned(), file.bytes.take(buffers)))
        .collect();
    let mut take = |name: &str, bytes: usize| {
        let place = files.iter().position(|(other, _)| other == name);
        let place = place.ok_or_else(|| CallError::new("content", format!("{name} is missing")))?;
        let found = files.swap_remove(place).1;
        if found.len().is_multiple_of(bytes) {
            Ok(found)
        } else {
            Err(CallError::new("content", format!("{name} ends in the middle of a number")))
        }
    };
    let claim = take("claim.txt", 1)?;
    let claimed = Claimed::of(&claim).ok_or_else(|| CallError::new("content", "claim.txt: no claim that is known"))?;
    let mut columns = vec![Vec::new(); Column::ALL.len()];
    for column in claimed.columns() {
        columns[column as usize] = take(&file_name(column), 4)?;
    }
    let mut points = [Vec::new(), Vec::new()];
    if claimed == Claimed::Drawing {
        for (column, name) in points.iter_mut().zip(POINT_FILES) {
            *column = take(name, 8)?;
        }
        if points[0].len() != points[1].len() {
            return Err(CallError::new("content", "the columns of points have different lengths"));
        }
    }
    match claimed.check(&Folder { columns, points }) {
        None => Err(CallError::new("content", "columns of one kind of record have different lengths")),
        Some(Ok(claim)) => Ok(json!({ "valid": true, "claim": claim, "failures": [] })),
        Some(Err(failures)) if failures.iter().any(|failure| failure.test() == Test::Readable) => Err(CallError::new(
            "content",
            "the length of a column is wrong or too large, a point is not there, or a coordinate is out of range",
        )),
        Some(Err(failures)) => {
            let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
            Ok(json!({ "valid": false, "claim": null, "failures": lines }))
        }
    }
}
