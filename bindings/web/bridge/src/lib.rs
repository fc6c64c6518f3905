//! The border between a module of WebAssembly and JavaScript: the imported functions, and the exported ones.
//!
//! A buffer is filled and read at its address, between two calls. No pointer is followed here. A module exports one
//! more function, `call`. On other targets the names are not exported, as `free` is a name of C:
//!
//! ```text
//! #[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
//! #[must_use]
//! pub extern "C" fn call(request: Id) -> Id {
//!     answer(request, |buffers, request, stage| …)
//! }
//! ```
#![allow(unsafe_code, reason = "exported names, which nothing else has")]

mod buffers;

pub use buffers::{Buffers, Id};

use std::cell::RefCell;
use std::panic;

thread_local! {
    static BUFFERS: RefCell<Buffers> = RefCell::default();
}

/// Adds a buffer of `length` bytes, all 0.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
#[must_use]
pub extern "C" fn buffer(length: u32) -> Id {
    BUFFERS.with_borrow_mut(|buffers| buffers.add(vec![0; length as usize]))
}

/// Returns the address of a buffer.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
#[must_use]
pub extern "C" fn address(id: Id) -> *const u8 {
    BUFFERS.with_borrow(|buffers| buffers.get(id).as_ptr())
}

/// Returns the length of a buffer.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
#[must_use]
pub extern "C" fn length(id: Id) -> u32 {
    BUFFERS.with_borrow(|buffers| buffers.get(id).len() as u32)
}

/// Drops a buffer.
#[cfg_attr(target_family = "wasm", unsafe(no_mangle))]
pub extern "C" fn free(id: Id) {
    BUFFERS.with_borrow_mut(|buffers| drop(buffers.take(id)));
}

/// Answers the request in a buffer by a function, which takes the request and the buffers that it names, and leaves the
/// answer in another buffer.
///
/// A panic tells JavaScript its message before the module ends.
pub fn answer(request: Id, call: impl FnOnce(&mut Buffers, Id, &mut dyn FnMut(&'static str)) -> Id) -> Id {
    panic::set_hook(Box::new(|info| host::panicked(&info.to_string())));
    let mut buffers = BUFFERS.take();
    let answer = call(&mut buffers, request, &mut host::stage);
    BUFFERS.set(buffers);
    answer
}

/// The functions of JavaScript.
#[cfg(target_family = "wasm")]
mod host {
    #[link(wasm_import_module = "twinedge")]
    unsafe extern "C" {
        #[link_name = "stage"]
        safe fn stage_at(text: *const u8, length: usize);
        #[link_name = "panicked"]
        safe fn panicked_at(text: *const u8, length: usize);
    }

    /// A stage of the work begins.
    pub(super) fn stage(name: &'static str) {
        stage_at(name.as_ptr(), name.len());
    }

    /// The program is about to end with this message.
    pub(super) fn panicked(message: &str) {
        panicked_at(message.as_ptr(), message.len());
    }
}

/// On other targets, for the tests.
#[cfg(not(target_family = "wasm"))]
mod host {
    pub(super) const fn stage(_: &'static str) {}

    pub(super) fn panicked(message: &str) {
        eprintln!("{message}");
    }
}
