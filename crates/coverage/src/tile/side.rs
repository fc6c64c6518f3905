//! The sides of a tile.

/// A side of a tile, in counter-clockwise order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// The lower side.
    Bottom,
    /// The right side.
    Right,
    /// The upper side.
    Top,
    /// The left side.
    Left,
}

impl Side {
    pub(super) const ALL: [Self; 4] = [Self::Bottom, Self::Right, Self::Top, Self::Left];

    /// Returns the side of the neighbour that lies along this one.
    pub(super) const fn opposite(self) -> Self {
        match self {
            Self::Bottom => Self::Top,
            Self::Right => Self::Left,
            Self::Top => Self::Bottom,
            Self::Left => Self::Right,
        }
    }

    pub(super) const fn is_upright(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }
}
