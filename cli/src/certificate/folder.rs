//! The folder of a certificate, as `proofs/coq/CERTIFICATE.md` specifies it.

use super::notes::Notes;
use crate::status::Failure;
use std::fs;
use std::path::Path;
use twinedge::validate::certificate::{Certificate, Column, Drawing, Labels};

/// The first line of `claim.txt`; the second one is the claim.
const FIRST_LINE: &str = "twinedge certificate 1\n";
const PLANE: &str = "plane\n";
const DRAWING: &str = "drawing\n";
const CLAIM_FILE: &str = "claim.txt";

/// A certificate as it is in a folder.
pub(super) struct Folder {
    pub(super) certificate: Certificate,
    /// With the claim `drawing`.
    pub(super) drawing: Option<Drawing>,
}

impl Folder {
    /// Writes all columns, and then the claim with these notes below it. What was there of another certificate is overwritten.
    pub(super) fn write(&self, folder: &Path, notes: &Notes) -> Result<(), Failure> {
        fs::create_dir_all(folder).map_err(|error| Failure(format!("{}: {error}", folder.display())))?;
        let claim = folder.join(CLAIM_FILE);
        let has_other_files = fs::read_dir(folder)?.next().is_some();
        if has_other_files && !claim.exists() {
            let name = folder.display();
            return Err(Failure(format!("{name}: this folder has other files, and is not written to")));
        }
        // Without its claim a folder that is not written to the end is unreadable.
        if has_other_files {
            fs::remove_file(&claim)?;
        }
        let columns = self.certificate.columns();
        for column in Column::of_subdivision() {
            write_column(folder, *column, columns.column(*column))?;
        }
        if let Some(drawing) = &self.drawing {
            for column in Column::of_drawing() {
                write_column(folder, *column, drawing.columns.column(*column))?;
            }
            for (axis, name) in ["point_x.i64", "point_y.i64"].into_iter().enumerate() {
                let bytes: Vec<u8> = drawing.points.iter().flat_map(|point| point[axis].to_le_bytes()).collect();
                write_file(&folder.join(name), &bytes)?;
            }
        }
        write_file(&claim, format!("{FIRST_LINE}{}{}", self.claim(), notes.lines()).as_bytes())
    }

    /// The line of the claim.
    pub(super) const fn claim(&self) -> &'static str {
        if self.drawing.is_some() { DRAWING } else { PLANE }
    }

    /// Reads a folder. What is not readable, as the specification says, is a failure.
    ///
    /// All columns are in memory at once: links lead anywhere, and memory maps would be unsafe code.
    pub(super) fn read(folder: &Path) -> Result<Self, Failure> {
        let claim = read_file(&folder.join(CLAIM_FILE))?;
        let claimed = claim.strip_prefix(FIRST_LINE.as_bytes());
        let is_drawing = match claimed {
            Some(line) if line.starts_with(DRAWING.as_bytes()) => true,
            Some(line) if line.starts_with(PLANE.as_bytes()) => false,
            _ => {
                let file = folder.join(CLAIM_FILE);
                return Err(Failure(format!("{}: no claim that is known", file.display())));
            }
        };
        let columns = read_columns(folder, Column::of_subdivision())?;
        let certificate = Certificate::from_columns(columns).ok_or_else(|| {
            Failure(format!("{}: columns of one kind of record have different lengths", folder.display()))
        })?;
        let drawing = if is_drawing { Some(read_drawing(folder)?) } else { None };
        Ok(Self { certificate, drawing })
    }
}

fn read_drawing(folder: &Path) -> Result<Drawing, Failure> {
    let [x, y] = ["point_x.i64", "point_y.i64"].map(|name| -> Result<Vec<i64>, Failure> {
        let bytes = read_file(&folder.join(name))?;
        let (numbers, rest) = bytes.as_chunks();
        refuse_rest(folder, name, rest)?;
        Ok(numbers.iter().map(|number| i64::from_le_bytes(*number)).collect())
    });
    let (x, y) = (x?, y?);
    if x.len() != y.len() {
        return Err(Failure(format!("{}: the columns of points have different lengths", folder.display())));
    }
    let points = x.into_iter().zip(y).map(|(x, y)| [x, y]).collect();
    Ok(Drawing { columns: read_columns(folder, Column::of_drawing())?, points, exponent: 0 })
}

fn read_columns(folder: &Path, wanted: &[Column]) -> Result<Labels, Failure> {
    let mut columns = Labels::default();
    for column in wanted {
        let name = file_name(*column);
        let bytes = read_file(&folder.join(&name))?;
        let (numbers, rest) = bytes.as_chunks();
        refuse_rest(folder, &name, rest)?;
        *columns.column_mut(*column) = numbers.iter().map(|number| u32::from_le_bytes(*number)).collect();
    }
    Ok(columns)
}

fn write_column(folder: &Path, column: Column, numbers: &[u32]) -> Result<(), Failure> {
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    write_file(&folder.join(file_name(column)), &bytes)
}

fn file_name(column: Column) -> String {
    format!("{}.u32", column.name())
}

fn refuse_rest(folder: &Path, name: &str, rest: &[u8]) -> Result<(), Failure> {
    if rest.is_empty() {
        return Ok(());
    }
    Err(Failure(format!("{}: ends in the middle of a number", folder.join(name).display())))
}

fn read_file(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|error| Failure(format!("{}: {error}", path.display())))
}

fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(|error| Failure(format!("{}: {error}", path.display())))
}
