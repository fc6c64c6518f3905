//! An allocator that counts per thread, so concurrent tests do not count each other's memory.
#![allow(unsafe_code, reason = "an allocator that counts has to be an allocator")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    /// The number of requests for memory, fresh or to grow.
    pub(crate) static REQUESTS: Cell<usize> = const { Cell::new(0) };
    /// Allocations minus deallocations.
    pub(crate) static LIVE: Cell<isize> = const { Cell::new(0) };
    pub(crate) static LIVE_BYTES: Cell<isize> = const { Cell::new(0) };
    /// The peak of live bytes since this was set.
    pub(crate) static PEAK_BYTES: Cell<isize> = const { Cell::new(0) };
}

struct Counting;

fn grow(bytes: usize) {
    let now = LIVE_BYTES.get() + bytes.cast_signed();
    LIVE_BYTES.set(now);
    PEAK_BYTES.set(PEAK_BYTES.get().max(now));
}

fn shrink(bytes: usize) {
    LIVE_BYTES.set(LIVE_BYTES.get() - bytes.cast_signed());
}

// SAFETY: every call is passed to the system's allocator unchanged; the counters do not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        REQUESTS.set(REQUESTS.get() + 1);
        LIVE.set(LIVE.get() + 1);
        grow(layout.size());
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        LIVE.set(LIVE.get() - 1);
        shrink(layout.size());
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { System.dealloc(old, layout) }
    }

    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        REQUESTS.set(REQUESTS.get() + 1);
        // Both blocks may be live while the content is copied.
        grow(size);
        // SAFETY: the caller keeps the contract of `realloc`.
        let new = unsafe { System.realloc(old, layout, size) };
        shrink(layout.size());
        new
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;
