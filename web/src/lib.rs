//! `twinedge` for WebAssembly: what the functions of the package for JavaScript call.
//!
//! ```text
//!   index.js ── message ──► worker.js ──► sync.js ── buffers ──► exports ─► call ─► one file for each function
//! ```
//!
//! The exports are five functions of numbers, and the imports four. Requests and answers are JSON; bytes go beside it, in buffers of their own.
//! `wasm-bindgen` is not used: `README.md` says why.

mod audit;
mod call;
mod check;
mod clean;
mod convert;
mod error;
mod exports;
mod neighbours;
mod options;
mod source;
mod validate;
mod voronoi;
