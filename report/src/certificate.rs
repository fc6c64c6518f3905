//! Certificates as they are in a folder: `claim.txt` and a file for each column (`proofs/coq/CERTIFICATE.md`).

use twinedge_certificate::{Certificate, Column, Columns, Failure, SurfaceCertificate, check_drawing};

/// The first line of `claim.txt`; the second one is the claim.
pub const FIRST_LINE: &str = "twinedge certificate 1\n";

/// The files of the points of a drawing.
pub const POINT_FILES: [&str; 2] = ["point_x.i64", "point_y.i64"];

/// The file of a column.
#[must_use]
pub fn file_name(column: Column) -> String {
    format!("{}.u32", column.name())
}

/// A claim of which a certificate can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Claimed {
    /// A plane subdivision.
    Plane,
    /// The same, drawn without crossings.
    Drawing,
    /// A surface.
    Surface,
}

impl Claimed {
    const ALL: [Self; 3] = [Self::Plane, Self::Drawing, Self::Surface];

    /// The second line of `claim.txt`.
    #[must_use]
    pub const fn line(self) -> &'static str {
        match self {
            Self::Plane => "plane\n",
            Self::Drawing => "drawing\n",
            Self::Surface => "surface\n",
        }
    }

    /// The claim of a file that begins so; none, if there is none that is known.
    #[must_use]
    pub fn of(claim: &[u8]) -> Option<Self> {
        let claimed = claim.strip_prefix(FIRST_LINE.as_bytes())?;
        Self::ALL.into_iter().find(|claim| claimed.starts_with(claim.line().as_bytes()))
    }

    /// The columns that it is about.
    #[must_use]
    pub fn columns(self) -> Vec<Column> {
        match self {
            Self::Plane => Column::of_subdivision().to_vec(),
            Self::Drawing => [Column::of_subdivision(), Column::of_drawing()].concat(),
            Self::Surface => Column::of_surface().to_vec(),
        }
    }

    /// Checks columns, and gives the claim in words, or the tests that fail. None, if columns of one kind of record have different lengths.
    pub fn check<C: Columns>(self, columns: &C) -> Option<Result<String, Vec<Failure>>> {
        Some(match self {
            Self::Plane => check_plane(&Certificate::from_columns(columns)?, None::<&C>),
            Self::Drawing => check_plane(&Certificate::from_columns(columns)?, Some(columns)),
            Self::Surface => check_surface(&SurfaceCertificate::from_columns(columns)?),
        })
    }
}

/// The claim of a certificate of a plane subdivision in words, or the tests that fail.
///
/// # Errors
/// The tests that fail.
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

/// The claim of a certificate of a surface in words, or the tests that fail.
///
/// # Errors
/// The tests that fail.
pub fn check_surface<C: Columns>(certificate: &SurfaceCertificate<C>) -> Result<String, Vec<Failure>> {
    certificate.check().map(|counts| counts.to_string())
}
