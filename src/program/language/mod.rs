//! Languages of programs, whatever their operators are: text, arguments, generation and shrinking.
//!
//! A table of operators becomes a language by the macro in [`table`]: see `program::operators` and `map::program::edits`.

pub(crate) mod argument;
pub mod choose;
pub(crate) mod generator;
pub(crate) mod instances;
#[cfg(feature = "proptest")]
pub(crate) mod proptest;
pub(crate) mod script;
pub(crate) mod shrink;
pub(crate) mod table;
pub(crate) mod words;
