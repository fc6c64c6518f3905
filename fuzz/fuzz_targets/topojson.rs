//! See `twinedge_fuzz::topojson`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::topojson(bytes));
