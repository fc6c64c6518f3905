//! See `twinedge_fuzz::programs`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::programs(bytes));
