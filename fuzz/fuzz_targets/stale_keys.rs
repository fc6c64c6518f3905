//! See `twinedge_fuzz::stale_keys`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::stale_keys(bytes));
