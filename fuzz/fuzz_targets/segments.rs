//! See `twinedge_fuzz::segments`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::segments(bytes));
