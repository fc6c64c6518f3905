//! Queries of a map that involve more than one record.
//!
//! Each takes a [`PlanarMap`](twinedge_map::PlanarMap), does not change it, and states its cost. Two do otherwise: [`convex`] draws
//! the borders of the pieces on the map, and [`voronoi`](mod@voronoi) makes a map of points.
//!
//! | module | answers |
//! | --- | --- |
//! | [`area`] | how large is a face, a feature? |
//! | [`centroid`] | where is the middle of a face, a feature? |
//! | [`colouring`] | which colours tell neighbours apart? |
//! | [`contour`] | what is the outline of a feature, a face, any set of faces? |
//! | [`claims`] | which faces does a feature cover, and which does another one cover, too? |
//! | [`convex`] | into which convex pieces does a face fall? |
//! | [`dual`] | what way leads from face to face, and what hangs by one edge? |
//! | [`lattice`] | how many lattice points lie inside a face, and does Pick's theorem hold? |
//! | [`neighbours`] | which faces or features share a border, where, and how long is it? |
//! | [`mod@overlay`] | what do two maps make together? |
//! | [`voronoi`](mod@voronoi) | which place is nearest to which of some sites? |

pub mod area;
pub mod centroid;
pub mod claims;
pub mod colouring;
pub mod contour;
pub mod convex;
pub mod dual;
#[cfg(feature = "geo-types")]
pub mod geo_types;
pub mod lattice;
pub mod neighbours;
pub mod overlay;
pub mod voronoi;
