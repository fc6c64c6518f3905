//! The findings of `findings.tsv`, one test each, in the crate's own terms. A test asserts the crate's *current* behaviour,
//! and fails when a later version fixes it; the finding then leaves the table.
//!
//! Each fault is shown twice: by the rules of twinedge, and by the crate's own accessors.

mod dcel;
mod halfedge;
mod plexus;
mod spade;
mod tri_mesh;

use twinedge::validate::Report;
use twinedge_peers::run::{caught, first_broken};

/// Asserts that the first broken rule is this one.
fn breaks(finding: &str, report: &Report, rule: &str) {
    let broken = first_broken(report).map(|(broken, _)| broken);
    assert_eq!(broken.as_deref(), Some(rule), "{finding}: {MENDED}\n{report}");
}

/// Asserts that the observed behaviour persists.
fn still(finding: &str, seen: bool) {
    assert!(seen, "{finding}: {MENDED}");
}

/// Asserts that the closure panics, in this file of the crate and with this message.
fn panics<T>(finding: &str, file: &str, message: &str, closure: impl FnOnce() -> T) {
    let Err((place, found)) = caught(closure) else { panic!("{finding}: {MENDED}") };
    assert!(place.contains(file) && found.contains(message), "{finding}: another panic, {place}: {found}. {MENDED}");
}

const MENDED: &str = "the crate no longer does this. If it was mended, take the finding out of findings.tsv";
