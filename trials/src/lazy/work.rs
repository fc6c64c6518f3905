//! The work of `lazy`.

use thiserror::Error;
use twinedge::validate::{Expectation, Part, Parts, Rule};

/// The tables that are judged, all of one size: every cell is free.
///
/// A link can be nil, each slot, or the one past the end. The list of a face has up to as many entries as there are vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LazyWork {
    /// The claims to which the tables are held.
    pub expectation: Expectation,
    /// The parts that they store.
    pub parts: Parts,
    /// The number of slots for vertices.
    pub vertices: usize,
    /// The number of slots for half-edges.
    pub half_edges: usize,
    /// The number of slots for boundary components, where there are records for these.
    pub boundaries: usize,
    /// The number of slots for faces, where there are faces.
    pub faces: usize,
    /// True if each slot can also be vacant.
    pub vacant: bool,
    /// True if certificates are judged: each table together with all labels, as [`lazy`](mod@crate::lazy) says. Then `boundaries` and `faces` are also the
    /// most that labels have, where the tables have no records for them.
    pub certificates: bool,
}

/// The most slots of a kind.
pub(super) const MOST_SLOTS: usize = 15;

/// The claim of a certificate.
#[derive(Clone, Copy)]
pub(super) enum Claim {
    /// A plane subdivision.
    Plane,
    /// Closed surfaces whose genera add up to this.
    Surface(usize),
}

impl Claim {
    /// The claim of certificates that says the same as the expectation; none if there are no certificates for it.
    pub(super) fn of(expectation: &Expectation) -> Option<Self> {
        match expectation.expected_count(Rule::M7) {
            None => (*expectation == Expectation::plane()).then_some(Self::Plane),
            Some(genus) => (*expectation == Expectation::surface().genus(genus)).then_some(Self::Surface(genus)),
        }
    }
}

impl LazyWork {
    /// The parts that are looked at.
    pub(super) fn parts(&self) -> Parts {
        self.expectation.looks_at(self.parts)
    }

    /// The claim of the certificates.
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

/// The reason why there is no such work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LazyError {
    /// There are more tables than can be counted, about 10^38, or more than 15 slots of a kind. Tables with different labels count as different.
    #[error("there are more than 10^38 tables of this size, or more than {MOST_SLOTS} slots of a kind")]
    TooMany,
    /// Certificates claim a plane subdivision, or closed surfaces of a genus, and nothing else. In the plane, tables with faces must have lists of holes
    /// and an unbounded face.
    #[error(
        "certificates are of the plane, without faces or with `holes` and `unbounded_face`, or of a `surface asking genus G`"
    )]
    NoCertificates,
}
