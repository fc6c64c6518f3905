//! Does a subject do what the operators say? A program is run on it and on the reference in step, and after every
//! operator both must have done the same.
//!
//! The reference is [`PointerModel`](crate::program::PointerModel), which has nothing in common with [`Dcel`](crate::dcel::Dcel) but the meaning of the
//! operators: `Dcel` is held to it like any other subject.
//!
//! Compared are, after each operator:
//!
//! 1. whether it was applied, refused (and with which category of error) or skipped;
//! 2. whether the subject is valid, by the validator;
//! 3. whether both are isomorphic, nesting and unbounded face included, by their canonical forms;
//! 4. whether the handles say the same: `twin`, `next`, origins and faces of every half-edge and isolated vertex, in
//!    order of their creation. So a subject that hands out the wrong handle is found at once, and not when it is used.
//!
//! The third needs a view with faces, their inner boundary components and the unbounded face. What else a view may lack,
//! the expectation says: `prev`, half-edges at vertices, records of boundary components, places.
//!
//! An operator that the subject does not have, or has no room for, is not run on the reference either, but the subject
//! must be as it was.
//!
//! ```
//! use twinedge::program::{RotationSystem, Program, conformance};
//! let program = Program::from_bytes(b"some bytes that came from a fuzzer");
//! conformance::run(&program, RotationSystem::new(), &RotationSystem::expectation())?;
//! # Ok::<(), conformance::Failure>(())
//! ```

mod answers;
mod difference;
mod in_step;

pub use difference::{Answer, Difference, Failure, Question};
pub use in_step::{ConformanceSummary, InStep, run};
