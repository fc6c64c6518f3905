//! The validator: its rules, reports, expectations and inputs.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod adapters;
mod adversarial_views;
mod comparison;
mod expectations;
mod families;
mod hints;
mod mesh_rules;
mod names;
mod near;
mod near_checks;
mod parts;
mod reports;
mod serialized;
mod settled;
mod small_tables;
mod statements;
mod table_text;
mod textbook_tables;
mod view_calls;
mod violations;
