//! Code that the tests of the validator share.
#![allow(dead_code, unused_macros, unused_imports, reason = "each test file uses a part of it")]

pub(crate) mod changes;
pub(crate) mod erased;
pub(crate) mod inconsistent;
pub(crate) mod nested;
pub(crate) mod only_live;
pub(crate) mod opinions;
pub(crate) mod programs;
pub(crate) mod renumbered;
pub(crate) mod rotations;
pub(crate) mod saved;
pub(crate) mod small;
pub(crate) mod tables;
pub(crate) mod textbook;
pub(crate) mod tokens;
pub(crate) mod tracked;
pub(crate) mod triangles;
pub(crate) mod watched;
