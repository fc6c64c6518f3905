//! The folder of a certificate, as `proofs/coq/CERTIFICATE.md` specifies it.

use super::notes::Notes;
use crate::status::Failure;
use std::fs;
use std::path::Path;
use twinedge::validate::certificate::{
    Certificate, Column, Drawing, Failure as FailedTest, Labels, SurfaceCertificate, check_drawing,
};

/// The first line of `claim.txt`; the second one is the claim.
pub(super) const FIRST_LINE: &str = "twinedge certificate 1\n";
const PLANE: &str = "plane\n";
const DRAWING: &str = "drawing\n";
const SURFACE: &str = "surface\n";
pub(super) const CLAIM_FILE: &str = "claim.txt";
const POINT_FILES: [&str; 2] = ["point_x.i64", "point_y.i64"];

/// A certificate by its claim.
pub(super) enum Claim {
    /// The claims `plane` and `drawing`.
    Plane(Box<Folder>),
    /// The claim `surface`.
    Surface(Box<SurfaceCertificate>),
}

/// A certificate of a plane subdivision as it is in a folder.
pub(super) struct Folder {
    pub(super) certificate: Certificate,
    /// With the claim `drawing`.
    pub(super) drawing: Option<Drawing>,
}

impl Claim {
    /// Checks the certificate, and gives the claim in words, or the tests that fail.
    pub(super) fn check(&self) -> Result<String, Vec<FailedTest>> {
        let plane = "a plane subdivision";
        match self {
            Self::Plane(folder) => match &**folder {
                Folder { certificate, drawing: None } => certificate.check().map(|()| plane.to_owned()),
                Folder { certificate, drawing: Some(drawing) } => {
                    let checked = check_drawing(certificate, certificate.columns(), drawing);
                    checked.map(|()| format!("{plane}, drawn without crossings"))
                }
            },
            Self::Surface(certificate) => certificate.check().map(|counts| counts.to_string()),
        }
    }

    /// The second line of its claim.
    pub(super) fn line(&self) -> &'static str {
        match self {
            Self::Plane(folder) if folder.drawing.is_some() => DRAWING,
            Self::Plane(_) => PLANE,
            Self::Surface(_) => SURFACE,
        }
    }

    /// Writes all columns.
    pub(super) fn write_columns(&self, folder: &Path) -> Result<(), Failure> {
        match self {
            Self::Plane(plane) => plane.write(folder),
            Self::Surface(surface) => write_columns(folder, Column::of_surface(), surface.columns()),
        }
    }

    /// Writes the claim with these notes below it.
    pub(super) fn write_claim(&self, folder: &Path, notes: &Notes) -> Result<(), Failure> {
        let claim = format!("{FIRST_LINE}{}{}", self.line(), notes.lines());
        write_file(&folder.join(CLAIM_FILE), claim.as_bytes())
    }

    /// Reads a folder. What is not readable, as the specification says, is a failure.
    ///
    /// All columns are in memory at once: links lead anywhere, and memory maps would be unsafe code.
    pub(super) fn read(folder: &Path) -> Result<Self, Failure> {
        let file = folder.join(CLAIM_FILE);
        let claim = read_file(&file)?;
        let claimed = claim.strip_prefix(FIRST_LINE.as_bytes()).unwrap_or_default();
        let claims = |line: &str| claimed.starts_with(line.as_bytes());
        let lengths = || Failure(format!("{}: columns of one kind of record have different lengths", folder.display()));
        if claims(SURFACE) {
            let columns = read_columns(folder, Column::of_surface())?;
            let certificate = SurfaceCertificate::from_columns(columns).ok_or_else(lengths)?;
            return Ok(Self::Surface(Box::new(certificate)));
        }
        if !claims(PLANE) && !claims(DRAWING) {
            return Err(Failure(format!("{}: no claim that is known", file.display())));
        }
        let columns = read_columns(folder, Column::of_subdivision())?;
        let certificate = Certificate::from_columns(columns).ok_or_else(lengths)?;
        let drawing = if claims(DRAWING) { Some(read_drawing(folder)?) } else { None };
        Ok(Self::Plane(Box::new(Folder { certificate, drawing })))
    }
}

impl Folder {
    /// Writes all columns.
    fn write(&self, folder: &Path) -> Result<(), Failure> {
        write_columns(folder, Column::of_subdivision(), self.certificate.columns())?;
        if let Some(drawing) = &self.drawing {
            write_columns(folder, Column::of_drawing(), &drawing.columns)?;
            for (axis, name) in POINT_FILES.into_iter().enumerate() {
                let bytes: Vec<u8> = drawing.points.iter().flat_map(|point| point[axis].to_le_bytes()).collect();
                write_file(&folder.join(name), &bytes)?;
            }
        }
        Ok(())
    }
}

/// The names of all files that a certificate may have without tables.
pub(super) fn file_names() -> impl Iterator<Item = String> {
    let fixed = [CLAIM_FILE, POINT_FILES[0], POINT_FILES[1]].map(str::to_owned);
    Column::ALL.into_iter().map(file_name).chain(fixed)
}

fn read_drawing(folder: &Path) -> Result<Drawing, Failure> {
    let [x, y] = POINT_FILES.map(|name| -> Result<Vec<i64>, Failure> {
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

fn write_columns(folder: &Path, wanted: &[Column], columns: &Labels) -> Result<(), Failure> {
    for column in wanted {
        let bytes: Vec<u8> = columns.column(*column).iter().flat_map(|number| number.to_le_bytes()).collect();
        write_file(&folder.join(file_name(*column)), &bytes)?;
    }
    Ok(())
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

pub(super) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(|error| Failure(format!("{}: {error}", path.display())))
}
