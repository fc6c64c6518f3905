//! Half-edge structures of other languages, for the validator of [`twinedge`]: links in columns, and promises of libraries.
//!
//! [`Columns`] is a [`View`](twinedge::validate::View) of slices: arrays of numpy, fields of an array of C structs, the columns
//! of a file. [`Preset`] has the [`Expectation`](twinedge::validate::Expectation) for a library, with its source.
//!
//! The crate needs no `std`, and allocates memory only for the adapters that some columns need (see [`Columns::validate`]).

#![no_std]

extern crate alloc;

mod boundaries;
mod cell;
mod column;
mod columns;
mod error;
mod form;
mod preset;

pub use boundaries::Boundaries;
pub use cell::Cell;
pub use column::Column;
pub use columns::{Columns, OnView};
pub use error::ColumnsError;
pub use preset::Preset;
