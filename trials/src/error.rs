//! Errors of the engines.

use std::fmt;
use thiserror::Error;
use twinedge::validate::{Part, Violation};

/// A structure is unsuitable for an engine.
#[derive(Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StructureError {
    /// The structure does not store a part that is needed to tell two maps apart.
    #[error("the structure stores no {}; without it two maps cannot be told apart", .0.name())]
    Lacks(Part),
    /// The empty map breaks a rule, so every other map would.
    #[error(
        "the empty map of the structure breaks {}: {_0}; {}. Either `make` does not make an empty map, or the expectation is not \
that of the structure",
        _0.rule(), _0.remedy()
    )]
    InvalidStart(Violation),
}

/// Equal to `Display`, since `unwrap` shows it.
impl fmt::Debug for StructureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// A run found faults, or was not finished.
#[derive(Clone, PartialEq, Eq, Error)]
pub struct Failed {
    /// The reasons, one each.
    pub reasons: Vec<String>,
}

impl Failed {
    /// Returns `Ok` if there is no reason.
    pub(crate) fn unless_empty(reasons: Vec<String>) -> Result<(), Self> {
        if reasons.is_empty() { Ok(()) } else { Err(Self { reasons }) }
    }
}

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reasons.join("\n"))
    }
}

/// Equal to `Display`, since `unwrap` shows it.
impl fmt::Debug for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
