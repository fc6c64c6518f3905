//! The validator for C and for every language that can call C.
//!
//! `include/twinedge.h` is generated from this crate, and documents every function. `README.md` has examples.
//!
//! # Why handles and setters
//!
//! A structure is described by calls on an opaque handle, not by a struct that the caller fills in. Later versions add
//! functions and numbers that older programs do not use: no layout is shared, so none can disagree. Callers from
//! languages without C's structs need no copy of one.
//!
//! # Unsafe code
//!
//! Three files justify it at their heads: `border.rs` (handles), `cells.rs` (the memory of columns), `callbacks.rs`
//! (the caller's functions). `structure.rs`, `report.rs` and `judge.rs` only pass on the caller's promises. The caller
//! must keep three promises, which no library can check: a handle comes from this library and was not freed; a pointer
//! that is not null leads to as much memory as its count and stride say, until
//! [`twinedge_validate`](structure::twinedge_validate) returns; a structure is used by one thread at a time. The
//! `SAFETY` comments call these "as the caller promises". Everything else is checked: null, alignment, overflow,
//! lengths, numbers that name nothing. Links are data, and the validator returns on any.

#![allow(clippy::missing_safety_doc, reason = "the same for every function, and said above and in the header")]

pub mod structure;

pub mod report;

mod border;
pub mod callbacks;
mod cells;
pub mod failure;
mod judge;
pub mod names;
mod plan;
#[cfg(test)]
mod tests;
mod words;
