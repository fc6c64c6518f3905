//! The sides of a tile.

/// A side of a tile, in counter-clockwise order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Side {
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

    pub(super) const fn is_upright(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }
}
