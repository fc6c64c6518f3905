//! Harnesses: properties of every operator and of the validator, each over all maps (or tables) up to a bound.
//!
//! A harness is one body over a source of choices ([`twinedge::program::choose`]). Under `cargo test` every sequence
//! of choices is run; under `cargo kani` all of them are one symbolic run. The bound is in the name either way, and
//! the body is the same function. `README.md` says which of the two has been run.
//!
//! | file | purpose |
//! | --- | --- |
//! | [`grow`] | choosing a map, and an operator with its arguments |
//! | [`operators`] | properties of operators: rules kept, inverses, refusals without a trace, stale handles |
//! | [`judges`] | the same for the validator and the reference |
//! | [`faults`] | faults to plant in the library, to see which check catches which |
//! | `engine` | the engine of choices, and the macro that makes a harness and its broken twin |
//! | `planted` | a subject with one fault, for the twins |
//! | `harnesses` | the list |
//!
//! The last three are compiled for tests and for Kani only.

pub mod faults;
pub mod grow;
pub mod judges;
pub mod operators;

#[cfg(any(test, kani))]
mod engine;
#[cfg(any(test, kani))]
pub mod harnesses;
#[cfg(all(test, not(kani)))]
mod planted;
