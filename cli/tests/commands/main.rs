//! The output of the commands, their exit status, and the way they end.

mod support;

mod audit;
mod between;
mod boundaries;
mod causes;
mod certificate;
mod clean_tiles;
mod cleaning;
mod conveniences;
mod corrupt;
mod draw;
mod edges;
mod findings;
mod fuzz_template;
mod gate;
mod help;
#[cfg(target_os = "linux")]
mod interrupt;
mod journal;
mod layers;
mod literature;
mod mesh;
mod overlay;
mod postgis;
mod print;
mod prove;
mod query;
mod readme;
mod schema;
mod soak;
mod sum;
mod tables;
mod tile;
mod tile_windows;
mod verdict;
