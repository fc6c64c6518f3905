//! The arguments of the commands, what they print, their exit status, the files that they write, and the way they end.

#[path = "../../../report/tests/report/shared.rs"]
mod shared;
mod support;

mod audit;
mod boundaries;
mod certificate;
mod clean;
mod convert;
mod draw;
mod help;
#[cfg(target_os = "linux")]
mod interrupt;
mod lists;
mod query;
mod readme;
mod shapes;
mod sum;
mod tile;
mod tile_windows;
