//! The folder of a certificate, as `proofs/coq/CERTIFICATE.md` specifies it.

use super::notes::Notes;
use super::sql::{self, Engine};
use crate::status::Failure;
use std::ffi::OsString;
use std::path::Path;
use std::{fs, io};
use twinedge::validate::certificate::{
    Certificate, Column, Drawing, Failure as FailedTest, Labels, SurfaceCertificate, check_drawing,
};

/// The first line of `claim.txt`; the second one is the claim.
const FIRST_LINE: &str = "twinedge certificate 1\n";
const PLANE: &str = "plane\n";
const DRAWING: &str = "drawing\n";
const SURFACE: &str = "surface\n";
const CLAIM_FILE: &str = "claim.txt";
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

    /// Writes all columns, the tables if they are asked for, and then the claim with these notes below it. A certificate that is there is
    /// replaced.
    pub(super) fn write(&self, folder: &Path, notes: &Notes, sql: Option<Engine>) -> Result<(), Failure> {
        clear(folder)?;
        match self {
            Self::Plane(plane) => plane.write(folder)?,
            Self::Surface(surface) => write_columns(folder, Column::of_surface(), surface.columns())?,
        }
        if let Some(engine) = sql {
            sql::write(folder, self, notes, engine)?;
        }
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

/// Makes the folder, or removes the certificate that is in it. A folder with anything else is left as it is.
fn clear(folder: &Path) -> Result<(), Failure> {
    let name = folder.display();
    let failed = |error: io::Error| Failure(format!("{name}: {error}"));
    fs::create_dir_all(folder).map_err(failed)?;
    let entries = fs::read_dir(folder).map_err(failed)?;
    let there: Vec<OsString> = entries.map(|entry| Ok(entry?.file_name())).collect::<Result<_, _>>().map_err(failed)?;
    let claim = folder.join(CLAIM_FILE);
    if there.is_empty() {
        return Ok(());
    }
    let may_be_there: Vec<OsString> = file_names().map(OsString::from).collect();
    if let Some(other) = there.iter().find(|file| !may_be_there.contains(file)) {
        let other = other.display();
        return Err(Failure(format!("{name}: {other} is no file of a certificate, so the folder is not written to")));
    }
    if !fs::read(&claim).is_ok_and(|claim| claim.starts_with(FIRST_LINE.as_bytes())) {
        return Err(Failure(format!("{name}: this folder has files and no certificate, and is not written to")));
    }
    // Without its second line a folder that is not written to the end is unreadable, and can be written to once more.
    write_file(&claim, FIRST_LINE.as_bytes())?;
    for file in there.iter().filter(|file| *file != CLAIM_FILE) {
        fs::remove_file(folder.join(file)).map_err(failed)?;
    }
    Ok(())
}

/// The names of all files that a certificate may have.
fn file_names() -> impl Iterator<Item = String> {
    let fixed = [CLAIM_FILE, POINT_FILES[0], POINT_FILES[1]].map(str::to_owned);
    Column::ALL.into_iter().map(file_name).chain(fixed).chain(sql::file_names())
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

fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(|error| Failure(format!("{}: {error}", path.display())))
}
