//! Other people's half-edge structures, audited: random programs over their public operators, judged by the rules of
//! twinedge after each step.
//!
//! `findings.tsv` has the findings. Each is a test in `tests/`, in the crate's own terms, without any of the modules here.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`program`] | a program as data: steps of an operator and small numbers |
//! | [`peer`] | the interface of an audited crate |
//! | [`entry`] | an audited crate, by name |
//! | [`run`] | runs a program, judges after each step, catches panics |
//! | [`judge`] | runs programs in a child process, to detect programs that never end or take all memory |
//! | [`search`] | many random programs, counted by finding |
//! | [`shrink`] | the shortest program with the same finding |
//! | [`crates`] | the adapters: `impl View` and the operators of each crate |

pub mod crates;
pub mod entry;
pub mod judge;
pub mod peer;
pub mod program;
pub mod run;
pub mod search;
pub mod shrink;
