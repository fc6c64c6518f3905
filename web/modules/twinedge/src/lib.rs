//! The module of WebAssembly with all functions.

// Its exported functions are those of the module.
extern crate twinedge_web as _;
