//! `twinedge` for WebAssembly: the functions behind the package for JavaScript.
//!
//! ```text
//!   index.js ── message ──► worker.js ──► sync.js ── buffers ──► call ─► one file for each function
//! ```
//!
//! The exports are five functions of numbers, and the imports four. Requests and answers are JSON; bytes are passed in
//! buffers of their own. `README.md` explains why `wasm-bindgen` is not used.

#![allow(unsafe_code, reason = "an exported name, which nothing else has")]

mod audit;
mod call;
mod check;
mod clean;
mod convert;
mod error;
mod neighbours;
mod options;
mod source;
mod validate;
mod voronoi;

use twinedge_web_bridge::{Id, answer};

/// Answers the request in a buffer, and drops the request and the buffers that it names. The answer is in another
/// buffer.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
#[must_use]
pub extern "C" fn call(request: Id) -> Id {
    answer(request, call::call)
}
