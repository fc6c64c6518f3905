//! Exact predicates, the sweep, noding.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod noding;
mod predicates;
mod sweep;
