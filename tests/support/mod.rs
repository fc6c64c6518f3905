//! What the tests of the validator share.
#![allow(dead_code, reason = "each test file uses a part of it")]

pub(crate) mod moody;
pub(crate) mod nested;
pub(crate) mod opinions;
pub(crate) mod tables;
pub(crate) mod watched;
