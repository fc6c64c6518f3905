//! Where points lie and what lines meet: against an oracle that asks everything, on hostile families, and on real maps.
#![cfg(feature = "geojson")]

#[path = "../support/edits.rs"]
mod edits;

mod edited;
mod families;
mod lines;
mod maps;
mod oracle;
mod points;
