//! See `twinedge_fuzz::geojson`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::geojson(bytes));
