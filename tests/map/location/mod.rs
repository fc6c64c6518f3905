//! Where points lie and what lines meet: against an oracle that asks everything, on hostile families, and on real maps.

mod edited;
mod families;
mod lines;
mod maps;
mod points;
