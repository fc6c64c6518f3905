//! See `twinedge_fuzz::shapefile`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| twinedge_fuzz::shapefile(bytes));
