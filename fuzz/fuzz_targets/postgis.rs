//! See `twinedge_fuzz_cases::postgis`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz_cases::postgis(bytes));
