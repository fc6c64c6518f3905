//! The lecture for WebAssembly: a half-edge structure that is changed by operators, and broken by hand.
//!
//! ```text
//!   lecture.js ── buffers ──► call ──► lesson: History, and above it tables that were edited
//! ```
//!
//! A request is `{"op": …}` with the arguments of the operator. Records are named by their indices. The answer is `{"ok": …}`, the whole
//! [`State`](state::State), or `{"error": …}`.

mod call;
mod cell;
mod error;
mod lesson;
mod state;
