//! See `twinedge_fuzz_cases::topojson`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz_cases::topojson(bytes));
