//! The `twinedge` program.
fn main() {}
