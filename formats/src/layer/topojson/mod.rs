//! TopoJSON: arcs, and features that are made of them. A file is read as a whole, since its arcs usually follow its features.
//!
//! Source: "The TopoJSON Format Specification", version 1.0.

mod document;
mod features;

pub(super) use features::read;
