//! The lecture for WebAssembly: a half-edge structure to change by operators, and to break by hand.
//!
//! ```text
//!   lecture.js ── buffers ──► call ──► lesson: History, and above it tables that were edited
//! ```
//!
//! A request is `{"op": …}` with the arguments of the operator. Records are named by their indices. The answer is
//! `{"ok": …}`, the whole `State`, or `{"error": …}`.
#![allow(unsafe_code, reason = "an exported name, which nothing else has")]

mod call;
mod cell;
mod error;
mod lesson;
mod state;

use twinedge_web_bridge::{Id, answer};

/// Answers the request in a buffer, and drops it. The answer is in another buffer.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
#[must_use]
pub extern "C" fn call(request: Id) -> Id {
    answer(request, |buffers, request, _| call::call(buffers, request))
}
