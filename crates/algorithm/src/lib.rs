//! Queries on a map that involve more than one record.
//!
//! Each takes a [`PlanarMap`](twinedge_map::PlanarMap), does not change it, and states its cost. There are two exceptions:
//! [`convex`] draws the borders of the pieces on the map, and [`voronoi`](mod@voronoi) makes a map from points.
//!
//! | module | question |
//! | --- | --- |
//! | [`area`] | how large is a face, a feature? |
//! | [`centroid`] | where is the middle of a face, a feature? |
//! | [`colouring`] | which colours distinguish neighbours? |
//! | [`contour`] | which outline does a feature, a face or any set of faces have? |
//! | [`claims`] | which faces does a feature cover, and which of these does another one cover? |
//! | [`convex`] | into which convex pieces does a face fall? |
//! | [`dual`] | which route leads from face to face, and which parts hang by one edge? |
//! | [`lattice`] | how many lattice points lie inside a face, and does Pick's theorem hold? |
//! | [`neighbours`] | which faces or features share a border, where, and how long is it? |
//! | [`mod@overlay`] | which map results from laying one map over another? |
//! | [`voronoi`](mod@voronoi) | which place is nearest to which of some sites? |

pub mod area;
pub mod centroid;
pub mod claims;
pub mod colouring;
pub mod contour;
pub mod convex;
pub mod dual;
pub mod lattice;
pub mod neighbours;
pub mod overlay;
pub mod voronoi;
