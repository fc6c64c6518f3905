//! Structures that other languages keep: links in columns of integers, and what known libraries promise.
//!
//! [`Columns`] is a [`View`](super::View) of slices: arrays of numpy, fields of an array of C structs, the columns of a file.
//! [`Preset`] has the [`Expectation`](super::Expectation) for the structures of a library, with its source.

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
