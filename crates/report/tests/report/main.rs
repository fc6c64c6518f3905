//! Pictures and the tables of textbooks.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod svg;
mod textbook;
