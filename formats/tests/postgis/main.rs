//! Topologies of PostGIS: what is read, what is found, what it is called.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod findings;
mod golden;
mod hostile;
mod mends;
mod support;
