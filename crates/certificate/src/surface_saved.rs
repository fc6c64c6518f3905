//! A self-contained certificate of surfaces: the structure and its labels as columns.

use super::answers::Answers;
use super::closed::closed;
use super::columns::{Column, Labels, LabelsError};
use super::saved::{Certificate, have_one_length};
use super::storage::Columns;
use super::sums::Sums;
use super::surface::Surface;
use super::surface_counts::SurfaceCounts;
use super::test::Failure;
use alloc::vec::Vec;
use twinedge::validate::View;

/// A structure on surfaces, and its labels, as columns of 32-bit numbers: the files of a certificate with the claim `surface`.
///
/// The surfaces have any genus, and may be open, with a face missing on one side of each edge along the border. In the
/// certificate each half-edge has a twin, and the cycles along the border are boundary components without a face: *holes*. Added
/// half-edges are numbered after the half-edges of the structure, and holes after its boundary components.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge_certificate::{Column, SurfaceCertificate};
/// // A triangle of three half-edges.
/// let table: Table = "P 3 prev leaving faces V 3 0 - 1 - 2 - H 3 0 - 1 2 - 1 - 2 0 - 2 - 0 1 - B 0 F 1 - 0 HF 3 0 0 0 FH 1 0 0".parse()?;
/// let certificate = SurfaceCertificate::new(&table)?;
/// assert_eq!(certificate.columns().column(Column::HalfEdgeTwin), [3, 4, 5, 0, 1, 2]);
/// assert_eq!(certificate.columns().column(Column::BoundaryFace), [0, u32::MAX]);
/// let counts = certificate.check().map_err(|failures| failures[0].to_string())?;
/// assert_eq!((counts.genus, counts.components, counts.holes), (0, 1, 1));
/// assert_eq!(counts.to_string(), "a surface of genus 0 with 1 component, open at 1 hole");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SurfaceCertificate<C = Labels> {
    certificate: Certificate<C>,
}

impl SurfaceCertificate {
    /// Creates the certificate of a structure on surfaces, open or closed.
    ///
    /// If the structure keeps all rules of [`Expectation::surface`](twinedge::validate::Expectation::surface),
    /// [`check`](Self::check) passes. If it is [open](twinedge::validate::Expectation::open) and keeps them, `check` passes
    /// unless its border meets itself at a vertex, or both sides of an edge lack a face. If a rule is broken, it never passes.
    /// The [number of holes](SurfaceCounts::holes) shows whether the structure is open where it should not be.
    ///
    /// O(n) for n slots; 40 bytes for each half-edge.
    ///
    /// # Errors
    /// [`LabelsError::TooLarge`], [`LabelsError::OutOfMemory`].
    pub fn new<V: View + ?Sized>(view: &V) -> Result<Self, LabelsError> {
        let mut certificate = Certificate { columns: closed(view)? };
        let (mut labels, _) = Labels::of_surface(&certificate)?;
        // In a certificate each half-edge has an entry: the last component stands for all later ones, and positions are missing for genus 0.
        for column in LABELS {
            let entries = labels.column_mut(column);
            let missing = certificate.half_edge_slots().saturating_sub(entries.len());
            entries.try_reserve_exact(missing).map_err(|_| LabelsError::OutOfMemory)?;
            let last = entries.last().copied().unwrap_or_default();
            entries.resize(entries.len() + missing, last);
            certificate.columns.set(column, core::mem::take(entries));
        }
        Ok(Self { certificate })
    }
}

impl<C: Columns> SurfaceCertificate<C> {
    /// Creates the certificate with these columns. `None` if columns of one kind of record have different lengths.
    #[must_use]
    pub fn from_columns(columns: C) -> Option<Self> {
        let kinds = KINDS.iter().all(|kind| have_one_length(&columns, kind));
        kinds.then_some(Self { certificate: Certificate { columns } })
    }

    /// Returns the columns. Columns other than the [columns of surfaces](Column::of_surface) are empty.
    #[must_use]
    pub const fn columns(&self) -> &C {
        self.certificate.columns()
    }

    /// Checks the certificate: a scan that reads each record once. If all tests pass, the columns are surfaces with these counts.
    ///
    /// # Errors
    /// The failed tests.
    pub fn check(&self) -> Result<SurfaceCounts, Vec<Failure>> {
        Surface(Answers::new(&self.certificate, self.columns())).check(true, None).map(Sums::counts)
    }
}

const LABELS: [Column; 4] =
    [Column::HalfEdgeTurn, Column::HalfEdgeStep, Column::HalfEdgeComponent, Column::HalfEdgeRank];

const KINDS: [&[Column]; 3] = [
    &[
        Column::HalfEdgeOrigin,
        Column::HalfEdgeTwin,
        Column::HalfEdgeNext,
        Column::HalfEdgePrev,
        Column::HalfEdgeBoundary,
        Column::HalfEdgeTurn,
        Column::HalfEdgeStep,
        Column::HalfEdgeComponent,
        Column::HalfEdgeRank,
    ],
    &[Column::VertexLeaving, Column::VertexBorder],
    &[Column::BoundaryFace, Column::BoundaryStart],
];
