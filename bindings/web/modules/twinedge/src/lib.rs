//! The WebAssembly module with all functions.

// The module exports these functions.
extern crate twinedge_web as _;
