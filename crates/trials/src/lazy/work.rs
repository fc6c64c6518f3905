//! The work of `lazy`.

use thiserror::Error;
use twinedge::validate::{Expectation, Part, Parts, Rule};

/// The tables that are judged, all of one size: every cell is free.
///
/// A link can be nil, each slot, or the one past the end. The list of a face has at most one entry per vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LazyWork {
    /// The claims about the tables.
    pub expectation: Expectation,
    /// The stored parts.
    pub parts: Parts,
    /// The number of slots for vertices.
    pub vertices: usize,
    /// The number of slots for half-edges.
    pub half_edges: usize,
    /// The number of slots for boundary components, if they have records.
    pub boundaries: usize,
    /// The number of slots for faces, if there are faces.
    pub faces: usize,
    /// True if each slot can also be vacant.
    pub vacant: bool,
    /// True to judge certificates: each table together with all labels, see [`lazy`](mod@crate::lazy). `boundaries` and `faces`
    /// are then also the largest numbers in labels, if the tables have no records for them.
    pub certificates: bool,
}

pub(super) const MOST_SLOTS: usize = 15;

#[derive(Clone, Copy)]
pub(super) enum Claim {
    Plane,
    /// Closed surfaces with this total genus.
    Surface(usize),
}

impl Claim {
    /// Returns the claim of certificates with the same meaning as the expectation; `None` without such certificates.
    pub(super) fn of(expectation: &Expectation) -> Option<Self> {
        match expectation.expected_count(Rule::M7) {
            None => (*expectation == Expectation::plane()).then_some(Self::Plane),
            Some(genus) => (*expectation == Expectation::surface().genus(genus)).then_some(Self::Surface(genus)),
        }
    }
}

impl LazyWork {
    pub(super) fn parts(&self) -> Parts {
        self.expectation.looks_at(self.parts)
    }

    /// Returns the claim of the certificates.
    ///
    /// # Errors
    /// [`LazyError::NoCertificates`].
    pub(super) fn claim(&self) -> Result<Claim, LazyError> {
        let parts = self.parts();
        let says_what_is_inside = !parts.has(Part::Faces) || parts.has(Part::Holes) && parts.has(Part::UnboundedFace);
        match Claim::of(&self.expectation) {
            Some(Claim::Plane) if !says_what_is_inside => Err(LazyError::NoCertificates),
            claim => claim.ok_or(LazyError::NoCertificates),
        }
    }
}

/// The reason that such work is impossible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LazyError {
    /// There are more than about 10^38 tables, counted with different labels, or more than 15 slots of a kind.
    #[error("there are more than 10^38 tables of this size, or more than {MOST_SLOTS} slots of a kind")]
    TooMany,
    /// Certificates claim a plane subdivision, or closed surfaces of a genus, and nothing else. In the plane, tables with faces
    /// must have lists of holes and an unbounded face.
    #[error(
        "certificates are of the plane, without faces or with `holes` and `unbounded_face`, or of a `surface asking genus G`"
    )]
    NoCertificates,
}
