//! The function that JavaScript calls. Those for buffers are in the crate `twinedge-web-bridge`.
#![allow(unsafe_code, reason = "an exported name, which nothing else has")]

use twinedge_web_bridge::{Id, answer};

/// Answers the request in a buffer, and drops it and those that it names. The answer is in another buffer.
#[unsafe(no_mangle)]
extern "C" fn call(request: Id) -> Id {
    answer(request, crate::call::call)
}
