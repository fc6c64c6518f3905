//! Numbers of tables, which are too large for JSON: as text there.

use std::fmt;
use std::ops::AddAssign;

/// A number of tables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(into = "String", try_from = "String")
)]
pub struct Many(pub u128);

impl Many {
    /// Returns the order of magnitude: `10^21.7`.
    #[must_use]
    pub fn rounded(self) -> String {
        format!("10^{:.1}", (self.0.max(1) as f64).log10())
    }
}

impl fmt::Display for Many {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl AddAssign for Many {
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl From<Many> for String {
    fn from(many: Many) -> Self {
        many.to_string()
    }
}

impl TryFrom<String> for Many {
    type Error = std::num::ParseIntError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse().map(Self)
    }
}
