//! The rules M9 … M11 about the coordinates of the points of a mesh, and their outcomes.

/// A rule about the coordinates of the points of a mesh.
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

    /// Returns the id: `M9`, `M10`, `M11`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Area => "M9",
            Self::Crossing => "M10",
            Self::Outward => "M11",
        }
    }

    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Crossing => "crossing",
            Self::Outward => "outward",
        }
    }

    /// Returns the rule in one sentence.
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

    /// Returns the plural of the checked unit.
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
    /// The number of checked faces or components.
    pub checked: usize,
    /// The number of unchecked faces: for M10, those with more than three sides that are not convex.
    pub left_out: usize,
}
