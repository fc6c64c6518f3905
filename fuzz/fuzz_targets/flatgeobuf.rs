//! See `twinedge_fuzz_cases::flatgeobuf`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz_cases::flatgeobuf(bytes));
