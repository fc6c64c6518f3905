//! A picture of a map, as SVG text.
//!
//! Faces have the colour of the first feature that covers them, neighbours different ones; a face that more than one feature
//! covers is hatched, one inside the map that none covers is dotted, and a dashed ring shows where one of them is tiny.
//! [Violations](Options::violations) are red, with numbers that a legend explains. Maps that are not plane are drawn too, so that
//! one can look at what a report names; the features are filled by their own outlines then. Parts far away are in
//! [insets](Options::insets). With [`Options::detail`] the half-edges are drawn as textbooks do:
//!
//! ```text
//!    v1 ●═══════════● v0        each half-edge is an arrow to the left of its edge,
//!       ║ ◄── h1 ── ║           in the face that it bounds; a thin curve leads from its
//!       ║ ╭       ▲ ║           head to the tail of the next one
//!       ║ │  f1   │ ║
//! ```
//!
//! Coordinates are drawn as they are, x to the right and y upwards, in equal units.

mod detail;
mod draw;
mod fill;
mod frame;
mod label_spot;
mod layout;
mod lines;
mod marks;
mod names;
mod options;
mod outline;
mod text;

pub use draw::draw;
pub use frame::half_edges_in;
pub use options::Options;
