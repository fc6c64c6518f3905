//! Exhaustive and random tests for half-edge structures.
//!
//! Each engine takes a [`Structure`]: a function that makes an empty map, and an expectation for the validator. It works on every
//! type that implements [`Subject`](twinedge::program::Subject) and [`View`](twinedge::validate::View).
//!
//! ```
//! use twinedge::dcel::Dcel; // in place of a structure of your own
//! use twinedge::validate::Expectation;
//! use twinedge_trials::prove::ProveWork;
//! use twinedge_trials::soak::SoakWork;
//! use twinedge_trials::{Run, Structure, prove, soak};
//!
//! // In a `#[test]`:
//! let mine = Structure::new("mine", Dcel::new, Expectation::plane());
//! // Every operator with every argument on every map of up to 2 edges.
//! prove(&mine, ProveWork { edges: 2 }, &Run::default())?.into_result()?;
//! // 20 random programs of 50 operators, compared with a reference after each operator.
//! soak(&[&mine], SoakWork { programs: 20, steps: 50, seed: 1 }, &Run::default()).into_result()?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | engine | method | faults found |
//! | --- | --- | --- |
//! | [`prove()`] | grows every small map and tries every operator with every argument on each | operators that break a rule, panic, change something when they refuse, or miss a map |
//! | [`soak()`] | runs random programs in step with a reference | operators that keep every rule but have the wrong effect; the program is made small |
//! | [`meshes()`] | tries every operator with every argument on every small triangulation | operators of meshes, or others, with the wrong effect on them |
//! | [`corrupt()`] | sets every field of every small map to every other value | invalid tables that a validator misses, false alarms, hangs, panics |
//! | [`tables()`] | judges every small table, valid or invalid | the same, and counts that differ from the published ones |
//! | [`lazy()`] | judges all tables of a size, every cell free, with one run for all that agree in the cells read | the same in 10^20 tables and more; certificates that pass for an invalid table, and valid tables without certificate |
//! | [`sample()`] | judges random tables, nested and damaged | the same in larger maps |
//! | [`replay()`] | runs one program and keeps the table after each operator | the step at which a failing program goes wrong |
//!
//! `prove`, `meshes` and `soak` test a structure. `corrupt`, `tables` and `sample` test a validator: [`Validator`] of
//! the library, its [`FastPath`] or its checker of [`Certificates`], or any other [`Checker`].
//!
//! | input for tests of one's own | |
//! | --- | --- |
//! | [`canonical`] | canonical forms: tells whether two maps are the same up to names |
//! | [`census`] | every small map, each once, grown by the operators |
//! | [`enumerate`] | every small table, and every change of one cell of a larger one |
//! | [`forms`] | the 112 forms in which a structure can keep a map, and a map in each |
//! | [`opinions`] | the validator and the reference on one structure, compared |
//! | [`RawPointers`] | a second model of the operators, simple and slow |
//! | [`ReportAudit`] | a `Dcel` that checks the reports of its operators |
//! | [`Rewound`] | a `Dcel` with a history, whose changes are undone and redone after each operator |
//! | [`Erased`] | structures of several types as one: the engines are compiled once for them |
//!
//! # Long runs
//!
//! [`Run`] has the number of threads, the part of the work, and the receiver of progress. A [`Progress`] can stop a run; the
//! results up to that point are returned, marked as interrupted. A [`Shard`] is one of N parts of the same work, for machines
//! that share it; [`sum`] adds the parts up to exactly the result of a single run.
//!
//! Each kind of work estimates itself, for example [`ProveWork::estimate`](prove::ProveWork::estimate).
//!
//! # Features
//!
//! `serde`: all outcomes implement `Serialize` and `Deserialize`.
//!
//! `program`, on by default: the program `twinedge-trials`, which runs the engines and prints their outcomes as text or JSON, and all its dependencies.
#![cfg_attr(docsrs, feature(doc_cfg))]

/// The examples of the page for newcomers.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

mod erased;
mod outcome;
mod published;
mod random;
mod raw_pointers;
mod report_audit;
mod rewound;
mod rows;
mod run;
mod shard;
mod structure;
mod verdict;

pub mod canonical;
pub mod census;
pub mod corrupt;
pub mod enumerate;
pub mod forms;
pub mod lazy;
pub mod meshes;
pub mod opinions;
pub mod planted;
pub mod prove;
pub mod replay;
pub mod sample;
pub mod soak;
pub mod tables;

pub use corrupt::corrupt;
pub use erased::Erased;
pub use lazy::lazy;
pub use meshes::meshes;
pub use outcome::{Failed, Outcome, Results, SumError, sum};
pub use prove::prove;
pub use raw_pointers::RawPointers;
pub use replay::replay;
pub use report_audit::ReportAudit;
pub use rewound::Rewound;
pub use rows::{Cell, Column, Row};
pub use run::{Estimate, Progress, Run, Silent};
pub use sample::sample;
pub use shard::{ParseShardError, Shard, ShardError};
pub use soak::soak;
pub use structure::{Structure, StructureError, TestSource};
pub use tables::tables;
pub use verdict::{Certificates, Checker, FastPath, Validator, Verdict, certificates_of};
