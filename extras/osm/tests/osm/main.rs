//! Boundaries of OpenStreetMap.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod boundaries;
mod pbf;
