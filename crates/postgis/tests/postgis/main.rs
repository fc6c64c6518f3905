//! Topologies of PostGIS: reading, findings and names.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod findings;
mod golden;
mod hostile;
mod mends;
mod support;
