//! The errors of imports, and the choice of the unbounded face.

use crate::store::RecordKind;
use crate::validate::{Part, Report};
use alloc::boxed::Box;
use core::fmt;
use thiserror::Error;

/// The choice of the unbounded face in [`Dcel::from_view`](crate::dcel::Dcel::from_view).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Outside {
    /// The unbounded face of the structure, whose expectation has [`Part::UnboundedFace`](crate::validate::Part).
    #[default]
    Given,
    /// This face of a closed mesh, by its index in the view. Its cycle becomes an inner boundary component, so the mesh
    /// is unrolled into the plane with that face around it.
    Face(usize),
    /// The part beyond the border of an open mesh: beyond half-edges without a twin, or whose twin has no face. Several
    /// components may lie side by side, each with one border.
    Border,
}

/// The reason why [`Dcel::from_view`](crate::dcel::Dcel::from_view) refused a structure.
#[derive(Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The structure breaks an expected rule.
    #[error("the structure is not valid:\n{0}")]
    Invalid(Box<Report>),
    /// The structure does not store a part that a planar subdivision needs.
    #[error("a planar subdivision needs {}, which the structure does not store", .0.name())]
    Lacks(Part),
    /// The structure should have an unbounded face, but has none.
    #[error("the structure has no unbounded face; name a face or its border")]
    NoUnboundedFace,
    /// A face or a border should become the unbounded face, but the structure already has one.
    #[error("the structure has an unbounded face already")]
    SecondUnboundedFace,
    /// The face that should become unbounded does not exist.
    #[error("there is no face {0} to become the unbounded one")]
    NoSuchFace(usize),
    /// The structure lies on a surface of this genus, and cannot be drawn in the plane.
    #[error("the structure has genus {0}, and a planar subdivision has genus 0")]
    Genus(usize),
    /// The structure has this number of components, and does not say in which faces they lie.
    #[error("the structure has {0} components and no lists that say in which faces they lie")]
    Disconnected(usize),
    /// The structure has a border, but borders should not become the unbounded face.
    #[error("the structure has a border, which no face would be on the other side of")]
    Border,
    /// A component has no border, so it cannot lie in the unbounded face.
    #[error("a component of the structure has no border")]
    NoBorder,
    /// A component has several borders, and the structure does not say which one is the outside.
    #[error("a component of the structure has several borders: {borders} in {components} components")]
    SeveralBorders {
        /// Borders and other inner boundary components that are cycles.
        borders: usize,
        /// Components that have an edge.
        components: usize,
    },
    /// With this face or border as the unbounded face, the structure would break a rule. The report describes the
    /// result.
    #[error("with that outside, the structure is not a planar subdivision:\n{0}")]
    NotPlane(Box<Report>),
    /// The view answered differently when asked again.
    #[error("the structure changed its answers while it was read")]
    Inconsistent,
    /// The structure has more records of this kind than a [`Dcel`](crate::dcel::Dcel) can hold.
    #[error("the structure has more {0} than fit")]
    Full(RecordKind),
}

/// Writes the text of `Display`, so a failed `unwrap` or `main` prints readable lines.
impl fmt::Debug for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl ImportError {
    /// Returns the report, if the validator refused the structure.
    #[must_use]
    pub const fn report(&self) -> Option<&Report> {
        match self {
            Self::Invalid(report) | Self::NotPlane(report) => Some(report),
            _ => None,
        }
    }
}
