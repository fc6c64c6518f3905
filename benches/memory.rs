//! Bytes per half-edge: of the structure, and of a validation beyond it, at its peak.
//!
//! Targets: 36 and 24. Run with `cargo bench -p twinedge-benches --bench memory`.

#![allow(unsafe_code, reason = "a counting allocator")]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::Dcel;

struct Counting;

static LIVE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: passes every call on to the system's allocator, and counts.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let live = LIVE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(live, Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        LIVE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn main() {
    let map = common::triangulated_grid(1000);
    let half_edges = map.dcel().half_edge_count() as f64;
    let before = LIVE.load(Ordering::Relaxed);
    let dcel: Dcel = map.dcel().clone();
    let size = LIVE.load(Ordering::Relaxed) - before;
    println!("structure:  {:.1} bytes per half-edge, all records and keys included", size as f64 / half_edges);

    let before = LIVE.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    let valid = dcel.validate().is_valid();
    let peak = PEAK.load(Ordering::Relaxed) - before;
    println!("validation: {:.1} bytes per half-edge beyond the structure, valid: {valid}", peak as f64 / half_edges);
}
