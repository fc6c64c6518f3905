//! Location of points and zones of lines: against an oracle that asks everything, on hostile families, and on real maps.

mod edited;
mod families;
mod lines;
mod maps;
mod points;
