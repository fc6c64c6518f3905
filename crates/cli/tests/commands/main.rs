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
mod draw;
mod edges;
mod findings;
mod gate;
mod help;
#[cfg(target_os = "linux")]
mod interrupt;
mod layers;
mod literature;
mod mesh;
mod overlay;
mod postgis;
mod query;
mod readme;
mod schema;
mod tables;
mod tile;
mod tile_windows;
mod verdict;
