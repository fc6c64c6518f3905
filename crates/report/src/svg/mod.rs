//! A picture of a map, as SVG text.
//!
//! Faces have the colour of the first feature that covers them, and neighbours have different colours. A face that several
//! features cover is hatched, an uncovered one inside the map is dotted, and a dashed ring marks a tiny one of either kind.
//! [Violations](Options::violations) are red, with numbers that a legend explains. Maps that are not plane are drawn too, to show
//! the records of a report; the features are then filled by their own outlines. Distant parts are in [insets](Options::insets).
//! With [`Options::detail`] the half-edges are drawn as in textbooks:
//!
//! ```text
//!    v1 ●═══════════● v0        each half-edge is an arrow to the left of its edge,
//!       ║ ◄── h1 ── ║           in the face that it bounds; a thin curve leads from its
//!       ║ ╭       ▲ ║           head to the tail of the next one
//!       ║ │  f1   │ ║
//! ```
//!
//! Coordinates are drawn unchanged, x to the right and y upwards, in equal units.

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
