//! The structure: its elements, its operators and their laws, its limits, import and history.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod attributes;
mod audited;
mod bulk;
mod elements;
mod equality;
mod history;
mod import;
mod limits;
mod operator_laws;
mod operators;
mod saving;
mod stale_keys;
mod textbook_tables;
