//! The folder of a certificate, as `proofs/coq/CERTIFICATE.md` specifies it.

use super::paged::Paged;
use crate::output::Failure;
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;
use twinedge_certificate::{Certificate, Column, Drawing, Failure as FailedTest, Labels, SurfaceCertificate};
use twinedge_report::certificate::{Claimed, FIRST_LINE, POINT_FILES, check_plane, check_surface, file_name};

/// An upper bound for the bytes of the first two lines of a claim.
const LINES: u64 = 64;
pub(super) const CLAIM_FILE: &str = "claim.txt";

pub(super) enum Claim {
    Plane(Box<Folder>),
    Surface(Box<SurfaceCertificate>),
}

/// A certificate of a plane subdivision, as stored in a folder.
pub(super) struct Folder {
    pub(super) certificate: Certificate,
    /// The drawing, for the claim `drawing`.
    pub(super) drawing: Option<Drawing>,
}

impl Claim {
    /// Checks the certificate. Returns the claim in words, or the failed tests.
    pub(super) fn check(&self) -> Result<String, Vec<FailedTest>> {
        match self {
            Self::Plane(folder) => check_plane(&folder.certificate, folder.drawing.as_ref()),
            Self::Surface(certificate) => check_surface(certificate),
        }
    }

    pub(super) fn line(&self) -> &'static str {
        match self {
            Self::Plane(folder) if folder.drawing.is_some() => Claimed::Drawing.line(),
            Self::Plane(_) => Claimed::Plane.line(),
            Self::Surface(_) => Claimed::Surface.line(),
        }
    }

    pub(super) fn write_columns(&self, folder: &Path) -> Result<(), Failure> {
        match self {
            Self::Plane(plane) => plane.write(folder),
            Self::Surface(surface) => write_columns(folder, Column::of_surface(), surface.columns()),
        }
    }

    pub(super) fn write_claim(&self, folder: &Path, notes: &Notes) -> Result<(), Failure> {
        let claim = format!("{FIRST_LINE}{}{}", self.line(), notes.lines());
        write_file(&folder.join(CLAIM_FILE), claim.as_bytes())
    }
}

/// Checks a folder. Returns its claim in words, or the failed tests. A folder that is unreadable by the specification is a failure.
///
/// Links lead anywhere, so pages of all columns are cached within `memory` bytes, and others are read again on demand.
pub(super) fn check(folder: &Path, memory: u64) -> Result<Result<String, Vec<FailedTest>>, Failure> {
    let file = folder.join(CLAIM_FILE);
    let mut lines = Vec::new();
    let read = File::open(&file).and_then(|file| file.take(LINES).read_to_end(&mut lines));
    read.map_err(|error| Failure(format!("{}: {error}", file.display())))?;
    let claimed = Claimed::of(&lines).ok_or_else(|| Failure(format!("{}: no claim that is known", file.display())))?;
    let paged = Paged::open(folder, &claimed.columns(), claimed == Claimed::Drawing, memory)?;
    let checked = claimed.check(&paged);
    let lengths = || Failure(format!("{}: columns of one kind of record have different lengths", folder.display()));
    paged.failure().map_or_else(|| checked.ok_or_else(lengths), Err)
}

impl Folder {
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

/// The names of all files of a certificate without tables.
pub(super) fn file_names() -> impl Iterator<Item = String> {
    let fixed = [CLAIM_FILE, POINT_FILES[0], POINT_FILES[1]].map(str::to_owned);
    Column::ALL.into_iter().map(file_name).chain(fixed)
}

fn write_columns(folder: &Path, wanted: &[Column], columns: &Labels) -> Result<(), Failure> {
    for column in wanted {
        let bytes: Vec<u8> = columns.column(*column).iter().flat_map(|number| number.to_le_bytes()).collect();
        write_file(&folder.join(file_name(*column)), &bytes)?;
    }
    Ok(())
}

pub(super) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(|error| Failure(format!("{}: {error}", path.display())))
}

pub(super) struct Notes(Vec<(&'static str, String)>);

impl Notes {
    /// Creates the notes on the certificate of the named input: the SHA-256 of its file if it is one, the numbers of records, and the exponent of the
    /// coordinates' unit, a power of two.
    pub(super) fn new(name: &str, sha256: Option<String>, counts: &str, exponent: Option<i32>) -> Self {
        let mut notes = vec![("of", name.escape_debug().to_string())];
        notes.extend(sha256.map(|sha256| ("sha256", sha256)));
        notes.push(("counts", counts.to_owned()));
        notes.extend(exponent.map(|exponent| ("unit", format!("2^{exponent}"))));
        notes.push(("by", concat!("twinedge ", env!("CARGO_PKG_VERSION")).to_owned()));
        Self(notes)
    }

    pub(super) fn entries(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.0.iter().map(|(key, value)| (*key, value.as_str()))
    }

    pub(super) fn lines(&self) -> String {
        self.entries().fold(String::new(), |lines, (key, value)| format!("{lines}{key} {value}\n"))
    }
}
