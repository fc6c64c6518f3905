//! Tests of the sphere.
#![allow(clippy::float_cmp, reason = "equal places have equal vectors, and that is asked here")]

mod coverages;
mod maps;
mod places;
mod predicates;
mod subdivisions;
mod support;
