//! Errors of imports.

use crate::store::RecordKind;
use crate::validate::{Part, Report};
use alloc::boxed::Box;
use core::fmt;
use thiserror::Error;

/// The error of [`Dcel::from_view`](crate::dcel::Dcel::from_view), which refused a structure.
#[derive(Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// It breaks a rule that it is held to.
    #[error("the structure is not valid:\n{0}")]
    Invalid(Box<Report>),
    /// The structure does not store a part that a planar subdivision cannot do without.
    #[error("a planar subdivision needs {}, which the structure does not store", .0.name())]
    Lacks(Part),
    /// It was to bring its own unbounded face, but it has none.
    #[error("the structure has no unbounded face; name a face or its border")]
    NoUnboundedFace,
    /// A face or a border was to become the unbounded face, but the structure has one.
    #[error("the structure has an unbounded face already")]
    SecondUnboundedFace,
    /// There is no face with the index that was to become the unbounded face.
    #[error("there is no face {0} to become the unbounded one")]
    NoSuchFace(usize),
    /// It lies on a surface of this genus, which cannot be drawn in the plane.
    #[error("the structure has genus {0}, and a planar subdivision has genus 0")]
    Genus(usize),
    /// It falls into so many components, and nothing says in which faces they lie.
    #[error("the structure has {0} components and no lists that say in which faces they lie")]
    Disconnected(usize),
    /// There is a border, but borders were not to become the unbounded face.
    #[error("the structure has a border, which no face would be on the other side of")]
    Border,
    /// A component has no border by which it could lie in the unbounded face.
    #[error("a component of the structure has no border")]
    NoBorder,
    /// A component has several borders, and nothing says which of them is the outside.
    #[error("a component of the structure has several borders: {borders} in {components} components")]
    SeveralBorders {
        /// Borders and other inner boundary components that are cycles.
        borders: usize,
        /// Components that have an edge.
        components: usize,
    },
    /// With this face or border as the unbounded face it would break a rule. The report is on what it would have become.
    #[error("with that outside, the structure is not a planar subdivision:\n{0}")]
    NotPlane(Box<Report>),
    /// It answered differently when it was asked again.
    #[error("the structure changed its answers while it was read")]
    Inconsistent,
    /// It has more records of this kind than a [`Dcel`](crate::dcel::Dcel) can hold.
    #[error("the structure has more {0} than fit")]
    Full(RecordKind),
}

/// As `Display` does it, so that a failed `unwrap` or `main` prints lines to read.
impl fmt::Debug for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl ImportError {
    /// The report of the validator, if it was the validator that refused.
    #[must_use]
    pub const fn report(&self) -> Option<&Report> {
        match self {
            Self::Invalid(report) | Self::NotPlane(report) => Some(report),
            _ => None,
        }
    }
}
