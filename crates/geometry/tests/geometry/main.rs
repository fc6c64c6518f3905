//! Exact predicates, the sweep, noding.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

mod exact;

mod noding;
mod predicates;
mod sweep;
