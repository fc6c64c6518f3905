//! The verdict, with three values, and what it is about.

use serde::{Deserialize, Serialize};

/// The verdict of an audit. Nothing is valid by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Verdict {
    /// Everything that applies was checked, and holds.
    Valid,
    /// Something is wrong.
    Invalid,
    /// Nothing wrong was found, and not everything was checked.
    #[default]
    Unknown,
}

/// The bytes that were judged.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Judged {
    /// Their SHA-256, in hexadecimal digits.
    pub sha256: String,
    /// Their number.
    pub bytes: u64,
}
