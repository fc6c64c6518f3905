//! Maps in tiles: the summaries add up to the audit of the whole.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]

mod corrupted;
mod counts;
mod coverages;
mod cut;
mod drawn;
mod maps;
mod portions;
mod proportion;
mod saved;
mod whole;
mod window;
