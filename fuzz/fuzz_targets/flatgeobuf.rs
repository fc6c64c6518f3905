//! See `twinedge_fuzz::flatgeobuf`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::flatgeobuf(bytes));
