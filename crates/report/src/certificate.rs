//! Certificates in a folder: `claim.txt` and a file for each column (`proofs/coq/CERTIFICATE.md`).

use twinedge_certificate::{Certificate, Column, Columns, Failure, SurfaceCertificate, check_drawing};

/// The first line of `claim.txt`; the second one is the claim.
pub const FIRST_LINE: &str = "twinedge certificate 1\n";

/// The files with the points of a drawing.
pub const POINT_FILES: [&str; 2] = ["point_x.i64", "point_y.i64"];

/// Returns the name of a column's file.
#[must_use]
pub fn file_name(column: Column) -> String {
    format!("{}.u32", column.name())
}

/// The claim of a certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claimed {
    /// A plane subdivision.
    Plane,
    /// A plane subdivision drawn without crossings.
    Drawing,
    /// A surface.
    Surface,
}

impl Claimed {
    const ALL: [Self; 3] = [Self::Plane, Self::Drawing, Self::Surface];

    /// Returns the second line of `claim.txt`.
    #[must_use]
    pub const fn line(self) -> &'static str {
        match self {
            Self::Plane => "plane\n",
            Self::Drawing => "drawing\n",
            Self::Surface => "surface\n",
        }
    }

    /// Returns the claim of a file with this beginning; `None` if the claim is unknown.
    #[must_use]
    pub fn of(claim: &[u8]) -> Option<Self> {
        let claimed = claim.strip_prefix(FIRST_LINE.as_bytes())?;
        Self::ALL.into_iter().find(|claim| claimed.starts_with(claim.line().as_bytes()))
    }

    /// Returns the columns of the claim.
    #[must_use]
    pub fn columns(self) -> Vec<Column> {
        match self {
            Self::Plane => Column::of_subdivision().to_vec(),
            Self::Drawing => [Column::of_subdivision(), Column::of_drawing()].concat(),
            Self::Surface => Column::of_surface().to_vec(),
        }
    }

    /// Checks columns. Returns the claim in words or the failed tests; `None` if columns of one kind of record differ in length.
    pub fn check<C: Columns>(self, columns: &C) -> Option<Result<String, Vec<Failure>>> {
        Some(match self {
            Self::Plane => check_plane(&Certificate::from_columns(columns)?, None::<&C>),
            Self::Drawing => check_plane(&Certificate::from_columns(columns)?, Some(columns)),
            Self::Surface => check_surface(&SurfaceCertificate::from_columns(columns)?),
        })
    }
}

/// Checks a certificate of a plane subdivision, and returns the claim in words.
///
/// # Errors
/// The failed tests.
pub fn check_plane<C: Columns, D: Columns>(
    certificate: &Certificate<C>,
    drawing: Option<&D>,
) -> Result<String, Vec<Failure>> {
    let plane = "a plane subdivision";
    match drawing {
        None => certificate.check().map(|()| plane.to_owned()),
        Some(drawing) => {
            let checked = check_drawing(certificate, certificate.columns(), drawing);
            checked.map(|()| format!("{plane}, drawn without crossings"))
        }
    }
}

/// Checks a certificate of a surface, and returns the claim in words.
///
/// # Errors
/// The failed tests.
pub fn check_surface<C: Columns>(certificate: &SurfaceCertificate<C>) -> Result<String, Vec<Failure>> {
    certificate.check().map(|counts| counts.to_string())
}
