//! Queries of a map that involve more than one record.
//!
//! Each takes a [`PlanarMap`](crate::map::PlanarMap), does not change it, and states its cost. Two do otherwise: `convex` draws
//! the borders of the pieces on the map, and `voronoi` makes a map of points.
//!
//! | module | answers |
//! | --- | --- |
//! | [`area`] | how large is a face, a feature? |
//! | [`centroid`] | where is the middle of a face, a feature? |
//! | [`clean`] | which feature gets each face, if none may lie in two, and gaps and slivers go to neighbours? |
//! | [`colouring`] | which colours tell neighbours apart? |
//! | [`contour`] | what is the outline of a feature, a face, any set of faces? |
//! | `convex` | into which convex pieces does a face fall? (feature `spade`) |
//! | [`coverage`] | which faces does a feature cover? where do features overlap, leave gaps, nearly meet? are they valid by the OGC? |
//! | `dual` | what way leads from face to face, and what hangs by one edge? (feature `petgraph`) |
//! | [`lattice`] | how many lattice points lie inside a face, and does Pick's theorem hold? |
//! | [`layers`] | does each feature lie within one of another layer, do both cover the same, do parts make up their parents? |
//! | [`neighbours`] | which faces or features share a border, where, and how long is it? |
//! | [`mod@overlay`] | what do two maps make together? |
//! | `voronoi` | which place is nearest to which of some sites? (feature `spade`) |

pub mod area;
pub mod centroid;
pub mod clean;
pub mod colouring;
pub mod contour;
#[cfg(feature = "spade")]
pub mod convex;
pub mod coverage;
#[cfg(feature = "petgraph")]
pub mod dual;
pub mod lattice;
pub mod layers;
pub mod neighbours;
pub mod overlay;
#[cfg(feature = "spade")]
pub mod voronoi;
