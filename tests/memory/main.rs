//! Memory use, counted by the allocator.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

mod counting;
mod history;
mod pointer_model;
mod stores;
mod validator;
