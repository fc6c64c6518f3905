//! The module of WebAssembly with the structure of the lecture. It is small, so that the page loads fast.

// Its exported functions are those of the module.
extern crate twinedge_web_lecture as _;
