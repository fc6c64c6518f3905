//! Noding compared with an oracle that tries everything, on families that break noders, and on real maps.

mod check;
mod families;
mod limits;
pub(crate) mod maps;
mod oracle;
mod properties;
