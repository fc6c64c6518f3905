//! See `twinedge_fuzz::noding`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::noding(bytes));
