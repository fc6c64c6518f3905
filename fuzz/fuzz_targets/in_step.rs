//! See `twinedge_fuzz::in_step`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::in_step(bytes));
