//! Certificates.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[allow(dead_code, reason = "other tests use the rest")]
#[path = "../../../../tests/support/only_live.rs"]
mod only_live;
#[allow(dead_code, unused_macros, unused_imports, reason = "other tests use the rest")]
#[path = "../../../../tests/support/tables.rs"]
mod tables;

mod columns;
mod labels;
mod lent;
mod records;
mod surface;
