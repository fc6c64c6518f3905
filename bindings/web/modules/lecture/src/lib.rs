//! The WebAssembly module with the structure of the lecture. It is small, so that the page loads fast.

// The module exports these functions.
extern crate twinedge_web_lecture as _;
