//! Locating points and zones of lines: compared with an oracle that tries everything, on hostile families, and on real maps.

mod families;
mod lines;
pub(crate) mod maps;
mod points;
