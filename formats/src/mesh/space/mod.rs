//! Rules about the places of the points of a mesh, M9 … M11, which are checked if they are asked for.
//!
//! Points at the same place count as one, as in files that repeat a point for each texture. A face with more than three sides is taken as the
//! triangles between its first corner and its other sides. All signs are exact, unless products of coordinates leave the range of numbers
//! of 64 bits.

mod area;
mod crossing;
mod exact;
mod outward;
mod places;
mod segment;

use super::{Finding, Findings, HalfEdgeMesh, Kind};
use places::Places;

/// A rule about the places of the points of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum SpaceRule {
    /// M9.
    Area,
    /// M10.
    Crossing,
    /// M11.
    Outward,
}

impl SpaceRule {
    /// All rules, in order.
    pub const ALL: [Self; 3] = [Self::Area, Self::Crossing, Self::Outward];

    /// The id: `M9`, `M10`, `M11`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Area => "M9",
            Self::Crossing => "M10",
            Self::Outward => "M11",
        }
    }

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Crossing => "crossing",
            Self::Outward => "outward",
        }
    }

    /// The rule in one sentence.
    #[must_use]
    pub const fn statement(self) -> &'static str {
        match self {
            Self::Area => "the corners of a face do not all lie on one line",
            Self::Crossing => "two faces meet in common corners and common edges only",
            Self::Outward => {
                "the faces of a closed component face outwards, or inwards where it is the wall of a cavity in another one"
            }
        }
    }

    /// The kind of its findings.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Area => Kind::ZeroArea,
            Self::Crossing => Kind::CrossingFaces,
            Self::Outward => Kind::InsideOut,
        }
    }

    /// The plural of what is checked.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Area | Self::Crossing => "faces",
            Self::Outward => "closed components",
        }
    }
}

/// The outcome of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SpaceOutcome {
    /// The rule.
    pub rule: SpaceRule,
    /// The number of faces or components that were checked.
    pub checked: usize,
    /// The number of faces that were not: of M10, those with more than three sides that are not convex.
    pub left_out: usize,
}

/// Checks rules. O(n) expected for M9; O(n log n + k) for M10, for k pairs of faces whose boxes meet; O(n) for M11, and O(n) for each component that
/// faces inwards.
pub(super) fn check(mesh: &HalfEdgeMesh<'_>, rules: &[SpaceRule], findings: &mut Findings) -> Vec<SpaceOutcome> {
    let mut asked = rules.to_vec();
    asked.sort_unstable();
    asked.dedup();
    let places = Places::new(mesh.mesh());
    let mut outcome = |rule: SpaceRule| {
        let mut found = |finding: Finding| findings.add(rule.kind(), || finding);
        let (checked, left_out) = match rule {
            SpaceRule::Area => (area::check(mesh, &places, &mut found), 0),
            SpaceRule::Crossing => crossing::check(mesh, &places, &mut found),
            SpaceRule::Outward => (outward::check(mesh, &places, &mut found), 0),
        };
        SpaceOutcome { rule, checked, left_out }
    };
    asked.into_iter().map(&mut outcome).collect()
}
