//! The verdict, with three values, and the judged bytes.

use serde::{Deserialize, Serialize};

/// The verdict of an audit. The default is not `Valid`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Verdict {
    /// Every rule that applies was checked and holds.
    Valid,
    /// A rule is broken.
    Invalid,
    /// No broken rule was found, but not every rule was checked.
    #[default]
    Unknown,
}

/// The judged bytes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Judged {
    /// The SHA-256 in hexadecimal digits.
    pub sha256: String,
    /// The number of bytes.
    pub bytes: u64,
}
