//! See `twinedge_fuzz::postgis`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::postgis(bytes));
